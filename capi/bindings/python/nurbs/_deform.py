# SPDX-License-Identifier: MIT
"""Deformations of a shape or of a region of it."""

from __future__ import annotations

import ctypes
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy

from ._arrays import address, exactly, if_given
from ._base import SplineBase, handle_of
from ._calls import watched
from ._library import if_representable, lib
from .constants import NURBS_REVERSED
from ._edit import PointEdit
from ._reduce import Reduced

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats
    from ._calls import Progress
    from ._spline import Spline

__all__ = ["Deformed", "Faired"]


class Deformed(NamedTuple):
    """A spline near the exact image, and how far it is from that: a bound if proven, else that of samples."""

    spline: Spline
    deviation: float
    proven: bool


class Faired(NamedTuple):
    """The spline, its energies (2,) before and after, and a bound of how far it moved."""

    spline: Spline
    energies: Floats
    bound: float


class Deformations(SplineBase):
    """Deformations; a `range` is a part (axes, 2) of the domain, of a curve (2,), points and vectors are
    (dimension,)."""

    def warp(self, direction: ArrayLike, distance: float, order: int, *, range: Optional[ArrayLike] = None) -> Spline:
        """A region raised along a direction; `order` derivatives stay at its ends."""
        part, along = self._part(range), self._coordinates(direction, "a direction")
        return self._made(lib.nurbs_warp, self._handle, address(part), along.ctypes.data, distance, order)

    def flatten(self, point: ArrayLike, normal: ArrayLike, direction: Optional[ArrayLike] = None, *,
                range: Optional[ArrayLike] = None) -> PointEdit:
        """A region flattened to a plane, along a direction or else its normal."""
        part, moved = self._part(range), ctypes.c_double()
        at, n = self._coordinates(point, "a point"), self._coordinates(normal, "a normal")
        along = if_given(direction, self.dimension, "a direction")
        made = self._made(lib.nurbs_flatten, self._handle, address(part), at.ctypes.data, n.ctypes.data, address(along),
                          ctypes.byref(moved))
        return PointEdit(made, moved.value)

    def _deformed(self, function: Any, *arguments: Any) -> Deformed:
        deviation, proven = ctypes.c_double(), ctypes.c_int32()
        made = self._made(function, self._handle, *arguments, ctypes.byref(deviation), ctypes.byref(proven))
        return Deformed(made, deviation.value, bool(proven.value))

    def bend(self, origin: ArrayLike, along: ArrayLike, across: ArrayLike, curvature: float, tolerance: float, *,
             lower: float = -inf, upper: float = inf, progress: Progress = None,
             work: Optional[int] = None) -> Deformed:
        """The part with lower <= a <= upper, a counted along a unit vector from the origin, bent about an axis: a goes
        to (1/k + b) sin(k a), b, counted across, to (1/k + b) cos(k a) - 1/k; the rest goes on straight."""
        named = (origin, "an origin"), (along, "along"), (across, "across")
        vectors = [self._coordinates(values, name) for values, name in named]
        return self._deformed(watched(lib.nurbs_bend, progress, work), *(v.ctypes.data for v in vectors), curvature,
                              lower, upper, tolerance)

    def free_form_deform(self, volume: SplineBase, lower: ArrayLike, upper: ArrayLike, tolerance: float, *,
                         progress: Progress = None, work: Optional[int] = None) -> Deformed:
        """A shape in the box from lower to upper mapped by a volume, whose domain the box stands for."""
        map_of, axes = handle_of(volume), volume.axes
        low, high = exactly(lower, axes, "lower"), exactly(upper, axes, "upper")
        return self._deformed(watched(lib.nurbs_free_form_deform, progress, work), map_of, low.ctypes.data,
                              high.ctypes.data, tolerance)

    def fair(self, tolerance: float, order: int = 2, *, keep: Optional[ArrayLike] = None, progress: Progress = None,
             work: Optional[int] = None) -> Faired:
        """The least energy within a tolerance: of order 1 (membrane), 2 (thin plate) or 3; keep holds the orders of
        derivatives (axes, 2) that stay at the ends, None: positions. Energies that overflow are infinite."""
        given = if_given(keep, 2 * self.axes, "keep", numpy.int32)
        energies, bound = numpy.empty(2), ctypes.c_double()
        fair = watched(lib.nurbs_fair, progress, work)

        def made(asked: Optional[int]) -> Spline:
            return self._made(fair, self._handle, order, address(given), tolerance, asked, ctypes.byref(bound))

        return Faired(if_representable(made, energies, inf), energies, bound.value)

    def snap_boundary(self, boundary: Tuple[int, int], other: SplineBase, other_boundary: Tuple[int, int],
                      order: int = 0, *, reversed: bool = False) -> Reduced:
        """A boundary (axis, NURBS_START or NURBS_END) moved onto one of another spline, with order 1 tangents too."""
        bound = ctypes.c_double()
        made = self._made(lib.nurbs_snap_boundary, self._handle, *boundary, handle_of(other), *other_boundary, order,
                          NURBS_REVERSED if reversed else 0, ctypes.byref(bound))
        return Reduced(made, bound.value)
