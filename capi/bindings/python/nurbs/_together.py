# SPDX-License-Identifier: MIT
"""Several splines brought to one form, or joined to one."""

from __future__ import annotations

import ctypes
from typing import Iterable, NamedTuple

from ._base import handles
from ._library import lib
from ._files import SplineList
from ._spline import Spline

__all__ = ["Compatible", "Joined", "join", "make_compatible"]


class Compatible(NamedTuple):
    """The splines, and a proved bound of how far they moved."""

    splines: SplineList
    deviation: float


class Joined(NamedTuple):
    """The spline, and the largest distance of two ends."""

    spline: Spline
    gap: float


def make_compatible(splines: Iterable[Spline], *, tolerance: float = 0.0, flags: int = 0) -> Compatible:
    """Splines brought to one degree, domain and knot vector on every axis, without a change of shape unless a tolerance
    lets near-equal knots become one; NURBS_MAP_DOMAINS maps their domains to that of the first."""
    given, deviation = handles(splines), ctypes.c_double()
    made = Spline._listed(lib.nurbs_make_compatible, len(given), given, tolerance, flags,
                          ctypes.byref(deviation))
    return Compatible(made, deviation.value)


def join(parts: Iterable[Spline], *, tolerance: float = 0.0, flags: int = 0, axis: int = 0) -> Joined:
    """Splines joined end to end along an axis, at the highest of their degrees. Raises ArgumentError where ends lie
    farther apart than the tolerance, unless NURBS_KEEP_GAPS makes a jump of them."""
    given, gap = handles(parts), ctypes.c_double()
    spline = Spline._made(lib.nurbs_join, len(given), given, axis, tolerance, flags,
                          ctypes.byref(gap))
    return Joined(spline, gap.value)
