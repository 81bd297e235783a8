# SPDX-License-Identifier: MIT
"""The smallest change that makes a shape meet constraints."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import address, exactly, if_given, records
from ._library import lib
from .spline import Spline

#: The spline, how far each constraint is missed (n,), the number of independent equations, the largest distance by
#: which a control point moved, and the gradient of the Lagrangian.
Constrained = namedtuple("Constrained", "spline residuals rank moved optimality")


def constrain(spline, params, targets, kinds=None, orders=None, *, keep=None, costs=None, weight_costs=None,
              tolerance=0.0):
    """Constraints at parameters (n,) of a curve, else (n, axes), with targets (n, dim); one alone may leave n out.

    kinds are NURBS_CONSTRAIN_ constants (n,), None for values; orders are those of derivatives (n, axes), None for 0,
    and 1 for directions of a curve. keep holds the orders of derivatives that stay at the ends (axes, 2), costs and
    weight_costs one number for each control point, of the shape of its counts.
    """
    axes, points = spline.axes, spline.point_count
    at = records(numpy.ascontiguousarray(params, dtype=numpy.float64), axes)
    targets = exactly(targets, at.n * spline.dimension, "targets")
    kinds = if_given(kinds, at.n, "kinds", numpy.int32)
    orders = if_given(orders, at.n * axes, "orders", numpy.int32)
    keep = if_given(keep, 2 * axes, "keep", numpy.int32)
    costs, weight_costs = if_given(costs, points, "costs"), if_given(weight_costs, points, "weight_costs")
    residuals, rank, moved, optimality = numpy.empty(at.n), ctypes.c_int64(), ctypes.c_double(), ctypes.c_double()
    made = Spline._made(lib.nurbs_constrain, spline._handle, at.n, address(kinds), address(orders), at.address,
                        targets.ctypes.data, address(keep), address(costs), address(weight_costs), tolerance,
                        residuals.ctypes.data, ctypes.byref(rank), ctypes.byref(moved), ctypes.byref(optimality))
    return Constrained(made, residuals, rank.value, moved.value, optimality.value)
