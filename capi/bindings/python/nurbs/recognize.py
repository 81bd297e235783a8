# SPDX-License-Identifier: MIT
"""Recognition of shapes."""

import ctypes
from collections import namedtuple

import numpy

from ._library import check, lib

#: A NURBS_SHAPE_ constant, origin, axis and x (3,), sizes (2,), and a proven bound of the distance from the shape.
Recognized = namedtuple("Recognized", "shape origin axis x sizes deviation")


def recognize(spline, tolerance):
    """The first shape of the list of nurbs_recognize() from which no point is farther than the tolerance."""
    shape, deviation = ctypes.c_int32(), ctypes.c_double()
    placement, sizes = numpy.empty((3, 3)), numpy.empty(2)
    check(lib.nurbs_recognize(spline._handle, tolerance, ctypes.byref(shape), placement.ctypes.data, sizes.ctypes.data,
                              ctypes.byref(deviation)))
    return Recognized(shape.value, *placement, sizes, deviation.value)
