// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Splines beyond their ends: extension, unclamped and periodic forms.

use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// A periodic spline, a proved bound of how far the shape moved, and the order of its seam.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PeriodicForm {
    /// The periodic spline.
    pub spline: Spline,
    /// How far its shape moved.
    pub deviation: f64,
    /// The order of continuity at the seam.
    pub order: i32,
}

/// Splines beyond their ends: extension, unclamped and periodic forms.
impl Spline {
    /// A spline extended beyond an end (`NURBS_START` or `NURBS_END`) by a Taylor polynomial.
    pub fn extend(&self, axis: i32, end: i32, amount: f64, order: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_extend(self.raw(), axis, end, amount, order, out) })
    }

    /// The same shape with unclamped ends; with `NURBS_HOMOGENEOUS` also where weights do not stay positive.
    pub fn unclamp(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_unclamp(self.raw(), axis, flags, out) })
    }

    /// A closed spline made periodic.
    pub fn make_periodic(&self, axis: i32, tolerance: f64) -> Result<PeriodicForm> {
        let mut deviation = 0.0;
        let mut order = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_make_periodic(self.raw(), axis, tolerance, &mut deviation, &mut order, out)
        })?;
        Ok(PeriodicForm { spline, deviation, order })
    }

    /// Whether knots and points of an axis repeat.
    pub fn detect_periodic(&self, axis: i32) -> Result<bool> {
        let mut periodic = 0;
        check(unsafe { sys::nurbs_detect_periodic(self.raw(), axis, &mut periodic) })?;
        Ok(periodic != 0)
    }
}
