# SPDX-License-Identifier: MIT
"""Ends: clamped, unclamped, extended and periodic ones, and how smooth knots and ends are."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, List, NamedTuple

import numpy

from ._arrays import addresses
from ._base import SplineBase, handle_of
from ._library import call, get, lib
from .constants import NURBS_END, NURBS_FORM_CLAMPED_END, NURBS_FORM_CLAMPED_START

if TYPE_CHECKING:
    from ._arrays import Floats, Int32s
    from ._spline import Spline

__all__ = ["PeriodicForm", "KnotContinuity", "EndContinuity"]

_BOTH_ENDS = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END


class PeriodicForm(NamedTuple):
    """The spline, a proved bound of how far it moved, and the order of continuity at its seam."""

    spline: Spline
    deviation: float
    order: int


class KnotContinuity(NamedTuple):
    """Arrays (n,): the knots, the orders that the knot vector promises, those found, the geometric ones (G^k), and the
    jumps of position, tangent direction and curvature."""

    knots: Floats
    knot_orders: Int32s
    orders: Int32s
    geometric_orders: Int32s
    position_gaps: Floats
    angles: Floats
    curvature_gaps: Floats


class EndContinuity(NamedTuple):
    """Order of continuity, geometric order, and the jumps of position, tangent direction and curvature."""

    order: int
    geometric: int
    position_gap: float
    angle: float
    curvature_gap: float


class Continuation(SplineBase):
    """Changes of the ends of an axis."""

    def clamp(self, flags: int = _BOTH_ENDS, *, axis: int = 0) -> Spline:
        """The same shape with ends clamped, NURBS_FORM_CLAMPED_START and _END; 0 only opens a periodic axis."""
        return self._made(lib.nurbs_clamp_ends, self._handle, axis, flags)

    def unclamp(self, flags: int = _BOTH_ENDS, *, axis: int = 0) -> Spline:
        """The same shape with ends unclamped; the knots beyond them repeat those of the domain. With NURBS_HOMOGENEOUS
        in the flags a rational result has homogeneous points, whose weights may be of any sign."""
        return self._made(lib.nurbs_unclamp, self._handle, axis, flags)

    def extend(self, amount: float, order: int, *, end: int = NURBS_END, axis: int = 0) -> Spline:
        """The spline continued beyond an end by a length of the parameter: by the Taylor polynomial of an order, which
        from the degree on is the piece itself."""
        return self._made(lib.nurbs_extend, self._handle, axis, end, amount, order)

    def move_seam(self, param: float, *, axis: int = 0) -> Spline:
        """The same shape on a periodic axis over [param, param + period]."""
        return self._made(lib.nurbs_move_seam, self._handle, axis, param)

    def make_periodic(self, tolerance: float, *, axis: int = 0) -> PeriodicForm:
        """A closed spline made periodic, its seam as smooth as the tolerance allows."""
        deviation, order = ctypes.c_double(), ctypes.c_int32()
        made = self._made(lib.nurbs_make_periodic, self._handle, axis, tolerance, ctypes.byref(deviation),
                          ctypes.byref(order))
        return PeriodicForm(made, deviation.value, order.value)

    def detect_periodic(self, *, axis: int = 0) -> bool:
        """Whether knots, points and weights of an axis repeat, declared so or not."""
        return bool(get(ctypes.c_int32, lib.nurbs_detect_periodic, self._handle, axis))

    def continuity(self, *, position: float = 0.0, derivative: float = 0.0, angle: float = 0.0,
                   axis: int = 0) -> KnotContinuity:
        """One row for each knot inside the domain, and for the seam if the axis closes; what differs by no more than
        the tolerances counts as equal."""
        count = ctypes.c_int64()
        tolerances = (axis, position, derivative, angle)
        call(lib.nurbs_continuity, self._handle, *tolerances, 0, *[None] * 7, ctypes.byref(count))
        n = count.value
        promised, orders, geometric = numpy.empty((3, n), numpy.int32)
        knots, gaps, angles, curvatures = numpy.empty((4, n))
        found = KnotContinuity(knots, promised, orders, geometric, gaps, angles, curvatures)
        call(lib.nurbs_continuity, self._handle, *tolerances, n, *addresses(*found), None)
        return found

    def continuity_between(self, end: int, other: SplineBase, other_end: int, *, position: float = 0.0,
                           derivative: float = 0.0, angle: float = 0.0) -> EndContinuity:
        """How this curve and another one meet, each at NURBS_START or NURBS_END, on the way along this one to its end
        and from the other's end along that."""
        results: List[Any] = [ctypes.c_int32(), ctypes.c_int32(), *(ctypes.c_double() for _ in range(3))]
        call(lib.nurbs_continuity_between, self._handle, end, handle_of(other), other_end, position, derivative, angle,
             *(ctypes.byref(result) for result in results))
        order, geometric, *gaps = (result.value for result in results)
        return EndContinuity(int(order), int(geometric), *gaps)
