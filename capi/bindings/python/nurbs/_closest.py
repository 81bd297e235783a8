# SPDX-License-Identifier: MIT
"""Distances and closest points."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, List, NamedTuple, Optional, Tuple

import numpy

from ._arrays import address, addresses, records
from ._base import SplineBase, handle_of
from ._calls import watched
from ._library import call, lib
from .constants import NURBS_NAN_POINTS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int32s, Records, Shape
    from ._calls import Progress

__all__ = ["ClosestPoints", "ClosestAll", "CriticalPoints", "SignedDistances", "Distance", "HausdorffDistance"]


class ClosestPoints(NamedTuple):
    """For points S + (dimension,): parameters S of a curve, else S + (axes,), points S + (dimension,), distances S, and
    sums of NURBS_CLOSEST_ bits S."""

    params: Floats
    points: Floats
    distances: Floats
    status: Int32s


class ClosestAll(NamedTuple):
    """n points as near as the nearest one: parameters (n,) of a curve, else (n, axes), distances (n,), and the sum of
    NURBS_CLOSEST_ bits of the search."""

    params: Floats
    distances: Floats
    status: int


class CriticalPoints(NamedTuple):
    """n critical points: parameters (n,) of a curve, else (n, axes), distances (n,), NURBS_CRITICAL_ constants (n,),
    and the sum of NURBS_CLOSEST_ bits of the search."""

    params: Floats
    distances: Floats
    kinds: Int32s
    status: int


class SignedDistances(NamedTuple):
    """For points S + (2,): distances, positive to the left, parameters, and sums of NURBS_CLOSEST_ bits, all S."""

    distances: Floats
    params: Floats
    status: Int32s


class Distance(NamedTuple):
    """Bounds of a distance, parameters (axes,) of a point of each spline that are at_most apart, and a sum of
    NURBS_CLOSEST_ bits."""

    at_least: float
    at_most: float
    params_a: Floats
    params_b: Floats
    status: int


class HausdorffDistance(NamedTuple):
    """The same with two bounds each (2,): of the distance from this spline to the other one, and back."""

    at_least: Floats
    at_most: Floats
    params_a: Floats
    params_b: Floats
    status: int


def smallest_distance(function: Callable[..., int], given: Tuple[Any, ...], axes: int, their_axes: int) -> Distance:
    """What a function tells of the smallest distance of two shapes."""
    low, high, status = ctypes.c_double(), ctypes.c_double(), ctypes.c_int32()
    params, others = numpy.empty(axes), numpy.empty(their_axes)
    call(function, *given, ctypes.byref(low), ctypes.byref(high), params.ctypes.data, others.ctypes.data,
         ctypes.byref(status))
    return Distance(low.value, high.value, params, others, status.value)


def largest_distances(function: Callable[..., int], given: Tuple[Any, ...], axes: int,
                      their_axes: int) -> HausdorffDistance:
    """What a function tells of the Hausdorff distances of two shapes."""
    low, high, status = numpy.empty(2), numpy.empty(2), ctypes.c_int32()
    params, others = numpy.empty(axes), numpy.empty(their_axes)
    call(function, *given, low.ctypes.data, high.ctypes.data, params.ctypes.data, others.ctypes.data,
         ctypes.byref(status))
    return HausdorffDistance(low, high, params, others, status.value)


def _flags(nan_points: bool) -> int:
    return NURBS_NAN_POINTS if nan_points else 0


class Distances(SplineBase):
    """Distances from points and between splines.

    A `range` is the part (axes, 2) of the domain that is searched, of a curve (2,). The status of a result says whether
    it is certified, at a boundary, not the only one to within `tolerance`, or came when the budget (of steps, 0: the
    library's) was spent. A point that is not finite is an error, with nan_points it gives NaN.
    """

    def _queries(self, points: ArrayLike) -> Tuple[Records, Shape]:
        """The points as records, and the shape of the batch."""
        given, dim = numpy.asarray(points, dtype=numpy.float64), self.dimension
        if given.ndim == 0 or given.shape[-1] != dim:
            raise ValueError(f"points of shape {given.shape}, expected (..., {dim})")
        return records(given, dim), given.shape[:-1]

    def _room(self, shape: Shape) -> Floats:
        """Room for parameters; those of a curve are numbers."""
        return numpy.empty(shape if self.axes == 1 else (*shape, self.axes))

    def _nearest(self, shape: Shape, nan_points: bool, function: Any, *inputs: Any) -> ClosestPoints:
        found = ClosestPoints(self._room(shape), numpy.empty((*shape, self.dimension)), numpy.empty(shape),
                              numpy.empty(shape, numpy.int32))
        params, points, distances, status = addresses(*found)
        call(function, self._handle, *inputs, params, 0, 0, points, 0, 0, distances, 0, status, _flags(nan_points))
        return found

    def _search(self, function: Any, points: ArrayLike, part: Optional[ArrayLike], tolerance: float, budget: int,
                nan_points: bool) -> ClosestPoints:
        (given, shape), limits = self._queries(points), self._part(part)
        return self._nearest(shape, nan_points, function, given.n, *given.layout, address(limits), tolerance, budget)

    def closest_points(self, points: ArrayLike, *, range: Optional[ArrayLike] = None, tolerance: float = 0.0,
                       budget: int = 0, nan_points: bool = False, progress: Progress = None,
                       work: Optional[int] = None) -> ClosestPoints:
        """The nearest points of the spline to points S + (dimension,); in a volume this is inversion."""
        return self._search(watched(lib.nurbs_closest_points, progress, work), points, range, tolerance, budget,
                            nan_points)

    def farthest_points(self, points: ArrayLike, *, range: Optional[ArrayLike] = None, tolerance: float = 0.0,
                        budget: int = 0, nan_points: bool = False, progress: Progress = None,
                        work: Optional[int] = None) -> ClosestPoints:
        """The farthest points of the spline from points S + (dimension,)."""
        return self._search(watched(lib.nurbs_farthest_points, progress, work), points, range, tolerance, budget,
                            nan_points)

    def closest_local(self, points: ArrayLike, guesses: ArrayLike, *, nan_points: bool = False,
                      progress: Progress = None, work: Optional[int] = None) -> ClosestPoints:
        """Local minima of the distance, each the one that a descent from a guess (parameters, one for each point) comes
        to. Never certified."""
        (given, shape), (starts, _) = self._queries(points), self._params(guesses)
        if starts.n != given.n:
            raise ValueError(f"{starts.n} guesses for {given.n} points")
        return self._nearest(shape, nan_points, watched(lib.nurbs_closest_local, progress, work), given.n,
                             *given.layout, *starts.layout)

    def _all(self, function: Any, point: ArrayLike, part: Optional[ArrayLike], tolerance: float, budget: int,
             kinds: int) -> Tuple[Any, ...]:
        """Parameters, distances and `kinds` arrays of kinds of the points that a function lists, and the status."""
        at, limits = self._coordinates(point, "a point"), self._part(part)
        count, status = ctypes.c_int64(), ctypes.c_int32()

        def listed(cap: int, *arrays: Any) -> None:
            call(function, self._handle, at.ctypes.data, address(limits), tolerance, budget, cap, *arrays,
                 ctypes.byref(count), ctypes.byref(status))

        listed(0, *[None] * (2 + kinds))
        n = count.value
        found: List[NDArray[Any]] = [self._room((n,)), numpy.empty(n)]
        found += [numpy.empty(n, numpy.int32)] * kinds
        listed(n, *addresses(*found))
        return (*found, status.value)

    def closest_all(self, point: ArrayLike, *, range: Optional[ArrayLike] = None, tolerance: float = 0.0,
                    budget: int = 0, progress: Progress = None, work: Optional[int] = None) -> ClosestAll:
        """All points that are local minima of the distance to a point (dimension,) and as near as the nearest one to
        the tolerance."""
        function = watched(lib.nurbs_closest_all, progress, work, 2)
        return ClosestAll(*self._all(function, point, range, tolerance, budget, 0))

    def critical_points(self, point: ArrayLike, *, range: Optional[ArrayLike] = None, tolerance: float = 0.0,
                        budget: int = 0, progress: Progress = None, work: Optional[int] = None) -> CriticalPoints:
        """All critical points of the distance from a point (dimension,): feet of perpendiculars, and minima and maxima
        at ends, edges and corners."""
        function = watched(lib.nurbs_critical_points, progress, work, 2)
        return CriticalPoints(*self._all(function, point, range, tolerance, budget, 1))

    def signed_distances(self, points: ArrayLike, *, tolerance: float = 0.0, budget: int = 0,
                         nan_points: bool = False, progress: Progress = None,
                         work: Optional[int] = None) -> SignedDistances:
        """Signed distances of points S + (2,) from a curve in the plane, positive to its left."""
        given, shape = self._queries(points)
        found = SignedDistances(numpy.empty(shape), numpy.empty(shape), numpy.empty(shape, numpy.int32))
        distances, params, status = addresses(*found)
        call(watched(lib.nurbs_curve_signed_distances, progress, work), self._handle, given.n, *given.layout,
             tolerance, budget, distances, 0, params, 0, status, _flags(nan_points))
        return found

    def distance(self, other: SplineBase, tolerance: float = 0.0, *, budget: int = 0, progress: Progress = None,
                 work: Optional[int] = None) -> Distance:
        """The smallest distance from another spline, enclosed to the tolerance."""
        return smallest_distance(watched(lib.nurbs_distance, progress, work),
                                 (self._handle, handle_of(other), tolerance, budget), self.axes, other.axes)

    def hausdorff_distance(self, other: SplineBase, tolerance: float, *, budget: int = 0, progress: Progress = None,
                           work: Optional[int] = None) -> HausdorffDistance:
        """How far the point of this spline that is farthest from another one is from it, and the other way round,
        enclosed to the tolerance."""
        return largest_distances(watched(lib.nurbs_hausdorff_distance, progress, work),
                                 (self._handle, handle_of(other), tolerance, budget), self.axes, other.axes)
