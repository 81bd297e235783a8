# SPDX-License-Identifier: MIT
"""Operations that move the shape, each with a proven bound."""

import ctypes
from collections import namedtuple

from ._library import get, lib
from .spline import Spline

Deviation = namedtuple("Deviation", "lower upper")
KnotRemoval = namedtuple("KnotRemoval", "spline removed bound")
Reduced = namedtuple("Reduced", "spline bound")


def deviation(f, g):
    """Proven bounds of the largest distance of two splines over the same domain: (lower, upper)."""
    lower = ctypes.c_double()
    upper = get(ctypes.c_double, lib.nurbs_deviation, f._handle, g._handle, ctypes.byref(lower))
    return Deviation(lower.value, upper)


def remove_knot(spline, knot, *, times=1, tolerance=0.0, axis=0):
    """Copies of a knot removed, as many as the tolerance allows: (spline, removed, bound)."""
    removed, bound = ctypes.c_int32(), ctypes.c_double()
    made = Spline._made(lib.nurbs_remove_knot, spline._handle, axis, knot, times, tolerance, ctypes.byref(removed),
                        ctypes.byref(bound))
    return KnotRemoval(made, removed.value, bound.value)


def _reduced(function, *arguments):
    bound = ctypes.c_double()
    made = Spline._made(function, *arguments, ctypes.byref(bound))
    return Reduced(made, bound.value)


def reduce_knots(spline, tolerance, *, axis=-1):
    """As few knots as the tolerance allows, on one axis or on every one: (spline, bound)."""
    return _reduced(lib.nurbs_reduce_knots, spline._handle, axis, tolerance)


def reduce_degree(spline, times=1, *, axis=0):
    """The closest spline of lower degree: (spline, bound)."""
    return _reduced(lib.nurbs_reduce_degree, spline._handle, axis, times)


def simplify(spline, tolerance):
    """The simplest spline within the tolerance: (spline, bound)."""
    return _reduced(lib.nurbs_simplify, spline._handle, tolerance)
