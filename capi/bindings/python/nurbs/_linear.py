# SPDX-License-Identifier: MIT
"""Derivatives with respect to data: collocation matrices and gradients."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from ._arrays import Gradient, address, addresses, if_given, packed, parameters, records, vector
from ._base import SplineBase
from ._library import call, get, lib
from ._net import concatenated
from .constants import NURBS_ACCUMULATE
from ._evaluation import derivative_slots

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int32s, Int64s, Records, Shape

__all__ = ["SparseMatrix", "Gradients", "FootGradients", "LengthGradients", "collocation"]


class SparseMatrix(NamedTuple):
    """Compressed sparse rows, as scipy.sparse.csr_array() takes them: the entries and their columns (entries,), and
    where each row begins (rows + 1,)."""

    values: Floats
    columns: Int64s
    row_pointers: Int64s


class Gradients(NamedTuple):
    """Gradients with respect to control points (counts..., dimension), weights (counts...) and parameters, of their
    shape; None where they are not wanted."""

    points: Floats
    weights: Floats
    params: Floats


class FootGradients(NamedTuple):
    """Gradients with respect to control points (counts..., dimension), weights (counts...) and query points, of their
    shape, and sums of NURBS_CLOSEST_ bits; None where they are not wanted."""

    points: Floats
    weights: Floats
    queries: Floats
    status: Int32s


class LengthGradients(NamedTuple):
    """Gradients of a length with respect to control points (count, dimension) and weights (count,), and an estimate of
    their relative error; None where they are not wanted."""

    points: Floats
    weights: Floats
    error: float


def _chosen(wanted: Optional[Sequence[str]], names: Sequence[str]) -> Tuple[bool, ...]:
    """Which of the names are wanted: all, or those of a list, or one alone."""
    chosen = tuple(names) if wanted is None else (wanted,) if isinstance(wanted, str) else tuple(wanted)
    for name in chosen:
        if name not in names:
            raise ValueError(f"wanted: {name!r}, expected some of {', '.join(names)}")
    return tuple(name in chosen for name in names)


def _layouts(outputs: Sequence[Optional[Gradient]]) -> List[Tuple[Optional[int], int, int]]:
    """Pointers and strides, NULL where nothing is wanted."""
    return [output.layout if output else (None, 0, 0) for output in outputs]


def _finished(outputs: Sequence[Optional[Gradient]]) -> List[Any]:
    """The filled arrays, None where nothing was wanted."""
    return [output.finish() if output else None for output in outputs]


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
                     param_gradients: Optional[NDArray[Any]] = None,
                     wanted: Union[str, Sequence[str], None] = None) -> Gradients:
        """Gradients of a function L with respect to control points, weights and parameters: the transpose of eval(), or
        with an order of eval_derivs(). Cotangents dL / dC have the shape of eval(params), or of
        eval_derivs(params, order). Arrays given for the gradients are filled, with NURBS_ACCUMULATE added to. Only
        those are computed that are `wanted`, of "points", "weights" and "params", by default all."""
        given, shape = self._params(params)
        dim, axes = self.dimension, self.axes
        slots = derivative_slots(axes, order or 0)
        shape_of = (*shape, dim) if order is None else (*shape, slots, dim)
        g, add = self._cotangents(cotangents, shape_of, slots * dim), bool(flags & NURBS_ACCUMULATE)
        shapes = (points, (*self.counts, dim), dim), (weights, self.counts, 1), (param_gradients, given.shape, axes)
        chosen = _chosen(wanted, ("points", "weights", "params"))
        outputs = [Gradient(*shape, add) if take else None for shape, take in zip(shapes, chosen)]
        of_points, of_weights, of_params = _layouts(outputs)
        call(lib.nurbs_eval_adjoint, self._handle, order or 0, given.n, *given.layout, *g.layout, *of_points,
             *of_weights[:2], *of_params, flags)
        return Gradients(*_finished(outputs))

    def eval_adjoint_knots(self, params: ArrayLike, cotangents: ArrayLike, order: Optional[int] = None, *,
                           axis: int = 0, flags: int = 0, knots: Optional[NDArray[Any]] = None) -> Floats:
        """The gradient of a function L with respect to the knots of an axis, each alone: the transpose of
        eval_knot_derivative() for all of them. Params and cotangents are those of eval_adjoint(); an array given for
        the gradient is filled, with NURBS_ACCUMULATE added to."""
        (given, shape), dim = self._params(params), self.dimension
        slots, add = derivative_slots(self.axes, order or 0), bool(flags & NURBS_ACCUMULATE)
        g = self._cotangents(cotangents, (*shape, dim) if order is None else (*shape, slots, dim), slots * dim)
        size = get(ctypes.c_int64, lib.nurbs_count, self._handle, axis)
        size += get(ctypes.c_int32, lib.nurbs_degree, self._handle, axis) + 1
        out = Gradient(knots, (size,), size, add)
        result = out.result if out.result.flags.c_contiguous else out.result.copy()
        call(lib.nurbs_eval_adjoint_knots, self._handle, axis, order or 0, given.n, *given.layout, *g.layout,
             result.ctypes.data, flags)
        if result is not out.result:
            out.result[...] = result
        return out.result

    @staticmethod
    def _cotangents(values: ArrayLike, wanted: Shape, width: int) -> Records:
        """Cotangents as records, of one shape."""
        g = records(values, width)
        if g.shape != wanted:
            raise ValueError(f"cotangents of shape {g.shape}, expected {wanted}")
        return g

    def closest_adjoint(self, points: ArrayLike, params: ArrayLike, param_cotangents: Optional[ArrayLike] = None,
                        foot_cotangents: Optional[ArrayLike] = None, distance_cotangents: Optional[ArrayLike] = None, *,
                        flags: int = 0, wanted: Union[str, Sequence[str], None] = None) -> FootGradients:
        """Gradients of a function L of closest points S + (dimension,) with their parameters S of a curve, else
        S + (axes,): with respect to control points, weights and the query points, from the cotangents dL / dparams,
        dL / dfeet and dL / ddistances, those of closest_points(). None is 0. Only those are computed that are `wanted`,
        of "points", "weights", "queries" and "status", by default all."""
        (at, _), dim = self._params(params), self.dimension
        queries = packed(points).reshape(-1, dim)
        shape, n = numpy.shape(points)[:-1], queries.shape[0]
        if at.n != n:
            raise ValueError(f"{at.n} parameters for {n} points")
        inputs = [queries, packed(params).reshape(-1)]
        cotangents = [if_given(param_cotangents, at.n * self.axes, "param_cotangents"),
                      if_given(foot_cotangents, n * dim, "foot_cotangents"),
                      if_given(distance_cotangents, n, "distance_cotangents")]
        shapes = (*self.counts, dim), self.counts, (*shape, dim), shape
        kinds = numpy.float64, numpy.float64, numpy.float64, numpy.int32
        chosen = _chosen(wanted, ("points", "weights", "queries", "status"))
        outputs: List[Any] = [numpy.empty(size, kind) if take else None
                              for size, kind, take in zip(shapes, kinds, chosen)]
        call(lib.nurbs_closest_adjoint, self._handle, n, *addresses(*inputs, *cotangents, *outputs), flags)
        return FootGradients(*outputs)

    def length_adjoint(self, relative_tolerance: float = 0.0, *, cotangent: float = 1.0,
                       range: Optional[ArrayLike] = None, flags: int = 0, points: Optional[NDArray[Any]] = None,
                       weights: Optional[NDArray[Any]] = None,
                       wanted: Union[str, Sequence[str], None] = None) -> LengthGradients:
        """Gradients of the length of a curve over a range (2,) of its domain, times a cotangent. Arrays given for them
        are filled, with NURBS_ACCUMULATE added to. Only those are computed that are `wanted`, of "points" and
        "weights", by default both."""
        add, limits, error = bool(flags & NURBS_ACCUMULATE), self._part(range), ctypes.c_double()
        shapes = (points, (*self.counts, self.dimension), self.dimension), (weights, self.counts, 1)
        chosen = _chosen(wanted, ("points", "weights"))
        outputs = [Gradient(*shape, add) if take else None for shape, take in zip(shapes, chosen)]
        of_points, of_weights = _layouts(outputs)
        call(lib.nurbs_length_adjoint, self._handle, address(limits), relative_tolerance, cotangent, *of_points,
             *of_weights[:2], ctypes.byref(error), flags)
        points_made, weights_made = _finished(outputs)
        return LengthGradients(points_made, weights_made, error.value)
