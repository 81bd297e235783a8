// SPDX-License-Identifier: MIT
//! Distances and closest points.

use crate::arrays::{exactly, if_given, layout, Records, RecordsMut};
use crate::error::{check, Error, Result};
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// How a search is done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Search<'a> {
    /// `[axes][2]` the part of the domain that is searched; empty: all of it.
    pub range: &'a [f64],
    /// How much nearer or farther another point may be.
    pub tolerance: f64,
    /// Most pieces looked at, 0 for the default.
    pub budget: i64,
    /// `NURBS_NAN_POINTS` or 0.
    pub flags: u32,
}

/// Parameters `[n][axes]`, points `[n][dim]`, distances, and sums of `NURBS_CLOSEST_` bits.
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
#[derive(Default, Debug)]
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

impl ClosestPoints {
    fn room(g: &Spline, n: usize) -> Result<ClosestPoints> {
        let (axes, dim) = (g.axes()? as usize, g.dimension()? as usize);
        Ok(ClosestPoints {
            params: vec![0.0; n * axes],
            points: vec![0.0; n * dim],
            distances: vec![0.0; n],
            status: vec![0; n],
        })
    }
    fn outputs(&mut self) -> ClosestPointsMut<'_> {
        ClosestPointsMut {
            params: Some((&mut self.params).into()),
            points: Some((&mut self.points).into()),
            distances: Some((&mut self.distances).into()),
            status: Some(&mut self.status),
        }
    }
}

/// n points as near as the nearest one: parameters `[n][axes]`, and the status of the search.
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

/// Critical points: parameters `[n][axes]`, `NURBS_CRITICAL_` constants, and the status of the search.
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
    /// The distance of the points at `params`.
    pub at_most: f64,
    /// Parameters of a point of each spline.
    pub params: [Vec<f64>; 2],
    /// `NURBS_CLOSEST_CERTIFIED` or `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

/// Bounds of the distances from the first to the second spline and back, and the parameters of points of each that are
/// `at_least` so far away.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct HausdorffDistance {
    /// Lower bounds of the distances from one to the other and back.
    pub at_least: [f64; 2],
    /// Upper bounds of them.
    pub at_most: [f64; 2],
    /// Parameters of points that are at least so far away.
    pub params: [Vec<f64>; 2],
    /// `NURBS_CLOSEST_CERTIFIED` or `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

fn status_pointer(status: &mut Option<&mut [i32]>, n: usize) -> Result<*mut i32> {
    match status {
        None => Ok(null_mut()),
        Some(values) if values.len() == n => Ok(values.as_mut_ptr()),
        Some(values) => Err(Error::size("status", values.len(), n.to_string())),
    }
}

/// `nurbs_closest_points` or `nurbs_farthest_points`.
type SearchFunction = unsafe extern "C" fn(
    *const sys::nurbs,
    i64,
    *const f64,
    i64,
    i64,
    *const f64,
    f64,
    i64,
    *mut f64,
    i64,
    i64,
    *mut f64,
    i64,
    i64,
    *mut f64,
    i64,
    *mut i32,
    u32,
) -> sys::nurbs_status;

/// An output as the library takes it: a pointer and its strides.
type Layout = (*mut f64, i64, i64);

/// Closest points.
impl Spline {
    fn queries(&self, points: &Records) -> Result<usize> {
        points.count(self.dimension()? as usize, "points")
    }
    pub(crate) fn range(&self, range: &[f64]) -> Result<*const f64> {
        if_given(range, 2 * self.axes()? as usize, "range")
    }
    fn layouts(&self, out: &mut ClosestPointsMut, n: usize) -> Result<(Layout, Layout, Layout, *mut i32)> {
        Ok((
            layout(&mut out.params, n, self.axes()? as usize, "params")?,
            layout(&mut out.points, n, self.dimension()? as usize, "points")?,
            layout(&mut out.distances, n, 1, "distances")?,
            status_pointer(&mut out.status, n)?,
        ))
    }

    fn search(
        &self,
        function: SearchFunction,
        x: Records,
        mut out: ClosestPointsMut,
        how: Search,
    ) -> Result<()> {
        let (n, range) = (self.queries(&x)?, self.range(how.range)?);
        let (params, feet, distances, status) = self.layouts(&mut out, n)?;
        check(unsafe {
            function(
                self.raw(),
                n as i64,
                x.pointer(),
                x.stride(),
                x.component_stride(),
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

    /// The nearest points; in a volume this is inversion.
    pub fn closest_points<'a>(&self, points: impl Into<Records<'a>>, how: Search) -> Result<ClosestPoints> {
        let x = points.into();
        let mut found = ClosestPoints::room(self, self.queries(&x)?)?;
        self.closest_points_into(x, found.outputs(), how)?;
        Ok(found)
    }
    /// The same, written to arrays of the caller.
    pub fn closest_points_into<'a>(
        &self,
        points: impl Into<Records<'a>>,
        out: ClosestPointsMut,
        how: Search,
    ) -> Result<()> {
        self.search(sys::nurbs_closest_points, points.into(), out, how)
    }

    /// The farthest points.
    pub fn farthest_points<'a>(&self, points: impl Into<Records<'a>>, how: Search) -> Result<ClosestPoints> {
        let x = points.into();
        let mut found = ClosestPoints::room(self, self.queries(&x)?)?;
        self.farthest_points_into(x, found.outputs(), how)?;
        Ok(found)
    }
    /// The same, written to arrays of the caller.
    pub fn farthest_points_into<'a>(
        &self,
        points: impl Into<Records<'a>>,
        out: ClosestPointsMut,
        how: Search,
    ) -> Result<()> {
        self.search(sys::nurbs_farthest_points, points.into(), out, how)
    }

