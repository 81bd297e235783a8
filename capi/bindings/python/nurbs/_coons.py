# SPDX-License-Identifier: MIT
"""Surfaces and volumes from their boundaries, which are counted by axis, then by end, as Spline.boundaries() does."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional

import numpy

from ._arrays import address, addresses, if_given
from ._base import handles
from ._library import call, lib
from .constants import NURBS_TWIST_AVERAGE, NURBS_TWIST_BILINEAR, NURBS_TWIST_GIVEN
from ._spline import Spline

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats

__all__ = ["HermiteCoons", "CoonsGaps", "coons", "coons_hermite", "coons_gaps", "coons_volume"]


class HermiteCoons(NamedTuple):
    """The surface, and a bound of how far it is from the data."""

    spline: Spline
    bound: float


class CoonsGaps(NamedTuple):
    """Differences at the corners (u0, v0), (u0, v1), (u1, v0), (u1, v1): of positions (4,), of tangents (4, 2) by u and
    by v, and of twists (4,)."""

    positions: Floats
    tangents: Floats
    twists: Floats


def _four(splines: Optional[Iterable[Spline]]) -> Any:
    """Four handles, or None."""
    return None if splines is None else handles(splines, 4)


def coons(curves: Iterable[Spline], tolerance: float = 0.0) -> Spline:
    """The bilinear blend of four curves, whose ends meet to within the tolerance."""
    return Spline._made(lib.nurbs_surface_coons, handles(curves, 4), tolerance)


def coons_hermite(curves: Iterable[Spline], cross: Optional[Iterable[Spline]] = None, twist: Optional[int] = None,
                  twists: Optional[ArrayLike] = None, tolerance: float = 0.0) -> HermiteCoons:
    """The bicubic blend of four curves and, unless None, derivatives across them.

    twist is a NURBS_TWIST_ constant. Left out it is NURBS_TWIST_GIVEN where twists (4, dimension) are given, the
    average with cross tangents, and the bilinear one without. Raises ArgumentError where data do not meet to the
    tolerance.
    """
    around, across = handles(curves, 4), _four(cross)
    if twist is None:
        twist = NURBS_TWIST_AVERAGE if across is not None else NURBS_TWIST_BILINEAR
        twist = twist if twists is None else NURBS_TWIST_GIVEN
    given, bound = if_given(twists, 4 * around.splines[0].dimension, "twists"), ctypes.c_double()
    made = Spline._made(lib.nurbs_surface_coons_hermite, around, across, twist,
                        address(given), tolerance, ctypes.byref(bound))
    return HermiteCoons(made, bound.value)


def coons_gaps(curves: Iterable[Spline], cross: Optional[Iterable[Spline]] = None) -> CoonsGaps:
    """What does not meet at the corners of a surface to be."""
    gaps, across = CoonsGaps(numpy.empty(4), numpy.empty((4, 2)), numpy.empty(4)), _four(cross)
    call(lib.nurbs_coons_gaps, handles(curves, 4), across, *addresses(*gaps))
    return gaps


def coons_volume(faces: Iterable[Spline], tolerance: float = 0.0) -> Spline:
    """The linear blend of six faces, whose edges meet to within the tolerance."""
    return Spline._made(lib.nurbs_volume_coons, handles(faces, 6), tolerance)
