# SPDX-License-Identifier: MIT
"""Splines taken apart into lists, and joined again."""

import ctypes
from collections import namedtuple

from ._library import get, lib
from .files import SplineList
from .spline import Spline

Joined = namedtuple("Joined", "spline gap")


def decompose(spline):
    """The polynomial pieces as Bezier splines over their own domains, last axis fastest: a SplineList."""
    return SplineList(get(ctypes.c_void_p, lib.nurbs_decompose, spline._handle))


def split_at_knots(spline, order, *, axis=0):
    """The parts between the knots at which the order of continuity is less than `order`: a SplineList."""
    return SplineList(get(ctypes.c_void_p, lib.nurbs_split_at_knots, spline._handle, axis, order))


def join(parts, *, tolerance=0.0, flags=0, axis=0):
    """A sequence of splines joined end to end, and the largest distance of two ends: (spline, gap)."""
    parts = list(parts)  # alive until the call is over
    handles = (ctypes.c_void_p * len(parts))(*(part._handle for part in parts))
    gap = ctypes.c_double()
    spline = Spline._made(lib.nurbs_join, len(parts), handles, axis, tolerance, flags, ctypes.byref(gap))
    return Joined(spline, gap.value)
