# SPDX-License-Identifier: MIT
"""Lines, conics and helices.

`center`, `axis` and `x` place a shape, vectors (dimension,) that tell its dimension. Without any of them a helix stands
in space and other curves in the plane, about the origin. Angles are in radians.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy

from ._arrays import Records, address, exactly, if_given, records
from ._library import call, lib
from ._placement import FULL_TURN, Vectors, place
from .constants import NURBS_ARC_QUARTERS
from ._spline import Spline

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats

__all__ = ["ConicAxes", "Helix", "line", "polyline", "polygon", "rounded_rectangle", "circle", "arc", "arc_through",
           "arc_tangent", "ellipse", "parabola", "hyperbola", "conic_triangle", "conic_shoulder", "conic_point",
           "conic_through", "conic_axes", "conic_implicit", "conic_focus", "helix"]


class ConicAxes(NamedTuple):
    """A NURBS_CONIC_ constant, the centre or vertex (2,), the direction (2,) to the vertex or focus, and semi-axes or
    focal length (2,)."""

    type: int
    origin: Floats
    x: Floats
    sizes: Floats


class Helix(NamedTuple):
    """The spline, and a proven bound of its error."""

    spline: Spline
    error: float


def _placed(function: Any, center: Optional[ArrayLike], axis: Optional[ArrayLike], x: Optional[ArrayLike],
            *arguments: Any) -> Spline:
    where, _alive = place(center, axis, x)
    return Spline._made(function, *where, *arguments)


def _through(function: Any, vectors: Tuple[Optional[ArrayLike], ...], *arguments: Any) -> Spline:
    given = Vectors(*vectors)
    return Spline._made(function, given.dim, *given.addresses, *arguments)


def _table(points: ArrayLike, rows: Optional[int] = None) -> Tuple[Records, int]:
    table = numpy.asarray(points, dtype=numpy.float64)
    if table.ndim != 2 or rows not in (None, len(table)):
        raise ValueError(f"points of shape {table.shape}, expected ({'n' if rows is None else rows}, dimension)")
    return records(table, table.shape[1]), table.shape[1]


def line(a: ArrayLike, b: ArrayLike) -> Spline:
    """The segment (1 - t) a + t b, of degree 1."""
    return _through(lib.nurbs_curve_line, (a, b))


def polyline(points: ArrayLike, params: Optional[ArrayLike] = None) -> Spline:
    """The polyline through points (n, dimension), at 0, 1, ..., n - 1 unless parameters (n,) are given."""
    given, dim = _table(points)
    at = if_given(params, given.n, "parameters")
    return Spline._made(lib.nurbs_curve_polyline, given.n, dim, *given.layout, address(at), 0)


def polygon(sides: int, radius: float = 1.0, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
            x: Optional[ArrayLike] = None) -> Spline:
    """A closed regular polygon; its corners are on a circle of the radius, at the parameters i / sides."""
    return _placed(lib.nurbs_curve_polygon, center, axis, x, radius, sides)


def rounded_rectangle(width: float, height: float, corner_radius: float = 0.0, center: Optional[ArrayLike] = None,
                      axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None) -> Spline:
    """A closed rectangle about a centre, its corners quarter circles."""
    return _placed(lib.nurbs_curve_rounded_rectangle, center, axis, x, width, height, corner_radius)


def circle(radius: float = 1.0, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
           x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The full circle, exact, counterclockwise about the axis from the direction x. form is a NURBS_ARC_ constant:
    quarters (9 control points of degree 2), thirds (7), or smooth (6 of degree 5)."""
    return _placed(lib.nurbs_curve_circle, center, axis, x, radius, form)


