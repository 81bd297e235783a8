# SPDX-License-Identifier: MIT
"""Derivatives with respect to data: collocation matrices and gradients."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy

from ._arrays import Gradient, address, addresses, if_given, parameters, records, vector
from ._base import SplineBase
from ._library import call, get, lib
from ._net import concatenated
from .constants import NURBS_ACCUMULATE
from ._evaluation import derivative_slots

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int64s

__all__ = ["SparseMatrix", "Gradients", "collocation"]


class SparseMatrix(NamedTuple):
    """Compressed sparse rows, as scipy.sparse.csr_array() takes them: the entries and their columns (entries,), and
    where each row begins (rows + 1,)."""

    values: Floats
    columns: Int64s
    row_pointers: Int64s


class Gradients(NamedTuple):
    """Gradients with respect to control points (counts..., dimension), weights (counts...) and parameters, of their
    shape."""

    points: Floats
    weights: Floats
    params: Floats


def _sparse(rows: int, function: Callable[..., None]) -> SparseMatrix:
    """The matrix of function(cap, values, columns, row_pointers, entries), whose size is asked for first."""
    entries = ctypes.c_int64()
    function(0, None, None, None, ctypes.byref(entries))
    n = entries.value
    made = SparseMatrix(numpy.empty(n), numpy.empty(n, numpy.int64), numpy.empty(rows + 1, numpy.int64))
    function(n, *addresses(*made), None)
    return made


def collocation(degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]], params: ArrayLike,
                orders: Optional[ArrayLike] = None, flags: int = 0) -> SparseMatrix:
    """The matrix of B-spline basis functions N_j(t_i), or of their partial derivatives of `orders` (axes,), a row for
    each parameter and a column for each control point, last axis fastest. degrees is a number or one for each axis,
    knots a vector or one for each axis; params have the shape (..., axes), for one axis any."""
    p = vector(degrees, numpy.int32)
    axes = p.size
    vectors, lengths = concatenated(knots, axes)
    counts = vector(lengths, numpy.int64) - p - 1
    given_orders, (given, _) = if_given(orders, axes, "orders", numpy.int32), parameters(params, axes)
    return _sparse(given.n, lambda *arrays: call(
        lib.nurbs_collocation, axes, p.ctypes.data, counts.ctypes.data, vectors.ctypes.data, vectors.size,
        address(given_orders), given.n, *given.layout, *arrays, flags))


class Linear(SplineBase):
    """How points depend on control points, weights and parameters."""

    def rational_collocation(self, params: ArrayLike, orders: Optional[ArrayLike] = None,
                             flags: int = 0) -> SparseMatrix:
        """The matrix of the rational basis functions R_j(t_i) = w_j N_j / w, or of their partial derivatives of
        `orders` (axes,): times points.reshape(-1, dimension) it gives the points, or derivatives, at params."""
        given, _ = self._params(params)
        given_orders = if_given(orders, self.axes, "orders", numpy.int32)
        return _sparse(given.n, lambda *arrays: call(
            lib.nurbs_rational_collocation, self._handle, address(given_orders), given.n, *given.layout, *arrays,
            flags))

    def refinement_matrix(self, knots: ArrayLike, *, axis: int = 0) -> SparseMatrix:
        """The matrix that refine(knots) applies along an axis to layers of (homogeneous) control points."""
        values = vector(knots)
        count = get(ctypes.c_int64, lib.nurbs_count, self._handle, axis)
        return _sparse(count + values.size, lambda *arrays: call(
            lib.nurbs_refinement_matrix, self._handle, axis, values.size, values.ctypes.data, *arrays))

    def eval_adjoint(self, params: ArrayLike, cotangents: ArrayLike, order: Optional[int] = None, flags: int = 0,
                     points: Optional[NDArray[Any]] = None, weights: Optional[NDArray[Any]] = None,
                     param_gradients: Optional[NDArray[Any]] = None) -> Gradients:
        """Gradients of a function L with respect to control points, weights and parameters: the transpose of eval(), or
        with an order of eval_derivs(). Cotangents dL / dC have the shape of eval(params), or of
        eval_derivs(params, order). Arrays given for the gradients are filled, with NURBS_ACCUMULATE added to."""
        given, shape = self._params(params)
        dim, axes = self.dimension, self.axes
        slots = derivative_slots(axes, order or 0)
        wanted = (*shape, dim) if order is None else (*shape, slots, dim)
        g, add = records(cotangents, slots * dim), bool(flags & NURBS_ACCUMULATE)
        if g.shape != wanted:
            raise ValueError(f"cotangents of shape {g.shape}, expected {wanted}")
        outputs = [Gradient(points, (*self.counts, dim), dim, add), Gradient(weights, self.counts, 1, add),
                   Gradient(param_gradients, given.shape, axes, add)]
        of_points, of_weights, of_params = (output.layout for output in outputs)
        call(lib.nurbs_eval_adjoint, self._handle, order or 0, given.n, *given.layout, *g.layout, *of_points,
             *of_weights[:2], *of_params, flags)
        return Gradients(*(output.finish() for output in outputs))
