# SPDX-License-Identifier: MIT
"""Derivatives with respect to data: collocation matrices, Bezier extraction, gradients."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import Output, address, records, vector
from ._library import check, get, lib
from .constants import NURBS_ACCUMULATE
from .spline import _concatenated, derivative_slots

Gradients = namedtuple("Gradients", "points weights params")


def _sparse(n, function):
    """(values, columns, row_pointers), whose sizes are asked for first."""
    entries = get(ctypes.c_int64, function, 0, None, None, None)
    values, columns = numpy.empty(entries), numpy.empty(entries, numpy.int64)
    rows = numpy.empty(n + 1, numpy.int64)
    check(function(entries, values.ctypes.data, columns.ctypes.data, rows.ctypes.data, None))
    return values, columns, rows


def _orders(orders, axes):
    """Orders of a derivative as an array, or None."""
    if orders is None:
        return None
    orders = vector(orders, numpy.int32)
    if orders.size != axes:
        raise ValueError(f"{orders.size} orders for {axes} axes")
    return orders


def collocation(degrees, knots, params, orders=None, flags=0):
    """The matrix of B-spline basis functions, or of their derivative `orders`: (values, columns, row_pointers), as
    scipy.sparse.csr_matrix takes them. `degrees` a number or one for each axis, `knots` a vector or one for each axis,
    params of shape (..., axes), for one axis of any shape."""
    degrees = vector(degrees, numpy.int32)
    axes = degrees.size
    knots, lengths = _concatenated(knots, axes)
    counts = vector(lengths, numpy.int64) - degrees - 1
    orders, given = _orders(orders, axes), records(params, axes)
    return _sparse(given.n, lambda *arrays: lib.nurbs_collocation(
        axes, degrees.ctypes.data, counts.ctypes.data, knots.ctypes.data, knots.size, address(orders), given.n,
        *given.layout, *arrays, flags))


def rational_collocation(spline, params, orders=None, flags=0):
    """The matrix of the rational basis functions of a spline, or of their derivative `orders`."""
    given, _ = spline._params(params)
    orders = _orders(orders, spline.axes)
    return _sparse(given.n, lambda *arrays: lib.nurbs_rational_collocation(
        spline._handle, address(orders), given.n, *given.layout, *arrays, flags))


def refinement_matrix(spline, knots, axis=0):
    """The matrix that Spline.refine(knots) applies along an axis: (values, columns, row_pointers)."""
    knots = vector(knots, numpy.float64)
    return _sparse(spline.counts[axis] + knots.size, lambda *arrays: lib.nurbs_refinement_matrix(
        spline._handle, axis, knots.size, knots.ctypes.data, *arrays))


def bezier_extraction(spline, axis=0):
    """Operators (spans, degree + 1, degree + 1), first control points (spans,) and domains (spans, 2)."""
    spans = get(ctypes.c_int64, lib.nurbs_bezier_extraction, spline._handle, axis, 0, None, None, None)
    width = spline.degree(axis) + 1
    operators, domains = numpy.empty((spans, width, width)), numpy.empty((spans, 2))
    firsts = numpy.empty(spans, numpy.int64)
    get(ctypes.c_int64, lib.nurbs_bezier_extraction, spline._handle, axis, spans, operators.ctypes.data,
        firsts.ctypes.data, domains.ctypes.data)
    return operators, firsts, domains


def eval_adjoint(spline, params, cotangents, order=None, flags=0, points=None, weights=None, param_gradients=None):
    """Gradients with respect to control points (counts..., dim), weights (counts...) and parameters, of the shape of
    params. Cotangents have the shape of eval(params), or with an order that of eval_derivs(params, order). Arrays given
    for the gradients are filled, with NURBS_ACCUMULATE added to."""
    given, shape = spline._params(params)
    dim, axes = spline.dimension, spline.axes
    slots = derivative_slots(axes, order or 0)
    wanted = shape + ((dim,) if order is None else (slots, dim))
    if numpy.shape(cotangents) != wanted:
        raise ValueError(f"cotangents must have shape {wanted}")
    g = records(cotangents, slots * dim)
    add = bool(flags & NURBS_ACCUMULATE)
    outputs = [_Gradient(points, spline.counts + (dim,), dim, add), _Gradient(weights, spline.counts, 1, add),
               _Gradient(param_gradients, numpy.shape(params), axes, add)]
    layouts = [output.layout for output in outputs]
    check(lib.nurbs_eval_adjoint(spline._handle, order or 0, given.n, *given.layout, *g.layout, *layouts[0],
                                 *layouts[1][:2], *layouts[2], flags))
    return Gradients(*(output.finish() for output in outputs))


class _Gradient(Output):
    """An output that may be added to."""

    def __init__(self, out, shape, width, add):
        super().__init__(out, shape, width)
        if add:
            if out is None:
                self.result[...] = 0
            elif self._copy is not None:
                self._copy[...] = out
