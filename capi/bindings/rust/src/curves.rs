// SPDX-License-Identifier: MIT
// Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
//! Lines, conics and helices.

use crate::arrays::{optional, Records};
use crate::error::{check, Result};
use crate::placement::{dimension_of, pointer, require_length, Placement, Turn};
use crate::sizes::positive;
use crate::spline::Spline;
use crate::sys;

/// A conic of the plane: its kind, centre or vertex, the direction to its vertex or focus, and semi-axes or
/// focal length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ConicAxes {
    /// One of the `NURBS_CONIC_` constants.
    pub kind: i32,
    /// Centre or vertex.
    pub origin: [f64; 2],
    /// Direction to the vertex or focus.
    pub x: [f64; 2],
    /// Semi-axes, or the focal length.
    pub sizes: [f64; 2],
}

/// A helix, where radius and height change evenly with the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HelixShape {
    /// At the start.
    pub radius: f64,
    /// Of the radius in a turn.
    pub growth: f64,
    /// Rise in a turn.
    pub pitch: f64,
    /// The angle where it starts.
    pub start: f64,
    /// How many there are.
    pub turns: f64,
}

impl Default for HelixShape {
    fn default() -> Self {
        HelixShape { radius: 1.0, growth: 0.0, pitch: 0.0, start: 0.0, turns: 1.0 }
    }
}

/// Kind and axes of A x^2 + B x y + C y^2 + D x + E y + F = 0.
pub fn conic_axes(coefficients: &[f64; 6]) -> Result<ConicAxes> {
    let mut kind = 0;
    let mut origin = [0.0; 2];
    let mut x = [0.0; 2];
    let mut sizes = [0.0; 2];
    check(unsafe {
        sys::nurbs_conic_axes(
            coefficients.as_ptr(),
            &mut kind,
            origin.as_mut_ptr(),
            x.as_mut_ptr(),
            sizes.as_mut_ptr(),
        )
    })?;
    Ok(ConicAxes { kind, origin, x, sizes })
}

/// Lines.
impl Spline {
    /// From a to b.
    pub fn line(a: &[f64], b: &[f64]) -> Result<Spline> {
        let dim = a.len() as i32;
        require_length(dim, &[b])?;
        Spline::made(|out| unsafe { sys::nurbs_curve_line(dim, a.as_ptr(), b.as_ptr(), out) })
    }

    /// Through points `[n][dim]`, at 0, 1, ..., n - 1 unless parameters are given.
    pub fn polyline<'a>(dim: i32, points: impl Into<Records<'a>>, params: Option<&[f64]>) -> Result<Spline> {
        let points = points.into();
        let n = points.count(positive(dim), "points")?;
        let params = optional(params, n, "params")?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_polyline(
                n as i64,
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                params,
                0,
                out,
            )
        })
    }

    /// A closed regular polygon; the radius is that of its corners.
    pub fn polygon(at: Placement, radius: f64, sides: i64) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe { sys::nurbs_curve_polygon(dim, center, axis, x, radius, sides, out) })
    }

    /// A rectangle about a centre, its corners quarter circles.
    pub fn rounded_rectangle(at: Placement, width: f64, height: f64, corner_radius: f64) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_rounded_rectangle(dim, center, axis, x, width, height, corner_radius, out)
        })
    }
}

/// Circles.
impl Spline {
    /// A full circle; `form` is one of the `NURBS_ARC_` constants, as in all that follow.
    pub fn circle(at: Placement, radius: f64, form: i32) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe { sys::nurbs_curve_circle(dim, center, axis, x, radius, form, out) })
    }

    /// A part of a circle.
    pub fn arc(at: Placement, radius: f64, turn: Turn, form: i32) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_arc(dim, center, axis, x, radius, turn.start, turn.sweep, form, out)
        })
    }

    /// From a through b to c.
    pub fn arc_through(a: &[f64], b: &[f64], c: &[f64], form: i32) -> Result<Spline> {
        let dim = a.len() as i32;
        require_length(dim, &[b, c])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_arc_through(dim, a.as_ptr(), b.as_ptr(), c.as_ptr(), form, out)
        })
    }

    /// From a in the direction of a tangent to b.
    pub fn arc_tangent(a: &[f64], tangent: &[f64], b: &[f64], form: i32) -> Result<Spline> {
        let dim = a.len() as i32;
        require_length(dim, &[tangent, b])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_arc_tangent(dim, a.as_ptr(), tangent.as_ptr(), b.as_ptr(), form, out)
        })
    }
}

