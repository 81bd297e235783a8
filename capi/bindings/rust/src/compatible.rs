// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Near-equal knots made equal, and sets of splines brought to one form.

use crate::error::Result;
use crate::list::List;
use crate::spline::{handles, Spline};
use crate::sys;

/// Splines brought to one degree, domain and knot vector on every axis, and a bound of what that moved.
pub fn make_compatible(splines: &[&Spline], tolerance: f64, flags: u32) -> Result<(List, f64)> {
    let splines = handles(splines);
    let mut deviation = 0.0;
    let list = List::made(|out| unsafe {
        sys::nurbs_make_compatible(
            splines.len() as i64,
            splines.as_ptr(),
            tolerance,
            flags,
            &mut deviation,
            out,
        )
    })?;
    Ok((list, deviation))
}

/// Near-equal knots made equal, and sets of splines brought to one form.
impl Spline {
    /// Knots within `tolerance` of the domain's length become one; and a bound of what that moved.
    pub fn snap_knots(&self, axis: i32, tolerance: f64) -> Result<(Spline, f64)> {
        let mut deviation = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_snap_knots(self.raw(), axis, tolerance, &mut deviation, out)
        })?;
        Ok((spline, deviation))
    }
}
