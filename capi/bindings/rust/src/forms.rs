// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Degree, form and transformations.

use crate::arrays::{exactly, optional};
use crate::error::Result;
use crate::sizes::positive;
use crate::spline::Spline;
use crate::sys;

/// Degree, form and transformations.
impl Spline {
    /// The same shape with the degree of an axis raised by `times`.
    pub fn elevate(&self, axis: i32, times: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_elevate(self.raw(), axis, times, out) })
    }

    /// The axis turned round; flags: 0 or `NURBS_KEEP_DOMAIN`.
    pub fn reverse(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_reverse(self.raw(), axis, flags, out) })
    }

    /// Axis k of the result is axis `permutation[k]`.
    pub fn transpose(&self, permutation: &[i32]) -> Result<Spline> {
        let permutation = exactly(permutation, self.axes()? as usize, "permutation")?;
        Spline::made(|out| unsafe { sys::nurbs_transpose(self.raw(), permutation, out) })
    }

    /// The same shape over another domain.
    pub fn reparametrize(&self, axis: i32, lower: f64, upper: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_reparametrize(self.raw(), axis, lower, upper, out) })
    }

    /// The same spline with weights.
    pub fn make_rational(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_make_rational(self.raw(), out) })
    }

    /// The polynomial spline of the points (w x, w y, ..., w).
    pub fn to_homogeneous(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_to_homogeneous(self.raw(), out) })
    }

    /// The rational spline whose homogeneous points these are.
    pub fn from_homogeneous(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_from_homogeneous(self.raw(), out) })
    }

    /// The shape under x -> A x + b; `matrix` is `[out_dim][dim]`, row by row, `translation` `[out_dim]`, or
    /// else 0.
    pub fn transform(&self, out_dim: i32, matrix: &[f64], translation: Option<&[f64]>) -> Result<Spline> {
        let matrix = exactly(matrix, positive(out_dim) * self.dimension()? as usize, "matrix")?;
        let translation = optional(translation, positive(out_dim), "translation")?;
        Spline::made(|out| unsafe { sys::nurbs_transform(self.raw(), out_dim, matrix, translation, out) })
    }

    /// The shape under a map of homogeneous points; `matrix` is `[out_dim + 1][dim + 1]`, row by row.
    pub fn transform_projective(&self, out_dim: i32, matrix: &[f64]) -> Result<Spline> {
        let matrix = exactly(matrix, (positive(out_dim) + 1) * (self.dimension()? as usize + 1), "matrix")?;
        Spline::made(|out| unsafe { sys::nurbs_transform_projective(self.raw(), out_dim, matrix, out) })
    }
}
