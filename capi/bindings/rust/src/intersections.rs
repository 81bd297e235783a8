// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Where shapes meet; every answer says whether it is complete.

use crate::arrays::{exactly, if_given, Records};
use crate::call::Call;
use crate::error::{check, Result};
use crate::sizes::monomials;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null_mut;

/// Parameters in rising order, one `NURBS_HIT_` constant each, and ranges `[n][2]` of parameters outside of
/// which there is no solution.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Hits {
    /// In rising order.
    pub params: Vec<f64>,
    /// One of the `NURBS_HIT_` constants each.
    pub kinds: Vec<i32>,
    /// `[n]` of lower and upper ends, outside of which there is no solution.
    pub ranges: Vec<[f64; 2]>,
    /// Whether none of them is undecided.
    pub complete: bool,
}

/// Parameters on both curves, rising on the first one, one `NURBS_HIT_` constant each, and ranges `[n][2]` of
/// parameters of both.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PairHits {
    /// On the first curve, in rising order.
    pub params_a: Vec<f64>,
    /// On the second curve.
    pub params_b: Vec<f64>,
    /// One of the `NURBS_HIT_` constants each.
    pub kinds: Vec<i32>,
    /// Of parameters of the first curve, `[n]` of lower and upper ends.
    pub ranges_a: Vec<[f64; 2]>,
    /// Of parameters of the second curve, `[n]` of ends; the first one is larger where an overlap runs
    /// against it.
    pub ranges_b: Vec<[f64; 2]>,
    /// Whether none of them is undecided.
    pub complete: bool,
}

/// Parameters on a curve, rising, and on a surface, `[n][2]`, one `NURBS_HIT_` constant each, and ranges of
/// parameters of both: `[n][2]`, and `[n][2][2]` of both axes of the surface.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SurfaceHits {
    /// On the curve, in rising order.
    pub params_curve: Vec<f64>,
    /// `[n][2]` on the surface.
    pub params_surface: Vec<[f64; 2]>,
    /// One of the `NURBS_HIT_` constants each.
    pub kinds: Vec<i32>,
    /// Of parameters of the curve, `[n]` of lower and upper ends.
    pub ranges_curve: Vec<[f64; 2]>,
    /// Of parameters of the surface, `[n][2]` of lower and upper ends along each axis.
    pub ranges_surface: Vec<[f64; 2]>,
    /// Whether none of them is undecided.
    pub complete: bool,
}

/// Parameters on three surfaces, `[n][3][2]`, rising on the first one, the points, one `NURBS_HIT_` constant
/// each, and ranges of parameters, `[n][3][2][2]`.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CommonPoints {
    /// `[n][3][2]` on the three surfaces.
    pub params: Vec<[f64; 6]>,
    /// `[n][3]`.
    pub points: Vec<[f64; 3]>,
    /// `NURBS_HIT_CROSSING` or `NURBS_HIT_UNDECIDED` each.
    pub kinds: Vec<i32>,
    /// Of parameters, `[n][6]` of lower and upper ends, outside of which there are no common points.
    pub ranges: Vec<[f64; 2]>,
    /// Whether none of them is undecided.
    pub complete: bool,
}

/// Where rays meet a surface first, at origin + t direction.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Rays {
    /// `[n][2]` on the surface, NaN without a hit or touch.
    pub params: Vec<[f64; 2]>,
    /// t, in lengths of the direction; NaN without a hit or touch.
    pub distances: Vec<f64>,
    /// `NURBS_RAY_` bits.
    pub status: Vec<i32>,
}

/// All places where a ray meets a surface, by rising t.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct RayHits {
    /// `[n][2]` on the surface.
    pub params: Vec<[f64; 2]>,
    /// t, in lengths of the direction.
    pub distances: Vec<f64>,
    /// `NURBS_RAY_HIT` or `NURBS_RAY_TOUCH` each, and `NURBS_RAY_BACK`.
    pub kinds: Vec<i32>,
    /// Whether there are no others, and none is a touch.
    pub complete: bool,
}

