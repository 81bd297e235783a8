// SPDX-License-Identifier: MIT
//! Degree, form and transformations.

use crate::error::{Error, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null;

fn check_length(what: &str, holds: usize, wanted: usize) -> Result<()> {
    if holds == wanted {
        Ok(())
    } else {
        Err(Error::size(what, holds, wanted.to_string()))
    }
}

impl Spline {
    /// The same shape with the degree of an axis raised by `times`.
    pub fn elevate(&self, axis: i32, times: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_elevate(self.raw(), axis, times, out) })
    }
    /// The axis turned round; `flags` is 0 or NURBS_KEEP_DOMAIN.
    pub fn reverse(&self, axis: i32, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_reverse(self.raw(), axis, flags, out) })
    }
    /// Axis k of the result is axis `permutation[k]`.
    pub fn transpose(&self, permutation: &[i32]) -> Result<Spline> {
        check_length("permutation", permutation.len(), self.axes()? as usize)?;
        Spline::made(|out| unsafe { sys::nurbs_transpose(self.raw(), permutation.as_ptr(), out) })
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
    /// The shape under x -> A x + b; `matrix` is `[out_dim][dim]`, row by row.
    pub fn transform(&self, out_dim: i32, matrix: &[f64], translation: Option<&[f64]>) -> Result<Spline> {
        let rows = out_dim.max(0) as usize;
        check_length("matrix", matrix.len(), rows * self.dimension()? as usize)?;
        if let Some(b) = translation {
            check_length("translation", b.len(), rows)?;
        }
        let b = translation.map_or(null(), <[f64]>::as_ptr);
        Spline::made(|out| unsafe { sys::nurbs_transform(self.raw(), out_dim, matrix.as_ptr(), b, out) })
    }
    /// The shape under a map of homogeneous points; `matrix` is `[out_dim + 1][dim + 1]`, row by row.
    pub fn transform_projective(&self, out_dim: i32, matrix: &[f64]) -> Result<Spline> {
        let rows = out_dim.max(0) as usize + 1;
        check_length("matrix", matrix.len(), rows * (self.dimension()? as usize + 1))?;
        Spline::made(|out| unsafe {
            sys::nurbs_transform_projective(self.raw(), out_dim, matrix.as_ptr(), out)
        })
    }
}
