// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Distances and closest points.

use crate::arrays::{exactly, exactly_mut, if_given, layout, Records, RecordsMut};
use crate::call::Call;
use crate::error::{check, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// How a search is done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Search<'a> {
    /// The part `[axes][2]` of the domain that is searched; empty: all of it.
    pub range: &'a [f64],
    /// How much nearer or farther another point may be.
    pub tolerance: f64,
    /// Most pieces looked at, 0 for the default.
    pub budget: i64,
    /// `NURBS_NAN_POINTS` or 0.
    pub flags: u32,
}

/// Points of a spline: parameters `[n][axes]`, points `[n][dim]`, distances, and sums of `NURBS_CLOSEST_`
/// bits.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ClosestPoints {
    /// `[n][axes]`
    pub params: Vec<f64>,
    /// `[n][dim]`
    pub points: Vec<f64>,
    /// `[n]`
    pub distances: Vec<f64>,
    /// Sums of `NURBS_CLOSEST_` bits, `[n]`.
    pub status: Vec<i32>,
}

/// Where they are written; those that are `None` are not wanted.
#[derive(Debug, Default)]
pub struct ClosestPointsMut<'a> {
    /// `[n][axes]`
    pub params: Option<RecordsMut<'a>>,
    /// `[n][dim]`
    pub points: Option<RecordsMut<'a>>,
    /// `[n]`
    pub distances: Option<RecordsMut<'a>>,
    /// Sums of `NURBS_CLOSEST_` bits, `[n]`.
    pub status: Option<&'a mut [i32]>,
}

/// Points as near as the nearest one to the tolerance: parameters `[n][axes]`, and the status of the search.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ClosestAll {
    /// `[n][axes]`
    pub params: Vec<f64>,
    /// `[n]`
    pub distances: Vec<f64>,
    /// Of the search: a sum of `NURBS_CLOSEST_` bits.
    pub status: i32,
}

/// Critical points of the distance: parameters `[n][axes]`, `NURBS_CRITICAL_` constants, and the status of
/// the search.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CriticalPoints {
    /// `[n][axes]`
    pub params: Vec<f64>,
    /// `[n]`
    pub distances: Vec<f64>,
    /// `NURBS_CRITICAL_` constants, `[n]`.
    pub kinds: Vec<i32>,
    /// Of the search: a sum of `NURBS_CLOSEST_` bits.
    pub status: i32,
}

/// Distances, positive to the left of a curve, parameters, and sums of `NURBS_CLOSEST_` bits.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SignedDistances {
    /// Positive to the left of the curve.
    pub distances: Vec<f64>,
    /// Of the nearest points.
    pub params: Vec<f64>,
    /// Sums of `NURBS_CLOSEST_` bits.
    pub status: Vec<i32>,
}

/// Bounds of a distance, and the parameters of a point of each spline.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Distance {
    /// A proven lower bound.
    pub at_least: f64,
    /// The distance of the points at the parameters.
    pub at_most: f64,
    /// Of a point of each spline.
    pub params: [Vec<f64>; 2],
    /// `NURBS_CLOSEST_CERTIFIED` or `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

/// Bounds of the distances from the first spline to the second and back, and the parameters of points that
/// are `at_least` so far away.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct HausdorffDistance {
    /// Lower bounds of the distances from one to the other and back.
    pub at_least: [f64; 2],
    /// Upper bounds of them.
    pub at_most: [f64; 2],
    /// Of points of each that are at least so far away.
    pub params: [Vec<f64>; 2],
    /// `NURBS_CLOSEST_CERTIFIED` or `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

