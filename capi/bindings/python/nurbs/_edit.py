# SPDX-License-Identifier: MIT
"""Changes of weights and control points, and knots that make points of the polygon control points."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy

from ._arrays import addresses, exactly, one_each, records, vector
from ._base import SplineBase
from ._library import call, get, lib
from ._placement import Vectors

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int64s
    from ._spline import Spline

__all__ = ["WeightEdit", "WeightsEdit", "WeightPoints", "PointEdit", "Influences", "LegEdit", "weight_cross_ratio"]


class WeightEdit(NamedTuple):
    """The spline, and the new weight."""

    spline: Spline
    weight: float


class WeightsEdit(NamedTuple):
    """The spline, and the factor of the weights."""

    spline: Spline
    factor: float


class WeightPoints(NamedTuple):
    """The points (dimension,) at a parameter for the weights 0, 1 and the present one."""

    at_zero: Floats
    at_one: Floats
    at_weight: Floats


class PointEdit(NamedTuple):
    """The spline, and the largest distance by which a control point moved."""

    spline: Spline
    moved: float


class Influences(NamedTuple):
    """Control points S, and their R_i, S."""

    indices: Int64s
    influences: Floats


class LegEdit(NamedTuple):
    """The spline, the leg by the control point where it starts, the place on it in [0, 1], and the knot."""

    spline: Spline
    leg: int
    ratio: float
    knot: float


class Edits(SplineBase):
    """Weights and control points. Points are counted with the last axis fastest, as numpy.ravel_multi_index() does it;
    a parameter is a number of a curve, else (axes,). R_i is the rational basis function of point i."""

    def with_points(self, points: ArrayLike, weights: Optional[ArrayLike] = None) -> Spline:
        """The same degrees, knots and periodicity with other points (counts..., dimension), and other weights
        (counts...) if any are given; knots and their tables are shared."""
        shape = (*self.counts, self.dimension)
        given = records(points, self.dimension)
        others = None if weights is None else one_each(weights, self.counts, "weights")
        if given.shape != shape:
            raise ValueError(f"points of shape {given.shape}, expected {shape}")
        return self._made(lib.nurbs_with_points, self._handle, *given.layout,
                          *((None, 0) if others is None else others.layout[:2]))

    def _param(self, params: ArrayLike) -> NDArray[Any]:
        return exactly(params, self.axes, "a parameter")

    def _with_number(self, function: Any, *arguments: Any) -> Tuple[Spline, float]:
        """The spline that function(self, arguments..., number, out) makes, and the number."""
        number = ctypes.c_double()
        return self._made(function, self._handle, *arguments, ctypes.byref(number)), number.value

    def set_weights(self, indices: ArrayLike, weights: ArrayLike) -> Spline:
        """The weights of some control points set: two arrays (n,)."""
        points = vector(indices, numpy.int64)
        values = exactly(weights, points.size, "weights")
        return self._made(lib.nurbs_set_weights, self._handle, points.size, points.ctypes.data, values.ctypes.data)

    def pull_weight(self, index: int, params: ArrayLike, distance: float) -> WeightEdit:
        """A weight changed so that the point S at a parameter moves by a distance towards the control point:
        w_i (1 + d / (R_i (|P_i S| - d)))."""
        at = self._param(params)
        return WeightEdit(*self._with_number(lib.nurbs_pull_weight, index, at.ctypes.data, distance))

    def pull_weights(self, indices: ArrayLike, params: ArrayLike, distance: float) -> WeightsEdit:
        """Several weights multiplied by one factor, so that the point moves towards sum R_i P_i / sum R_i."""
        at, points = self._param(params), vector(indices, numpy.int64)
        return WeightsEdit(*self._with_number(lib.nurbs_pull_weights, points.size, points.ctypes.data, at.ctypes.data,
                                              distance))

    def weight_points(self, index: int, params: ArrayLike) -> WeightPoints:
        """The points at a parameter for the weights 0, 1 and the present one of a control point, all on a line with
        it."""
        at, found = self._param(params), WeightPoints(*numpy.empty((3, self.dimension)))
        call(lib.nurbs_weight_points, self._handle, index, at.ctypes.data, *addresses(*found))
        return found

    def weight_through(self, index: int, params: ArrayLike, target: ArrayLike, tolerance: float) -> WeightEdit:
        """A weight set so that the point at a parameter becomes the target (dimension,), which lies on that line to
        within the tolerance."""
        at, goal = self._param(params), self._coordinates(target, "a target")
        return WeightEdit(*self._with_number(lib.nurbs_weight_through, index, at.ctypes.data, goal.ctypes.data,
                                             tolerance))

    def pull_point(self, index: int, params: ArrayLike, direction: ArrayLike, distance: float) -> PointEdit:
        """A control point moved so that the point at a parameter moves by a distance along a direction (dimension,)."""
        at, along = self._param(params), self._coordinates(direction, "a direction")
        return PointEdit(*self._with_number(lib.nurbs_pull_point, index, at.ctypes.data, along.ctypes.data, distance))

    def most_influential(self, params: ArrayLike) -> Influences:
        """The control point with the largest |R_i| at each parameter."""
        given, shape = self._params(params)
        found = Influences(numpy.empty(shape, numpy.int64), numpy.empty(shape))
        call(lib.nurbs_most_influential, self._handle, given.n, *given.layout, *addresses(*found))
        return found

    def insert_on_leg(self, index: int, ratio: float, *, axis: int = 0) -> LegEdit:
        """The knot inserted that makes the point P_i + ratio (P_j - P_i) of a leg of the control polygon a control
        point."""
        made, knot = self._with_number(lib.nurbs_insert_on_leg, axis, index, ratio)
        return LegEdit(made, index, ratio, knot)

    def insert_at_point(self, point: ArrayLike, tolerance: float, *, axis: int = 0) -> LegEdit:
        """The same for the point on a leg that is nearest to the one given (dimension,). Raises ArgumentError if it is
        farther than the tolerance."""
        at, index, ratio = self._coordinates(point, "a point"), ctypes.c_int64(), ctypes.c_double()
        made, knot = self._with_number(lib.nurbs_insert_at_point, axis, at.ctypes.data, tolerance, ctypes.byref(index),
                                       ctypes.byref(ratio))
        return LegEdit(made, index.value, ratio.value, knot)


def weight_cross_ratio(control_point: ArrayLike, at_zero: ArrayLike, at_one: ArrayLike, at_weight: ArrayLike) -> float:
    """The weight as the cross ratio of a control point and the three points of Spline.weight_points()."""
    points = Vectors(control_point, at_zero, at_one, at_weight)
    return float(get(ctypes.c_double, lib.nurbs_weight_cross_ratio, points.dim, *points.addresses))
