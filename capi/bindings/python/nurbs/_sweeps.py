# SPDX-License-Identifier: MIT
"""Surfaces and volumes that come of moving a spline, or of two."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

from ._base import SplineBase, handle_of
from ._library import lib
from ._placement import FULL_TURN, Vectors
from .constants import NURBS_ARC_QUARTERS, NURBS_RULED_CARTESIAN

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._spline import Spline


class Sweeps(SplineBase):
    """Splines with more axes."""

    def extrude(self, vector: ArrayLike) -> Spline:
        """A curve or surface moved along a vector, which becomes a new last axis over [0, 1]."""
        along = self._coordinates(vector, "a vector")
        return self._made(lib.nurbs_extrude, self._handle, along.ctypes.data)

    def revolve(self, sweep: float = FULL_TURN, point: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
                form: int = NURBS_ARC_QUARTERS) -> Spline:
        """A curve or surface in space turned about an axis through a point, by default the z axis; the angle is a new
        axis 0 over [0, 1], its form a NURBS_ARC_ constant."""
        given = Vectors(point, axis, otherwise=3)
        if given.dim != 3:
            raise ValueError(f"an axis of revolution of dimension {given.dim}")
        return self._made(lib.nurbs_revolve, self._handle, *given.addresses, sweep, form)

    def ruled(self, other: SplineBase, *, cartesian: bool = False) -> Spline:
        """Straight lines from this curve or surface to another, a new last axis over [0, 1]; cartesian ones are
        (1 - v) self(u) + v other(u), whatever the weights."""
        return self._made(lib.nurbs_ruled, self._handle, handle_of(other), NURBS_RULED_CARTESIAN if cartesian else 0)

    def tensor_sum(self, other: SplineBase, alpha: float = 1.0, beta: float = 1.0) -> Spline:
        """The translational sweep alpha self(u) + beta other(v)."""
        return self._made(lib.nurbs_tensor_sum, self._handle, alpha, handle_of(other), beta)

    def tensor_product(self, other: SplineBase) -> Spline:
        """The product self(u) other(v), component by component."""
        return self._made(lib.nurbs_tensor_product, self._handle, handle_of(other))

    def swung(self, profile: SplineBase, scale: float = 1.0) -> Spline:
        """The surface (scale r(v) x(u), scale r(v) y(u), z(v)) of this trajectory (x, y) and a profile (r, z)."""
        return self._made(lib.nurbs_surface_swung, self._handle, handle_of(profile), scale)
