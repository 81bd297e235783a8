// SPDX-License-Identifier: MIT
//! Deformations of a shape or of a region of it.

use crate::arrays::{exactly, if_given};
use crate::error::Result;
use crate::reduce::Reduced;
use crate::spline::Spline;
use crate::sys;

/// A spline near the exact image: how far it is from that, a bound if proven, else of samples.
#[derive(Debug)]
#[non_exhaustive]
pub struct Deformed {
    /// The spline.
    pub spline: Spline,
    /// How far it is from the exact image.
    pub deviation: f64,
    /// Whether that is a bound, or else of samples.
    pub proven: bool,
}

/// A bend about an axis across the plane of the unit vectors of `along` and `across`.
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
    /// The bent part; infinite ends are allowed.
    pub lower: f64,
    /// The end of what is bent along it.
    pub upper: f64,
}

/// The spline, its energies before and after, and a bound of how far it moved.
#[derive(Debug)]
#[non_exhaustive]
pub struct Faired {
    /// The spline.
    pub spline: Spline,
    /// Before and after.
    pub energies: [f64; 2],
    /// Of how far it moved.
    pub bound: f64,
}

/// Deformations. A range is a part `[axes][2]` of the domain, empty for all of it.
impl Spline {
    /// A region raised along a direction; `order` derivatives stay at its ends.
    pub fn warp(&self, direction: &[f64], distance: f64, order: i32, range: &[f64]) -> Result<Spline> {
        let (along, part) = (self.vector(direction, "direction")?, self.range(range)?);
        Spline::made(|out| unsafe { sys::nurbs_warp(self.raw(), part, along, distance, order, out) })
    }
    /// A region flattened to the plane through a point, along a direction or, if that is empty, its normal; and how far
    /// a control point moved.
    pub fn flatten(
        &self,
        point: &[f64],
        normal: &[f64],
        direction: &[f64],
        range: &[f64],
    ) -> Result<(Spline, f64)> {
        let (on, up) = (self.vector(point, "point")?, self.vector(normal, "normal")?);
        let along = if_given(direction, self.dimension()? as usize, "direction")?;
        let (g, part, mut moved) = (self.raw(), self.range(range)?, 0.0);
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_flatten(g, part, on, up, along, &mut moved, out) })?;
        Ok((spline, moved))
    }
    /// A bend about an axis across the plane of two vectors.
    pub fn bend(&self, how: Bend, tolerance: f64) -> Result<Deformed> {
        let (g, origin) = (self.raw(), self.vector(how.origin, "origin")?);
        let (along, across) = (self.vector(how.along, "along")?, self.vector(how.across, "across")?);
        let (k, lower, upper) = (how.curvature, how.lower, how.upper);
        let (mut deviation, mut proven) = (0.0, 0);
        let (d, p) = (&mut deviation, &mut proven);
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_bend(g, origin, along, across, k, lower, upper, tolerance, d, p, out)
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
        let (g, v, axes) = (self.raw(), volume.raw(), volume.axes()? as usize);
        let (from, to) = (exactly(lower, axes, "lower")?, exactly(upper, axes, "upper")?);
        let (mut deviation, mut proven) = (0.0, 0);
        let (d, p) = (&mut deviation, &mut proven);
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_free_form_deform(g, v, from, to, tolerance, d, p, out) })?;
        Ok(Deformed { spline, deviation, proven: proven != 0 })
    }
    /// Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3; `keep` `[axes][2]` holds the orders of
    /// derivatives that stay at the ends, empty: positions.
    pub fn fair(&self, order: i32, tolerance: f64, keep: &[i32]) -> Result<Faired> {
        let stay = if_given(keep, 2 * self.axes()? as usize, "keep")?;
        let (g, mut energies, mut bound) = (self.raw(), [0.0; 2], 0.0);
        let e = energies.as_mut_ptr();
        let spline =
            Spline::made(|out| unsafe { sys::nurbs_fair(g, order, stay, tolerance, e, &mut bound, out) })?;
        Ok(Faired { spline, energies, bound })
    }
    /// A boundary (axis, `NURBS_START` or `NURBS_END`) moved onto one of another spline, with order 1 tangents too;
    /// flags: 0 or `NURBS_REVERSED`.
    pub fn snap_boundary(
        &self,
        boundary: (i32, i32),
        other: (&Spline, i32, i32),
        order: i32,
        flags: u32,
    ) -> Result<Reduced> {
        let ((axis, end), (target, other_axis, other_end)) = (boundary, other);
        let (g, t, mut bound) = (self.raw(), target.raw(), 0.0);
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_snap_boundary(g, axis, end, t, other_axis, other_end, order, flags, &mut bound, out)
        })?;
        Ok(Reduced { spline, bound })
    }
}
