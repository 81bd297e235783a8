// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Surfaces and volumes from their boundaries.

use crate::arrays::optional;
use crate::error::{check, Result};
use crate::list::List;
use crate::spline::Spline;
use crate::sys;
use std::ptr::null;

/// What `Spline::coons_hermite` blends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HermiteBoundaries<'a> {
    /// The boundaries, as those of `Spline::coons`.
    pub curves: [&'a Spline; 4],
    /// The derivatives across the curves.
    pub cross: Option<[&'a Spline; 4]>,
    /// A `NURBS_TWIST_` constant.
    pub twist: i32,
    /// `[4][dim]`, for `NURBS_TWIST_GIVEN`.
    pub twists: Option<&'a [f64]>,
}

/// What does not meet at the corners (u0, v0), (u0, v1), (u1, v0), (u1, v1); tangents by u, then by v.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct CoonsGaps {
    /// Of the corners.
    pub positions: [f64; 4],
    /// Of the tangents at each corner.
    pub tangents: [[f64; 2]; 4],
    /// Of the twists at each corner.
    pub twists: [f64; 4],
}

/// The differences at the corners of a surface to be.
pub fn coons_gaps(curves: [&Spline; 4], cross: Option<[&Spline; 4]>) -> Result<CoonsGaps> {
    let curves = curves.map(Spline::raw);
    let cross = cross.map(|splines| splines.map(Spline::raw));
    let mut positions = [0.0; 4];
    let mut tangents = [[0.0; 2]; 4];
    let mut twists = [0.0; 4];
    check(unsafe {
        sys::nurbs_coons_gaps(
            curves.as_ptr(),
            cross.as_ref().map_or(null(), |handles| handles.as_ptr()),
            positions.as_mut_ptr(),
            tangents.as_mut_ptr().cast(),
            twists.as_mut_ptr(),
        )
    })?;
    Ok(CoonsGaps { positions, tangents, twists })
}

/// Surfaces and volumes from their boundaries.
impl Spline {
    /// The four curves of a surface, or the six faces of a volume.
    pub fn boundaries(&self) -> Result<List> {
        List::made(|out| unsafe { sys::nurbs_boundaries(self.raw(), out) })
    }

    /// The bilinear blend of four curves.
    pub fn coons(curves: [&Spline; 4], tolerance: f64) -> Result<Spline> {
        let curves = curves.map(Spline::raw);
        Spline::made(|out| unsafe { sys::nurbs_surface_coons(curves.as_ptr(), tolerance, out) })
    }

    /// The bicubic blend, and the largest difference between its twists and those of the cross tangents.
    pub fn coons_hermite(given: HermiteBoundaries, tolerance: f64) -> Result<(Spline, f64)> {
        let boundaries = given.curves.map(Spline::raw);
        let cross = given.cross.map(|splines| splines.map(Spline::raw));
        let twists = optional(given.twists, 4 * given.curves[0].dimension()? as usize, "twists")?;
        let mut bound = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_surface_coons_hermite(
                boundaries.as_ptr(),
                cross.as_ref().map_or(null(), |handles| handles.as_ptr()),
                given.twist,
                twists,
                tolerance,
                &mut bound,
                out,
            )
        })?;
        Ok((spline, bound))
    }

    /// The linear blend of six faces.
    pub fn coons_volume(faces: [&Spline; 6], tolerance: f64) -> Result<Spline> {
        let faces = faces.map(Spline::raw);
        Spline::made(|out| unsafe { sys::nurbs_volume_coons(faces.as_ptr(), tolerance, out) })
    }
}
