// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Splines taken apart into lists, and joined again.

use crate::error::Result;
use crate::list::List;
use crate::spline::{handles, Spline};
use crate::sys;

/// The joined spline, and the largest distance of two ends.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Joined {
    /// The joined spline.
    pub spline: Spline,
    /// The largest distance of two ends.
    pub gap: f64,
}

/// Splines joined end to end along an axis.
pub fn join(parts: &[&Spline], axis: i32, tolerance: f64, flags: u32) -> Result<Joined> {
    let parts = handles(parts);
    let mut gap = 0.0;
    let spline = Spline::made(|out| unsafe {
        sys::nurbs_join(parts.len() as i64, parts.as_ptr(), axis, tolerance, flags, &mut gap, out)
    })?;
    Ok(Joined { spline, gap })
}

/// Splines taken apart into lists, and joined again.
impl Spline {
    /// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
    pub fn decompose(&self) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_decompose(self.raw(), out) })
    }

    /// The parts between the knots at which the order of continuity is less than `order`.
    pub fn split_at_knots(&self, axis: i32, order: i32) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_split_at_knots(self.raw(), axis, order, out) })
    }
}
