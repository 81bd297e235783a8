# SPDX-License-Identifier: MIT
"""Operations that move the shape, each with a proven bound."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Sequence, Union

import numpy

from ._arrays import address, if_given
from ._base import SplineBase, handle_of
from ._calls import watched
from ._library import get, lib

if TYPE_CHECKING:
    from ._calls import Progress
    from ._spline import Spline

__all__ = ["Deviation", "KnotRemoval", "Reduced", "Snapped"]


class Deviation(NamedTuple):
    """Proven bounds of the largest distance of two splines at equal parameters."""

    at_least: float
    at_most: float


class KnotRemoval(NamedTuple):
    """The spline, how many copies went, and a proven bound of how far it moved."""

    spline: Spline
    removed: int
    bound: float


class Reduced(NamedTuple):
    """The spline, and a proven bound of how far it moved."""

    spline: Spline
    bound: float


class Snapped(NamedTuple):
    """The spline, and a proven bound of how far it moved."""

    spline: Spline
    deviation: float


class Reduction(SplineBase):
    """Fewer knots, lower degrees. Tolerances are distances."""

    def deviation(self, other: SplineBase) -> Deviation:
        """Bounds of sup |self(t) - other(t)| over the domain, which has to be the same."""
        at_least = ctypes.c_double()
        at_most = get(ctypes.c_double, lib.nurbs_deviation, self._handle, handle_of(other), ctypes.byref(at_least))
        return Deviation(at_least.value, at_most)

    def remove_knot(self, knot: float, times: int = 1, *, tolerance: float = 0.0, axis: int = 0) -> KnotRemoval:
        """Copies of a knot removed, as many of `times` as the tolerance allows. Raises ArgumentError if it is none."""
        removed, bound = ctypes.c_int32(), ctypes.c_double()
        made = self._made(lib.nurbs_remove_knot, self._handle, axis, knot, times, tolerance, ctypes.byref(removed),
                          ctypes.byref(bound))
        return KnotRemoval(made, removed.value, bound.value)

    def _reduced(self, function: Any, *arguments: Any) -> Reduced:
        bound = ctypes.c_double()
        return Reduced(self._made(function, self._handle, *arguments, ctypes.byref(bound)), bound.value)

    def reduce_knots(self, tolerance: float, *, axis: int = -1, progress: Progress = None,
                     work: Optional[int] = None) -> Reduced:
        """As few knots as the tolerance allows, on one axis, or on every one (-1)."""
        return self._reduced(watched(lib.nurbs_reduce_knots, progress, work), axis, tolerance)

    def reduce_degree(self, times: int = 1, *, axis: int = 0, progress: Progress = None,
                      work: Optional[int] = None) -> Reduced:
        """The closest spline with a lower degree on an axis."""
        return self._reduced(watched(lib.nurbs_reduce_degree, progress, work), axis, times)

    def simplify(self, tolerance: float, *, progress: Progress = None, work: Optional[int] = None) -> Reduced:
        """The simplest spline within the tolerance: weights, degrees and knots that are not needed go."""
        return self._reduced(watched(lib.nurbs_simplify, progress, work), tolerance)

    def approximate(self, tolerance: float, degrees: Optional[Union[int, Sequence[int]]] = None, *, max_count: int = 0,
                    progress: Progress = None, work: Optional[int] = None) -> Reduced:
        """A polynomial spline of given degrees, those of this one for None, with few control points: within the
        tolerance where the bound says so, else the closest one that was met."""
        wanted = if_given(degrees, self.axes, "degrees", numpy.int32)
        return self._reduced(watched(lib.nurbs_approximate, progress, work), address(wanted), tolerance, max_count)

    def snap_knots(self, tolerance: float, *, axis: int = 0) -> Snapped:
        """Knots of an axis within `tolerance` times the length of the domain become one."""
        return Snapped(*self._reduced(lib.nurbs_snap_knots, axis, tolerance))