def arc(radius: float, start: float, sweep: float, center: Optional[ArrayLike] = None,
        axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The circular arc center + radius (X cos a + Y sin a), a from start to start + sweep."""
    return _placed(lib.nurbs_curve_arc, center, axis, x, radius, start, sweep, form)


def arc_through(a: ArrayLike, b: ArrayLike, c: ArrayLike, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The circular arc from a through b to c."""
    return _through(lib.nurbs_curve_arc_through, (a, b, c), form)


def arc_tangent(a: ArrayLike, tangent: ArrayLike, b: ArrayLike, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The circular arc that leaves a in the direction of a tangent and ends at b."""
    return _through(lib.nurbs_curve_arc_tangent, (a, tangent, b), form)


def ellipse(radius_x: float, radius_y: float, start: float = 0.0, sweep: float = FULL_TURN,
            center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None,
            form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The elliptic arc center + radius_x X cos a + radius_y Y sin a, a from start to start + sweep."""
    return _placed(lib.nurbs_curve_ellipse, center, axis, x, radius_x, radius_y, start, sweep, form)


def parabola(focal_length: float, start: float, end: float, vertex: Optional[ArrayLike] = None,
             axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None) -> Spline:
    """The parabolic arc vertex + t^2 / (4 focal_length) X + t Y over [start, end]; x points to the focus."""
    return _placed(lib.nurbs_curve_parabola, vertex, axis, x, focal_length, start, end)


def hyperbola(radius_x: float, radius_y: float, start: float, end: float, center: Optional[ArrayLike] = None,
              axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None) -> Spline:
    """The arc center + radius_x X cosh u + radius_y Y sinh u of a hyperbola, u from start to end."""
    return _placed(lib.nurbs_curve_hyperbola, center, axis, x, radius_x, radius_y, start, end)


def conic_triangle(p0: ArrayLike, p1: ArrayLike, p2: ArrayLike, shape_factor: float) -> Spline:
    """The conic of a control triangle with the shape factor w_1^2 / (w_0 w_2): below 1 an ellipse, 1 a parabola, above
    1 a hyperbola, 0 the chord, infinite the legs."""
    return _through(lib.nurbs_curve_conic_triangle, (p0, p1, p2), shape_factor)


def conic_shoulder(a: ArrayLike, tangent_a: ArrayLike, b: ArrayLike, tangent_b: ArrayLike, rho: float) -> Spline:
    """The conic from a to b with tangents, whose shoulder is at the part rho of the way from the chord to where they
    meet."""
    return _through(lib.nurbs_curve_conic_shoulder, (a, tangent_a, b, tangent_b), rho)


def conic_point(a: ArrayLike, tangent_a: ArrayLike, b: ArrayLike, tangent_b: ArrayLike, point: ArrayLike,
                form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The conic from a to b with tangent lines through a third point."""
    return _through(lib.nurbs_curve_conic_point, (a, tangent_a, b, tangent_b, point), form)


def conic_through(points: ArrayLike, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The conic through five points (5, dimension), from the first to the last."""
    given, dim = _table(points, 5)
    return Spline._made(lib.nurbs_curve_conic_through, dim, *given.layout, form)


def conic_axes(coefficients: ArrayLike) -> ConicAxes:
    """Kind and axes of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0, given its coefficients (6,). Raises
    ArgumentError if it is a point, lines or nothing."""
    given, kind = exactly(coefficients, 6, "coefficients"), ctypes.c_int32()
    origin, x, sizes = numpy.empty((3, 2))
    call(lib.nurbs_conic_axes, given.ctypes.data, ctypes.byref(kind), origin.ctypes.data, x.ctypes.data,
         sizes.ctypes.data)
    return ConicAxes(kind.value, origin, x, sizes)


def conic_implicit(coefficients: ArrayLike, start: float = 0.0, end: float = FULL_TURN,
                   form: int = NURBS_ARC_QUARTERS) -> Spline:
    """An arc of the conic of conic_axes(): of an ellipse from angle to angle, else as parabola() and hyperbola()."""
    given = exactly(coefficients, 6, "coefficients")
    return Spline._made(lib.nurbs_curve_conic_implicit, given.ctypes.data, start, end, form)


def conic_focus(focus: ArrayLike, foot: ArrayLike, eccentricity: float, start: float, sweep: float,
                axis: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The arc r(a) = e d / (1 + e cos a) about a focus, d = |foot - focus|, of the conic with an eccentricity e and the
    foot of the perpendicular from the focus to the directrix, a from start to start + sweep."""
    return _through(lib.nurbs_curve_conic_focus, (focus, axis, foot), eccentricity, start, sweep, form)


def helix(radius: float = 1.0, pitch: float = 1.0, turns: float = 1.0, *, tolerance: float, growth: float = 0.0,
          start: float = 0.0, origin: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
          x: Optional[ArrayLike] = None) -> Helix:
    """The helix origin + r (X cos a + Y sin a) + pitch n Z, a = start + 2 pi n, r = radius + growth n, over [0, turns],
    to a tolerance: conical where growth is not 0; in the plane, with pitch 0, a spiral."""
    where, _alive = place(origin, axis, x, 3)
    error = ctypes.c_double()
    made = Spline._made(lib.nurbs_curve_helix, *where, radius, growth, pitch, start, turns, tolerance,
                        ctypes.byref(error))
    return Helix(made, error.value)
