// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Trimmed faces: the part of a surface that loops of curves bound.

use crate::arrays::{if_given, Records};
use crate::bounds::BoundingBox;
use crate::call::Call;
use crate::error::{check, value, Result};
use crate::face::Face;
use crate::intersections::Rays;
use crate::measure::{Measured, Moments};
use crate::moments::moments_of;
use crate::sizes::sum;
use crate::spline::{some_handles, Spline};
use crate::sys;
use std::ptr::null_mut;

/// An edge of a face.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FaceEdge {
    /// The curve in space.
    pub spline: Spline,
    /// Its number, negative if it runs against the loop.
    pub key: i64,
}

/// How far a curve of a loop and its edge are apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FaceDeviation {
    /// The distance.
    pub distance: f64,
    /// Whether it is a bound, not only the largest one seen.
    pub proven: bool,
}

/// The points of a face that are nearest to given points.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ClosestOnFace {
    /// `[n][2]` on the surface.
    pub params: Vec<[f64; 2]>,
    /// `[n][dim]`, as evaluation gives them.
    pub points: Vec<f64>,
    /// From the points that were given.
    pub distances: Vec<f64>,
    /// `NURBS_CLOSEST_` bits.
    pub status: Vec<i32>,
}

/// The smallest distance of two faces: between both bounds, at most that of two points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FaceDistance {
    /// From below.
    pub at_least: f64,
    /// From above.
    pub at_most: f64,
    /// `[2]` on the surface of the one.
    pub params_a: [f64; 2],
    /// `[2]` on that of the other one.
    pub params_b: [f64; 2],
    /// `NURBS_CLOSEST_CERTIFIED`, `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

/// How far the farthest point of a face is from another one, and the other way round.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FaceHausdorffDistance {
    /// `[2]`: from below.
    pub at_least: [f64; 2],
    /// `[2]`: from above.
    pub at_most: [f64; 2],
    /// `[2]` of a point that is `at_least[0]` away.
    pub params_a: [f64; 2],
    /// `[2]` of a point that is `at_least[1]` away.
    pub params_b: [f64; 2],
    /// `NURBS_CLOSEST_CERTIFIED`, `NURBS_CLOSEST_BUDGET`.
    pub status: i32,
}

/// Points and weights of a rule inside a face.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FaceQuadrature {
    /// Parameters of the points.
    pub params: Vec<[f64; 2]>,
    /// Weights of the parameters.
    pub weights: Vec<f64>,
    /// Weights of areas.
    pub measures: Vec<f64>,
}

/// Trimmed faces: the part of a surface that loops of curves bound.
impl Face {
    /// A face of a surface and loops of curves in its domain, edges in space, or both; sizes are the numbers
    /// of curves of the loops. Where a curve or an edge is missing, it is made. Without loops it is the whole
    /// surface.
    pub fn create(
        surface: &Spline,
        sizes: &[i64],
        curves: &[Option<&Spline>],
        edges: &[Option<&Spline>],
        keys: &[i64],
        tolerance: f64,
        flags: u32,
    ) -> Result<Face> {
        let curves = some_handles(curves);
        let curves = if_given(&curves, sum(sizes), "curves")?;
        let edges = some_handles(edges);
        let edges = if_given(&edges, sum(sizes), "edges")?;
        let keys = if_given(keys, sum(sizes), "keys")?;
        Face::made(|out| unsafe {
            sys::nurbs_face_create(
                surface.raw(),
                sizes.len() as i64,
                sizes.as_ptr(),
                curves,
                edges,
                keys,
                tolerance,
                flags,
                null_mut(),
                out,
            )
        })
    }

    /// The same as `create`; it can be watched and stopped.
    pub fn create_with(
        surface: &Spline,
        sizes: &[i64],
        curves: &[Option<&Spline>],
        edges: &[Option<&Spline>],
        keys: &[i64],
        tolerance: f64,
        flags: u32,
        call: &mut Call,
    ) -> Result<Face> {
        let curves = some_handles(curves);
        let curves = if_given(&curves, sum(sizes), "curves")?;
        let edges = some_handles(edges);
        let edges = if_given(&edges, sum(sizes), "edges")?;
        let keys = if_given(keys, sum(sizes), "keys")?;
        Face::made(|out| unsafe {
            sys::nurbs_face_create_with(
                surface.raw(),
                sizes.len() as i64,
                sizes.as_ptr(),
                curves,
                edges,
                keys,
                tolerance,
                flags,
                null_mut(),
                call.options(),
                out,
            )
        })
    }

