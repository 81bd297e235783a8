// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Surfaces and volumes from curves.

use crate::arrays::{exactly, if_given, Records};
use crate::error::Result;
use crate::list::List;
use crate::placement::{dimension_of, pointer, require_length, Placement, Turn};
use crate::sizes::positive;
use crate::spline::Spline;
use crate::sys;

/// From curves and surfaces.
impl Spline {
    /// Moved along a vector, which becomes a new last axis.
    pub fn extrude(&self, vector: &[f64]) -> Result<Spline> {
        let vector = exactly(vector, self.dimension()? as usize, "vector")?;
        Spline::made(|out| unsafe { sys::nurbs_extrude(self.raw(), vector, out) })
    }

    /// Turned about an axis through a point (empty: the z axis), the angle being a new first axis.
    pub fn revolve(&self, point: &[f64], axis: &[f64], sweep: f64, form: i32) -> Result<Spline> {
        let point = if_given(point, 3, "point and axis")?;
        let axis = if_given(axis, 3, "point and axis")?;
        Spline::made(|out| unsafe { sys::nurbs_revolve(self.raw(), point, axis, sweep, form, out) })
    }

    /// Straight lines from this spline to the other one; flags: `NURBS_RULED_CARTESIAN`.
    pub fn ruled(&self, other: &Spline, flags: u32) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_ruled(self.raw(), other.raw(), flags, out) })
    }

    /// alpha times this spline at u and beta times the other one at v.
    pub fn tensor_sum(&self, alpha: f64, other: &Spline, beta: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_tensor_sum(self.raw(), alpha, other.raw(), beta, out) })
    }

    /// This spline at u times the other one at v, component by component.
    pub fn tensor_product(&self, other: &Spline) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_tensor_product(self.raw(), other.raw(), out) })
    }

    /// (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the profile (r, z).
    pub fn swung(trajectory: &Spline, profile: &Spline, scale: f64) -> Result<Spline> {
        Spline::made(|out| unsafe { sys::nurbs_surface_swung(trajectory.raw(), profile.raw(), scale, out) })
    }
}

/// Patches.
impl Spline {
    /// The parallelogram over two sides from an origin, which is 0 if empty.
    pub fn plane(origin: &[f64], u: &[f64], v: &[f64]) -> Result<Spline> {
        let dim = dimension_of(&[origin, u, v], 0)?;
        require_length(dim, &[u, v])?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_plane(dim, pointer(origin), u.as_ptr(), v.as_ptr(), out)
        })
    }

    /// Over corners `[4][dim]`.
    pub fn bilinear<'a>(dim: i32, corners: impl Into<Records<'a>>) -> Result<Spline> {
        let corners = corners.into();
        corners.require(4, positive(dim), "corners")?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_bilinear(
                dim,
                corners.pointer(),
                corners.stride(),
                corners.component_stride(),
                out,
            )
        })
    }

    /// Over corners `[8][dim]`.
    pub fn trilinear<'a>(dim: i32, corners: impl Into<Records<'a>>) -> Result<Spline> {
        let corners = corners.into();
        corners.require(8, positive(dim), "corners")?;
        Spline::made(|out| unsafe {
            sys::nurbs_volume_trilinear(
                dim,
                corners.pointer(),
                corners.stride(),
                corners.component_stride(),
                out,
            )
        })
    }
}

/// Spheres.
impl Spline {
    /// By longitude and latitude, with poles.
    pub fn sphere(at: Placement, radius: f64, form: i32) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe { sys::nurbs_surface_sphere(center, axis, x, radius, form, out) })
    }

    /// Longitudes, and latitudes from south to north.
    pub fn spherical_patch(
        at: Placement,
        radius: f64,
        turn: Turn,
        south: f64,
        north: f64,
        form: i32,
    ) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_spherical_patch(
                center, axis, x, radius, turn.start, turn.sweep, south, north, form, out,
            )
        })
    }

    /// Six patches of degree 4 x 4 without poles; flags: `NURBS_HEMISPHERE`, five patches.
    pub fn sphere_patches(at: Placement, radius: f64, flags: u32) -> Result<List> {
        let [center, axis, x] = at.space()?;
        List::made(|out| unsafe { sys::nurbs_surface_sphere_patches(center, axis, x, radius, flags, out) })
    }

    /// Semi-axes along X, Y and Z.
    pub fn ellipsoid(at: Placement, radii: [f64; 3], form: i32) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_ellipsoid(center, axis, x, radii[0], radii[1], radii[2], form, out)
        })
    }
}

/// Surfaces of revolution.
impl Spline {
    /// The side of a cylinder, or a part of it.
    pub fn cylinder(at: Placement, radius: f64, height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let [origin, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_cylinder(origin, axis, x, radius, height, turn.start, turn.sweep, form, out)
        })
    }

    /// Radii of the base and of the top.
    pub fn cone(at: Placement, radii: [f64; 2], height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let [origin, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_cone(
                origin, axis, x, radii[0], radii[1], height, turn.start, turn.sweep, form, out,
            )
        })
    }

    /// Major and minor radius; angles about the axis, and about the tube.
    pub fn torus(at: Placement, radii: [f64; 2], turn: Turn, tube: Turn, form: i32) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_torus(
                center, axis, x, radii[0], radii[1], turn.start, turn.sweep, tube.start, tube.sweep, form,
                out,
            )
        })
    }
}

/// Other quadrics.
impl Spline {
    /// A bowl from its vertex to a rim with two semi-axes.
    pub fn paraboloid(at: Placement, radii: [f64; 2], height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let [vertex, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_paraboloid(
                vertex, axis, x, radii[0], radii[1], height, turn.start, turn.sweep, form, out,
            )
        })
    }

    /// The hyperbolic paraboloid over a rectangle.
    pub fn saddle(at: Placement, radii: [f64; 2], height: f64) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_saddle(center, axis, x, radii[0], radii[1], height, out)
        })
    }

    /// Between the heights bottom and top; flags: `NURBS_TWO_SHEETS`.
    pub fn hyperboloid(
        at: Placement,
        radii: [f64; 3],
        heights: [f64; 2],
        turn: Turn,
        form: i32,
        flags: u32,
    ) -> Result<Spline> {
        let [center, axis, x] = at.space()?;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_hyperboloid(
                center, axis, x, radii[0], radii[1], radii[2], heights[0], heights[1], turn.start,
                turn.sweep, form, flags, out,
            )
        })
    }
}
