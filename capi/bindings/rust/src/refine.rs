// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Exact refinement, and parts of a spline.

use crate::arrays::exactly;
use crate::error::Result;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Exact refinement, and parts of a spline.
impl Spline {
    /// The spline of one axis less on which the parameter of `axis` is fixed.
    pub fn iso(&self, axis: i32, param: f64, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_iso(self.raw(), axis, param, flags, out) })
    }

    /// The same shape with a knot inserted.
    pub fn insert_knot(&self, axis: i32, knot: f64, times: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_insert_knot(self.raw(), axis, knot, times, out) })
    }

    /// The same shape with a list of knots inserted, in any order.
    pub fn refine(&self, axis: i32, knots: &[f64]) -> Result<Spline> {
        Spline::made(|out| unsafe {
            sys::nurbs_refine(self.raw(), axis, knots.len() as i64, knots.as_ptr(), out)
        })
    }

    /// The same shape with every non-empty span divided into equal parts.
    pub fn refine_uniform(&self, axis: i32, parts: i64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_refine_uniform(self.raw(), axis, parts, out) })
    }

    /// The parts below and above a parameter.
    pub fn split(&self, axis: i32, param: f64) -> Result<(Spline, Spline)> {
        let mut lower = null_mut();
        let upper =
            Spline::made(|out| unsafe { sys::nurbs_split(self.raw(), axis, param, &mut lower, out) })?;
        Ok((unsafe { Spline::owned(lower) }, upper))
    }

    /// The part over a box in the domain: the ends on each axis.
    pub fn extract(&self, lower: &[f64], upper: &[f64]) -> Result<Spline> {
        let axes = self.axes()? as usize;
        let lower = exactly(lower, axes, "lower")?;
        let upper = exactly(upper, axes, "upper")?;
        Spline::made(|out| unsafe { sys::nurbs_extract(self.raw(), lower, upper, out) })
    }

    /// The same shape with clamped ends; flags 0 only open a periodic axis.
    pub fn clamp(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_clamp_ends(self.raw(), axis, flags, out) })
    }

    /// The same shape on a periodic axis over [param, param + period].
    pub fn move_seam(&self, axis: i32, param: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_move_seam(self.raw(), axis, param, out) })
    }
}