    /// Its surface.
    pub fn surface(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_face_surface(self.raw(), out) })
    }

    /// The number of curves of each loop.
    pub fn loops(&self) -> Result<Vec<i64>> {
        let fill = |cap, sizes, count| unsafe { sys::nurbs_face_loops(self.raw(), cap, sizes, count) };
        let mut count = 0;
        check(fill(0, null_mut(), &mut count))?;
        let n = count as usize;
        let mut sizes = vec![0; n];
        check(fill(count, sizes.as_mut_ptr(), &mut count))?;
        Ok(sizes)
    }

    /// A curve of a loop in the domain of the surface, as it runs with the inside to its left.
    pub fn curve(&self, loop_index: usize, index: usize) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_face_curve(self.raw(), loop_index as i64, index as i64, out) })
    }

    /// The edge in space that belongs to a curve of a loop: the one that was given, or one that is made.
    pub fn edge(&self, loop_index: usize, index: usize) -> Result<FaceEdge> {
        let mut key = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_face_edge(self.raw(), loop_index as i64, index as i64, &mut key, out)
        })?;
        Ok(FaceEdge { spline, key })
    }

    /// How far a curve of a loop, mapped by the surface, and its edge are apart.
    pub fn deviation(&self, loop_index: usize, index: usize) -> Result<FaceDeviation> {
        let mut distance = 0.0;
        let mut proven = 0;
        check(unsafe {
            sys::nurbs_face_deviation(self.raw(), loop_index as i64, index as i64, &mut distance, &mut proven)
        })?;
        Ok(FaceDeviation { distance, proven: proven != 0 })
    }

    /// The tolerance that it was created with.
    pub fn tolerance(&self) -> Result<f64> {
        value(|tolerance| unsafe { sys::nurbs_face_tolerance(self.raw(), tolerance) })
    }

    /// On which side of the boundary parameters lie: 1 inside, 0 on the boundary, -1 outside.
    pub fn classify<'a>(&self, params: impl Into<Records<'a>>, tolerance: f64) -> Result<Vec<i32>> {
        let params = params.into();
        let n = params.count(2, "params")?;
        let mut sides = vec![0; n];
        check(unsafe {
            sys::nurbs_face_classify(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                tolerance,
                sides.as_mut_ptr(),
            )
        })?;
        Ok(sides)
    }

    /// The same as `classify`; it can be watched and stopped.
    pub fn classify_with<'a>(
        &self,
        params: impl Into<Records<'a>>,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Vec<i32>> {
        let params = params.into();
        let n = params.count(2, "params")?;
        let mut sides = vec![0; n];
        check(unsafe {
            sys::nurbs_face_classify_with(
                self.raw(),
                n as i64,
                params.pointer(),
                params.stride(),
                params.component_stride(),
                tolerance,
                sides.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(sides)
    }

    /// Where rays meet it first, with proof.
    pub fn rays<'a, 'b>(
        &self,
        origins: impl Into<Records<'a>>,
        directions: impl Into<Records<'b>>,
    ) -> Result<Rays> {
        let origins = origins.into();
        let directions = directions.into();
        let n = origins.count(3, "origins")?;
        directions.require(n, 3, "directions")?;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_face_rays(
                self.raw(),
                n as i64,
                origins.pointer(),
                origins.stride(),
                origins.component_stride(),
                directions.pointer(),
                directions.stride(),
                directions.component_stride(),
                params.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
            )
        })?;
        Ok(Rays { params, distances, status })
    }

    /// The same as `rays`; it can be watched and stopped.
    pub fn rays_with<'a, 'b>(
        &self,
        origins: impl Into<Records<'a>>,
        directions: impl Into<Records<'b>>,
        call: &mut Call,
    ) -> Result<Rays> {
        let origins = origins.into();
        let directions = directions.into();
        let n = origins.count(3, "origins")?;
        directions.require(n, 3, "directions")?;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_face_rays_with(
                self.raw(),
                n as i64,
                origins.pointer(),
                origins.stride(),
                origins.component_stride(),
                directions.pointer(),
                directions.stride(),
                directions.component_stride(),
                params.as_mut_ptr().cast(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(Rays { params, distances, status })
    }

    /// Its points that are nearest to given points, with proof.
    pub fn closest_points<'a>(
        &self,
        points: impl Into<Records<'a>>,
        tolerance: f64,
    ) -> Result<ClosestOnFace> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let mut params = vec![[0.0; 2]; n];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_face_closest_points(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                params.as_mut_ptr().cast(),
                feet.as_mut_ptr(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
            )
        })?;
        Ok(ClosestOnFace { params, points: feet, distances, status })
    }

    /// The same as `closest_points`; it can be watched and stopped.
    pub fn closest_points_with<'a>(
        &self,
        points: impl Into<Records<'a>>,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<ClosestOnFace> {
        let points = points.into();
        let dim = self.dimension()? as usize;
        let n = points.count(dim, "points")?;
        let mut params = vec![[0.0; 2]; n];
        let mut feet = vec![0.0; n * dim];
        let mut distances = vec![0.0; n];
        let mut status = vec![0; n];
        check(unsafe {
            sys::nurbs_face_closest_points_with(
                self.raw(),
                n as i64,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                tolerance,
                params.as_mut_ptr().cast(),
                feet.as_mut_ptr(),
                distances.as_mut_ptr(),
                status.as_mut_ptr(),
                call.options(),
            )
        })?;
        Ok(ClosestOnFace { params, points: feet, distances, status })
    }

    /// The smallest distance to another face, with proof; the points are at_most apart.
    pub fn distance(&self, other: &Face, tolerance: f64) -> Result<FaceDistance> {
        let mut at_least = 0.0;
        let mut at_most = 0.0;
        let mut params_a = [0.0; 2];
        let mut params_b = [0.0; 2];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_face_distance(
                self.raw(),
                other.raw(),
                tolerance,
                &mut at_least,
                &mut at_most,
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
            )
        })?;
        Ok(FaceDistance { at_least, at_most, params_a, params_b, status })
    }

    /// The same as `distance`; it can be watched and stopped.
    pub fn distance_with(&self, other: &Face, tolerance: f64, call: &mut Call) -> Result<FaceDistance> {
        let mut at_least = 0.0;
        let mut at_most = 0.0;
        let mut params_a = [0.0; 2];
        let mut params_b = [0.0; 2];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_face_distance_with(
                self.raw(),
                other.raw(),
                tolerance,
                &mut at_least,
                &mut at_most,
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
                call.options(),
            )
        })?;
        Ok(FaceDistance { at_least, at_most, params_a, params_b, status })
    }

    /// How far the points that are farthest from another face are from it, and the other way round.
    pub fn hausdorff_distance(&self, other: &Face, tolerance: f64) -> Result<FaceHausdorffDistance> {
        let mut at_least = [0.0; 2];
        let mut at_most = [0.0; 2];
        let mut params_a = [0.0; 2];
        let mut params_b = [0.0; 2];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_face_hausdorff_distance(
                self.raw(),
                other.raw(),
                tolerance,
                at_least.as_mut_ptr(),
                at_most.as_mut_ptr(),
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
            )
        })?;
        Ok(FaceHausdorffDistance { at_least, at_most, params_a, params_b, status })
    }

    /// The same as `hausdorff_distance`; it can be watched and stopped.
    pub fn hausdorff_distance_with(
        &self,
        other: &Face,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<FaceHausdorffDistance> {
        let mut at_least = [0.0; 2];
        let mut at_most = [0.0; 2];
        let mut params_a = [0.0; 2];
        let mut params_b = [0.0; 2];
        let mut status = 0;
        check(unsafe {
            sys::nurbs_face_hausdorff_distance_with(
                self.raw(),
                other.raw(),
                tolerance,
                at_least.as_mut_ptr(),
                at_most.as_mut_ptr(),
                params_a.as_mut_ptr(),
                params_b.as_mut_ptr(),
                &mut status,
                call.options(),
            )
        })?;
        Ok(FaceHausdorffDistance { at_least, at_most, params_a, params_b, status })
    }

    /// Its area.
    pub fn area(&self, relative_tolerance: f64) -> Result<Measured> {
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe { sys::nurbs_face_area(self.raw(), relative_tolerance, &mut value, &mut error) })?;
        Ok(Measured { value, error })
    }

    /// The same as `area`; it can be watched and stopped.
    pub fn area_with(&self, relative_tolerance: f64, call: &mut Call) -> Result<Measured> {
        let mut value = 0.0;
        let mut error = 0.0;
        check(unsafe {
            sys::nurbs_face_area_with(self.raw(), relative_tolerance, &mut value, &mut error, call.options())
        })?;
        Ok(Measured { value, error })
    }

    /// Area, centroid and inertia about the centroid.
    pub fn moments(&self, relative_tolerance: f64) -> Result<Moments> {
        let mut content = 0.0;
        let dim = self.dimension()? as usize;
        let mut centroid = vec![0.0; dim];
        let mut inertia = vec![0.0; dim * dim];
        let mut error = 0.0;
        moments_of(&mut centroid, &mut inertia, |centroid, inertia| unsafe {
            sys::nurbs_face_moments(
                self.raw(),
                relative_tolerance,
                &mut content,
                centroid,
                inertia,
                &mut error,
            )
        })?;
        Ok(Moments { content, centroid, inertia, error })
    }

    /// The same as `moments`; it can be watched and stopped.
    pub fn moments_with(&self, relative_tolerance: f64, call: &mut Call) -> Result<Moments> {
        let mut content = 0.0;
        let dim = self.dimension()? as usize;
        let mut centroid = vec![0.0; dim];
        let mut inertia = vec![0.0; dim * dim];
        let mut error = 0.0;
        moments_of(&mut centroid, &mut inertia, |centroid, inertia| unsafe {
            sys::nurbs_face_moments_with(
                self.raw(),
                relative_tolerance,
                &mut content,
                centroid,
                inertia,
                &mut error,
                call.options(),
            )
        })?;
        Ok(Moments { content, centroid, inertia, error })
    }

    /// Points and weights for integrals of any function over it: so many nodes along each axis of a cell, 0
    /// for one more than the degree.
    pub fn quadrature(&self, nodes: i32) -> Result<FaceQuadrature> {
        let fill = |cap, params, weights, measures, count| unsafe {
            sys::nurbs_face_quadrature(self.raw(), nodes, cap, params, weights, measures, count)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut weights = vec![0.0; n];
        let mut measures = vec![0.0; n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            weights.as_mut_ptr(),
            measures.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(FaceQuadrature { params, weights, measures })
    }

    /// The same as `quadrature`; it can be watched and stopped.
    pub fn quadrature_with(&self, nodes: i32, call: &mut Call) -> Result<FaceQuadrature> {
        let mut fill = |cap, params, weights, measures, count| unsafe {
            sys::nurbs_face_quadrature_with(
                self.raw(),
                nodes,
                cap,
                params,
                weights,
                measures,
                count,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut weights = vec![0.0; n];
        let mut measures = vec![0.0; n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            weights.as_mut_ptr(),
            measures.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(FaceQuadrature { params, weights, measures })
    }

    /// An axis-aligned box that contains it; no side is farther from it than the tolerance.
    pub fn bounding_box(&self, tolerance: f64) -> Result<BoundingBox> {
        let dim = self.dimension()? as usize;
        let mut lower = vec![0.0; dim];
        let mut upper = vec![0.0; dim];
        let mut gap = 0.0;
        check(unsafe {
            sys::nurbs_face_box(self.raw(), tolerance, lower.as_mut_ptr(), upper.as_mut_ptr(), &mut gap)
        })?;
        Ok(BoundingBox { lower, upper, gap })
    }

    /// The same as `bounding_box`; it can be watched and stopped.
    pub fn bounding_box_with(&self, tolerance: f64, call: &mut Call) -> Result<BoundingBox> {
        let dim = self.dimension()? as usize;
        let mut lower = vec![0.0; dim];
        let mut upper = vec![0.0; dim];
        let mut gap = 0.0;
        check(unsafe {
            sys::nurbs_face_box_with(
                self.raw(),
                tolerance,
                lower.as_mut_ptr(),
                upper.as_mut_ptr(),
                &mut gap,
                call.options(),
            )
        })?;
        Ok(BoundingBox { lower, upper, gap })
    }

    /// The face of what to_bytes() made of it.
    pub fn from_bytes(bytes: &[u8]) -> Result<Face> {
        Face::made(|out| unsafe {
            sys::nurbs_face_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out)
        })
    }
}
