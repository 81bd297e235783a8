# SPDX-License-Identifier: MIT
"""Shapes made of what is straight and flat, within a proven distance."""

from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy

from ._base import SplineBase
from ._calls import watched
from ._library import call, lib

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._calls import Progress

__all__ = ["CurvePolyline"]


class CurvePolyline(NamedTuple):
    """Parameters (n,), rising, and points (n, dimension) of the vertices of a polyline in place of a curve; a bound of its
    distance from the curve, as proven, and whether all segments keep to the limits."""

    params: Floats
    points: Floats
    bound: float
    reached: bool


class Meshes(SplineBase):
    """What is straight and flat in place of a shape."""

    def mesh_curve(self, chord: float = math.inf, angle: float = 0.0, longest: float = 0.0, *,
                   progress: Progress = None, work: Optional[int] = None) -> CurvePolyline:
        """A polyline in place of a curve: every segment is within `chord` of its part of the curve, as proven. The angle
        between any two tangents of that part and the length of the segment are limited too, if they are not 0."""
        function = watched(lib.nurbs_mesh_curve, progress, work, 2)
        bound, reached, count = ctypes.c_double(), ctypes.c_int32(), ctypes.c_int64()
        given = self._handle, chord, angle, longest
        ends = ctypes.byref(bound), ctypes.byref(reached), ctypes.byref(count)
        call(function, *given, 0, None, None, *ends)
        params, points = numpy.empty(count.value), numpy.empty((count.value, self.dimension))
        call(function, *given, count.value, params.ctypes.data, points.ctypes.data, *ends)
        return CurvePolyline(params, points, bound.value, bool(reached.value))