/// Conics.
impl Spline {
    /// Semi-axes along X and Y; angles are eccentric ones.
    pub fn ellipse(at: Placement, radii: [f64; 2], turn: Turn, form: i32) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_ellipse(
                dim, center, axis, x, radii[0], radii[1], turn.start, turn.sweep, form, out,
            )
        })
    }

    /// Over [start, end], the coordinates along Y; x points from the vertex to the focus.
    pub fn parabola(at: Placement, focal_length: f64, start: f64, end: f64) -> Result<Spline> {
        let (dim, [vertex, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_parabola(dim, vertex, axis, x, focal_length, start, end, out)
        })
    }

    /// The branch that opens to x.
    pub fn hyperbola(at: Placement, radii: [f64; 2], start: f64, end: f64) -> Result<Spline> {
        let (dim, [center, axis, x]) = at.place(2)?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_hyperbola(dim, center, axis, x, radii[0], radii[1], start, end, out)
        })
    }

    /// By a control triangle and C_sf = w1^2 / (w0 w2).
    pub fn conic_triangle(p0: &[f64], p1: &[f64], p2: &[f64], shape_factor: f64) -> Result<Spline> {
        let dim = p0.len() as i32;
        require_length(dim, &[p1, p2])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_triangle(dim, p0.as_ptr(), p1.as_ptr(), p2.as_ptr(), shape_factor, out)
        })
    }

    /// By two points with tangents, and how far the shoulder point is on its way from the chord to the
    /// tangents.
    pub fn conic_shoulder(
        a: &[f64],
        tangent_a: &[f64],
        b: &[f64],
        tangent_b: &[f64],
        rho: f64,
    ) -> Result<Spline> {
        let dim = a.len() as i32;
        require_length(dim, &[tangent_a, b, tangent_b])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_shoulder(
                dim,
                a.as_ptr(),
                tangent_a.as_ptr(),
                b.as_ptr(),
                tangent_b.as_ptr(),
                rho,
                out,
            )
        })
    }

    /// By two points with tangent lines, and a third point between them.
    pub fn conic_point(
        a: &[f64],
        tangent_a: &[f64],
        b: &[f64],
        tangent_b: &[f64],
        point: &[f64],
        form: i32,
    ) -> Result<Spline> {
        let dim = a.len() as i32;
        require_length(dim, &[tangent_a, b, tangent_b, point])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_point(
                dim,
                a.as_ptr(),
                tangent_a.as_ptr(),
                b.as_ptr(),
                tangent_b.as_ptr(),
                point.as_ptr(),
                form,
                out,
            )
        })
    }

    /// Through five points `[5][dim]`.
    pub fn conic_through<'a>(dim: i32, points: impl Into<Records<'a>>, form: i32) -> Result<Spline> {
        let points = points.into();
        points.require(5, positive(dim), "points")?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_through(
                dim,
                points.pointer(),
                points.stride(),
                points.component_stride(),
                form,
                out,
            )
        })
    }

    /// An arc of the conic that `conic_axes` describes.
    pub fn conic_implicit(coefficients: &[f64; 6], start: f64, end: f64, form: i32) -> Result<Spline> {
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_implicit(coefficients.as_ptr(), start, end, form, out)
        })
    }

    /// By a focus, the nearest point of the directrix, and the eccentricity; the axis is empty in the plane.
    pub fn conic_focus(
        focus: &[f64],
        axis: &[f64],
        foot: &[f64],
        eccentricity: f64,
        turn: Turn,
        form: i32,
    ) -> Result<Spline> {
        let dim = dimension_of(&[focus, axis, foot], 0)?;
        require_length(dim, &[focus, foot])?;
        Spline::made(|out| unsafe {
            sys::nurbs_curve_conic_focus(
                dim,
                focus.as_ptr(),
                pointer(axis),
                foot.as_ptr(),
                eccentricity,
                turn.start,
                turn.sweep,
                form,
                out,
            )
        })
    }

    /// C_sf and the kind, a `NURBS_CONIC_` constant, of a conic segment of degree 2.
    pub fn shape_factor(&self) -> Result<(f64, i32)> {
        let mut factor = 0.0;
        let mut kind = 0;
        check(unsafe { sys::nurbs_curve_shape_factor(self.raw(), &mut factor, &mut kind) })?;
        Ok((factor, kind))
    }
}

/// Helices.
impl Spline {
    /// The curve, and a proven bound of its distance from the true one.
    pub fn helix(at: Placement, shape: HelixShape, tolerance: f64) -> Result<(Spline, f64)> {
        let (dim, [origin, axis, x]) = at.place(3)?;
        let mut error = 0.0;
        let spline = Spline::made(|out| unsafe {
            sys::nurbs_curve_helix(
                dim,
                origin,
                axis,
                x,
                shape.radius,
                shape.growth,
                shape.pitch,
                shape.start,
                shape.turns,
                tolerance,
                &mut error,
                out,
            )
        })?;
        Ok((spline, error))
    }
}
