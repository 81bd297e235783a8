// SPDX-License-Identifier: MIT
//! Knot vectors, span search and basis functions: what needs knots but no spline.

use crate::arrays::Records;
use crate::error::{check, Error, Result};
use crate::sys;

/// Active basis functions at parameters: where they start, and their values.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Basis {
    /// The span of each parameter.
    pub spans: Vec<i64>,
    /// Of the functions that are active there.
    pub values: Vec<f64>,
}

/// Knots of `count` control points. A degree that the library refuses gets no memory.
fn generated(degree: i32, count: usize, fill: impl FnOnce(i64, *mut f64) -> i32) -> Result<Vec<f64>> {
    let sane = (0..=sys::NURBS_MAX_DEGREE).contains(&degree) && count < 1 << 48;
    let mut knots = vec![0.0; if sane { count + degree as usize + 1 } else { 0 }];
    check(fill(knots.len() as i64, knots.as_mut_ptr()))?;
    Ok(knots)
}

/// Uniform unclamped knots with the domain [a, b].
pub fn knots_uniform(degree: i32, count: usize, a: f64, b: f64) -> Result<Vec<f64>> {
    generated(degree, count, |size, knots| unsafe {
        sys::nurbs_knots_uniform(degree, count as i64, a, b, size, knots)
    })
}

/// Clamped knots, evenly spaced between a and b.
pub fn knots_open_uniform(degree: i32, count: usize, a: f64, b: f64) -> Result<Vec<f64>> {
    generated(degree, count, |size, knots| unsafe {
        sys::nurbs_knots_open_uniform(degree, count as i64, a, b, size, knots)
    })
}

fn bezier_count(degree: i32, pieces: usize) -> usize {
    match degree {
        0 => pieces,
        _ => pieces.saturating_mul(degree.max(0) as usize).saturating_add(1),
    }
}

/// Piecewise Bezier knots with the breaks 0, 1/pieces, ..., 1.
pub fn knots_bezier(degree: i32, pieces: usize) -> Result<Vec<f64>> {
    generated(degree, bezier_count(degree, pieces), |size, knots| unsafe {
        sys::nurbs_knots_bezier(degree, pieces as i64, std::ptr::null(), size, knots)
    })
}

/// Piecewise Bezier knots with given breaks.
pub fn knots_bezier_breaks(degree: i32, breaks: &[f64]) -> Result<Vec<f64>> {
    let pieces = breaks.len().saturating_sub(1);
    generated(degree, bezier_count(degree, pieces), |size, knots| unsafe {
        sys::nurbs_knots_bezier(degree, pieces as i64, breaks.as_ptr(), size, knots)
    })
}

/// Clamped knots averaged from parameters, for interpolation.
pub fn knots_averaged(degree: i32, params: &[f64]) -> Result<Vec<f64>> {
    generated(degree, params.len(), |size, knots| unsafe {
        sys::nurbs_knots_averaged(degree, params.len() as i64, params.as_ptr(), size, knots)
    })
}

/// Periodic knots from the breaks of one period; without multiplicities each break is simple.
pub fn knots_periodic(degree: i32, breaks: &[f64], times: Option<&[i32]>) -> Result<Vec<f64>> {
    let distinct: i64 = match times {
        Some(t) if t.len() != breaks.len() => {
            return Err(Error::size("multiplicities", t.len(), breaks.len().to_string()));
        }
        Some(t) => t.iter().rev().skip(1).map(|&m| i64::from(m)).sum(),
        None => breaks.len() as i64 - 1,
    };
    let count = distinct.max(0) as usize + degree.max(0) as usize;
    let times = times.map_or(std::ptr::null(), <[i32]>::as_ptr);
    generated(degree, count, |size, knots| unsafe {
        sys::nurbs_knots_periodic(degree, breaks.len() as i64, breaks.as_ptr(), times, size, knots)
    })
}

fn control_points(degree: i32, knots: &[f64]) -> i64 {
    knots.len() as i64 - i64::from(degree) - 1
}

/// Values per parameter; 1 where the library will refuse the degree or the order.
fn basis_width(degree: i32, order: i32) -> usize {
    let sane = (0..=sys::NURBS_MAX_DEGREE).contains(&degree);
    let sane = sane && (0..=sys::NURBS_MAX_ORDER).contains(&order);
    if sane {
        (order as usize + 1) * (degree as usize + 1)
    } else {
        1
    }
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
    let (count, size) = (control_points(degree, knots), knots.len() as i64);
    check(unsafe {
        sys::nurbs_find_spans(
            degree,
            count,
            knots.as_ptr(),
            size,
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
    let (count, size) = (control_points(degree, knots), knots.len() as i64);
    check(unsafe {
        sys::nurbs_basis(
            degree,
            count,
            knots.as_ptr(),
            size,
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
