// SPDX-License-Identifier: MIT
//! Changes of weights and control points, and knots that make points of the polygon control points.

use crate::arrays::{exactly, Records};
use crate::error::{check, value, Result};
use crate::placement::require_length;
use crate::spline::Spline;
use crate::sys;

/// The points `[dim]` at a parameter for the weights 0, 1 and the present one.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct WeightPoints {
    /// For the weight 0.
    pub at_zero: Vec<f64>,
    /// For the weight 1.
    pub at_one: Vec<f64>,
    /// For the present weight.
    pub at_weight: Vec<f64>,
}

/// A control point, and its R_i.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Influence {
    /// Of the control point.
    pub index: i64,
    /// How far the point moves with it.
    pub influence: f64,
}

/// The spline, the leg by the control point where it starts, the place on it, and the knot.
#[derive(Debug)]
#[non_exhaustive]
pub struct LegEdit {
    /// With one knot more.
    pub spline: Spline,
    /// Of the control point where the leg starts.
    pub index: i64,
    /// The place on the leg, from 0 to 1.
    pub ratio: f64,
    /// The knot inserted.
    pub knot: f64,
}

/// The weight from a control point and the three points of `Spline::weight_points`.
pub fn weight_cross_ratio(
    control_point: &[f64],
    at_zero: &[f64],
    at_one: &[f64],
    at_weight: &[f64],
) -> Result<f64> {
    let dim = control_point.len() as i32;
    require_length(dim, &[at_zero, at_one, at_weight])?;
    let (p, zero, one) = (control_point.as_ptr(), at_zero.as_ptr(), at_one.as_ptr());
    value(|v| unsafe { sys::nurbs_weight_cross_ratio(dim, p, zero, one, at_weight.as_ptr(), v) })
}

/// Weights and control points. The number beside a new spline is the weight, the factor of the weights, or how far the
/// control point moved.
impl Spline {
    fn at(&self, params: &[f64]) -> Result<*const f64> {
        exactly(params, self.axes()? as usize, "params")
    }
    pub(crate) fn vector(&self, values: &[f64], what: &str) -> Result<*const f64> {
        exactly(values, self.dimension()? as usize, what)
    }

    /// A weight changed so that the point at `params` moves by a distance towards the control point.
    pub fn pull_weight(&self, index: i64, params: &[f64], distance: f64) -> Result<(Spline, f64)> {
        let (g, at, mut weight) = (self.raw(), self.at(params)?, 0.0);
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_pull_weight(g, index, at, distance, &mut weight, out) })?;
        Ok((spline, weight))
    }
    /// Several weights multiplied by one factor, so that the point moves towards their common centre.
    pub fn pull_weights(&self, indices: &[i64], params: &[f64], distance: f64) -> Result<(Spline, f64)> {
        let (g, at, mut factor) = (self.raw(), self.at(params)?, 0.0);
        let (count, first) = (indices.len() as i64, indices.as_ptr());
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_pull_weights(g, count, first, at, distance, &mut factor, out)
        })?;
        Ok((spline, factor))
    }
    /// The weights of some control points set.
    pub fn set_weights(&self, indices: &[i64], weights: &[f64]) -> Result<Spline> {
        let (count, first) = (indices.len() as i64, indices.as_ptr());
        let values = exactly(weights, indices.len(), "weights")?;
        Spline::made(|out| unsafe { sys::nurbs_set_weights(self.raw(), count, first, values, out) })
    }
    /// The points at a parameter for the weights 0, 1 and the present one of a control point.
    pub fn weight_points(&self, index: i64, params: &[f64]) -> Result<WeightPoints> {
        let (at, dim) = (self.at(params)?, self.dimension()? as usize);
        let (mut at_zero, mut at_one, mut at_weight) = (vec![0.0; dim], vec![0.0; dim], vec![0.0; dim]);
        let (zero, one, now) = (at_zero.as_mut_ptr(), at_one.as_mut_ptr(), at_weight.as_mut_ptr());
        check(unsafe { sys::nurbs_weight_points(self.raw(), index, at, zero, one, now) })?;
        Ok(WeightPoints { at_zero, at_one, at_weight })
    }
    /// A weight set so that the point at `params` becomes the target.
    pub fn weight_through(
        &self,
        index: i64,
        params: &[f64],
        target: &[f64],
        tolerance: f64,
    ) -> Result<(Spline, f64)> {
        let (g, at, to) = (self.raw(), self.at(params)?, self.vector(target, "target")?);
        let mut weight = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_weight_through(g, index, at, to, tolerance, &mut weight, out)
        })?;
        Ok((spline, weight))
    }
    /// A control point moved so that the point at `params` moves by a distance along a direction.
    pub fn pull_point(
        &self,
        index: i64,
        params: &[f64],
        direction: &[f64],
        distance: f64,
    ) -> Result<(Spline, f64)> {
        let (g, at, along) = (self.raw(), self.at(params)?, self.vector(direction, "direction")?);
        let mut moved = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_pull_point(g, index, at, along, distance, &mut moved, out)
        })?;
        Ok((spline, moved))
    }
    /// The control point with the largest |R_i| at each of `params`.
    pub fn most_influential<'a>(&self, params: impl Into<Records<'a>>) -> Result<Vec<Influence>> {
        let (g, p) = (self.raw(), params.into());
        let n = p.count(self.axes()? as usize, "params")?;
        let (mut indices, mut influences) = (vec![0; n], vec![0.0; n]);
        let (first, stride, component_stride) = (p.pointer(), p.stride(), p.component_stride());
        let (index, influence) = (indices.as_mut_ptr(), influences.as_mut_ptr());
        check(unsafe {
            sys::nurbs_most_influential(g, n as i64, first, stride, component_stride, index, influence)
        })?;
        let pairs = indices.into_iter().zip(influences);
        Ok(pairs.map(|(index, influence)| Influence { index, influence }).collect())
    }

    /// The knot inserted that makes a point of a leg of the control polygon a control point.
    pub fn insert_on_leg(&self, axis: i32, index: i64, ratio: f64) -> Result<LegEdit> {
        let (g, mut knot) = (self.raw(), 0.0);
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_insert_on_leg(g, axis, index, ratio, &mut knot, out) })?;
        Ok(LegEdit { spline, index, ratio, knot })
    }
    /// The same for the point on the leg that is nearest to the one given.
    pub fn insert_at_point(&self, axis: i32, point: &[f64], tolerance: f64) -> Result<LegEdit> {
        let (g, at) = (self.raw(), self.vector(point, "point")?);
        let (mut index, mut ratio, mut knot) = (0, 0.0, 0.0);
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_insert_at_point(g, axis, at, tolerance, &mut index, &mut ratio, &mut knot, out)
        })?;
        Ok(LegEdit { spline, index, ratio, knot })
    }
}
