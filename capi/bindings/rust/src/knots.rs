// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Knot generators, span search and basis functions: what needs knots but no spline.

use crate::arrays::{optional, Records};
use crate::error::{check, Result};
use crate::eval::Basis;
use crate::sizes::{basis_width, bezier_count, knot_count, periodic_count};
use crate::sys;
use std::ptr::null;

/// Uniform unclamped knots with the domain [a, b].
pub fn knots_uniform(degree: i32, count: usize, a: f64, b: f64) -> Result<Vec<f64>> {
    let size = knot_count(degree, count);
    let mut knots = vec![0.0; size];
    check(unsafe { sys::nurbs_knots_uniform(degree, count as i64, a, b, size as i64, knots.as_mut_ptr()) })?;
    Ok(knots)
}

/// Clamped knots, evenly spaced between a and b.
pub fn knots_open_uniform(degree: i32, count: usize, a: f64, b: f64) -> Result<Vec<f64>> {
    let size = knot_count(degree, count);
    let mut knots = vec![0.0; size];
    check(unsafe {
        sys::nurbs_knots_open_uniform(degree, count as i64, a, b, size as i64, knots.as_mut_ptr())
    })?;
    Ok(knots)
}

/// Piecewise Bezier knots with the breaks 0, 1/pieces, ..., 1.
pub fn knots_bezier(degree: i32, pieces: usize) -> Result<Vec<f64>> {
    let size = knot_count(degree, bezier_count(degree, pieces));
    let mut knots = vec![0.0; size];
    check(unsafe {
        sys::nurbs_knots_bezier(degree, pieces as i64, null(), size as i64, knots.as_mut_ptr())
    })?;
    Ok(knots)
}

/// Piecewise Bezier knots with given breaks.
pub fn knots_bezier_breaks(degree: i32, breaks: &[f64]) -> Result<Vec<f64>> {
    let pieces = breaks.len().saturating_sub(1);
    let size = knot_count(degree, bezier_count(degree, pieces));
    let mut knots = vec![0.0; size];
    check(unsafe {
        sys::nurbs_knots_bezier(degree, pieces as i64, breaks.as_ptr(), size as i64, knots.as_mut_ptr())
    })?;
    Ok(knots)
}

/// Clamped knots averaged from parameters, for interpolation.
pub fn knots_averaged(degree: i32, params: &[f64]) -> Result<Vec<f64>> {
    let count = params.len();
    let size = knot_count(degree, count);
    let mut knots = vec![0.0; size];
    check(unsafe {
        sys::nurbs_knots_averaged(degree, count as i64, params.as_ptr(), size as i64, knots.as_mut_ptr())
    })?;
    Ok(knots)
}

/// Periodic knots from the breaks of one period; without multiplicities each break is simple.
pub fn knots_periodic(degree: i32, breaks: &[f64], times: Option<&[i32]>) -> Result<Vec<f64>> {
    let n = breaks.len();
    let multiplicities = optional(times, n, "multiplicities")?;
    let size = knot_count(degree, periodic_count(degree, breaks, times));
    let mut knots = vec![0.0; size];
    check(unsafe {
        sys::nurbs_knots_periodic(
            degree,
            n as i64,
            breaks.as_ptr(),
            multiplicities,
            size as i64,
            knots.as_mut_ptr(),
        )
    })?;
    Ok(knots)
}

/// The span of each parameter in a full knot vector.
pub fn find_spans<'a>(
    degree: i32,
    knots: &[f64],
    params: impl Into<Records<'a>>,
    flags: u32,
) -> Result<Vec<i64>> {
    let params = params.into();
    let n = params.count(1, "params")?;
    let mut spans = vec![0; n];
    check(unsafe {
        sys::nurbs_find_spans(
            degree,
            knots.len() as i64 - i64::from(degree) - 1,
            knots.as_ptr(),
            knots.len() as i64,
            n as i64,
            params.pointer(),
            params.step(),
            spans.as_mut_ptr(),
            flags,
        )
    })?;
    Ok(spans)
}

/// Bernstein polynomials and derivatives, `[n][order + 1][degree + 1]`.
pub fn bernstein<'a>(degree: i32, order: i32, params: impl Into<Records<'a>>) -> Result<Vec<f64>> {
    let params = params.into();
    let n = params.count(1, "params")?;
    let mut values = vec![0.0; n * basis_width(degree, order)];
    check(unsafe {
        sys::nurbs_bernstein(
            degree,
            order,
            n as i64,
            params.pointer(),
            params.step(),
            values.as_mut_ptr(),
            0,
            0,
        )
    })?;
    Ok(values)
}

/// B-spline basis functions and derivatives, `[n][order + 1][degree + 1]`, and the span of each parameter.
pub fn basis<'a>(
    degree: i32,
    knots: &[f64],
    order: i32,
    params: impl Into<Records<'a>>,
    flags: u32,
) -> Result<Basis> {
    let params = params.into();
    let n = params.count(1, "params")?;
    let mut spans = vec![0; n];
    let mut values = vec![0.0; n * basis_width(degree, order)];
    check(unsafe {
        sys::nurbs_basis(
            degree,
            knots.len() as i64 - i64::from(degree) - 1,
            knots.as_ptr(),
            knots.len() as i64,
            order,
            n as i64,
            params.pointer(),
            params.step(),
            spans.as_mut_ptr(),
            values.as_mut_ptr(),
            0,
            0,
            flags,
        )
    })?;
    Ok(Basis { spans, values })
}
