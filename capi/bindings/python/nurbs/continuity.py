# SPDX-License-Identifier: MIT
"""Continuity at knots and between ends."""

import ctypes
from collections import namedtuple

import numpy

from ._library import check, lib

KnotContinuity = namedtuple("KnotContinuity", "knots knot_orders orders geometric_orders position_gaps angles "
                                              "curvature_gaps")
EndContinuity = namedtuple("EndContinuity", "order geometric position_gap angle curvature_gap")


def continuity(spline, *, position=0.0, derivative=0.0, angle=0.0, axis=0):
    """One row for each knot inside the domain, and for the seam: a KnotContinuity of arrays."""
    count = ctypes.c_int64()
    check(lib.nurbs_continuity(spline._handle, axis, position, derivative, angle, 0, *[None] * 7, ctypes.byref(count)))
    kinds = (float, numpy.int32, numpy.int32, numpy.int32, float, float, float)
    arrays = [numpy.empty(count.value, kind) for kind in kinds]
    check(lib.nurbs_continuity(spline._handle, axis, position, derivative, angle, count.value,
                               *(array.ctypes.data for array in arrays), None))
    return KnotContinuity(*arrays)


def continuity_between(a, end_a, b, end_b, *, position=0.0, derivative=0.0, angle=0.0):
    """How two curves meet at one end of each: an EndContinuity."""
    results = [ctypes.c_int32(), ctypes.c_int32(), ctypes.c_double(), ctypes.c_double(), ctypes.c_double()]
    check(lib.nurbs_continuity_between(a._handle, end_a, b._handle, end_b, position, derivative, angle,
                                       *(ctypes.byref(result) for result in results)))
    return EndContinuity(*(result.value for result in results))