/// Where shapes meet; every answer says whether it is complete.
impl Spline {
    /// Where a scalar curve has a value: its roots, with proof that there are no others.
    pub fn roots(&self, value: f64, tolerance: f64) -> Result<Hits> {
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_roots(self.raw(), value, tolerance, cap, params, kinds, ranges, count, &mut complete)
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// The same as `roots`; it can be watched and stopped.
    pub fn roots_with(&self, value: f64, tolerance: f64, call: &mut Call) -> Result<Hits> {
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_roots_with(
                self.raw(),
                value,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a
    /// degree is 0; its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic
    /// order, where x_dim stands for 1.
    pub fn curve_level(&self, degree: i32, coefficients: &[f64], tolerance: f64) -> Result<Hits> {
        let coefficients =
            exactly(coefficients, monomials(self.dimension()? as usize, degree), "coefficients")?;
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_curve_level(
                self.raw(),
                degree,
                coefficients,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// The same as `curve_level`; it can be watched and stopped.
    pub fn curve_level_with(
        &self,
        degree: i32,
        coefficients: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Hits> {
        let coefficients =
            exactly(coefficients, monomials(self.dimension()? as usize, degree), "coefficients")?;
        let mut complete = 0;
        let mut fill = |cap, params, kinds, ranges, count| unsafe {
            sys::nurbs_curve_level_with(
                self.raw(),
                degree,
                coefficients,
                tolerance,
                cap,
                params,
                kinds,
                ranges,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; n];
        check(fill(count, params.as_mut_ptr(), kinds.as_mut_ptr(), ranges.as_mut_ptr().cast(), &mut count))?;
        Ok(Hits { params, kinds, ranges, complete: complete != 0 })
    }

    /// Where two curves meet, with proof that there are no other places.
    pub fn curve_intersections(&self, b: &Spline, tolerance: f64) -> Result<PairHits> {
        let mut complete = 0;
        let mut fill = |cap, params_a, params_b, kinds, ranges_a, ranges_b, count| unsafe {
            sys::nurbs_curve_intersections(
                self.raw(),
                b.raw(),
                tolerance,
                cap,
                params_a,
                params_b,
                kinds,
                ranges_a,
                ranges_b,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_a = vec![0.0; n];
        let mut params_b = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges_a = vec![[0.0; 2]; n];
        let mut ranges_b = vec![[0.0; 2]; n];
        check(fill(
            count,
            params_a.as_mut_ptr(),
            params_b.as_mut_ptr(),
            kinds.as_mut_ptr(),
            ranges_a.as_mut_ptr().cast(),
            ranges_b.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(PairHits { params_a, params_b, kinds, ranges_a, ranges_b, complete: complete != 0 })
    }

    /// The same as `curve_intersections`; it can be watched and stopped.
    pub fn curve_intersections_with(&self, b: &Spline, tolerance: f64, call: &mut Call) -> Result<PairHits> {
        let mut complete = 0;
        let mut fill = |cap, params_a, params_b, kinds, ranges_a, ranges_b, count| unsafe {
            sys::nurbs_curve_intersections_with(
                self.raw(),
                b.raw(),
                tolerance,
                cap,
                params_a,
                params_b,
                kinds,
                ranges_a,
                ranges_b,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_a = vec![0.0; n];
        let mut params_b = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges_a = vec![[0.0; 2]; n];
        let mut ranges_b = vec![[0.0; 2]; n];
        check(fill(
            count,
            params_a.as_mut_ptr(),
            params_b.as_mut_ptr(),
            kinds.as_mut_ptr(),
            ranges_a.as_mut_ptr().cast(),
            ranges_b.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(PairHits { params_a, params_b, kinds, ranges_a, ranges_b, complete: complete != 0 })
    }

    /// Where a curve meets itself, with proof that there are no other places.
    pub fn self_intersections(&self, tolerance: f64) -> Result<PairHits> {
        let mut complete = 0;
        let mut fill = |cap, params_a, params_b, kinds, ranges_a, ranges_b, count| unsafe {
            sys::nurbs_curve_self_intersections(
                self.raw(),
                tolerance,
                cap,
                params_a,
                params_b,
                kinds,
                ranges_a,
                ranges_b,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_a = vec![0.0; n];
        let mut params_b = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges_a = vec![[0.0; 2]; n];
        let mut ranges_b = vec![[0.0; 2]; n];
        check(fill(
            count,
            params_a.as_mut_ptr(),
            params_b.as_mut_ptr(),
            kinds.as_mut_ptr(),
            ranges_a.as_mut_ptr().cast(),
            ranges_b.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(PairHits { params_a, params_b, kinds, ranges_a, ranges_b, complete: complete != 0 })
    }

    /// The same as `self_intersections`; it can be watched and stopped.
    pub fn self_intersections_with(&self, tolerance: f64, call: &mut Call) -> Result<PairHits> {
        let mut complete = 0;
        let mut fill = |cap, params_a, params_b, kinds, ranges_a, ranges_b, count| unsafe {
            sys::nurbs_curve_self_intersections_with(
                self.raw(),
                tolerance,
                cap,
                params_a,
                params_b,
                kinds,
                ranges_a,
                ranges_b,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_a = vec![0.0; n];
        let mut params_b = vec![0.0; n];
        let mut kinds = vec![0; n];
        let mut ranges_a = vec![[0.0; 2]; n];
        let mut ranges_b = vec![[0.0; 2]; n];
        check(fill(
            count,
            params_a.as_mut_ptr(),
            params_b.as_mut_ptr(),
            kinds.as_mut_ptr(),
            ranges_a.as_mut_ptr().cast(),
            ranges_b.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(PairHits { params_a, params_b, kinds, ranges_a, ranges_b, complete: complete != 0 })
    }

    /// Where a curve meets a surface, with proof that there are no other places.
    pub fn surface_intersections(&self, surface: &Spline, tolerance: f64) -> Result<SurfaceHits> {
        let mut complete = 0;
        let mut fill = |cap, params_curve, params_surface, kinds, ranges_curve, ranges_surface, count| unsafe {
            sys::nurbs_curve_surface_intersections(
                self.raw(),
                surface.raw(),
                tolerance,
                cap,
                params_curve,
                params_surface,
                kinds,
                ranges_curve,
                ranges_surface,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_curve = vec![0.0; n];
        let mut params_surface = vec![[0.0; 2]; n];
        let mut kinds = vec![0; n];
        let mut ranges_curve = vec![[0.0; 2]; n];
        let mut ranges_surface = vec![[0.0; 2]; 2 * n];
        check(fill(
            count,
            params_curve.as_mut_ptr(),
            params_surface.as_mut_ptr().cast(),
            kinds.as_mut_ptr(),
            ranges_curve.as_mut_ptr().cast(),
            ranges_surface.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(SurfaceHits {
            params_curve,
            params_surface,
            kinds,
            ranges_curve,
            ranges_surface,
            complete: complete != 0,
        })
    }

    /// The same as `surface_intersections`; it can be watched and stopped.
    pub fn surface_intersections_with(
        &self,
        surface: &Spline,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<SurfaceHits> {
        let mut complete = 0;
        let mut fill = |cap, params_curve, params_surface, kinds, ranges_curve, ranges_surface, count| unsafe {
            sys::nurbs_curve_surface_intersections_with(
                self.raw(),
                surface.raw(),
                tolerance,
                cap,
                params_curve,
                params_surface,
                kinds,
                ranges_curve,
                ranges_surface,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params_curve = vec![0.0; n];
        let mut params_surface = vec![[0.0; 2]; n];
        let mut kinds = vec![0; n];
        let mut ranges_curve = vec![[0.0; 2]; n];
        let mut ranges_surface = vec![[0.0; 2]; 2 * n];
        check(fill(
            count,
            params_curve.as_mut_ptr(),
            params_surface.as_mut_ptr().cast(),
            kinds.as_mut_ptr(),
            ranges_curve.as_mut_ptr().cast(),
            ranges_surface.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(SurfaceHits {
            params_curve,
            params_surface,
            kinds,
            ranges_curve,
            ranges_surface,
            complete: complete != 0,
        })
    }

    /// The points that three surfaces have in common, with proof that there are no others.
    pub fn common_points(&self, b: &Spline, c: &Spline, tolerance: f64) -> Result<CommonPoints> {
        let mut complete = 0;
        let mut fill = |cap, params, points, kinds, ranges, count| unsafe {
            sys::nurbs_surfaces_common_points(
                self.raw(),
                b.raw(),
                c.raw(),
                tolerance,
                cap,
                params,
                points,
                kinds,
                ranges,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 6]; n];
        let mut points = vec![[0.0; 3]; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; 6 * n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            points.as_mut_ptr().cast(),
            kinds.as_mut_ptr(),
            ranges.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(CommonPoints { params, points, kinds, ranges, complete: complete != 0 })
    }

    /// The same as `common_points`; it can be watched and stopped.
    pub fn common_points_with(
        &self,
        b: &Spline,
        c: &Spline,
        tolerance: f64,
        call: &mut Call,
    ) -> Result<CommonPoints> {
        let mut complete = 0;
        let mut fill = |cap, params, points, kinds, ranges, count| unsafe {
            sys::nurbs_surfaces_common_points_with(
                self.raw(),
                b.raw(),
                c.raw(),
                tolerance,
                cap,
                params,
                points,
                kinds,
                ranges,
                count,
                &mut complete,
                call.options(),
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 6]; n];
        let mut points = vec![[0.0; 3]; n];
        let mut kinds = vec![0; n];
        let mut ranges = vec![[0.0; 2]; 6 * n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            points.as_mut_ptr().cast(),
            kinds.as_mut_ptr(),
            ranges.as_mut_ptr().cast(),
            &mut count,
        ))?;
        Ok(CommonPoints { params, points, kinds, ranges, complete: complete != 0 })
    }

    /// Where rays meet a surface first, with proof.
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
            sys::nurbs_surface_rays(
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
            sys::nurbs_surface_rays_with(
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

    /// All places where a ray meets a surface, by rising t.
    pub fn ray_hits(&self, origin: &[f64; 3], direction: &[f64; 3], range: &[f64]) -> Result<RayHits> {
        let range = if_given(range, 2, "range")?;
        let mut complete = 0;
        let mut fill = |cap, params, distances, kinds, count| unsafe {
            sys::nurbs_surface_ray_hits(
                self.raw(),
                origin.as_ptr(),
                direction.as_ptr(),
                range,
                cap,
                params,
                distances,
                kinds,
                count,
                &mut complete,
            )
        };
        let mut count = 0;
        check(fill(0, null_mut(), null_mut(), null_mut(), &mut count))?;
        let n = count as usize;
        let mut params = vec![[0.0; 2]; n];
        let mut distances = vec![0.0; n];
        let mut kinds = vec![0; n];
        check(fill(
            count,
            params.as_mut_ptr().cast(),
            distances.as_mut_ptr(),
            kinds.as_mut_ptr(),
            &mut count,
        ))?;
        Ok(RayHits { params, distances, kinds, complete: complete != 0 })
    }
}
