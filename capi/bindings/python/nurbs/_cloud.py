# SPDX-License-Identifier: MIT
"""Splines closest to points without parameters."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from ._arrays import one_each, records
from ._base import SplineBase
from ._calls import watched
from ._library import call, int32, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._calls import Progress
    from ._spline import Spline

__all__ = ["CloudReport", "FittedCloud"]


class CloudReport(NamedTuple):
    """The number of points that count and the sum of their weights, sum_i w_i d_i^2 and the root of its mean, with d_i the
    distance of point i from the result, the largest d_i and where it is, the last factor lambda of the penalty, a bound of
    how far a d_i is from the true distance if it is certified, how many of the nearest points are on an end or an edge, and
    how many are not proven to be nearest, the number of rounds, and a sum of NURBS_CLOUD_ bits."""

    data_count: int
    weight: float
    squares: float
    rms: float
    largest: float
    largest_index: int
    lam: float
    noise: float
    boundary: int
    uncertified: int
    rounds: int
    bits: int


class FittedCloud(NamedTuple):
    """The spline, and how close to the points it is."""

    spline: Spline
    report: CloudReport


class _CloudOptions(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("penalty_order", ctypes.c_int32), ("rounds", ctypes.c_int32),
                ("lam", ctypes.c_double), ("first_lambda", ctypes.c_double), ("tolerance", ctypes.c_double)]


class _CloudReport(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("data_count", ctypes.c_int64), ("weight", ctypes.c_double),
                ("squares", ctypes.c_double), ("rms", ctypes.c_double), ("largest", ctypes.c_double),
                ("largest_index", ctypes.c_int64), ("lam", ctypes.c_double), ("noise", ctypes.c_double),
                ("boundary", ctypes.c_int64), ("uncertified", ctypes.c_int64), ("rounds", ctypes.c_int32),
                ("bits", ctypes.c_int32)]


class Clouds(SplineBase):
    """Fits that begin with a spline."""

    def fit_cloud(self, points: ArrayLike, weights: Optional[ArrayLike] = None, *, penalty_order: int = 2,
                  rounds: int = 100, lam: float = -1.0, first_lambda: float = -1.0, tolerance: float = 1e-3,
                  progress: Progress = None, work: Optional[int] = None) -> FittedCloud:
        """The spline over the knots of this one, which is polynomial, that is closest to points (n, dimension) without
        parameters, with weights (n,), by default 1: a minimum of sum_i w_i d_i^2 + lam sum_k int (d^m s / dx_k^m)^2 dx
        that is reached from here, with d_i the distance of point i from the spline, and m the penalty_order.

            start = nurbs.cloud_start(points, 3, nurbs.knots_open_uniform(3, 12))
            spline, report = start.fit_cloud(points)

        A lam below 0 is found from the distances; it falls to its value from first_lambda, which is also found if it is
        below 0. The fit ends when steps lower the sum by less than the part `tolerance`, or after so many rounds, each of
        which finds the nearest points of all points: then the report has the bit NURBS_CLOUD_NOT_CONVERGED."""
        given = records(points, self.dimension)
        each = None if weights is None else one_each(weights, (given.n,), "weights")
        options: Any = _CloudOptions()
        call(lib.nurbs_cloud_options_init, ctypes.byref(options), ctypes.sizeof(options))
        options.penalty_order, options.rounds = int32(penalty_order), int32(rounds)
        options.lam, options.first_lambda, options.tolerance = lam, first_lambda, tolerance
        report: Any = _CloudReport(ctypes.sizeof(_CloudReport))
        made = self._made(watched(lib.nurbs_fit_cloud, progress, work), self._handle, given.n, *given.layout,
                          *(each.layout[:2] if each is not None else (None, 0)), ctypes.byref(options),
                          ctypes.byref(report))
        return FittedCloud(made, CloudReport(*(getattr(report, name) for name in CloudReport._fields)))
