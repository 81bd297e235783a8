# SPDX-License-Identifier: MIT
"""Splines beyond their ends: extension, unclamped and periodic forms."""

import ctypes
from collections import namedtuple

from ._library import get, lib
from .constants import NURBS_END, NURBS_FORM_CLAMPED_END, NURBS_FORM_CLAMPED_START
from .spline import Spline

PeriodicForm = namedtuple("PeriodicForm", "spline deviation order")


def extend(spline, amount, order, *, end=NURBS_END, axis=0):
    """A spline extended beyond an end by a Taylor polynomial."""
    return Spline._made(lib.nurbs_extend, spline._handle, axis, end, amount, order)


def unclamp(spline, flags=NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, *, axis=0):
    """The same shape with unclamped ends."""
    return Spline._made(lib.nurbs_unclamp, spline._handle, axis, flags)


def make_periodic(spline, tolerance, *, axis=0):
    """A closed spline made periodic: (spline, proved bound of the deviation, order of the seam)."""
    deviation, order = ctypes.c_double(), ctypes.c_int32()
    made = Spline._made(lib.nurbs_make_periodic, spline._handle, axis, tolerance, ctypes.byref(deviation),
                        ctypes.byref(order))
    return PeriodicForm(made, deviation.value, order.value)


def detect_periodic(spline, *, axis=0):
    """Whether knots and points of an axis repeat."""
    return get(ctypes.c_int32, lib.nurbs_detect_periodic, spline._handle, axis) != 0
