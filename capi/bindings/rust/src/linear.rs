// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Derivatives with respect to data: collocation matrices, Bezier extraction, gradients.

use crate::arrays::{exactly, if_given, knots_by_axis, layout, rows, Records, RecordsMut};
use crate::error::{check, Result};
use crate::sizes::axes_of;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Compressed sparse rows.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SparseMatrix {
    /// Row by row.
    pub values: Vec<f64>,
    /// The column of each value.
    pub columns: Vec<i64>,
    /// Where each row starts, and where the last one ends.
    pub row_pointers: Vec<i64>,
}

/// Operators `[spans][degree + 1][degree + 1]`, the first control point and the domain `[spans][2]` of each
/// span.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Extraction {
    /// `[spans][degree + 1][degree + 1]`
    pub operators: Vec<f64>,
    /// The first control point of each span.
    pub firsts: Vec<i64>,
    /// The ends of each span.
    pub domains: Vec<[f64; 2]>,
}

/// Gradients `[N][dim]`, `[N]` and `[n][axes]`.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Gradients {
    /// With respect to the control points, `[N][dim]`.
    pub points: Vec<f64>,
    /// With respect to the weights, `[N]`.
    pub weights: Vec<f64>,
    /// With respect to the parameters, `[n][axes]`.
    pub params: Vec<f64>,
}

/// Where they are written; those that are `None` are not wanted.
#[derive(Debug, Default)]
pub struct GradientsMut<'a> {
    /// With respect to the control points, `[N][dim]`.
    pub points: Option<RecordsMut<'a>>,
    /// With respect to the weights, `[N]`.
    pub weights: Option<RecordsMut<'a>>,
    /// With respect to the parameters, `[n][axes]`.
    pub params: Option<RecordsMut<'a>>,
}

/// Gradients `[N][dim]`, `[N]` and `[n][dim]`, and `NURBS_CLOSEST_` bits `[n]`.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FootGradients {
    /// With respect to the control points, `[N][dim]`.
    pub points: Vec<f64>,
    /// With respect to the weights, `[N]`.
    pub weights: Vec<f64>,
    /// With respect to the query points, `[n][dim]`.
    pub queries: Vec<f64>,
    /// `NURBS_CLOSEST_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Gradients `[N][dim]` and `[N]` of the length of a curve, and an estimate of their relative error.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LengthGradients {
    /// With respect to the control points, `[N][dim]`.
    pub points: Vec<f64>,
    /// With respect to the weights, `[N]`.
    pub weights: Vec<f64>,
    /// Of the integrals, relative.
    pub error: f64,
}

/// The matrix of B-spline basis functions, or of their derivative `orders` (empty: 0); `knots` has one vector
/// for each axis.
pub fn collocation<'a>(
    degrees: &[i32],
    knots: &[&[f64]],
    orders: &[i32],
    params: impl Into<Records<'a>>,
    flags: u32,
) -> Result<SparseMatrix> {
    let params = params.into();
    let axes = degrees.len();
    let n = params.count(axes, "params")?;
    let (counts, knots) = knots_by_axis(knots, degrees, "knots")?;
    let orders = if_given(orders, axes, "orders")?;
    let mut row_pointers = vec![0; n + 1];
    let mut fill = |cap, values, columns, entries| unsafe {
        sys::nurbs_collocation(
            axes_of(degrees),
            degrees.as_ptr(),
            counts.as_ptr(),
            knots.as_ptr(),
            knots.len() as i64,
            orders,
            n as i64,
            params.pointer(),
            params.stride(),
            params.component_stride(),
            cap,
            values,
            columns,
            row_pointers.as_mut_ptr(),
            entries,
            flags,
        )
    };
    let mut entries = 0;
    check(fill(0, null_mut(), null_mut(), &mut entries))?;
    let size = entries as usize;
    let mut values = vec![0.0; size];
    let mut columns = vec![0; size];
    check(fill(entries, values.as_mut_ptr(), columns.as_mut_ptr(), &mut entries))?;
    Ok(SparseMatrix { values, columns, row_pointers })
}

