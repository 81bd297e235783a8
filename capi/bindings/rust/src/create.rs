// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Construction.

use crate::arrays::{counts_of, optional, pairs_by_axis, Records};
use crate::error::Result;
use crate::sizes::{axes_of, bezier_points, positive, product};
use crate::spline::Spline;
use crate::sys;

/// Construction.
impl Spline {
    /// A spline from full knot vectors, all axes one after the other; the last axis of the points is the
    /// fastest.
    pub fn create<'a>(
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let counts = counts_of(counts, degrees.len(), "counts")?;
        let n = product(&counts);
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(n, positive(dim), "points")?;
        }
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A rational spline from points (w x, w y, ..., w).
    pub fn create_homogeneous<'a>(
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let counts = counts_of(counts, degrees.len(), "counts")?;
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(product(&counts), positive(dim) + 1, "points")?;
        }
        Spline::made(|out| unsafe {
            sys::nurbs_create_homogeneous(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                flags,
                out,
            )
        })
    }

    /// A spline from knot vectors without their first and last knot.
    pub fn create_short<'a>(
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let counts = counts_of(counts, degrees.len(), "counts")?;
        let n = product(&counts);
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(n, positive(dim), "points")?;
        }
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_short(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A spline from distinct knots with multiplicities, one pair of vectors for each axis.
    pub fn create_multiplicities<'a>(
        degrees: &[i32],
        counts: &[usize],
        distinct: &[(&[f64], &[i32])],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let axes = degrees.len();
        let counts = counts_of(counts, axes, "counts")?;
        let (distinct_counts, distinct_knots, multiplicities) = pairs_by_axis(distinct, axes, "distinct")?;
        let n = product(&counts);
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(n, positive(dim), "points")?;
        }
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_multiplicities(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                distinct_counts.as_ptr(),
                distinct_knots.as_ptr(),
                multiplicities.as_ptr(),
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A spline whose periodic axes are given without what they repeat: counts of control points that differ,
    /// and the knots of one period with its end.
    pub fn create_periodic<'a>(
        degrees: &[i32],
        counts: &[usize],
        knots: &[f64],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
        flags: u32,
    ) -> Result<Spline> {
        let points = points.into();
        let counts = counts_of(counts, degrees.len(), "counts")?;
        let n = product(&counts);
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(n, positive(dim), "points")?;
        }
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_periodic(
                axes_of(degrees),
                degrees.as_ptr(),
                counts.as_ptr(),
                knots.as_ptr(),
                knots.len() as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                flags,
                out,
            )
        })
    }

    /// A Bezier spline over [0, 1] on every axis.
    pub fn bezier<'a>(
        degrees: &[i32],
        dim: i32,
        points: impl Into<Records<'a>>,
        weights: Option<&[f64]>,
    ) -> Result<Spline> {
        let points = points.into();
        let n = bezier_points(degrees);
        // Another dimension is left to the library to name.
        if dim > 0 {
            points.require(n, positive(dim), "points")?;
        }
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_create_bezier(
                axes_of(degrees),
                degrees.as_ptr(),
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                out,
            )
        })
    }

    /// The same knots with other points, and other weights if any are given.
    pub fn with_points<'a>(&self, points: impl Into<Records<'a>>, weights: Option<&[f64]>) -> Result<Spline> {
        let points = points.into();
        let n = self.point_count()?;
        points.require(n, self.dimension()? as usize, "points")?;
        let weights = optional(weights, n, "weights")?;
        Spline::made(|out| unsafe {
            sys::nurbs_with_points(
                self.raw(),
                points.pointer(),
                points.stride(),
                points.component_stride(),
                weights,
                0,
                out,
            )
        })
    }

    /// The spline of what to_bytes() made of it, bit for bit.
    pub fn from_bytes(bytes: &[u8]) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_from_bytes(bytes.as_ptr().cast(), bytes.len() as i64, out) })
    }

    /// Another handle on the same data, in constant time.
    pub fn try_clone(&self) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_clone(self.raw(), out) })
    }
}
