// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Questions about a spline.

use crate::arrays::Records;
use crate::error::{check, value, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Knots without repetition.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DistinctKnots {
    /// In rising order.
    pub knots: Vec<f64>,
    /// How often each of them occurs.
    pub multiplicities: Vec<i32>,
}

/// Control points, each once.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct UnwrappedPoints {
    /// Cartesian, `[n][dim]`.
    pub points: Vec<f64>,
    /// All 1 for a polynomial spline.
    pub weights: Vec<f64>,
}

/// Questions about a spline.
impl Spline {
    /// Number of parametric axes: 1, 2 or 3.
    pub fn axes(&self) -> Result<i32> {
        value(|axes| unsafe { sys::nurbs_axes(self.raw(), axes) })
    }

    /// Number of coordinates of a point.
    pub fn dimension(&self) -> Result<i32> {
        value(|dim| unsafe { sys::nurbs_dimension(self.raw(), dim) })
    }

    /// Degree along an axis.
    pub fn degree(&self, axis: i32) -> Result<i32> {
        value(|degree| unsafe { sys::nurbs_degree(self.raw(), axis, degree) })
    }

    /// Number of control points along an axis.
    pub fn count(&self, axis: i32) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::nurbs_count(self.raw(), axis, &mut count) })?;
        Ok(count as usize)
    }

    /// Number of control points of all axes together.
    pub fn point_count(&self) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::nurbs_point_count(self.raw(), &mut count) })?;
        Ok(count as usize)
    }

    /// Whether it has weights.
    pub fn is_rational(&self) -> Result<bool> {
        let mut rational = 0;
        check(unsafe { sys::nurbs_is_rational(self.raw(), &mut rational) })?;
        Ok(rational != 0)
    }

    /// Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    pub fn is_homogeneous(&self) -> Result<bool> {
        let mut homogeneous = 0;
        check(unsafe { sys::nurbs_is_homogeneous(self.raw(), &mut homogeneous) })?;
        Ok(homogeneous != 0)
    }

    /// Sum of `NURBS_FORM_` bits.
    pub fn knot_form(&self, axis: i32) -> Result<i32> {
        value(|form| unsafe { sys::nurbs_knot_form(self.raw(), axis, form) })
    }

    /// The ends of the domain of an axis.
    pub fn domain(&self, axis: i32) -> Result<[f64; 2]> {
        let mut domain = [0.0; 2];
        check(unsafe { sys::nurbs_domain(self.raw(), axis, domain.as_mut_ptr()) })?;
        Ok(domain)
    }

    /// The full knot vector.
    pub fn knots(&self, axis: i32) -> Result<Vec<f64>> {
        let size = self.count(axis)? + self.degree(axis)? as usize + 1;
        let mut knots = vec![0.0; size];
        check(unsafe { sys::nurbs_knots(self.raw(), axis, size as i64, knots.as_mut_ptr()) })?;
        Ok(knots)
    }

    /// The knot vector without its first and last knot.
    pub fn short_knots(&self, axis: i32) -> Result<Vec<f64>> {
        let fill = |cap, knots, count| unsafe { sys::nurbs_short_knots(self.raw(), axis, cap, knots, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut knots = vec![0.0; n];
        check(fill(count, knots.as_mut_ptr(), &mut count))?;
        Ok(knots)
    }

    /// Number of control points along an axis, each counted once.
    pub fn unwrapped_count(&self, axis: i32) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::nurbs_unwrapped_count(self.raw(), axis, &mut count) })?;
        Ok(count as usize)
    }

    /// The knots of one period with its end; of an axis that is not periodic all of them.
    pub fn unwrapped_knots(&self, axis: i32) -> Result<Vec<f64>> {
        let fill =
            |cap, knots, count| unsafe { sys::nurbs_unwrapped_knots(self.raw(), axis, cap, knots, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut knots = vec![0.0; n];
        check(fill(count, knots.as_mut_ptr(), &mut count))?;
        Ok(knots)
    }

    /// Control points and weights, each once.
    pub fn unwrapped_points(&self) -> Result<UnwrappedPoints> {
        let fill = |cap, points, weights, count| unsafe {
            sys::nurbs_unwrapped_points(self.raw(), cap, points, weights, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut points = vec![0.0; n * self.dimension()? as usize];
        let mut weights = vec![0.0; n];
        check(fill(count, points.as_mut_ptr(), weights.as_mut_ptr(), &mut count))?;
        Ok(UnwrappedPoints { points, weights })
    }

    /// The knots without repetition, and how often each occurs.
    pub fn distinct_knots(&self, axis: i32) -> Result<DistinctKnots> {
        let fill = |cap, knots, multiplicities, count| unsafe {
            sys::nurbs_distinct_knots(self.raw(), axis, cap, knots, multiplicities, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut knots = vec![0.0; n];
        let mut multiplicities = vec![0; n];
        check(fill(count, knots.as_mut_ptr(), multiplicities.as_mut_ptr(), &mut count))?;
        Ok(DistinctKnots { knots, multiplicities })
    }

    /// The Greville abscissa of each control point along an axis.
    pub fn greville(&self, axis: i32) -> Result<Vec<f64>> {
        let size = self.count(axis)?;
        let mut abscissae = vec![0.0; size];
        check(unsafe { sys::nurbs_greville(self.raw(), axis, size as i64, abscissae.as_mut_ptr()) })?;
        Ok(abscissae)
    }

    /// Cartesian control points, `[n][dim]`.
    pub fn points(&self) -> Result<Vec<f64>> {
        let size = self.point_count()?;
        let mut points = vec![0.0; size * self.dimension()? as usize];
        check(unsafe { sys::nurbs_points(self.raw(), size as i64, points.as_mut_ptr(), 0, 0) })?;
        Ok(points)
    }

    /// Weights, all 1 for a polynomial spline.
    pub fn weights(&self) -> Result<Vec<f64>> {
        let size = self.point_count()?;
        let mut weights = vec![0.0; size];
        check(unsafe { sys::nurbs_weights(self.raw(), size as i64, weights.as_mut_ptr(), 0) })?;
        Ok(weights)
    }

    /// Homogeneous control points, `[n][dim + 1]`.
    pub fn homogeneous_points(&self) -> Result<Vec<f64>> {
        let size = self.point_count()?;
        let mut points = vec![0.0; size * (self.dimension()? as usize + 1)];
        check(unsafe { sys::nurbs_homogeneous_points(self.raw(), size as i64, points.as_mut_ptr(), 0, 0) })?;
        Ok(points)
    }

    /// The `hull` of the accuracy contract at each parameter.
    pub fn hull_size<'a>(&self, params: impl Into<Records<'a>>, flags: u32) -> Result<Vec<f64>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut sizes = vec![0.0; n];
        check(unsafe {
            sys::nurbs_hull_size(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                sizes.as_mut_ptr(),
                0,
                flags,
            )
        })?;
        Ok(sizes)
    }
}
