// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
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
#[derive(Clone, Debug, PartialEq)]
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

/// The weight from a control point and the three points of `Spline::weight_points`, all of one dimension.
pub fn weight_cross_ratio(
    control_point: &[f64],
    at_zero: &[f64],
    at_one: &[f64],
    at_weight: &[f64],
) -> Result<f64> {
    let dim = control_point.len() as i32;
    require_length(dim, &[at_zero, at_one, at_weight])?;
    value(|weight| unsafe {
        sys::nurbs_weight_cross_ratio(
            dim,
            control_point.as_ptr(),
            at_zero.as_ptr(),
            at_one.as_ptr(),
            at_weight.as_ptr(),
            weight,
        )
    })
}

/// Changes of weights and control points, and knots that make points of the polygon control points.
impl Spline {
    /// A weight changed so that the point at `params` `[axes]` moves by a distance towards the control point;
    /// and that weight.
    pub fn pull_weight(&self, index: i64, params: &[f64], distance: f64) -> Result<(Spline, f64)> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let mut weight = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_pull_weight(self.raw(), index, params, distance, &mut weight, out)
        })?;
        Ok((spline, weight))
    }

    /// Several weights multiplied by one factor, so that the point moves towards their common centre; and
    /// that factor.
    pub fn pull_weights(&self, indices: &[i64], params: &[f64], distance: f64) -> Result<(Spline, f64)> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let mut factor = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_pull_weights(
                self.raw(),
                indices.len() as i64,
                indices.as_ptr(),
                params,
                distance,
                &mut factor,
                out,
            )
        })?;
        Ok((spline, factor))
    }

    /// The weights of some control points set.
    pub fn set_weights(&self, indices: &[i64], weights: &[f64]) -> Result<Spline> {
        let count = indices.len();
        let weights = exactly(weights, count, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_set_weights(self.raw(), count as i64, indices.as_ptr(), weights, out)
        })
    }

    /// The points at a parameter for the weights 0, 1 and the present one of a control point.
    pub fn weight_points(&self, index: i64, params: &[f64]) -> Result<WeightPoints> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let dim = self.dimension()? as usize;
        let mut at_zero = vec![0.0; dim];
        let mut at_one = vec![0.0; dim];
        let mut at_weight = vec![0.0; dim];
        check(unsafe {
            sys::nurbs_weight_points(
                self.raw(),
                index,
                params,
                at_zero.as_mut_ptr(),
                at_one.as_mut_ptr(),
                at_weight.as_mut_ptr(),
            )
        })?;
        Ok(WeightPoints { at_zero, at_one, at_weight })
    }

    /// A weight set so that the point at `params` `[axes]` becomes the target `[dim]`; and that weight.
    pub fn weight_through(
        &self,
        index: i64,
        params: &[f64],
        target: &[f64],
        tolerance: f64,
    ) -> Result<(Spline, f64)> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let target = exactly(target, self.dimension()? as usize, "target")?;
        let mut weight = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_weight_through(self.raw(), index, params, target, tolerance, &mut weight, out)
        })?;
        Ok((spline, weight))
    }

    /// A control point moved so that the point at `params` `[axes]` moves by a distance along a direction
    /// `[dim]`; and how far it moved.
    pub fn pull_point(
        &self,
        index: i64,
        params: &[f64],
        direction: &[f64],
        distance: f64,
    ) -> Result<(Spline, f64)> {
        let params = exactly(params, self.axes()? as usize, "params")?;
        let direction = exactly(direction, self.dimension()? as usize, "direction")?;
        let mut moved = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_pull_point(self.raw(), index, params, direction, distance, &mut moved, out)
        })?;
        Ok((spline, moved))
    }

    /// The control point with the largest `|R_i|` at each of `params` `[n][axes]`.
    pub fn most_influential<'a>(&self, params: impl Into<Records<'a>>) -> Result<Vec<Influence>> {
        let params = params.into();
        let n = params.count(self.axes()? as usize, "params")?;
        let mut indices = vec![0; n];
        let mut influences = vec![0.0; n];
        check(unsafe {
            sys::nurbs_most_influential(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                indices.as_mut_ptr(),
                influences.as_mut_ptr(),
            )
        })?;
        Ok((0..n).map(|i| Influence { index: indices[i], influence: influences[i] }).collect())
    }

    /// The knot inserted that makes a point of a leg of the control polygon a control point.
    pub fn insert_on_leg(&self, axis: i32, index: i64, ratio: f64) -> Result<LegEdit> {
        let mut knot = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_insert_on_leg(self.raw(), axis, index, ratio, &mut knot, out)
        })?;
        Ok(LegEdit { spline, index, ratio, knot })
    }

    /// The same for the point on the leg that is nearest to the one given, `[dim]`.
    pub fn insert_at_point(&self, axis: i32, point: &[f64], tolerance: f64) -> Result<LegEdit> {
        let point = exactly(point, self.dimension()? as usize, "point")?;
        let mut index = 0;
        let mut ratio = 0.0;
        let mut knot = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_insert_at_point(
                self.raw(),
                axis,
                point,
                tolerance,
                &mut index,
                &mut ratio,
                &mut knot,
                out,
            )
        })?;
        Ok(LegEdit { spline, index, ratio, knot })
    }
}
