// SPDX-License-Identifier: MIT
//! Lengths of arrays that follow from numbers and from other arrays. None overflows: what is too large for the memory is
//! left to the library to refuse.

use crate::error::Result;
use crate::eval::derivative_slots;
use crate::spline::Spline;
use crate::sys;

/// A number, or 0 if it is negative.
pub(crate) fn positive(number: impl Into<i64>) -> usize {
    number.into().max(0) as usize
}

pub(crate) fn times(factors: &[usize]) -> usize {
    factors.iter().fold(1, |product, &factor| product.saturating_mul(factor))
}

pub(crate) fn product(counts: &[i64]) -> usize {
    counts.iter().fold(1, |product, &count| product.saturating_mul(positive(count)))
}

pub(crate) fn sum(counts: &[i64]) -> usize {
    counts.iter().fold(0, |sum, &count| sum.saturating_add(positive(count)))
}

/// Number of axes that degrees stand for. More than the library takes is as good as any number of them.
pub(crate) fn axes_of<T>(by_axis: &[T]) -> i32 {
    by_axis.len().min(sys::NURBS_MAX_AXES as usize + 1) as i32
}

/// Control points of one Bezier piece.
pub(crate) fn bezier_points(degrees: &[i32]) -> usize {
    degrees.iter().fold(1, |product, &degree| product.saturating_mul(positive(degree) + 1))
}

/// 1 if there are homogeneous records.
pub(crate) fn homogeneous(flags: u32) -> usize {
    usize::from(flags & sys::NURBS_HOMOGENEOUS != 0)
}

fn is_degree(degree: i32) -> bool {
    (0..=sys::NURBS_MAX_DEGREE).contains(&degree)
}

/// Knots of `count` control points. What the library refuses gets no memory.
pub(crate) fn knot_count(degree: i32, count: usize) -> usize {
    if is_degree(degree) && count < 1 << 48 {
        count + degree as usize + 1
    } else {
        0
    }
}

/// Control points of a piecewise Bezier curve.
pub(crate) fn bezier_count(degree: i32, pieces: usize) -> usize {
    match degree {
        0 => pieces,
        _ => pieces.saturating_mul(positive(degree)).saturating_add(1),
    }
}

/// Control points of a periodic curve; without multiplicities each break is simple.
pub(crate) fn periodic_count(degree: i32, breaks: &[f64], multiplicities: Option<&[i32]>) -> usize {
    let distinct: i64 = match multiplicities {
        Some(times) => times.iter().rev().skip(1).map(|&times| i64::from(times)).sum(),
        None => breaks.len() as i64 - 1,
    };
    positive(distinct) + positive(degree)
}

/// Values for each parameter; 1 where the library will refuse the degree or the order.
pub(crate) fn basis_width(degree: i32, order: i32) -> usize {
    if is_degree(degree) && (0..=sys::NURBS_MAX_ORDER).contains(&order) {
        (order as usize + 1) * (degree as usize + 1)
    } else {
        1
    }
}

/// Elements of a square matrix; 0 where the library refuses the degree.
pub(crate) fn matrix_size(degree: i32) -> usize {
    if is_degree(degree) {
        (degree as usize + 1).pow(2)
    } else {
        0
    }
}

/// Coefficients of a polynomial in the coordinates; 0 where the library refuses the degree.
pub(crate) fn monomials(dim: usize, degree: i32) -> usize {
    if !(1..=8).contains(&degree) {
        return 0;
    }
    let count = (1..=degree as u128).try_fold(1u128, |count, i| Some(count.checked_mul(dim as u128 + i)? / i));
    count.and_then(|count| usize::try_from(count).ok()).unwrap_or(0)
}

impl Spline {
    /// The number of derivatives up to an order.
    pub(crate) fn slots(&self, order: i32) -> Result<usize> {
        derivative_slots(self.axes()?, order)
    }

    /// The number of basis functions that are not 0 at a parameter.
    pub(crate) fn active(&self) -> Result<usize> {
        let mut active = 1;
        for axis in 0..self.axes()? {
            active *= self.degree(axis)? as usize + 1;
        }
        Ok(active)
    }
}
