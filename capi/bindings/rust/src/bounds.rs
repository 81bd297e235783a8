// SPDX-License-Identifier: MIT
//! Boxes and cones that contain a spline, proven.

use crate::arrays::exactly;
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

/// The box of `center + sum of x_k axes[k]`, where `|x_k| <= half[k]`.
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

/// Bounds. A range is a part `[axes][2]` of the domain, empty for all of it.
impl Spline {
    /// An axis-aligned box, tight to the tolerance; infinite: that of the Bezier points.
    pub fn bounding_box(&self, tolerance: f64, range: &[f64]) -> Result<BoundingBox> {
        let (g, dim, part) = (self.raw(), self.dimension()? as usize, self.range(range)?);
        let (mut lower, mut upper, mut gap) = (vec![0.0; dim], vec![0.0; dim], 0.0);
        let (low, high) = (lower.as_mut_ptr(), upper.as_mut_ptr());
        check(unsafe { sys::nurbs_box(g, part, tolerance, low, high, &mut gap) })?;
        Ok(BoundingBox { lower, upper, gap })
    }
    /// A box with axes of its own.
    pub fn oriented_box(&self, tolerance: f64) -> Result<OrientedBox> {
        let dim = self.dimension()? as usize;
        let (mut center, mut axes, mut half) = (vec![0.0; dim], vec![0.0; dim * dim], vec![0.0; dim]);
        let (c, a, h) = (center.as_mut_ptr(), axes.as_mut_ptr(), half.as_mut_ptr());
        check(unsafe { sys::nurbs_oriented_box(self.raw(), tolerance, c, a, h) })?;
        Ok(OrientedBox { center, axes, half })
    }
    /// The directions of the derivatives along an axis.
    pub fn tangent_cone(&self, axis: i32, tolerance: f64, range: &[f64]) -> Result<DirectionCone> {
        let (g, part) = (self.raw(), self.range(range)?);
        let (mut direction, mut angle) = (vec![0.0; self.dimension()? as usize], 0.0);
        let d = direction.as_mut_ptr();
        check(unsafe { sys::nurbs_tangent_cone(g, axis, part, tolerance, d, &mut angle) })?;
        Ok(DirectionCone { direction, angle })
    }
    /// The directions of the normals of a surface in space.
    pub fn normal_cone(&self, tolerance: f64, range: &[f64]) -> Result<DirectionCone> {
        let (g, part) = (self.raw(), self.range(range)?);
        let (mut direction, mut angle) = (vec![0.0; 3], 0.0);
        check(unsafe { sys::nurbs_normal_cone(g, part, tolerance, direction.as_mut_ptr(), &mut angle) })?;
        Ok(DirectionCone { direction, angle })
    }
    /// The point that is farthest in a direction.
    pub fn extreme_point(&self, direction: &[f64], tolerance: f64, range: &[f64]) -> Result<ExtremePoint> {
        let (g, part) = (self.raw(), self.range(range)?);
        let along = exactly(direction, self.dimension()? as usize, "direction")?;
        let mut found = ExtremePoint { params: vec![0.0; self.axes()? as usize], ..ExtremePoint::default() };
        let (params, value, bound) = (found.params.as_mut_ptr(), &mut found.value, &mut found.bound);
        check(unsafe { sys::nurbs_extreme_point(g, along, part, tolerance, params, value, bound) })?;
        Ok(found)
    }
}
