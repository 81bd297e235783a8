// SPDX-License-Identifier: MIT
//! Derivatives with respect to data: collocation matrices, Bezier extraction, gradients.

use crate::arrays::{layout, Records, RecordsMut};
use crate::error::{check, value, Error, Result};
use crate::spline::{derivative_slots, Spline};
use crate::sys;
use std::ptr::{null, null_mut};

/// Compressed sparse rows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SparseMatrix {
    /// Row by row.
    pub values: Vec<f64>,
    /// The column of each value.
    pub columns: Vec<i64>,
    /// Where each row starts, and where the last one ends.
    pub row_pointers: Vec<i64>,
}

/// Operators `[spans][degree + 1][degree + 1]`, the first control point and the domain of each span.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Extraction {
    /// `[spans][degree + 1][degree + 1]`
    pub operators: Vec<f64>,
    /// The first control point of each span.
    pub firsts: Vec<i64>,
    /// The ends of each span.
    pub domains: Vec<[f64; 2]>,
}

/// Outputs of [`Spline::eval_adjoint_into`]; those that are `None` are not computed.
#[derive(Default, Debug)]
pub struct GradientsMut<'a> {
    /// With respect to the control points, `[n][dim]`.
    pub points: Option<RecordsMut<'a>>,
    /// With respect to the weights, `[n]`.
    pub weights: Option<RecordsMut<'a>>,
    /// With respect to the parameters, `[n][axes]`.
    pub params: Option<RecordsMut<'a>>,
}

/// Gradients `[N][dim]`, `[N]` and `[n][axes]`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Gradients {
    /// With respect to the control points, `[n][dim]`.
    pub points: Vec<f64>,
    /// With respect to the weights, `[n]`.
    pub weights: Vec<f64>,
    /// With respect to the parameters, `[n][axes]`.
    pub params: Vec<f64>,
}

/// fill(cap, values, columns, row_pointers, entries), asked for the size first.
pub(crate) fn sparse(
    n: usize,
    fill: impl Fn(i64, *mut f64, *mut i64, *mut i64, *mut i64) -> i32,
) -> Result<SparseMatrix> {
    let entries = value(|v: *mut i64| fill(0, null_mut(), null_mut(), null_mut(), v))?;
    let (mut values, mut columns) = (vec![0.0; entries as usize], vec![0; entries as usize]);
    let mut row_pointers = vec![0; n + 1];
    let rows = row_pointers.as_mut_ptr();
    check(fill(entries, values.as_mut_ptr(), columns.as_mut_ptr(), rows, null_mut()))?;
    Ok(SparseMatrix { values, columns, row_pointers })
}

fn checked_orders(orders: &[i32], axes: usize) -> Result<*const i32> {
    match orders.len() {
        0 => Ok(null()),
        n if n == axes => Ok(orders.as_ptr()),
        n => Err(Error::size("orders", n, axes.to_string())),
    }
}

/// The matrix of B-spline basis functions, or of their derivative `orders` (empty: 0); `knots` one vector for
/// each axis.
pub fn collocation<'a>(
    degrees: &[i32],
    knots: &[&[f64]],
    orders: &[i32],
    params: impl Into<Records<'a>>,
    flags: u32,
) -> Result<SparseMatrix> {
    let axes = degrees.len();
    if knots.len() != axes {
        return Err(Error::size("knots", knots.len(), format!("{} vectors", axes)));
    }
    let counts: Vec<i64> =
        knots.iter().zip(degrees).map(|(k, &p)| k.len() as i64 - i64::from(p) - 1).collect();
    let (all, p) = (knots.concat(), params.into());
    let (n, of) = (p.count(axes, "params")?, checked_orders(orders, axes)?);
    sparse(n, |cap, values, columns, rows, entries| unsafe {
        sys::nurbs_collocation(
            axes.min(4) as i32,
            degrees.as_ptr(),
            counts.as_ptr(),
            all.as_ptr(),
            all.len() as i64,
            of,
            n as i64,
            p.pointer(),
            p.stride(),
            p.component_stride(),
            cap,
            values,
            columns,
            rows,
            entries,
            flags,
        )
    })
}

/// Derivatives with respect to data.
impl Spline {
    /// The matrix of the rational basis functions, or of their derivative `orders` (empty: 0).
    pub fn rational_collocation<'a>(
        &self,
        orders: &[i32],
        params: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<SparseMatrix> {
        let (p, axes) = (params.into(), self.axes()? as usize);
        let (n, of) = (p.count(axes, "params")?, checked_orders(orders, axes)?);
        sparse(n, |cap, values, columns, rows, entries| unsafe {
            sys::nurbs_rational_collocation(
                self.raw(),
                of,
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                cap,
                values,
                columns,
                rows,
                entries,
                flags,
            )
        })
    }

    /// The operators that take Bernstein polynomials to the basis functions of each span.
    pub fn bezier_extraction(&self, axis: i32) -> Result<Extraction> {
        let g = self.raw();
        let (no, none) = (null_mut(), null_mut());
        let spans =
            value(|v: *mut i64| unsafe { sys::nurbs_bezier_extraction(g, axis, 0, no, none, no, v) })?;
        let width = self.degree(axis)? as usize + 1;
        let mut operators = vec![0.0; spans as usize * width * width];
        let mut firsts = vec![0; spans as usize];
        let mut domains = vec![[0.0; 2]; spans as usize];
        let (o, f, d) = (operators.as_mut_ptr(), firsts.as_mut_ptr(), domains.as_mut_ptr().cast());
        value(|v: *mut i64| unsafe { sys::nurbs_bezier_extraction(g, axis, spans, o, f, d, v) })?;
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
        let (p, axes, count) = (params.into(), self.axes()? as usize, self.point_count()?);
        let mut points = vec![0.0; count * self.dimension()? as usize];
        let mut weights = vec![0.0; count];
        let mut to_params = vec![0.0; p.count(axes, "params")? * axes];
        let out = GradientsMut {
            points: Some((&mut points).into()),
            weights: Some((&mut weights).into()),
            params: Some((&mut to_params).into()),
        };
        self.eval_adjoint_into(order, p, cotangents, out, flags)?;
        Ok(Gradients { points, weights, params: to_params })
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
        let (p, g) = (params.into(), cotangents.into());
        let (axes, dim, count) = (self.axes()?, self.dimension()? as usize, self.point_count()?);
        let n = p.count(axes as usize, "params")?;
        g.require(n, derivative_slots(axes, order)? * dim, "cotangents")?;
        let points = layout(&mut out.points, count, dim, "grad_points")?;
        let weights = layout(&mut out.weights, count, 1, "grad_weights")?;
        let to_params = layout(&mut out.params, n, axes as usize, "grad_params")?;
        check(unsafe {
            sys::nurbs_eval_adjoint(
                self.raw(),
                order,
                n as i64,
                p.pointer(),
                p.stride(),
                p.component_stride(),
                g.pointer(),
                g.stride(),
                g.component_stride(),
                points.0,
                points.1,
                points.2,
                weights.0,
                weights.1,
                to_params.0,
                to_params.1,
                to_params.2,
                flags,
            )
        })
    }
}
