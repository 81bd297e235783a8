// SPDX-License-Identifier: MIT
//! Near-equal knots made equal, and sets of splines brought to one form.

use crate::error::Result;
use crate::list::List;
use crate::spline::Spline;
use crate::sys;

/// Splines brought to one degree, domain and knot vector on every axis, and a bound of what that moved.
pub fn make_compatible(splines: &[&Spline], tolerance: f64, flags: u32) -> Result<(List, f64)> {
    let handles: Vec<*const sys::nurbs> = splines.iter().map(|spline| spline.raw()).collect();
    let (count, first) = (handles.len() as i64, handles.as_ptr());
    let mut moved = 0.0;
    let list = List::made(|out| unsafe {
        sys::nurbs_make_compatible(count, first, tolerance, flags, &mut moved, out)
    })?;
    Ok((list, moved))
}

/// Knots brought together.
impl Spline {
    /// Knots within `tolerance` of the domain's length become one; also a bound of what that moved.
    pub fn snap_knots(&self, axis: i32, tolerance: f64) -> Result<(Spline, f64)> {
        let mut moved = 0.0;
        let g = self.raw();
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_snap_knots(g, axis, tolerance, &mut moved, out) })?;
        Ok((spline, moved))
    }
}
