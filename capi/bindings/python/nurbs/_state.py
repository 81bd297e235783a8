# SPDX-License-Identifier: MIT
"""What a spline is made of, bit for bit: for pickles, equality and hashes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple

from .constants import NURBS_PERIODIC, on_axis

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._spline import Spline

    #: Whether it was built homogeneous, degrees, knots, points (homogeneous ones if so), weights, and flags.
    State = Tuple[bool, Tuple[int, ...], Tuple[Floats, ...], Floats, Optional[Floats], int]


def state_of(spline: Spline) -> State:
    """The arguments of the constructor that makes the same spline, and whether that is Spline.create_homogeneous()."""
    flags = sum(on_axis(axis, NURBS_PERIODIC) for axis, periodic in enumerate(spline.periodic) if periodic)
    if spline.is_homogeneous:
        return True, spline.degrees, spline.knots, spline.homogeneous_points, None, flags
    return False, spline.degrees, spline.knots, spline.points, spline.weights, flags


def key_of(spline: Spline) -> Tuple[Any, ...]:
    """A value that is equal, and can be hashed, if every bit of a spline is."""
    homogeneous, degrees, knots, points, weights, flags = state_of(spline)
    return (homogeneous, degrees, tuple(axis.tobytes() for axis in knots), points.shape, points.tobytes(),
            None if weights is None else weights.tobytes(), flags)
