# SPDX-License-Identifier: MIT
"""Changes of weights and control points, and knots that make points of the polygon control points.

Control points are counted with the last axis fastest, as in numpy.ravel_multi_index(); a parameter is a number of a
curve, else (axes,).
"""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import exactly, vector
from ._library import check, get, lib
from ._placement import Vectors
from .spline import Spline

WeightEdit = namedtuple("WeightEdit", "spline weight")
WeightsEdit = namedtuple("WeightsEdit", "spline factor")
#: The points (dim,) at a parameter for the weights 0, 1 and the present one.
WeightPoints = namedtuple("WeightPoints", "at_zero at_one at_weight")
#: The spline, and how far a control point moved.
PointEdit = namedtuple("PointEdit", "spline moved")
#: Control points, and their R_i.
Influences = namedtuple("Influences", "indices influences")
#: The spline, the leg by the control point where it starts, the place on it, and the knot.
LegEdit = namedtuple("LegEdit", "spline index ratio knot")


def _param(spline, params):
    return exactly(params, spline.axes, "a parameter")


def _with_number(function, *arguments):
    """The spline that function(arguments..., number, out) makes, and the number."""
    number = ctypes.c_double()
    return Spline._made(function, *arguments, ctypes.byref(number)), number.value


def pull_weight(spline, index, params, distance):
    """A weight changed so that the point at a parameter moves by a distance towards the control point."""
    at = _param(spline, params)
    return WeightEdit(*_with_number(lib.nurbs_pull_weight, spline._handle, index, at.ctypes.data, distance))


def pull_weights(spline, indices, params, distance):
    """Several weights multiplied by one factor, so that the point moves towards their common centre."""
    at, indices = _param(spline, params), vector(indices, numpy.int64)
    return WeightsEdit(*_with_number(lib.nurbs_pull_weights, spline._handle, indices.size, indices.ctypes.data,
                                     at.ctypes.data, distance))


def set_weights(spline, indices, weights):
    """The weights of some control points set."""
    indices = vector(indices, numpy.int64)
    weights = exactly(weights, indices.size, "weights")
    return Spline._made(lib.nurbs_set_weights, spline._handle, indices.size, indices.ctypes.data, weights.ctypes.data)


def weight_points(spline, index, params):
    """The points at a parameter for the weights 0, 1 and the present one of a control point."""
    at, found = _param(spline, params), WeightPoints(*(numpy.empty(spline.dimension) for _ in range(3)))
    check(lib.nurbs_weight_points(spline._handle, index, at.ctypes.data, *(point.ctypes.data for point in found)))
    return found


def weight_cross_ratio(control_point, at_zero, at_one, at_weight):
    """The weight from a control point and these three points."""
    points = Vectors(control_point, at_zero, at_one, at_weight)
    return get(ctypes.c_double, lib.nurbs_weight_cross_ratio, points.dim, *points.addresses)


def weight_through(spline, index, params, target, tolerance):
    """A weight set so that the point at a parameter becomes the target."""
    at, target = _param(spline, params), exactly(target, spline.dimension, "a target")
    return WeightEdit(*_with_number(lib.nurbs_weight_through, spline._handle, index, at.ctypes.data,
                                    target.ctypes.data, tolerance))


def pull_point(spline, index, params, direction, distance):
    """A control point moved so that the point at a parameter moves by a distance along a direction."""
    at, direction = _param(spline, params), exactly(direction, spline.dimension, "a direction")
    return PointEdit(*_with_number(lib.nurbs_pull_point, spline._handle, index, at.ctypes.data, direction.ctypes.data,
                                   distance))


def most_influential(spline, params):
    """The control point with the largest |R_i| at each parameter, of the shape of the batch."""
    given, shape = spline._params(params)
    found = Influences(numpy.empty(shape, numpy.int64), numpy.empty(shape))
    check(lib.nurbs_most_influential(spline._handle, given.n, *given.layout, *(array.ctypes.data for array in found)))
    return found


def insert_on_leg(spline, index, ratio, *, axis=0):
    """The knot inserted that makes a point of a leg of the control polygon a control point."""
    made, knot = _with_number(lib.nurbs_insert_on_leg, spline._handle, axis, index, ratio)
    return LegEdit(made, index, ratio, knot)


def insert_at_point(spline, point, tolerance, *, axis=0):
    """The same for the point on the leg that is nearest to the one given."""
    point, index, ratio = exactly(point, spline.dimension, "a point"), ctypes.c_int64(), ctypes.c_double()
    made, knot = _with_number(lib.nurbs_insert_at_point, spline._handle, axis, point.ctypes.data, tolerance,
                              ctypes.byref(index), ctypes.byref(ratio))
    return LegEdit(made, index.value, ratio.value, knot)
