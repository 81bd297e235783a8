// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Evaluation.

use crate::arrays::{by_axis, Records, RecordsMut};
use crate::error::{check, Result};
use crate::sizes::{product, times};
use crate::spline::Spline;
use crate::sys;

/// Active basis functions at parameters: where they start, and their values.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Basis {
    /// The span of each parameter.
    pub spans: Vec<i64>,
    /// Of the functions that are active there.
    pub values: Vec<f64>,
}

/// The gradients of active basis functions at parameters: where they start, and the vectors.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BasisGradients {
    /// The span of each parameter.
    pub spans: Vec<i64>,
    /// Of the functions that are active there.
    pub gradients: Vec<f64>,
}

/// Number of partial derivatives of orders 0 to `order`: binomial(order + axes, axes).
pub fn derivative_slots(axes: i32, order: i32) -> Result<usize> {
    let mut slots = 0;
    check(unsafe { sys::nurbs_derivative_slots(axes, order, &mut slots) })?;
    Ok(slots as usize)
}

/// Evaluation.
impl Spline {
    /// Points `[n][dim]` at parameters `[n][axes]`.
    pub fn eval<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(unsafe {
            sys::nurbs_eval(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                points.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(points)
    }

    /// The same, written to an array of the caller.
    pub fn eval_into<'a, 'b>(
        &self,
        params: impl Into<Records<'a>>,
        points: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut points = points.into();
        points.require(n, self.dimension()? as usize, "points")?;
        check(unsafe {
            sys::nurbs_eval(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
            )
        })
    }

    /// Points and partial derivatives `[n][slots][dim]`.
    pub fn eval_derivs<'a>(
        &self,
        order: i32,
        params: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut derivs = vec![0.0; n * self.slots(order)? * self.dimension()? as usize];
        check(unsafe {
            sys::nurbs_eval_derivs(
                self.raw(),
                order,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                derivs.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(derivs)
    }

    /// The same, written to an array of the caller.
    pub fn eval_derivs_into<'a, 'b>(
        &self,
        order: i32,
        params: impl Into<Records<'a>>,
        derivs: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut derivs = derivs.into();
        derivs.require(n, self.slots(order)? * self.dimension()? as usize, "derivs")?;
        check(unsafe {
            sys::nurbs_eval_derivs(
                self.raw(),
                order,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                derivs.pointer(),
                derivs.stride(),
                derivs.component_stride(),
                flags,
            )
        })
    }

    /// Points on the grid of the given parameters, one vector for each axis.
    pub fn eval_grid(&self, params: &[&[f64]], flags: u32) -> Result<Vec<f64>> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut points = vec![0.0; times(&[product(&counts), self.dimension()? as usize])];
        check(unsafe {
            sys::nurbs_eval_grid(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                points.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(points)
    }

    /// The same, written to an array of the caller.
    pub fn eval_grid_into<'b>(
        &self,
        params: &[&[f64]],
        points: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut points = points.into();
        points.require(product(&counts), self.dimension()? as usize, "points")?;
        check(unsafe {
            sys::nurbs_eval_grid(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
            )
        })
    }

    /// Points and partial derivatives on a grid.
    pub fn eval_grid_derivs(&self, order: i32, params: &[&[f64]], flags: u32) -> Result<Vec<f64>> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut derivs =
            vec![0.0; times(&[product(&counts), self.slots(order)?, self.dimension()? as usize])];
        check(unsafe {
            sys::nurbs_eval_grid_derivs(
                self.raw(),
                order,
                counts.as_ptr(),
                params.as_ptr(),
                derivs.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(derivs)
    }

    /// The same, written to an array of the caller.
    pub fn eval_grid_derivs_into<'b>(
        &self,
        order: i32,
        params: &[&[f64]],
        derivs: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut derivs = derivs.into();
        derivs.require(product(&counts), self.slots(order)? * self.dimension()? as usize, "derivs")?;
        check(unsafe {
            sys::nurbs_eval_grid_derivs(
                self.raw(),
                order,
                counts.as_ptr(),
                params.as_ptr(),
                derivs.pointer(),
                derivs.stride(),
                derivs.component_stride(),
                flags,
            )
        })
    }

    /// Points in single precision: those of `eval`, rounded once.
    pub fn eval_f32<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f32>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut points = vec![0.0; n * self.dimension()? as usize];
        check(unsafe {
            sys::nurbs_eval_f32(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                points.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(points)
    }

    /// The same, written to an array of the caller.
    pub fn eval_f32_into<'a, 'b>(
        &self,
        params: impl Into<Records<'a>>,
        points: impl Into<RecordsMut<'b, f32>>,
        flags: u32,
    ) -> Result<()> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut points = points.into();
        points.require(n, self.dimension()? as usize, "points")?;
        check(unsafe {
            sys::nurbs_eval_f32(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
            )
        })
    }

    /// Points on a grid in single precision: those of `eval_grid`, rounded once.
    pub fn eval_grid_f32(&self, params: &[&[f64]], flags: u32) -> Result<Vec<f32>> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut points = vec![0.0; times(&[product(&counts), self.dimension()? as usize])];
        check(unsafe {
            sys::nurbs_eval_grid_f32(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                points.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(points)
    }

    /// The same, written to an array of the caller.
    pub fn eval_grid_f32_into<'b>(
        &self,
        params: &[&[f64]],
        points: impl Into<RecordsMut<'b, f32>>,
        flags: u32,
    ) -> Result<()> {
        let (counts, params) = by_axis(params, self.axes()? as usize, "params")?;
        let mut points = points.into();
        points.require(product(&counts), self.dimension()? as usize, "points")?;
        check(unsafe {
            sys::nurbs_eval_grid_f32(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
            )
        })
    }

    /// R_i of the active control points at each parameter; the spans are `[n][axes]`.
    pub fn rational_basis<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Basis> {
        let params = params.into();
        let axes = self.axes()? as usize;
        let n = params.count(axes, "params")?;
        let mut spans = vec![0; n * axes];
        let mut values = vec![0.0; n * self.active()?];
        check(unsafe {
            sys::nurbs_rational_basis(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                spans.as_mut_ptr(),
                values.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(Basis { spans, values })
    }

    /// The gradients in space of the R_i of the active control points at each parameter; the spans are
    /// `[n][axes]`.
    pub fn basis_gradients<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<BasisGradients> {
        let params = params.into();
        let axes = self.axes()? as usize;
        let n = params.count(axes, "params")?;
        let mut spans = vec![0; n * axes];
        let mut gradients = vec![0.0; n * self.active()? * self.dimension()? as usize];
        check(unsafe {
            sys::nurbs_basis_gradients(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                spans.as_mut_ptr(),
                gradients.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(BasisGradients { spans, gradients })
    }
}
