// SPDX-License-Identifier: MIT
//! Evaluation, and the operations that make new splines.

use crate::arrays::{Records, RecordsMut};
use crate::error::{check, Error, Result};
use crate::knots::Basis;
use crate::spline::{derivative_slots, Spline};
use crate::sys;

/// Evaluation and operations.
impl Spline {
    fn width(&self) -> Result<usize> {
        Ok(self.dimension()? as usize)
    }
    fn number_of(&self, params: &Records) -> Result<usize> {
        params.count(self.axes()? as usize, "params")
    }
    fn slots(&self, order: i32) -> Result<usize> {
        derivative_slots(self.axes()?, order)
    }

    /// Points `[n][dim]` at parameters `[n][axes]`.
    pub fn eval<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f64>> {
        let params = params.into();
        let mut points = vec![0.0; self.number_of(&params)? * self.width()?];
        self.eval_into(params, &mut points, flags)?;
        Ok(points)
    }
    /// The same, written to an array of the caller.
    pub fn eval_into<'a, 'b>(
        &self,
        params: impl Into<Records<'a>>,
        points: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let (p, mut o) = (params.into(), points.into());
        let n = self.number_of(&p)?;
        o.require(n, self.width()?, "points")?;
        check(unsafe {
            sys::nurbs_eval(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                o.pointer(),
                o.stride(),
                o.component_stride(),
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
        let mut derivs = vec![0.0; self.number_of(&params)? * self.slots(order)? * self.width()?];
        self.eval_derivs_into(order, params, &mut derivs, flags)?;
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
        let (p, mut o) = (params.into(), derivs.into());
        let n = self.number_of(&p)?;
        o.require(n, self.slots(order)? * self.width()?, "derivs")?;
        check(unsafe {
            sys::nurbs_eval_derivs(
                self.raw(),
                order,
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                o.pointer(),
                o.stride(),
                o.component_stride(),
                flags,
            )
        })
    }

    /// The number of grid points, and the counts and parameters of all axes one after the other.
    fn grid(&self, params: &[&[f64]]) -> Result<(usize, Vec<i64>, Vec<f64>)> {
        let axes = self.axes()? as usize;
        if params.len() != axes {
            return Err(Error::size("params", params.len(), format!("{} vectors", axes)));
        }
        let n = params.iter().fold(1usize, |product, p| product.saturating_mul(p.len()));
        let counts = params.iter().map(|p| p.len() as i64).collect();
        Ok((n, counts, params.concat()))
    }
    /// Points on the grid of the given parameters, one vector for each axis.
    pub fn eval_grid(&self, params: &[&[f64]], flags: u32) -> Result<Vec<f64>> {
        let (n, _, _) = self.grid(params)?;
        let mut points = vec![0.0; n.saturating_mul(self.width()?)];
        self.eval_grid_into(params, &mut points, flags)?;
        Ok(points)
    }
    /// The same, written to an array of the caller.
    pub fn eval_grid_into<'b>(
        &self,
        params: &[&[f64]],
        points: impl Into<RecordsMut<'b>>,
        flags: u32,
    ) -> Result<()> {
        let ((n, counts, params), mut o) = (self.grid(params)?, points.into());
        o.require(n, self.width()?, "points")?;
        let (stride, component_stride) = (o.stride(), o.component_stride());
        check(unsafe {
            sys::nurbs_eval_grid(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                o.pointer(),
                stride,
                component_stride,
                flags,
            )
        })
    }
    /// Points and partial derivatives on a grid.
    pub fn eval_grid_derivs(&self, order: i32, params: &[&[f64]], flags: u32) -> Result<Vec<f64>> {
        let (n, _, _) = self.grid(params)?;
        let width = self.slots(order)? * self.width()?;
        let mut derivs = vec![0.0; n.saturating_mul(width)];
        self.eval_grid_derivs_into(order, params, &mut derivs, flags)?;
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
        let ((n, counts, params), mut o) = (self.grid(params)?, derivs.into());
        o.require(n, self.slots(order)? * self.width()?, "derivs")?;
        let (stride, component_stride) = (o.stride(), o.component_stride());
        check(unsafe {
            sys::nurbs_eval_grid_derivs(
                self.raw(),
                order,
                counts.as_ptr(),
                params.as_ptr(),
                o.pointer(),
                stride,
                component_stride,
                flags,
            )
        })
    }

    /// Points in single precision: those of `eval()`, rounded once.
    pub fn eval_f32<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f32>> {
        let params = params.into();
        let mut points = vec![0.0; self.number_of(&params)? * self.width()?];
        self.eval_f32_into(params, &mut points, flags)?;
        Ok(points)
    }
    /// The same, written to an array of the caller.
    pub fn eval_f32_into<'a, 'b>(
        &self,
        params: impl Into<Records<'a>>,
        points: impl Into<RecordsMut<'b, f32>>,
        flags: u32,
    ) -> Result<()> {
        let (p, mut o) = (params.into(), points.into());
        let n = self.number_of(&p)?;
        o.require(n, self.width()?, "points")?;
        check(unsafe {
            sys::nurbs_eval_f32(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                o.pointer(),
                o.stride(),
                o.component_stride(),
                flags,
            )
        })
    }
    /// Points on a grid in single precision: those of `eval_grid()`, rounded once.
    pub fn eval_grid_f32(&self, params: &[&[f64]], flags: u32) -> Result<Vec<f32>> {
        let (n, _, _) = self.grid(params)?;
        let mut points = vec![0.0; n.saturating_mul(self.width()?)];
        self.eval_grid_f32_into(params, &mut points, flags)?;
        Ok(points)
    }
    /// The same, written to an array of the caller.
    pub fn eval_grid_f32_into<'b>(
        &self,
        params: &[&[f64]],
        points: impl Into<RecordsMut<'b, f32>>,
        flags: u32,
    ) -> Result<()> {
        let ((n, counts, params), mut o) = (self.grid(params)?, points.into());
        o.require(n, self.width()?, "points")?;
        let (stride, component_stride) = (o.stride(), o.component_stride());
        check(unsafe {
            sys::nurbs_eval_grid_f32(
                self.raw(),
                counts.as_ptr(),
                params.as_ptr(),
                o.pointer(),
                stride,
                component_stride,
                flags,
            )
        })
    }

    /// The `hull` of the accuracy contract at each parameter.
    pub fn hull_size<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f64>> {
        let p = params.into();
        let n = self.number_of(&p)?;
        let mut sizes = vec![0.0; n];
        check(unsafe {
            sys::nurbs_hull_size(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                sizes.as_mut_ptr(),
                0,
                flags,
            )
        })?;
        Ok(sizes)
    }

    /// R_i of the active control points at each parameter; the spans are `[n][axes]`.
    pub fn rational_basis<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Basis> {
        let p = params.into();
        let (n, axes) = (self.number_of(&p)?, self.axes()?);
        let mut active = 1;
        for axis in 0..axes {
            active *= self.degree(axis)? as usize + 1;
        }
        let mut spans = vec![0; n * axes as usize];
        let mut values = vec![0.0; n * active];
        check(unsafe {
            sys::nurbs_rational_basis(
                self.raw(),
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                spans.as_mut_ptr(),
                values.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(Basis { spans, values })
    }

    /// The spline of one axis less on which the parameter of `axis` is fixed.
    pub fn iso(&self, axis: i32, param: f64, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_iso(self.raw(), axis, param, flags, out) })
    }
    /// The same shape with a knot inserted.
    pub fn insert_knot(&self, axis: i32, knot: f64, times: i32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_insert_knot(self.raw(), axis, knot, times, out) })
    }
}
