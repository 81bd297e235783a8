# SPDX-License-Identifier: MIT
"""Distances and closest points. A `range` is the part (axes, 2) of the domain that is searched, of a curve (2,)."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import address, exactly, if_given, records
from ._library import check, lib
from .constants import NURBS_NAN_POINTS

#: For points (..., dim): parameters (...) of a curve, else (..., axes), points (..., dim), distances (...), and sums of
#: NURBS_CLOSEST_ bits (...).
ClosestPoints = namedtuple("ClosestPoints", "params points distances status")
#: n points as near as the nearest one: parameters (n,) of a curve, else (n, axes), distances (n,), and the status of
#: the search.
ClosestAll = namedtuple("ClosestAll", "params distances status")
#: The same, with NURBS_CRITICAL_ constants (n,).
CriticalPoints = namedtuple("CriticalPoints", "params distances kinds status")
#: Distances, positive to the left, parameters, and sums of NURBS_CLOSEST_ bits.
SignedDistances = namedtuple("SignedDistances", "distances params status")
#: Bounds of a distance, the parameters (axes,) of a point of each spline, and the status.
Distance = namedtuple("Distance", "at_least at_most params_a params_b status")
#: The same with two bounds each (2,): of the distance from a to b, and from b to a.
HausdorffDistance = namedtuple("HausdorffDistance", "at_least at_most params_a params_b status")


def _queries(spline, points):
    """The points as records, and the shape of the batch."""
    shape, dim = numpy.shape(points), spline.dimension
    if not shape or shape[-1] != dim:
        raise ValueError(f"points must have shape (..., {dim})")
    return records(points, dim), shape[:-1]


def _params(spline, shape):
    """Room for parameters; those of a curve are numbers."""
    return numpy.empty(shape if spline.axes == 1 else shape + (spline.axes,))


def _range(spline, part):
    return if_given(part, 2 * spline.axes, "a range")


def _flags(nan_points):
    return NURBS_NAN_POINTS if nan_points else 0


def _closest(spline, shape, function):
    """The results of function(outputs with their strides)."""
    found = ClosestPoints(_params(spline, shape), numpy.empty(shape + (spline.dimension,)), numpy.empty(shape),
                          numpy.empty(shape, numpy.int32))
    params, points, distances, status = (array.ctypes.data for array in found)
    check(function(params, 0, 0, points, 0, 0, distances, 0, status))
    return found


def _search(function, spline, points, part, tolerance, budget, nan_points):
    (given, shape), part = _queries(spline, points), _range(spline, part)
    return _closest(spline, shape, lambda *outputs: function(
        spline._handle, given.n, *given.layout, address(part), tolerance, budget, *outputs, _flags(nan_points)))


def closest_points(spline, points, *, range=None, tolerance=0.0, budget=0, nan_points=False):
    """The nearest points of a spline; in a volume this is inversion."""
    return _search(lib.nurbs_closest_points, spline, points, range, tolerance, budget, nan_points)


def farthest_points(spline, points, *, range=None, tolerance=0.0, budget=0, nan_points=False):
    """The farthest points of a spline."""
    return _search(lib.nurbs_farthest_points, spline, points, range, tolerance, budget, nan_points)


def closest_local(spline, points, guesses, *, nan_points=False):
    """Local minima of the distance, each the one that a descent from a guess comes to."""
    (given, shape), (starts, _) = _queries(spline, points), spline._params(guesses)
    if starts.n != given.n:
        raise ValueError(f"{starts.n} guesses for {given.n} points")
    return _closest(spline, shape, lambda *outputs: lib.nurbs_closest_local(
        spline._handle, given.n, *given.layout, *starts.layout, *outputs, _flags(nan_points)))


def closest_all(spline, point, *, range=None, tolerance=0.0, budget=0):
    """All points that are local minima of the distance and as near as the nearest one to the tolerance."""
    point, part = exactly(point, spline.dimension, "a point"), _range(spline, range)
    count, status = ctypes.c_int64(), ctypes.c_int32()

    def call(cap, *arrays):
        check(lib.nurbs_closest_all(spline._handle, point.ctypes.data, address(part), tolerance, budget, cap, *arrays,
                                    ctypes.byref(count), ctypes.byref(status)))

    call(0, None, None)
    params, distances = _params(spline, (count.value,)), numpy.empty(count.value)
    call(count.value, params.ctypes.data, distances.ctypes.data)
    return ClosestAll(params, distances, status.value)


def critical_points(spline, point, *, range=None, tolerance=0.0, budget=0):
    """All critical points of the distance from a point."""
    point, part = exactly(point, spline.dimension, "a point"), _range(spline, range)
    count, status = ctypes.c_int64(), ctypes.c_int32()

    def call(cap, *arrays):
        check(lib.nurbs_critical_points(spline._handle, point.ctypes.data, address(part), tolerance, budget, cap,
                                        *arrays, ctypes.byref(count), ctypes.byref(status)))

    call(0, None, None, None)
    n = count.value
    params, distances, kinds = _params(spline, (n,)), numpy.empty(n), numpy.empty(n, numpy.int32)
    call(n, params.ctypes.data, distances.ctypes.data, kinds.ctypes.data)
    return CriticalPoints(params, distances, kinds, status.value)


def signed_distances(spline, points, *, tolerance=0.0, budget=0, nan_points=False):
    """Signed distances of points (..., 2) from a curve in the plane, positive to its left."""
    given, shape = _queries(spline, points)
    found = SignedDistances(numpy.empty(shape), numpy.empty(shape), numpy.empty(shape, numpy.int32))
    distances, params, status = (array.ctypes.data for array in found)
    check(lib.nurbs_curve_signed_distances(spline._handle, given.n, *given.layout, tolerance, budget, distances, 0,
                                           params, 0, status, _flags(nan_points)))
    return found


def distance(a, b, tolerance=0.0, *, budget=0):
    """The smallest distance of two splines, enclosed; the points of the parameters are at_most apart."""
    low, high, status = ctypes.c_double(), ctypes.c_double(), ctypes.c_int32()
    params_a, params_b = numpy.empty(a.axes), numpy.empty(b.axes)
    check(lib.nurbs_distance(a._handle, b._handle, tolerance, budget, ctypes.byref(low), ctypes.byref(high),
                             params_a.ctypes.data, params_b.ctypes.data, ctypes.byref(status)))
    return Distance(low.value, high.value, params_a, params_b, status.value)


def hausdorff_distance(a, b, tolerance, *, budget=0):
    """How far the points of a that are farthest from b are from it, and the other way round, enclosed."""
    low, high, status = numpy.empty(2), numpy.empty(2), ctypes.c_int32()
    params_a, params_b = numpy.empty(a.axes), numpy.empty(b.axes)
    check(lib.nurbs_hausdorff_distance(a._handle, b._handle, tolerance, budget, low.ctypes.data, high.ctypes.data,
                                       params_a.ctypes.data, params_b.ctypes.data, ctypes.byref(status)))
    return HausdorffDistance(low, high, params_a, params_b, status.value)
