// SPDX-License-Identifier: MIT
//! Questions about a spline.

use crate::error::{check, value, Result};
use crate::spline::{DistinctKnots, Spline};
use crate::sys;
use std::ptr::null_mut;

impl Spline {
    /// Number of parametric axes: 1, 2 or 3.
    pub fn axes(&self) -> Result<i32> {
        value(|v| unsafe { sys::nurbs_axes(self.raw(), v) })
    }
    /// Number of coordinates of a point.
    pub fn dimension(&self) -> Result<i32> {
        value(|v| unsafe { sys::nurbs_dimension(self.raw(), v) })
    }
    /// Degree along an axis.
    pub fn degree(&self, axis: i32) -> Result<i32> {
        value(|v| unsafe { sys::nurbs_degree(self.raw(), axis, v) })
    }
    /// Number of control points along an axis.
    pub fn count(&self, axis: i32) -> Result<usize> {
        let count = value(|v: *mut i64| unsafe { sys::nurbs_count(self.raw(), axis, v) })?;
        Ok(count as usize)
    }
    /// Number of control points of all axes together.
    pub fn point_count(&self) -> Result<usize> {
        let count = value(|v: *mut i64| unsafe { sys::nurbs_point_count(self.raw(), v) })?;
        Ok(count as usize)
    }
    /// Whether it has weights.
    pub fn is_rational(&self) -> Result<bool> {
        let rational = value(|v: *mut i32| unsafe { sys::nurbs_is_rational(self.raw(), v) })?;
        Ok(rational != 0)
    }
    /// Whether homogeneous points are stored, and not Cartesian ones with or without weights.
    pub fn is_homogeneous(&self) -> Result<bool> {
        let homogeneous = value(|v: *mut i32| unsafe { sys::nurbs_is_homogeneous(self.raw(), v) })?;
        Ok(homogeneous != 0)
    }
    /// Sum of `NURBS_FORM_` bits.
    pub fn knot_form(&self, axis: i32) -> Result<i32> {
        value(|v| unsafe { sys::nurbs_knot_form(self.raw(), axis, v) })
    }
    /// The ends of the domain of an axis.
    pub fn domain(&self, axis: i32) -> Result<[f64; 2]> {
        value(|v: *mut [f64; 2]| unsafe { sys::nurbs_domain(self.raw(), axis, v.cast()) })
    }
    /// The full knot vector.
    pub fn knots(&self, axis: i32) -> Result<Vec<f64>> {
        let size = self.count(axis)? + self.degree(axis)? as usize + 1;
        filled(size, |v| unsafe { sys::nurbs_knots(self.raw(), axis, size as i64, v) })
    }
    /// The knots without repetition, and how often each occurs.
    pub fn distinct_knots(&self, axis: i32) -> Result<DistinctKnots> {
        let g = self.raw();
        let size =
            value(|v: *mut i64| unsafe { sys::nurbs_distinct_knots(g, axis, 0, null_mut(), null_mut(), v) })?;
        let mut knots = vec![0.0; size as usize];
        let mut multiplicities = vec![0; size as usize];
        let (k, m) = (knots.as_mut_ptr(), multiplicities.as_mut_ptr());
        value(|v: *mut i64| unsafe { sys::nurbs_distinct_knots(g, axis, size, k, m, v) })?;
        Ok(DistinctKnots { knots, multiplicities })
    }
    /// The Greville abscissa of each control point along an axis.
    pub fn greville(&self, axis: i32) -> Result<Vec<f64>> {
        let size = self.count(axis)?;
        filled(size, |v| unsafe { sys::nurbs_greville(self.raw(), axis, size as i64, v) })
    }
    /// Cartesian control points, `[n][dim]`.
    pub fn points(&self) -> Result<Vec<f64>> {
        let n = self.point_count()?;
        let size = n * self.dimension()? as usize;
        filled(size, |v| unsafe { sys::nurbs_points(self.raw(), n as i64, v, 0, 0) })
    }
    /// Weights, all 1 for a polynomial spline.
    pub fn weights(&self) -> Result<Vec<f64>> {
        let n = self.point_count()?;
        filled(n, |v| unsafe { sys::nurbs_weights(self.raw(), n as i64, v, 0) })
    }
    /// Homogeneous control points, `[n][dim + 1]`.
    pub fn homogeneous_points(&self) -> Result<Vec<f64>> {
        let n = self.point_count()?;
        let size = n * (self.dimension()? as usize + 1);
        filled(size, |v| unsafe { sys::nurbs_homogeneous_points(self.raw(), n as i64, v, 0, 0) })
    }
}

fn filled(size: usize, fill: impl FnOnce(*mut f64) -> i32) -> Result<Vec<f64>> {
    let mut values = vec![0.0; size];
    check(fill(values.as_mut_ptr()))?;
    Ok(values)
}