/// Derivatives with respect to data: collocation matrices, Bezier extraction, gradients.
impl Spline {
    /// The matrix of the rational basis functions, or of their derivative `orders` (empty: 0).
    pub fn rational_collocation<'a>(
        &self,
        orders: &[i32],
        params: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<SparseMatrix> {
        let params = params.into();
        let axes = self.axes()? as usize;
        let n = params.count(axes, "params")?;
        let orders = if_given(orders, axes, "orders")?;
        let mut row_pointers = vec![0; n + 1];
        let mut fill = |cap, values, columns, entries| unsafe {
            sys::nurbs_rational_collocation(
                self.raw(),
                orders,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                cap,
                values,
                columns,
                row_pointers.as_mut_ptr(),
                entries,
                flags,
            )
        };
        let mut entries = 0;
        check(fill(0, null_mut(), null_mut(), &mut entries))?;
        let size = entries as usize;
        let mut values = vec![0.0; size];
        let mut columns = vec![0; size];
        check(fill(entries, values.as_mut_ptr(), columns.as_mut_ptr(), &mut entries))?;
        Ok(SparseMatrix { values, columns, row_pointers })
    }

    /// The matrix that `Spline::refine` applies along the axis.
    pub fn refinement_matrix(&self, axis: i32, knots: &[f64]) -> Result<SparseMatrix> {
        let count = knots.len();
        let mut row_pointers = vec![0; self.count(axis)? + count + 1];
        let mut fill = |cap, values, columns, entries| unsafe {
            sys::nurbs_refinement_matrix(
                self.raw(),
                axis,
                count as i64,
                knots.as_ptr(),
                cap,
                values,
                columns,
                row_pointers.as_mut_ptr(),
                entries,
            )
        };
        let mut entries = 0;
        check(fill(0, null_mut(), null_mut(), &mut entries))?;
        let n = entries as usize;
        let mut values = vec![0.0; n];
        let mut columns = vec![0; n];
        check(fill(entries, values.as_mut_ptr(), columns.as_mut_ptr(), &mut entries))?;
        Ok(SparseMatrix { values, columns, row_pointers })
    }

