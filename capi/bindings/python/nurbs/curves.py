# SPDX-License-Identifier: MIT
"""Lines, conics and helices.

`center`, `axis` and `x` place a shape; their length is its dimension. Without any of them a helix stands in space and
other curves in the plane, about the origin. Angles are in radians.
"""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import records, vector
from ._library import check, lib
from ._placement import FULL_TURN, Vectors, place
from .constants import NURBS_ARC_QUARTERS
from .spline import Spline

#: Kind of a conic, centre or vertex, direction to its vertex or focus, semi-axes or focal length.
ConicAxes = namedtuple("ConicAxes", "type origin x sizes")
ShapeFactor = namedtuple("ShapeFactor", "factor type")
Helix = namedtuple("Helix", "spline error")


def _placed(function, center, axis, x, *arguments):
    where, _alive = place(center, axis, x)
    return Spline._made(function, *where, *arguments)


def _through(function, vectors, *arguments):
    given = Vectors(*vectors)
    return Spline._made(function, given.dim, *given.addresses, *arguments)


def _table(points, rows=None):
    table = numpy.asarray(points, dtype=numpy.float64)
    if table.ndim != 2 or rows not in (None, len(table)):
        raise ValueError(f"points of shape {table.shape}, expected ({'n' if rows is None else rows}, dim)")
    return records(table, table.shape[1]), table.shape[1]


def line(a, b):
    """The segment from a to b."""
    return _through(lib.nurbs_curve_line, (a, b))


def polyline(points, params=None):
    """The polyline through points (n, dim), at 0, 1, ..., n - 1 unless parameters are given."""
    given, dim = _table(points)
    at = None if params is None else vector(params, numpy.float64)
    if at is not None and at.size != given.n:
        raise ValueError(f"{at.size} parameters for {given.n} points")
    return Spline._made(lib.nurbs_curve_polyline, given.n, dim, *given.layout, None if at is None else at.ctypes.data, 0)


def polygon(sides, radius=1.0, center=None, axis=None, x=None):
    """A closed regular polygon; the radius is that of its corners."""
    return _placed(lib.nurbs_curve_polygon, center, axis, x, radius, sides)


def rounded_rectangle(width, height, corner_radius=0.0, center=None, axis=None, x=None):
    """A closed rectangle about a centre, its corners quarter circles."""
    return _placed(lib.nurbs_curve_rounded_rectangle, center, axis, x, width, height, corner_radius)


def circle(radius=1.0, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """The full circle, counterclockwise about the axis from the direction x."""
    return _placed(lib.nurbs_curve_circle, center, axis, x, radius, form)


def arc(radius, start, sweep, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """A circular arc from the angle `start` to `start + sweep`."""
    return _placed(lib.nurbs_curve_arc, center, axis, x, radius, start, sweep, form)


def arc_through(a, b, c, form=NURBS_ARC_QUARTERS):
    """The circular arc from a through b to c."""
    return _through(lib.nurbs_curve_arc_through, (a, b, c), form)


def arc_tangent(a, tangent, b, form=NURBS_ARC_QUARTERS):
    """The circular arc that leaves a in the direction of a tangent and ends at b."""
    return _through(lib.nurbs_curve_arc_tangent, (a, tangent, b), form)


def ellipse(radius_x, radius_y, start=0.0, sweep=FULL_TURN, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """An elliptic arc, or the whole ellipse; angles are eccentric ones."""
    return _placed(lib.nurbs_curve_ellipse, center, axis, x, radius_x, radius_y, start, sweep, form)


def parabola(focal_length, start, end, vertex=None, axis=None, x=None):
    """A parabolic arc over [start, end], the coordinates across; x points from the vertex to the focus."""
    return _placed(lib.nurbs_curve_parabola, vertex, axis, x, focal_length, start, end)


def hyperbola(radius_x, radius_y, start, end, center=None, axis=None, x=None):
    """An arc of the branch of a hyperbola that opens to x: cosh and sinh from start to end."""
    return _placed(lib.nurbs_curve_hyperbola, center, axis, x, radius_x, radius_y, start, end)


def conic_triangle(p0, p1, p2, shape_factor):
    """The conic of a control triangle with the shape factor w1^2 / (w0 w2), which may be infinite."""
    return _through(lib.nurbs_curve_conic_triangle, (p0, p1, p2), shape_factor)


def conic_shoulder(a, tangent_a, b, tangent_b, rho):
    """The conic from a to b with tangents, whose shoulder is at the part rho of the way from the chord to where they
    meet."""
    return _through(lib.nurbs_curve_conic_shoulder, (a, tangent_a, b, tangent_b), rho)


def conic_point(a, tangent_a, b, tangent_b, point, form=NURBS_ARC_QUARTERS):
    """The conic from a to b with tangent lines through a third point."""
    return _through(lib.nurbs_curve_conic_point, (a, tangent_a, b, tangent_b, point), form)


def conic_through(points, form=NURBS_ARC_QUARTERS):
    """The conic through five points (5, dim), from the first to the last."""
    given, dim = _table(points, 5)
    return Spline._made(lib.nurbs_curve_conic_through, dim, *given.layout, form)


def _coefficients(values):
    values = vector(values, numpy.float64)
    if values.size != 6:
        raise ValueError(f"{values.size} coefficients, expected 6")
    return values


def conic_axes(coefficients):
    """Kind and axes of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0."""
    given, kind = _coefficients(coefficients), ctypes.c_int32()
    origin, x, sizes = numpy.empty((3, 2))
    check(lib.nurbs_conic_axes(given.ctypes.data, ctypes.byref(kind), origin.ctypes.data, x.ctypes.data,
                               sizes.ctypes.data))
    return ConicAxes(kind.value, origin, x, sizes)


def conic_implicit(coefficients, start=0.0, end=FULL_TURN, form=NURBS_ARC_QUARTERS):
    """An arc of that conic: from angle to angle of an ellipse, else as parabola() and hyperbola()."""
    given = _coefficients(coefficients)
    return Spline._made(lib.nurbs_curve_conic_implicit, given.ctypes.data, start, end, form)


def conic_focus(focus, foot, eccentricity, start, sweep, axis=None, form=NURBS_ARC_QUARTERS):
    """An arc of the conic with a focus, the foot of the perpendicular from it to the directrix, and an eccentricity."""
    return _through(lib.nurbs_curve_conic_focus, (focus, axis, foot), eccentricity, start, sweep, form)


def shape_factor(spline):
    """Shape factor and kind (NURBS_CONIC_) of a conic segment of degree 2."""
    factor, kind = ctypes.c_double(), ctypes.c_int32()
    check(lib.nurbs_curve_shape_factor(spline._handle, ctypes.byref(factor), ctypes.byref(kind)))
    return ShapeFactor(factor.value, kind.value)


def helix(radius=1.0, pitch=1.0, turns=1.0, *, tolerance, growth=0.0, start=0.0, origin=None, axis=None, x=None):
    """A helix to a tolerance, conical where the radius grows, and its proven error: (spline, error). In the plane, with
    pitch 0, a spiral."""
    where, _alive = place(origin, axis, x, 3)
    error = ctypes.c_double()
    made = Spline._made(lib.nurbs_curve_helix, *where, radius, growth, pitch, start, turns, tolerance,
                        ctypes.byref(error))
    return Helix(made, error.value)
