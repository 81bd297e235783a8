# SPDX-License-Identifier: MIT
"""Near-equal knots made equal, and sets of splines brought to one form."""

import ctypes
from collections import namedtuple

from ._library import get, lib
from .files import SplineList
from .spline import Spline

Snapped = namedtuple("Snapped", "spline deviation")
Compatible = namedtuple("Compatible", "splines deviation")


def snap_knots(spline, tolerance, *, axis=0):
    """Knots within `tolerance` of the domain's length become one: (spline, proved bound of the deviation)."""
    deviation = ctypes.c_double()
    out = Spline._made(lib.nurbs_snap_knots, spline._handle, axis, tolerance, ctypes.byref(deviation))
    return Snapped(out, deviation.value)


def make_compatible(splines, *, tolerance=0.0, flags=0):
    """A sequence of splines brought to one degree, domain and knot vector on every axis: (SplineList, bound)."""
    splines = list(splines)  # alive until the call is over
    handles = (ctypes.c_void_p * len(splines))(*(spline._handle for spline in splines))
    deviation = ctypes.c_double()
    made = get(ctypes.c_void_p, lib.nurbs_make_compatible, len(splines), handles, tolerance, flags,
               ctypes.byref(deviation))
    return Compatible(SplineList(made), deviation.value)