/// Distances and closest points.
impl Spline {
    /// The nearest points of a spline; in a volume this is inversion.
    pub fn closest_points<'a>(&self, points: impl Into<Records<'a>>, how: Search) -> Result<ClosestPoints> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_closest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn closest_points_into<'a>(
        &self,
        points: impl Into<Records<'a>>,
        mut out: ClosestPointsMut,
        how: Search,
    ) -> Result<()> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            sys::nurbs_closest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                how.flags,
            )
        })
    }

    /// The same as `closest_points`; it can be watched and stopped.
    pub fn closest_points_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        how: Search,
        call: &mut Call,
    ) -> Result<ClosestPoints> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            crate::call::nurbs_closest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
                call.options(),
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn closest_points_into_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        mut out: ClosestPointsMut,
        how: Search,
        call: &mut Call,
    ) -> Result<()> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            crate::call::nurbs_closest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                how.flags,
                call.options(),
            )
        })
    }

    /// The farthest points of a spline.
    pub fn farthest_points<'a>(&self, points: impl Into<Records<'a>>, how: Search) -> Result<ClosestPoints> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_farthest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn farthest_points_into<'a>(
        &self,
        points: impl Into<Records<'a>>,
        mut out: ClosestPointsMut,
        how: Search,
    ) -> Result<()> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            sys::nurbs_farthest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                how.flags,
            )
        })
    }

    /// The same as `farthest_points`; it can be watched and stopped.
    pub fn farthest_points_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        how: Search,
        call: &mut Call,
    ) -> Result<ClosestPoints> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            crate::call::nurbs_farthest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
                call.options(),
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn farthest_points_into_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        mut out: ClosestPointsMut,
        how: Search,
        call: &mut Call,
    ) -> Result<()> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            crate::call::nurbs_farthest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                range,
                how.tolerance,
                how.budget,
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                how.flags,
                call.options(),
            )
        })
    }

    /// Local minima of the distance, each the one that a descent from a guess `[axes]` comes to.
    pub fn closest_local<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        flags: u32,
    ) -> Result<ClosestPoints> {
        let points = points.into();
        let guesses = guesses.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        guesses.require(n, axes, "guesses")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_closest_local(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                guesses.pointer(),
                guesses.stride(),
                guesses.component_stride(),
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                flags,
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn closest_local_into<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        mut out: ClosestPointsMut,
        flags: u32,
    ) -> Result<()> {
        let points = points.into();
        let guesses = guesses.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        guesses.require(n, axes, "guesses")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            sys::nurbs_closest_local(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                guesses.pointer(),
                guesses.stride(),
                guesses.component_stride(),
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                flags,
            )
        })
    }

    /// The same as `closest_local`; it can be watched and stopped.
    pub fn closest_local_with<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        flags: u32,
        call: &mut Call,
    ) -> Result<ClosestPoints> {
        let points = points.into();
        let guesses = guesses.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        guesses.require(n, axes, "guesses")?;
        let mut params = vec![0.0; n * axes];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            crate::call::nurbs_closest_local_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                guesses.pointer(),
                guesses.stride(),
                guesses.component_stride(),
                params.as_mut_ptr(),
                0,
                0,
                feet.as_mut_ptr(),
                0,
                0,
                distances.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                flags,
                call.options(),
            )
        })?;
        Ok(ClosestPoints { params, points: feet, distances, status })
    }

    /// The same, written to arrays of the caller.
    pub fn closest_local_into_with<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        mut out: ClosestPointsMut,
        flags: u32,
        call: &mut Call,
    ) -> Result<()> {
        let points = points.into();
        let guesses = guesses.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let axes = self.axes()? as usize;
        guesses.require(n, axes, "guesses")?;
        let params = layout(&mut out.params, n, axes, "params")?;
        let feet = layout(&mut out.points, n, dim, "points")?;
        let distances = layout(&mut out.distances, n, 1, "distances")?;
        let status = exactly_mut(&mut out.status, n, "status")?;
        check(unsafe {
            crate::call::nurbs_closest_local_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                guesses.pointer(),
                guesses.stride(),
                guesses.component_stride(),
                params.0,
                params.1,
                params.2,
                feet.0,
                feet.1,
                feet.2,
                distances.0,
                distances.1,
                status,
                flags,
                call.options(),
            )
        })
    }

    /// All points that are local minima of the distance and as near as the nearest one to the tolerance.
    pub fn closest_all(&self, point: &[f64], how: Search) -> Result<ClosestAll> {
        let point = exactly(point, self.dimension()? as usize, "point")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut status = 0;
        let mut fill = |cap, params, distances, count| unsafe {
            sys::nurbs_closest_all(
                self.raw(),
                point,
                range,
                how.tolerance,
                how.budget,
                cap,
                params,
                distances,
                count,
                &mut status,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n * axes];
        let mut distances = vec![0.0; n];
        check(fill(count, params.as_mut_ptr(), distances.as_mut_ptr(), &mut count))?;
        Ok(ClosestAll { params, distances, status })
    }

    /// The same as `closest_all`; it can be watched and stopped.
    pub fn closest_all_with(&self, point: &[f64], how: Search, call: &mut Call) -> Result<ClosestAll> {
        let point = exactly(point, self.dimension()? as usize, "point")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut status = 0;
        let mut fill = |cap, params, distances, count| unsafe {
            sys::nurbs_closest_all_with(
                self.raw(),
                point,
                range,
                how.tolerance,
                how.budget,
                cap,
                params,
                distances,
                count,
                &mut status,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n * axes];
        let mut distances = vec![0.0; n];
        check(fill(count, params.as_mut_ptr(), distances.as_mut_ptr(), &mut count))?;
        Ok(ClosestAll { params, distances, status })
    }

    /// All critical points of the distance from a point.
    pub fn critical_points(&self, point: &[f64], how: Search) -> Result<CriticalPoints> {
        let point = exactly(point, self.dimension()? as usize, "point")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut status = 0;
        let mut fill = |cap, params, distances, kinds, count| unsafe {
            sys::nurbs_critical_points(
                self.raw(),
                point,
                range,
                how.tolerance,
                how.budget,
                cap,
                params,
                distances,
                kinds,
                count,
                &mut status,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n * axes];
        let mut distances = vec![0.0; n];
        let mut kinds = vec![0; n];
        check(fill(count, params.as_mut_ptr(), distances.as_mut_ptr(), kinds.as_mut_ptr(), &mut count))?;
        Ok(CriticalPoints { params, distances, kinds, status })
    }

    /// The same as `critical_points`; it can be watched and stopped.
    pub fn critical_points_with(
        &self,
        point: &[f64],
        how: Search,
        call: &mut Call,
    ) -> Result<CriticalPoints> {
        let point = exactly(point, self.dimension()? as usize, "point")?;
        let axes = self.axes()? as usize;
        let range = if_given(how.range, 2 * axes, "range")?;
        let mut status = 0;
        let mut fill = |cap, params, distances, kinds, count| unsafe {
            sys::nurbs_critical_points_with(
                self.raw(),
                point,
                range,
                how.tolerance,
                how.budget,
                cap,
                params,
                distances,
                kinds,
                count,
                &mut status,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n * axes];
        let mut distances = vec![0.0; n];
        let mut kinds = vec![0; n];
        check(fill(count, params.as_mut_ptr(), distances.as_mut_ptr(), kinds.as_mut_ptr(), &mut count))?;
        Ok(CriticalPoints { params, distances, kinds, status })
    }

    /// Signed distances of points `[n][2]` from a curve in the plane, positive to its left; the search has no
    /// range.
    pub fn signed_distances<'a>(
        &self,
        points: impl Into<Records<'a>>,
        how: Search,
    ) -> Result<SignedDistances> {
        let points = points.into();
        let n = points.count(self.dimension()? as usize, "points")?;
        let mut distances = vec![0.0; n];
        let mut params = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_curve_signed_distances(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                how.tolerance,
                how.budget,
                distances.as_mut_ptr(),
                0,
                params.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
            )
        })?;
        Ok(SignedDistances { distances, params, status })
    }

    /// The same as `signed_distances`; it can be watched and stopped.
    pub fn signed_distances_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        how: Search,
        call: &mut Call,
    ) -> Result<SignedDistances> {
        let points = points.into();
        let n = points.count(self.dimension()? as usize, "points")?;
        let mut distances = vec![0.0; n];
        let mut params = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            crate::call::nurbs_curve_signed_distances_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                how.tolerance,
                how.budget,
                distances.as_mut_ptr(),
                0,
                params.as_mut_ptr(),
                0,
                status.as_mut_ptr(),
                how.flags,
                call.options(),
            )
        })?;
        Ok(SignedDistances { distances, params, status })
    }

    /// The smallest distance to another spline; the points of the parameters are `at_most` apart.
    pub fn distance(&self, other: &Spline, tolerance: f64, budget: i64) -> Result<Distance> {
        let mut at_least = 0.0;
        let mut at_most = 0.0;
        let mut params_a = vec![0.0; self.axes()? as usize];
        let mut params_b = vec![0.0; other.axes()? as usize];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_distance(
                self.raw(),
                other.raw(),
                tolerance,
                budget,
                &mut at_least,
                &mut at_most,
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
            )
        })?;
        Ok(Distance { at_least, at_most, params: [params_a, params_b], status })
    }

    /// The same as `distance`; it can be watched and stopped.
    pub fn distance_with(
        &self,
        other: &Spline,
        tolerance: f64,
        budget: i64,
        call: &mut Call,
    ) -> Result<Distance> {
        let mut at_least = 0.0;
        let mut at_most = 0.0;
        let mut params_a = vec![0.0; self.axes()? as usize];
        let mut params_b = vec![0.0; other.axes()? as usize];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_distance_with(
                self.raw(),
                other.raw(),
                tolerance,
                budget,
                &mut at_least,
                &mut at_most,
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
                call.options(),
            )
        })?;
        Ok(Distance { at_least, at_most, params: [params_a, params_b], status })
    }

    /// How far the points that are farthest from the other spline are from it, and the other way round.
    pub fn hausdorff_distance(
        &self,
        other: &Spline,
        tolerance: f64,
        budget: i64,
    ) -> Result<HausdorffDistance> {
        let mut at_least = [0.0; 2];
        let mut at_most = [0.0; 2];
        let mut params_a = vec![0.0; self.axes()? as usize];
        let mut params_b = vec![0.0; other.axes()? as usize];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_hausdorff_distance(
                self.raw(),
                other.raw(),
                tolerance,
                budget,
                at_least.as_mut_ptr(),
                at_most.as_mut_ptr(),
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
            )
        })?;
        Ok(HausdorffDistance { at_least, at_most, params: [params_a, params_b], status })
    }

    /// The same as `hausdorff_distance`; it can be watched and stopped.
    pub fn hausdorff_distance_with(
        &self,
        other: &Spline,
        tolerance: f64,
        budget: i64,
        call: &mut Call,
    ) -> Result<HausdorffDistance> {
        let mut at_least = [0.0; 2];
        let mut at_most = [0.0; 2];
        let mut params_a = vec![0.0; self.axes()? as usize];
        let mut params_b = vec![0.0; other.axes()? as usize];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_hausdorff_distance_with(
                self.raw(),
                other.raw(),
                tolerance,
                budget,
                at_least.as_mut_ptr(),
                at_most.as_mut_ptr(),
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
                call.options(),
            )
        })?;
        Ok(HausdorffDistance { at_least, at_most, params: [params_a, params_b], status })
    }
}