    /// Local minima of the distance, each the one that a descent from a guess `[axes]` comes to.
    pub fn closest_local<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        flags: u32,
    ) -> Result<ClosestPoints> {
        let x = points.into();
        let mut found = ClosestPoints::room(self, self.queries(&x)?)?;
        self.closest_local_into(x, guesses, found.outputs(), flags)?;
        Ok(found)
    }
    /// The same, written to arrays of the caller.
    pub fn closest_local_into<'a, 'b>(
        &self,
        points: impl Into<Records<'a>>,
        guesses: impl Into<Records<'b>>,
        mut out: ClosestPointsMut,
        flags: u32,
    ) -> Result<()> {
        let (x, start) = (points.into(), guesses.into());
        let n = self.queries(&x)?;
        start.require(n, self.axes()? as usize, "guesses")?;
        let (params, feet, distances, status) = self.layouts(&mut out, n)?;
        check(unsafe {
            sys::nurbs_closest_local(
                self.raw(),
                n as i64,
                x.pointer(),
                x.stride(),
                x.component_stride(),
                start.pointer(),
                start.stride(),
                start.component_stride(),
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

    /// All points that are local minima of the distance and as near as the nearest one to the tolerance.
    pub fn closest_all(&self, point: &[f64], how: Search) -> Result<ClosestAll> {
        let (axes, x) = (self.axes()? as usize, exactly(point, self.dimension()? as usize, "point")?);
        let (range, tolerance, budget) = (self.range(how.range)?, how.tolerance, how.budget);
        let (mut found, mut count) = (ClosestAll::default(), 0i64);
        let mut call = |cap: i64, params, distances, status: &mut i32| {
            check(unsafe {
                sys::nurbs_closest_all(
                    self.raw(),
                    x,
                    range,
                    tolerance,
                    budget,
                    cap,
                    params,
                    distances,
                    &mut count,
                    status,
                )
            })?;
            Ok(count)
        };
        let n = call(0, null_mut(), null_mut(), &mut found.status)?;
        found.params.resize(n as usize * axes, 0.0);
        found.distances.resize(n as usize, 0.0);
        call(n, found.params.as_mut_ptr(), found.distances.as_mut_ptr(), &mut found.status)?;
        Ok(found)
    }

    /// All critical points of the distance from a point.
    pub fn critical_points(&self, point: &[f64], how: Search) -> Result<CriticalPoints> {
        let (axes, x) = (self.axes()? as usize, exactly(point, self.dimension()? as usize, "point")?);
        let (range, tolerance, budget) = (self.range(how.range)?, how.tolerance, how.budget);
        let (mut found, mut count) = (CriticalPoints::default(), 0i64);
        let mut call = |cap: i64, params, distances, kinds, status: &mut i32| {
            check(unsafe {
                sys::nurbs_critical_points(
                    self.raw(),
                    x,
                    range,
                    tolerance,
                    budget,
                    cap,
                    params,
                    distances,
                    kinds,
                    &mut count,
                    status,
                )
            })?;
            Ok(count)
        };
        let n = call(0, null_mut(), null_mut(), null_mut(), &mut found.status)?;
        found.params.resize(n as usize * axes, 0.0);
        found.distances.resize(n as usize, 0.0);
        found.kinds.resize(n as usize, 0);
        let (params, distances) = (found.params.as_mut_ptr(), found.distances.as_mut_ptr());
        call(n, params, distances, found.kinds.as_mut_ptr(), &mut found.status)?;
        Ok(found)
    }

    /// Signed distances of points `[n][2]` from a curve in the plane, positive to its left; the search has no range.
    pub fn signed_distances<'a>(
        &self,
        points: impl Into<Records<'a>>,
        how: Search,
    ) -> Result<SignedDistances> {
        let x = points.into();
        let n = self.queries(&x)?;
        let (mut distances, mut params, mut status) = (vec![0.0; n], vec![0.0; n], vec![0; n]);
        check(unsafe {
            sys::nurbs_curve_signed_distances(
                self.raw(),
                n as i64,
                x.pointer(),
                x.stride(),
                x.component_stride(),
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

    /// The smallest distance to another spline; the points of the parameters are `at_most` apart.
    pub fn distance(&self, other: &Spline, tolerance: f64, budget: i64) -> Result<Distance> {
        let (a, b) = (self.raw(), other.raw());
        let mut params = [vec![0.0; self.axes()? as usize], vec![0.0; other.axes()? as usize]];
        let (pa, pb) = (params[0].as_mut_ptr(), params[1].as_mut_ptr());
        let (mut at_least, mut at_most, mut status) = (0.0, 0.0, 0);
        check(unsafe {
            sys::nurbs_distance(a, b, tolerance, budget, &mut at_least, &mut at_most, pa, pb, &mut status)
        })?;
        Ok(Distance { at_least, at_most, params, status })
    }

    /// How far the points that are farthest from the other spline are from it, and the other way round.
    pub fn hausdorff_distance(
        &self,
        other: &Spline,
        tolerance: f64,
        budget: i64,
    ) -> Result<HausdorffDistance> {
        let (a, b) = (self.raw(), other.raw());
        let mut params = [vec![0.0; self.axes()? as usize], vec![0.0; other.axes()? as usize]];
        let (pa, pb) = (params[0].as_mut_ptr(), params[1].as_mut_ptr());
        let (mut at_least, mut at_most, mut status) = ([0.0; 2], [0.0; 2], 0);
        let (low, high) = (at_least.as_mut_ptr(), at_most.as_mut_ptr());
        check(unsafe {
            sys::nurbs_hausdorff_distance(a, b, tolerance, budget, low, high, pa, pb, &mut status)
        })?;
        Ok(HausdorffDistance { at_least, at_most, params, status })
    }
}
