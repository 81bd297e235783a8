# SPDX-License-Identifier: MIT
"""Deformations of a shape or of a region of it; a `range` is a part (axes, 2) of the domain, of a curve (2,)."""

import ctypes
from collections import namedtuple
from math import inf

import numpy

from ._arrays import address, exactly, if_given
from ._library import lib
from .constants import NURBS_REVERSED
from .edit import PointEdit
from .reduce import Reduced
from .spline import Spline

#: A spline near the exact image: how far it is from that, a bound if proven, else of samples.
Deformed = namedtuple("Deformed", "spline deviation proven")
#: The spline, its energies (2,) before and after, and a bound of how far it moved.
Faired = namedtuple("Faired", "spline energies bound")


def _range(spline, part):
    return if_given(part, 2 * spline.axes, "a range")


def warp(spline, direction, distance, order, *, range=None):
    """A region raised along a direction; `order` derivatives stay at its ends."""
    part, direction = _range(spline, range), exactly(direction, spline.dimension, "a direction")
    return Spline._made(lib.nurbs_warp, spline._handle, address(part), direction.ctypes.data, distance, order)


def flatten(spline, point, normal, direction=None, *, range=None):
    """A region flattened to a plane, along a direction or else its normal: (spline, moved)."""
    dim, part, moved = spline.dimension, _range(spline, range), ctypes.c_double()
    point, normal = exactly(point, dim, "a point"), exactly(normal, dim, "a normal")
    direction = if_given(direction, dim, "a direction")
    made = Spline._made(lib.nurbs_flatten, spline._handle, address(part), point.ctypes.data, normal.ctypes.data,
                        address(direction), ctypes.byref(moved))
    return PointEdit(made, moved.value)


def _deformed(function, *arguments):
    deviation, proven = ctypes.c_double(), ctypes.c_int32()
    made = Spline._made(function, *arguments, ctypes.byref(deviation), ctypes.byref(proven))
    return Deformed(made, deviation.value, bool(proven.value))


def bend(spline, origin, along, across, curvature, tolerance, *, lower=-inf, upper=inf):
    """The part between lower and upper bent about an axis: (spline, deviation, proven)."""
    dim = spline.dimension
    vectors = [exactly(v, dim, name) for v, name in ((origin, "origin"), (along, "along"), (across, "across"))]
    return _deformed(lib.nurbs_bend, spline._handle, *(v.ctypes.data for v in vectors), curvature, lower, upper,
                     tolerance)


def free_form_deform(spline, volume, lower, upper, tolerance):
    """A shape in the box from lower to upper mapped by a volume: (spline, deviation, proven)."""
    lower, upper = exactly(lower, volume.axes, "lower"), exactly(upper, volume.axes, "upper")
    return _deformed(lib.nurbs_free_form_deform, spline._handle, volume._handle, lower.ctypes.data, upper.ctypes.data,
                     tolerance)


def fair(spline, tolerance, order=2, *, keep=None):
    """Small energy within a tolerance: order 1 (membrane), 2 (thin plate) or 3; keep holds the orders of derivatives
    (axes, 2) that stay at the ends, None: positions."""
    keep = if_given(keep, 2 * spline.axes, "keep", numpy.int32)
    energies, bound = numpy.empty(2), ctypes.c_double()
    made = Spline._made(lib.nurbs_fair, spline._handle, order, address(keep), tolerance, energies.ctypes.data,
                        ctypes.byref(bound))
    return Faired(made, energies, bound.value)


def snap_boundary(spline, boundary, other, other_boundary, order=0, *, reversed=False):
    """A boundary (axis, NURBS_START or NURBS_END) moved onto one of another spline, with order 1 tangents too:
    (spline, bound)."""
    bound = ctypes.c_double()
    made = Spline._made(lib.nurbs_snap_boundary, spline._handle, *boundary, other._handle, *other_boundary, order,
                        NURBS_REVERSED if reversed else 0, ctypes.byref(bound))
    return Reduced(made, bound.value)
