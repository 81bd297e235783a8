// SPDX-License-Identifier: MIT
//! Splines beyond their ends: extension, unclamped and periodic forms.

use crate::error::{value, Result};
use crate::spline::Spline;
use crate::sys;

/// A periodic spline, a proved bound of how far the shape moved, and the order of its seam.
#[derive(Debug)]
#[non_exhaustive]
pub struct PeriodicForm {
    /// The periodic spline.
    pub spline: Spline,
    /// How far its shape moved.
    pub deviation: f64,
    /// The order of continuity at the seam.
    pub order: i32,
}

impl Spline {
    /// Extended beyond an end, `NURBS_START` or `NURBS_END`, by a Taylor polynomial.
    pub fn extend(&self, axis: i32, end: i32, amount: f64, order: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_extend(self.raw(), axis, end, amount, order, out) })
    }
    /// The same shape with unclamped ends; `NURBS_HOMOGENEOUS` allows weights of any sign.
    pub fn unclamp(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_unclamp(self.raw(), axis, flags, out) })
    }
    /// A closed spline made periodic.
    pub fn make_periodic(&self, axis: i32, tolerance: f64) -> Result<PeriodicForm> {
        let (g, mut deviation, mut order) = (self.raw(), 0.0, 0);
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_make_periodic(g, axis, tolerance, &mut deviation, &mut order, out)
        })?;
        Ok(PeriodicForm { spline, deviation, order })
    }
    /// Whether knots and points of an axis repeat.
    pub fn detect_periodic(&self, axis: i32) -> Result<bool> {
        Ok(value(|v: *mut i32| unsafe { sys::nurbs_detect_periodic(self.raw(), axis, v) })? != 0)
    }
}
