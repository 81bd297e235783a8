// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Parameters of data, and splines through them.

use crate::arrays::{counts_of, exactly, if_given, optional, Records};
use crate::error::{check, Result};
use crate::sizes::{axes_of, positive, product, sum};
use crate::spline::Spline;
use crate::sys;

/// The spline, and the largest distance of a point from it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Interpolated {
    /// The spline.
    pub spline: Spline,
    /// The largest distance of a point from the spline at its parameter.
    pub residual: f64,
}

/// Parameters of points on a grid from the distances between them, those of each axis from 0 to 1.
pub fn parametrize<'a>(
    counts: &[usize],
    dim: i32,
    points: impl Into<Records<'a>>,
    rule: i32,
    exponent: f64,
    flags: u32,
) -> Result<Vec<f64>> {
    let points = points.into();
    let counts = counts_of(counts, counts.len(), "counts")?;
    // Another dimension is left to the library to name.
    if dim > 0 {
        points.require(product(&counts), positive(dim), "points")?;
    }
    let mut params = vec![0.0; sum(&counts)];
    check(unsafe {
        sys::nurbs_parametrize(
            axes_of(&counts),
            counts.as_ptr(),
            dim,
            points.pointer(),
            points.stride(),
            points.component_stride(),
            rule,
            exponent,
            flags,
            params.as_mut_ptr(),
        )
    })?;
    Ok(params)
}

/// Parameters where the basis functions over evenly spaced knots are largest, for interpolation over these.
pub fn params_universal(degree: i32, count: usize) -> Result<Vec<f64>> {
    let mut params = vec![0.0; count];
    check(unsafe { sys::nurbs_params_universal(degree, count as i64, params.as_mut_ptr()) })?;
    Ok(params)
}

/// The factors that make derivatives of targets of which `Spline::curve_interpolate` is told the directions.
pub fn tangent_lengths<'a>(
    degree: i32,
    params: &[f64],
    dim: i32,
    targets: impl Into<Records<'a>>,
    orders: &[i32],
    knots: &[f64],
    flags: u32,
) -> Result<Vec<f64>> {
    let targets = targets.into();
    let n = params.len();
    let orders = if_given(orders, n, "orders")?;
    targets.require(n, positive(dim), "targets")?;
    let mut lengths = vec![0.0; n];
    check(unsafe {
        sys::nurbs_tangent_lengths(
            degree,
            n as i64,
            params.as_ptr(),
            orders,
            dim,
            targets.pointer(),
            targets.stride(),
            targets.component_stride(),
            knots.as_ptr(),
            knots.len() as i64,
            flags,
            lengths.as_mut_ptr(),
        )
    })?;
    Ok(lengths)
}

/// Derivatives at the points of a curve from the points near them, as `Spline::hermite` takes them.
pub fn tangents<'a>(
    rule: i32,
    params: &[f64],
    dim: i32,
    points: impl Into<Records<'a>>,
    flags: u32,
) -> Result<Vec<f64>> {
    let points = points.into();
    let n = params.len();
    points.require(n, positive(dim), "points")?;
    let mut tangents = vec![0.0; n * positive(dim)];
    check(unsafe {
        sys::nurbs_tangents(
            rule,
            n as i64,
            params.as_ptr(),
            dim,
            points.pointer(),
            points.stride(),
            points.component_stride(),
            flags,
            tangents.as_mut_ptr(),
            0,
            0,
        )
    })?;
    Ok(tangents)
}

/// Parameters of data, and splines through them.
impl Spline {
    /// The spline through points on a grid of parameters; without ends, not-a-knot.
    pub fn interpolate<'a>(
        degrees: &[i32],
        counts: &[usize],
        params: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        ends: Option<&[i32]>,
        flags: u32,
    ) -> Result<Interpolated> {
        let points = points.into();
        let axes = degrees.len();
        let counts = counts_of(counts, axes, "counts")?;
        let ends = optional(ends, 2 * axes, "ends")?;
        let params = exactly(params, sum(&counts), "params")?;
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(product(&counts), positive(dim), "points")?;
        }
        let mut residual = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_interpolate(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                params,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                ends,
                flags,
                &mut residual,
                out,
            )
        })?;
        Ok(Interpolated { spline, residual })
    }

    /// The spline over full knot vectors, all axes one after the other, through points on a grid of
    /// parameters.
    pub fn interpolate_over_knots<'a>(
        degrees: &[i32],
        counts: &[usize],
        params: &[f64],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let counts = counts_of(counts, degrees.len(), "counts")?;
        let params = exactly(params, sum(&counts), "params")?;
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(product(&counts), positive(dim), "points")?;
        }
        Spline::made(|out| unsafe {
            sys::nurbs_interpolate_over_knots(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                params,
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
                out,
            )
        })
    }

    /// The spline through layers of points and, at the ends of axes, of derivatives; mixed ones may be NaN.
    pub fn interpolate_derivatives<'a>(
        degrees: &[i32],
        counts: &[usize],
        params: &[f64],
        orders: &[i32],
        dim: i32,
        values: impl Into<Records<'a>>,
        ends: Option<&[i32]>,
        flags: u32,
    ) -> Result<Spline> {
        let values = values.into();
        let axes = degrees.len();
        let counts = counts_of(counts, axes, "counts")?;
        let ends = optional(ends, 2 * axes, "ends")?;
        let params = exactly(params, sum(&counts), "params")?;
        let orders = if_given(orders, sum(&counts), "orders")?;
        // Another dimension is left to the library to name.
        if dim > 0 {
            values.require(product(&counts), positive(dim), "values")?;
        }
        Spline::made(|out| unsafe {
            sys::nurbs_interpolate_derivatives(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                params,
                orders,
                dim,
                values.pointer(),
                values.stride(),
                values.component_stride(),
                ends,
                flags,
                out,
            )
        })
    }

    /// The curve with given points and derivatives; without orders, points; without knots, averaged ones.
    pub fn curve_interpolate<'a>(
        degree: i32,
        params: &[f64],
        dim: i32,
        targets: impl Into<Records<'a>>,
        orders: &[i32],
        knots: &[f64],
        flags: u32,
    ) -> Result<Spline> {
        let targets = targets.into();
        let n = params.len();
        let orders = if_given(orders, n, "orders")?;
        targets.require(n, positive(dim), "targets")?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_interpolate(
                degree,
                n as i64,
                params.as_ptr(),
                orders,
                dim,
                targets.pointer(),
                targets.stride(),
                targets.component_stride(),
                knots.as_ptr(),
                knots.len() as i64,
                flags,
                out,
            )
        })
    }
}
