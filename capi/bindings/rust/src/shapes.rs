// SPDX-License-Identifier: MIT
//! Surfaces and volumes from curves.

use crate::arrays::Records;
use crate::error::{Error, Result};
use crate::list::List;
use crate::placement::{dimension_of, pointer, require_length, Placement, Turn};
use crate::spline::Spline;
use crate::sys;

/// From curves and surfaces.
impl Spline {
    /// Moved along a vector, which becomes a new last axis.
    pub fn extrude(&self, vector: &[f64]) -> Result<Spline> {
        require_length(self.dimension()?, &[vector])?;
        Spline::made(|out| unsafe { sys::nurbs_extrude(self.raw(), vector.as_ptr(), out) })
    }
    /// Turned about an axis through a point (empty: the z axis), the angle being a new first axis.
    pub fn revolve(&self, point: &[f64], axis: &[f64], sweep: f64, form: i32) -> Result<Spline> {
        let dim = dimension_of(&[point, axis], 3)?;
        if dim != 3 {
            return Err(Error::size("point and axis", dim as usize, String::from("3")));
        }
        let (g, p, z) = (self.raw(), pointer(point), pointer(axis));
        Spline::made(|out| unsafe { sys::nurbs_revolve(g, p, z, sweep, form, out) })
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
        let (t, p) = (trajectory.raw(), profile.raw());
        Spline::made(|out| unsafe { sys::nurbs_surface_swung(t, p, scale, out) })
    }
}

/// Patches.
impl Spline {
    /// The parallelogram over two sides from an origin, which is 0 if empty.
    pub fn plane(origin: &[f64], u: &[f64], v: &[f64]) -> Result<Spline> {
        let dim = dimension_of(&[origin, u, v], 0)?;
        require_length(dim, &[u, v])?;
        let (o, u, v) = (pointer(origin), u.as_ptr(), v.as_ptr());
        Spline::made(|out| unsafe { sys::nurbs_surface_plane(dim, o, u, v, out) })
    }
    /// Over corners `[4][dim]`.
    pub fn bilinear<'a>(dim: i32, corners: impl Into<Records<'a>>) -> Result<Spline> {
        let c = corners.into();
        c.require(4, dim.max(0) as usize, "corners")?;
        let (first, stride, component) = (c.pointer(), c.stride(), c.component_stride());
        Spline::made(|out| unsafe { sys::nurbs_surface_bilinear(dim, first, stride, component, out) })
    }
    /// Over corners `[8][dim]`.
    pub fn trilinear<'a>(dim: i32, corners: impl Into<Records<'a>>) -> Result<Spline> {
        let c = corners.into();
        c.require(8, dim.max(0) as usize, "corners")?;
        let (first, stride, component) = (c.pointer(), c.stride(), c.component_stride());
        Spline::made(|out| unsafe { sys::nurbs_volume_trilinear(dim, first, stride, component, out) })
    }
}

/// Spheres. The form is a `NURBS_ARC_` constant.
impl Spline {
    /// By longitude and latitude, with poles.
    pub fn sphere(at: Placement, radius: f64, form: i32) -> Result<Spline> {
        let [o, z, x] = at.space()?;
        Spline::made(|out| unsafe { sys::nurbs_surface_sphere(o, z, x, radius, form, out) })
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
        let [o, z, x] = at.space()?;
        let Turn { start, sweep } = turn;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_spherical_patch(o, z, x, radius, start, sweep, south, north, form, out)
        })
    }
    /// Six patches of degree 4 x 4 without poles; flags: `NURBS_HEMISPHERE`, five patches.
    pub fn sphere_patches(at: Placement, radius: f64, flags: u32) -> Result<List> {
        let [o, z, x] = at.space()?;
        List::made(|out| unsafe { sys::nurbs_surface_sphere_patches(o, z, x, radius, flags, out) })
    }
    /// Semi-axes along X, Y and Z.
    pub fn ellipsoid(at: Placement, radii: [f64; 3], form: i32) -> Result<Spline> {
        let ([o, z, x], [rx, ry, rz]) = (at.space()?, radii);
        Spline::made(|out| unsafe { sys::nurbs_surface_ellipsoid(o, z, x, rx, ry, rz, form, out) })
    }
}

/// Surfaces of revolution.
impl Spline {
    /// The side of a cylinder, or a part of it.
    pub fn cylinder(at: Placement, radius: f64, height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let ([o, z, x], Turn { start, sweep }) = (at.space()?, turn);
        Spline::made(|out| unsafe {
            sys::nurbs_surface_cylinder(o, z, x, radius, height, start, sweep, form, out)
        })
    }
    /// Radii of the base and of the top.
    pub fn cone(at: Placement, radii: [f64; 2], height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let ([o, z, x], [base, top], Turn { start, sweep }) = (at.space()?, radii, turn);
        Spline::made(|out| unsafe {
            sys::nurbs_surface_cone(o, z, x, base, top, height, start, sweep, form, out)
        })
    }
    /// Major and minor radius; angles about the axis, and about the tube.
    pub fn torus(at: Placement, radii: [f64; 2], turn: Turn, tube: Turn, form: i32) -> Result<Spline> {
        let ([o, z, x], [major, minor]) = (at.space()?, radii);
        let (a, da, b, db) = (turn.start, turn.sweep, tube.start, tube.sweep);
        Spline::made(|out| unsafe {
            sys::nurbs_surface_torus(o, z, x, major, minor, a, da, b, db, form, out)
        })
    }
}

/// Other quadrics.
impl Spline {
    /// A bowl from its vertex to a rim with two semi-axes.
    pub fn paraboloid(at: Placement, radii: [f64; 2], height: f64, turn: Turn, form: i32) -> Result<Spline> {
        let ([o, z, x], [rx, ry], Turn { start, sweep }) = (at.space()?, radii, turn);
        Spline::made(|out| unsafe {
            sys::nurbs_surface_paraboloid(o, z, x, rx, ry, height, start, sweep, form, out)
        })
    }
    /// The hyperbolic paraboloid over a rectangle.
    pub fn saddle(at: Placement, radii: [f64; 2], height: f64) -> Result<Spline> {
        let ([o, z, x], [rx, ry]) = (at.space()?, radii);
        Spline::made(|out| unsafe { sys::nurbs_surface_saddle(o, z, x, rx, ry, height, out) })
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
        let ([o, z, x], [rx, ry, rz], [bottom, top]) = (at.space()?, radii, heights);
        let Turn { start, sweep } = turn;
        Spline::made(|out| unsafe {
            sys::nurbs_surface_hyperboloid(o, z, x, rx, ry, rz, bottom, top, start, sweep, form, flags, out)
        })
    }
}
