# SPDX-License-Identifier: MIT
"""The smallest change that makes a shape meet constraints."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy

from ._arrays import address, exactly, if_given, one_each, packed, records
from ._base import SplineBase
from ._calls import watched
from ._library import lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats
    from ._calls import Progress
    from ._spline import Spline

__all__ = ["Constrained"]


class Constrained(NamedTuple):
    """The spline, how far each constraint is missed (n,), the number of independent equations, the largest distance by
    which a control point moved, and the gradient of the Lagrangian."""

    spline: Spline
    residuals: Floats
    rank: int
    moved: float
    optimality: float


class Constraints(SplineBase):
    """Constraints at parameters."""

    def _of_points(self, values: Optional[ArrayLike], name: str) -> Optional[NDArray[Any]]:
        """A number for each control point, if they are given."""
        return None if values is None else packed(one_each(values, self.counts, name).array)

    def constrain(self, params: ArrayLike, targets: ArrayLike, kinds: Optional[ArrayLike] = None,
                  orders: Optional[ArrayLike] = None, *, keep: Optional[ArrayLike] = None,
                  costs: Optional[ArrayLike] = None, weight_costs: Optional[ArrayLike] = None,
                  tolerance: float = 0.0, progress: Progress = None, work: Optional[int] = None) -> Constrained:
        """Control points, and with weight_costs weights, changed so that constraints at parameters (n,) of a curve,
        else (n, axes), meet targets (n, dimension); one alone may leave n out. Least sum costs_i |P_i* - P_i|^2 +
        weight_costs_i (w_i* / w_i - 1)^2.

        kinds are NURBS_CONSTRAIN_ constants (n,), None for values; orders are those of derivatives (n, axes), None for
        0, and 1 for directions of a curve. keep holds the orders of derivatives that stay at the ends (axes, 2), costs
        and weight_costs one number for each control point (counts...). Raises ArgumentError if constraints contradict
        each other, NumericError if none is found.
        """
        axes = self.axes
        at = records(packed(params), axes)
        goals = exactly(targets, at.n * self.dimension, "targets")
        given = [if_given(kinds, at.n, "kinds", numpy.int32), if_given(orders, at.n * axes, "orders", numpy.int32)]
        options = [if_given(keep, 2 * axes, "keep", numpy.int32), self._of_points(costs, "costs"),
                   self._of_points(weight_costs, "weight_costs")]
        residuals, rank, moved, optimality = numpy.empty(at.n), ctypes.c_int64(), ctypes.c_double(), ctypes.c_double()
        made = self._made(watched(lib.nurbs_constrain, progress, work), self._handle, at.n, *map(address, given),
                          at.layout[0], goals.ctypes.data, *map(address, options), tolerance, residuals.ctypes.data,
                          ctypes.byref(rank), ctypes.byref(moved), ctypes.byref(optimality))
        return Constrained(made, residuals, rank.value, moved.value, optimality.value)
