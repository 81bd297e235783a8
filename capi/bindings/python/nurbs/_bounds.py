# SPDX-License-Identifier: MIT
"""Boxes and cones that contain a spline, proven."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy

from ._arrays import address, addresses
from ._base import SplineBase
from ._library import call, get, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats

__all__ = ["Box", "OrientedBox", "DirectionCone", "ExtremePoint"]


class Box(NamedTuple):
    """Lower and upper ends (dimension,), and how far a face is from the spline at most."""

    lower: Floats
    upper: Floats
    gap: float


class OrientedBox(NamedTuple):
    """The points center + sum_k x_k axes[k], |x_k| <= half[k]: (dimension,), (dimension, dimension), (dimension,)."""

    center: Floats
    axes: Floats
    half: Floats


class DirectionCone(NamedTuple):
    """A unit vector (dimension,), and half the opening in radians; pi for all of space."""

    direction: Floats
    angle: float


class ExtremePoint(NamedTuple):
    """Parameters (axes,) of a point, its component along the direction, and a bound of that of all others."""

    params: Floats
    value: float
    bound: float


class Bounds(SplineBase):
    """Proven bounds; a `range` is a part (axes, 2) of the domain, of a curve (2,)."""

    def box(self, tolerance: float, *, range: Optional[ArrayLike] = None) -> Box:
        """An axis-aligned box, tight to the tolerance; an infinite one gives that of the Bezier points."""
        part, lower, upper = self._part(range), numpy.empty(self.dimension), numpy.empty(self.dimension)
        gap = get(ctypes.c_double, lib.nurbs_box, self._handle, address(part), tolerance, lower.ctypes.data,
                  upper.ctypes.data)
        return Box(lower, upper, gap)

    def oriented_box(self, tolerance: float) -> OrientedBox:
        """A box along the principal axes of the control points, tight to the tolerance."""
        dim = self.dimension
        found = OrientedBox(numpy.empty(dim), numpy.empty((dim, dim)), numpy.empty(dim))
        call(lib.nurbs_oriented_box, self._handle, tolerance, *addresses(*found))
        return found

    def tangent_cone(self, tolerance: float, *, axis: int = 0, range: Optional[ArrayLike] = None) -> DirectionCone:
        """The directions of the derivatives along an axis, within the tolerance in radians."""
        part, direction = self._part(range), numpy.empty(self.dimension)
        angle = get(ctypes.c_double, lib.nurbs_tangent_cone, self._handle, axis, address(part), tolerance,
                    direction.ctypes.data)
        return DirectionCone(direction, angle)

    def normal_cone(self, tolerance: float, *, range: Optional[ArrayLike] = None) -> DirectionCone:
        """The directions of the normals S_u x S_v of a surface in space, within the tolerance in radians."""
        part, direction = self._part(range), numpy.empty(3)
        angle = get(ctypes.c_double, lib.nurbs_normal_cone, self._handle, address(part), tolerance,
                    direction.ctypes.data)
        return DirectionCone(direction, angle)

    def extreme_point(self, direction: ArrayLike, tolerance: float, *,
                      range: Optional[ArrayLike] = None) -> ExtremePoint:
        """The point that is farthest in a direction (dimension,): the largest direction . C(t)."""
        part, along = self._part(range), self._coordinates(direction, "a direction")
        params, value = numpy.empty(self.axes), ctypes.c_double()
        bound = get(ctypes.c_double, lib.nurbs_extreme_point, self._handle, along.ctypes.data, address(part),
                    tolerance, params.ctypes.data, ctypes.byref(value))
        return ExtremePoint(params, value.value, bound)
