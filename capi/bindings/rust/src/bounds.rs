// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Boxes and cones that contain a spline, proven.

use crate::arrays::{exactly, if_given};
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;

/// Lower and upper ends `[dim]`, and how far a face is from the spline at most.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct BoundingBox {
    /// `[dim]`
    pub lower: Vec<f64>,
    /// `[dim]`
    pub upper: Vec<f64>,
    /// How far a face is from the spline at most.
    pub gap: f64,
}

/// The box of center + sum of x_k `axes[k]`, |x_k| <= `half[k]`.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct OrientedBox {
    /// `[dim]`
    pub center: Vec<f64>,
    /// Unit vectors `[dim][dim]`.
    pub axes: Vec<f64>,
    /// Half the extent along each of them.
    pub half: Vec<f64>,
}

/// A unit vector `[dim]`, and half the opening in radians; pi for all of space.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct DirectionCone {
    /// A unit vector.
    pub direction: Vec<f64>,
    /// Half the opening in radians; pi for all of space.
    pub angle: f64,
}

/// Parameters `[axes]` of a point, its component along a direction, and a bound of that of all others.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ExtremePoint {
    /// `[axes]`
    pub params: Vec<f64>,
    /// Its component along the direction.
    pub value: f64,
    /// A bound of that of all other points.
    pub bound: f64,
}

/// Boxes and cones that contain a spline, proven.
impl Spline {
    /// An axis-aligned box, tight to the tolerance; infinite: that of the Bezier points.
    pub fn bounding_box(&self, tolerance: f64, range: &[f64]) -> Result<BoundingBox> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let dim = self.dimension()? as usize;
        let mut lower = vec![0.0; dim];
        let mut upper = vec![0.0; dim];
        let mut gap = 0.0;
        check(unsafe {
            sys::nurbs_box(self.raw(), range, tolerance, lower.as_mut_ptr(), upper.as_mut_ptr(), &mut gap)
        })?;
        Ok(BoundingBox { lower, upper, gap })
    }

    /// A box with axes of its own.
    pub fn oriented_box(&self, tolerance: f64) -> Result<OrientedBox> {
        let dim = self.dimension()? as usize;
        let mut center = vec![0.0; dim];
        let mut axes = vec![0.0; dim * dim];
        let mut half = vec![0.0; dim];
        check(unsafe {
            sys::nurbs_oriented_box(
                self.raw(),
                tolerance,
                center.as_mut_ptr(),
                axes.as_mut_ptr(),
                half.as_mut_ptr(),
            )
        })?;
        Ok(OrientedBox { center, axes, half })
    }

    /// The directions of the derivatives along an axis.
    pub fn tangent_cone(&self, axis: i32, tolerance: f64, range: &[f64]) -> Result<DirectionCone> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut direction = vec![0.0; self.dimension()? as usize];
        let mut angle = 0.0;
        check(unsafe {
            sys::nurbs_tangent_cone(self.raw(), axis, range, tolerance, direction.as_mut_ptr(), &mut angle)
        })?;
        Ok(DirectionCone { direction, angle })
    }

    /// The directions of the normals of a surface in space.
    pub fn normal_cone(&self, tolerance: f64, range: &[f64]) -> Result<DirectionCone> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let mut direction = vec![0.0; 3];
        let mut angle = 0.0;
        check(unsafe {
            sys::nurbs_normal_cone(self.raw(), range, tolerance, direction.as_mut_ptr(), &mut angle)
        })?;
        Ok(DirectionCone { direction, angle })
    }

    /// The point that is farthest in a direction `[dim]`.
    pub fn extreme_point(&self, direction: &[f64], tolerance: f64, range: &[f64]) -> Result<ExtremePoint> {
        let direction = exactly(direction, self.dimension()? as usize, "direction")?;
        let axes = self.axes()? as usize;
        let range = if_given(range, 2 * axes, "range")?;
        let mut params = vec![0.0; axes];
        let mut value = 0.0;
        let mut bound = 0.0;
        check(unsafe {
            sys::nurbs_extreme_point(
                self.raw(),
                direction,
                range,
                tolerance,
                params.as_mut_ptr(),
                &mut value,
                &mut bound,
            )
        })?;
        Ok(ExtremePoint { params, value, bound })
    }
}