    /// The operators that take Bernstein polynomials to the basis functions of each span.
    pub fn bezier_extraction(&self, axis: i32) -> Result<Extraction> {
        let fill = |cap, operators, firsts, domains, count| unsafe {
            sys::nurbs_bezier_extraction(self.raw(), axis, cap, operators, firsts, domains, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let degrees = self.degree(axis)? as usize;
        let mut operators = vec![0.0; n * (degrees + 1) * (degrees + 1)];
        let mut firsts = vec![0; n];
        let mut domains = vec![[0.0; 2]; n];
        check(fill(
            count,
            operators.as_mut_ptr(),
            firsts.as_mut_ptr(),
            domains.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(Extraction { operators, firsts, domains })
    }

    /// Gradients of a function of points and derivatives, from its cotangents `[n][slots][dim]`.
    pub fn eval_adjoint<'a, 'b>(
        &self,
        order: i32,
        params: impl Into<Records<'a>>,
        cotangents: impl Into<Records<'b>>,
        flags: u32,
    ) -> Result<Gradients> {
        let params = params.into();
        let cotangents = cotangents.into();
        let axes = self.axes()? as usize;
        let n = params.count(axes, "params")?;
        let dim = self.dimension()? as usize;
        cotangents.require(n, self.slots(order)? * dim, "cotangents")?;
        let count = self.point_count()?;
        let mut points = vec![0.0; count * dim];
        let mut weights = vec![0.0; count];
        let mut grad_params = vec![0.0; n * axes];
        check(unsafe {
            sys::nurbs_eval_adjoint(
                self.raw(),
                order,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                cotangents.pointer(),
                cotangents.stride(),
                cotangents.component_stride(),
                points.as_mut_ptr(),
                0,
                0,
                weights.as_mut_ptr(),
                0,
                grad_params.as_mut_ptr(),
                0,
                0,
                flags,
            )
        })?;
        Ok(Gradients { points, weights, params: grad_params })
    }

    /// The same, written to arrays of the caller.
    pub fn eval_adjoint_into<'a, 'b>(
        &self,
        order: i32,
        params: impl Into<Records<'a>>,
        cotangents: impl Into<Records<'b>>,
        mut out: GradientsMut,
        flags: u32,
    ) -> Result<()> {
        let params = params.into();
        let cotangents = cotangents.into();
        let axes = self.axes()? as usize;
        let n = params.count(axes, "params")?;
        let dim = self.dimension()? as usize;
        cotangents.require(n, self.slots(order)? * dim, "cotangents")?;
        let count = self.point_count()?;
        let grad_points = layout(&mut out.points, count, dim, "grad_points")?;
        let grad_weights = layout(&mut out.weights, count, 1, "grad_weights")?;
        let grad_params = layout(&mut out.params, n, axes, "grad_params")?;
        check(unsafe {
            sys::nurbs_eval_adjoint(
                self.raw(),
                order,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                cotangents.pointer(),
                cotangents.stride(),
                cotangents.component_stride(),
                grad_points.0,
                grad_points.1,
                grad_points.2,
                grad_weights.0,
                grad_weights.1,
                grad_params.0,
                grad_params.1,
                grad_params.2,
                flags,
            )
        })
    }

    /// Gradients with respect to the knots of an axis of a function of points and derivatives, from its
    /// cotangents `[n][slots][dim]`.
    pub fn eval_adjoint_knots<'a, 'b>(
        &self,
        axis: i32,
        order: i32,
        params: impl Into<Records<'a>>,
        cotangents: impl Into<Records<'b>>,
        flags: u32,
    ) -> Result<Vec<f64>> {
        let params = params.into();
        let cotangents = cotangents.into();
        let n = params.count(self.axes()? as usize, "params")?;
        cotangents.require(n, self.slots(order)? * self.dimension()? as usize, "cotangents")?;
        let mut grad_knots = vec![0.0; self.count(axis)? + self.degree(axis)? as usize + 1];
        check(unsafe {
            sys::nurbs_eval_adjoint_knots(
                self.raw(),
                axis,
                order,
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                cotangents.pointer(),
                cotangents.stride(),
                cotangents.component_stride(),
                grad_knots.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(grad_knots)
    }

    /// Gradients through the closest points of query points, whose parameters are given, from cotangents of
    /// parameters, points and distances; empty ones are 0.
    pub fn closest_adjoint(
        &self,
        points: &[f64],
        params: &[f64],
        param_cotangents: &[f64],
        foot_cotangents: &[f64],
        distance_cotangents: &[f64],
        flags: u32,
    ) -> Result<FootGradients> {
        let dim = self.dimension()? as usize;
        let n = rows(points, dim, "points")?;
        let axes = self.axes()? as usize;
        let params = exactly(params, n * axes, "params")?;
        let param_cotangents = if_given(param_cotangents, n * axes, "param_cotangents")?;
        let foot_cotangents = if_given(foot_cotangents, n * dim, "foot_cotangents")?;
        let distance_cotangents = if_given(distance_cotangents, n, "distance_cotangents")?;
        let count = self.point_count()?;
        let mut grad_points = vec![0.0; count * dim];
        let mut weights = vec![0.0; count];
        let mut queries = vec![0.0; n * dim];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_closest_adjoint(
                self.raw(),
                n as i64,
                points.as_ptr(),
                params,
                param_cotangents,
                foot_cotangents,
                distance_cotangents,
                grad_points.as_mut_ptr(),
                weights.as_mut_ptr(),
                queries.as_mut_ptr(),
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(FootGradients { points: grad_points, weights, queries, status })
    }

    /// Gradients of the length of a curve over a range `[2]` of its domain, or all of it.
    pub fn length_adjoint(
        &self,
        relative_tolerance: f64,
        cotangent: f64,
        range: &[f64],
        flags: u32,
    ) -> Result<LengthGradients> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let n = self.point_count()?;
        let mut points = vec![0.0; n * self.dimension()? as usize];
        let mut weights = vec![0.0; n];
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_length_adjoint(
                self.raw(),
                range,
                relative_tolerance,
                cotangent,
                points.as_mut_ptr(),
                0,
                0,
                weights.as_mut_ptr(),
                0,
                &mut error,
                flags,
            )
        })?;
        Ok(LengthGradients { points, weights, error })
    }
}
