# SPDX-License-Identifier: MIT
"""Boxes and cones that contain a spline, proven. A `range` is a part (axes, 2) of the domain, of a curve (2,)."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import address, exactly, if_given
from ._library import check, get, lib

#: Lower and upper ends (dim,), and how far a face is from the spline at most.
Box = namedtuple("Box", "lower upper gap")
#: The box of center + sum of x_k axes[k], |x_k| <= half[k]: (dim,), (dim, dim), (dim,).
OrientedBox = namedtuple("OrientedBox", "center axes half")
#: A unit vector (dim,), and half the opening in radians; pi for all of space.
DirectionCone = namedtuple("DirectionCone", "direction angle")
#: Parameters (axes,) of a point, its component along a direction, and a bound of that of all others.
ExtremePoint = namedtuple("ExtremePoint", "params value bound")


def _range(spline, part):
    return if_given(part, 2 * spline.axes, "a range")


def box(spline, tolerance, *, range=None):
    """An axis-aligned box, tight to the tolerance; infinite: that of the Bezier points."""
    part, lower, upper = _range(spline, range), numpy.empty(spline.dimension), numpy.empty(spline.dimension)
    gap = get(ctypes.c_double, lib.nurbs_box, spline._handle, address(part), tolerance, lower.ctypes.data,
              upper.ctypes.data)
    return Box(lower, upper, gap)


def oriented_box(spline, tolerance):
    """A box with axes of its own."""
    dim = spline.dimension
    found = OrientedBox(numpy.empty(dim), numpy.empty((dim, dim)), numpy.empty(dim))
    check(lib.nurbs_oriented_box(spline._handle, tolerance, *(array.ctypes.data for array in found)))
    return found


def tangent_cone(spline, tolerance, *, axis=0, range=None):
    """The directions of the derivatives along an axis."""
    part, direction = _range(spline, range), numpy.empty(spline.dimension)
    angle = get(ctypes.c_double, lib.nurbs_tangent_cone, spline._handle, axis, address(part), tolerance,
                direction.ctypes.data)
    return DirectionCone(direction, angle)


def normal_cone(spline, tolerance, *, range=None):
    """The directions of the normals of a surface in space."""
    part, direction = _range(spline, range), numpy.empty(3)
    angle = get(ctypes.c_double, lib.nurbs_normal_cone, spline._handle, address(part), tolerance,
                direction.ctypes.data)
    return DirectionCone(direction, angle)


def extreme_point(spline, direction, tolerance, *, range=None):
    """The point that is farthest in a direction."""
    part, direction = _range(spline, range), exactly(direction, spline.dimension, "a direction")
    params, value = numpy.empty(spline.axes), ctypes.c_double()
    bound = get(ctypes.c_double, lib.nurbs_extreme_point, spline._handle, direction.ctypes.data, address(part),
                tolerance, params.ctypes.data, ctypes.byref(value))
    return ExtremePoint(params, value.value, bound)
