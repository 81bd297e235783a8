// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Deformations of a shape or of a region `[axes][2]` of it.

use crate::arrays::{exactly, if_given};
use crate::call::Call;
use crate::error::Result;
use crate::reduce::Reduced;
use crate::spline::Spline;
use crate::sys;

/// A spline near the exact image: how far it is from that, a bound if proven, else of samples.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Deformed {
    /// The spline.
    pub spline: Spline,
    /// How far it is from the exact image.
    pub deviation: f64,
    /// Whether that is a bound, or else of samples.
    pub proven: bool,
}

/// A bend about an axis across the plane of two vectors `[dim]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend<'a> {
    /// A point that stays, `[dim]`.
    pub origin: &'a [f64],
    /// The direction that is bent, `[dim]`.
    pub along: &'a [f64],
    /// The direction away from the axis, `[dim]`.
    pub across: &'a [f64],
    /// Of the line along.
    pub curvature: f64,
    /// The start of the bent part; infinite ends are allowed.
    pub lower: f64,
    /// The end of what is bent along it.
    pub upper: f64,
}

impl Default for Bend<'_> {
    fn default() -> Self {
        Bend {
            origin: &[],
            along: &[],
            across: &[],
            curvature: 0.0,
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
        }
    }
}

/// The spline, its energies before and after, and a bound of how far it moved.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Faired {
    /// The spline.
    pub spline: Spline,
    /// Before and after.
    pub energies: [f64; 2],
    /// Of how far it moved.
    pub bound: f64,
}

/// Deformations of a shape or of a region `[axes][2]` of it.
impl Spline {
    /// A region raised along a direction `[dim]`; `order` derivatives stay at its ends.
    pub fn warp(&self, direction: &[f64], distance: f64, order: i32, range: &[f64]) -> Result<Spline> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let direction = exactly(direction, self.dimension()? as usize, "direction")?;
        Spline::made(|out| unsafe { sys::nurbs_warp(self.raw(), range, direction, distance, order, out) })
    }

    /// A region flattened to the plane through a point, along a direction or, if that is empty, its normal;
    /// and how far a control point moved.
    pub fn flatten(
        &self,
        point: &[f64],
        normal: &[f64],
        direction: &[f64],
        range: &[f64],
    ) -> Result<(Spline, f64)> {
        let range = if_given(range, 2 * self.axes()? as usize, "range")?;
        let dim = self.dimension()? as usize;
        let point = exactly(point, dim, "point")?;
        let normal = exactly(normal, dim, "normal")?;
        let direction = if_given(direction, dim, "direction")?;
        let mut moved = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_flatten(self.raw(), range, point, normal, direction, &mut moved, out)
        })?;
        Ok((spline, moved))
    }

    /// A bend about an axis across the plane of two vectors.
    pub fn bend(&self, how: Bend, tolerance: f64) -> Result<Deformed> {
        let dim = self.dimension()? as usize;
        let origin = exactly(how.origin, dim, "origin")?;
        let along = exactly(how.along, dim, "along")?;
        let across = exactly(how.across, dim, "across")?;
        let mut deviation = 0.0;
        let mut proven = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_bend(
                self.raw(),
                origin,
                along,
                across,
                how.curvature,
                how.lower,
                how.upper,
                tolerance,
                &mut deviation,
                &mut proven,
                out,
            )
        })?;
        Ok(Deformed { spline, deviation, proven: proven != 0 })
    }

    /// The same as `bend`; it can be watched and stopped.
    pub fn bend_with(&self, how: Bend, tolerance: f64, call: &mut Call) -> Result<Deformed> {
        let dim = self.dimension()? as usize;
        let origin = exactly(how.origin, dim, "origin")?;
        let along = exactly(how.along, dim, "along")?;
        let across = exactly(how.across, dim, "across")?;
        let mut deviation = 0.0;
        let mut proven = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_bend_with(
                self.raw(),
                origin,
                along,
                across,
                how.curvature,
                how.lower,
                how.upper,
                tolerance,
                &mut deviation,
                &mut proven,
                call.options(),
                out,
            )
        })?;
        Ok(Deformed { spline, deviation, proven: proven != 0 })
    }

    /// A shape in the box from `lower` to `upper` mapped by a volume.
    pub fn free_form_deform(
        &self,
        volume: &Spline,
        lower: &[f64],
        upper: &[f64],
        tolerance: f64,
    ) -> Result<Deformed> {
        let lower = exactly(lower, volume.axes()? as usize, "lower")?;
        let upper = exactly(upper, volume.axes()? as usize, "upper")?;
        let mut deviation = 0.0;
        let mut proven = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_free_form_deform(
                self.raw(),
                volume.raw(),
                lower,
                upper,
                tolerance,
                &mut deviation,
                &mut proven,
                out,
            )
        })?;
        Ok(Deformed { spline, deviation, proven: proven != 0 })
    }

    /// The same as `free_form_deform`; it can be watched and stopped.
    pub fn free_form_deform_with(
        &self,
        volume: &Spline,
        lower: &[f64],
        upper: &[f64],
        tolerance: f64,
        call: &mut Call,
    ) -> Result<Deformed> {
        let lower = exactly(lower, volume.axes()? as usize, "lower")?;
        let upper = exactly(upper, volume.axes()? as usize, "upper")?;
        let mut deviation = 0.0;
        let mut proven = 0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_free_form_deform_with(
                self.raw(),
                volume.raw(),
                lower,
                upper,
                tolerance,
                &mut deviation,
                &mut proven,
                call.options(),
                out,
            )
        })?;
        Ok(Deformed { spline, deviation, proven: proven != 0 })
    }

    /// Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3; `keep` `[axes][2]` holds the
    /// orders of derivatives that stay at the ends, empty: positions.
    pub fn fair(&self, order: i32, tolerance: f64, keep: &[i32]) -> Result<Faired> {
        let keep = if_given(keep, 2 * self.axes()? as usize, "keep")?;
        let mut energies = [0.0; 2];
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fair(self.raw(), order, keep, tolerance, energies.as_mut_ptr(), &mut bound, out)
        })?;
        Ok(Faired { spline, energies, bound })
    }

    /// The same as `fair`; it can be watched and stopped.
    pub fn fair_with(&self, order: i32, tolerance: f64, keep: &[i32], call: &mut Call) -> Result<Faired> {
        let keep = if_given(keep, 2 * self.axes()? as usize, "keep")?;
        let mut energies = [0.0; 2];
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_fair_with(
                self.raw(),
                order,
                keep,
                tolerance,
                energies.as_mut_ptr(),
                &mut bound,
                call.options(),
                out,
            )
        })?;
        Ok(Faired { spline, energies, bound })
    }

    /// A boundary (axis, `NURBS_START` or `NURBS_END`) moved onto one of another spline, with order 1
    /// tangents too; flags: 0 or `NURBS_REVERSED`.
    pub fn snap_boundary(
        &self,
        boundary: (i32, i32),
        other: (&Spline, i32, i32),
        order: i32,
        flags: u32,
    ) -> Result<Reduced> {
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_snap_boundary(
                self.raw(),
                boundary.0,
                boundary.1,
                other.0.raw(),
                other.1,
                other.2,
                order,
                flags,
                &mut bound,
                out,
            )
        })?;
        Ok(Reduced { spline, bound })
    }
}
