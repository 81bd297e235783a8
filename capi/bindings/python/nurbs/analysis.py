# SPDX-License-Identifier: MIT
"""Features of curves and surfaces; `complete` tells that nothing was missed."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import address, exactly, if_given
from ._library import check, get, lib
from .constants import (NURBS_FEATURE_CURVATURE_MAXIMUM, NURBS_FEATURE_CURVATURE_MINIMUM, NURBS_FEATURE_CUSP,
                        NURBS_FEATURE_INFLECTION, NURBS_FEATURE_JUMP, NURBS_FEATURE_KINK, NURBS_FEATURE_TORSION)

#: Parameters (n,) in rising order, one NURBS_FEATURE_ constant each, and curvature, turning angle or width there.
CurveFeatures = namedtuple("CurveFeatures", "params found values complete")
#: Lower ends (n,) of pieces, and 1, -1 or 0 where the curve rises, falls or stays.
MonotonePieces = namedtuple("MonotonePieces", "starts signs complete")
#: A line, and a proven bound of the distance from it.
Straightness = namedtuple("Straightness", "origin direction bound")
#: A plane, and a proven bound of the distance from it.
Planarity = namedtuple("Planarity", "origin normal bound")
#: Of each axis (axes,) whether it closes and a bound of the gap; of each boundary (axes, 2) whether it collapses and
#: its size.
BoundaryContacts = namedtuple("BoundaryContacts", "closed gaps collapsed sizes")
#: Parameters (n, axes), and the boxes (n, axes, 2) in which the singular sets lie.
SingularPoints = namedtuple("SingularPoints", "params boxes complete")
#: A NURBS_FOLD_ constant, and parameters (axes,) of either sign, NaN if none are known.
Fold = namedtuple("Fold", "result positive negative")

_PLANE = (NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CURVATURE_MINIMUM
          | NURBS_FEATURE_CUSP | NURBS_FEATURE_KINK | NURBS_FEATURE_JUMP)


def _listed(function, arrays_for):
    """What function(cap, arrays..., count, complete) lists in arrays_for(count), and whether that is complete."""
    count, complete = ctypes.c_int64(), ctypes.c_int32()
    check(function(0, *[None] * len(arrays_for(0)), ctypes.byref(count), ctypes.byref(complete)))
    arrays = arrays_for(count.value)
    check(function(count.value, *(array.ctypes.data for array in arrays), ctypes.byref(count), ctypes.byref(complete)))
    return (*arrays, bool(complete.value))


def features(spline, kinds=None):
    """The features of a curve, of all kinds unless a sum of NURBS_FEATURE_ constants is given."""
    if kinds is None:
        kinds = _PLANE | NURBS_FEATURE_TORSION if spline.dimension == 3 else _PLANE
    return CurveFeatures(*_listed(
        lambda *outputs: lib.nurbs_curve_features(spline._handle, kinds, *outputs),
        lambda n: (numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty(n))))


def monotone_pieces(spline, direction):
    """The pieces of a curve on which it runs one way along a direction."""
    direction = exactly(direction, spline.dimension, "a direction")
    return MonotonePieces(*_listed(
        lambda *outputs: lib.nurbs_curve_monotone_pieces(spline._handle, direction.ctypes.data, *outputs),
        lambda n: (numpy.empty(n), numpy.empty(n, numpy.int32))))


def convexity(spline):
    """A NURBS_CONVEXITY_ constant of a curve in the plane."""
    return get(ctypes.c_int32, lib.nurbs_curve_convexity, spline._handle)


def straightness(spline):
    """How far a spline is from a straight line."""
    origin, direction = numpy.empty(spline.dimension), numpy.empty(spline.dimension)
    bound = get(ctypes.c_double, lib.nurbs_straightness, spline._handle, origin.ctypes.data, direction.ctypes.data)
    return Straightness(origin, direction, bound)


def planarity(spline):
    """How far a spline in space is from a plane."""
    origin, normal = numpy.empty(3), numpy.empty(3)
    bound = get(ctypes.c_double, lib.nurbs_planarity, spline._handle, origin.ctypes.data, normal.ctypes.data)
    return Planarity(origin, normal, bound)


def boundary_contacts(spline, tolerance=0.0):
    """Which axes close, and which boundaries collapse."""
    axes = spline.axes
    closed, collapsed = numpy.empty(axes, numpy.int32), numpy.empty((axes, 2), numpy.int32)
    gaps, sizes = numpy.empty(axes), numpy.empty((axes, 2))
    check(lib.nurbs_boundary_contacts(spline._handle, tolerance, closed.ctypes.data, gaps.ctypes.data,
                                      collapsed.ctypes.data, sizes.ctypes.data))
    return BoundaryContacts(closed.astype(bool), gaps, collapsed.astype(bool), sizes)


def singular_points(spline, tolerance):
    """Places where a curve or surface is singular; the tolerance is a part of the domain."""
    axes = spline.axes
    return SingularPoints(*_listed(
        lambda *outputs: lib.nurbs_singular_points(spline._handle, tolerance, *outputs),
        lambda n: (numpy.empty((n, axes)), numpy.empty((n, axes, 2)))))


def fold_test(spline, reference=None):
    """Whether a surface or volume folds over; reference is the direction that normals are compared with."""
    reference = if_given(reference, 3, "a reference")
    positive, negative, result = numpy.empty(spline.axes), numpy.empty(spline.axes), ctypes.c_int32()
    check(lib.nurbs_fold_test(spline._handle, address(reference), ctypes.byref(result), positive.ctypes.data,
                              negative.ctypes.data))
    return Fold(result.value, positive, negative)
