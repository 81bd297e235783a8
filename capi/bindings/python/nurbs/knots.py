# SPDX-License-Identifier: MIT
"""Knot vectors, span search and basis functions: what needs knots but no spline."""

import numpy

from ._arrays import Output, records, vector
from ._library import check, lib


def _generated(degree, count, function, *arguments):
    knots = numpy.empty(max(count + degree + 1, 0))
    check(function(degree, *arguments, knots.size, knots.ctypes.data))
    return knots


def knots_uniform(degree, count, a=0.0, b=1.0):
    """Uniform unclamped knots with the domain [a, b]."""
    return _generated(degree, count, lib.nurbs_knots_uniform, count, a, b)


def knots_open_uniform(degree, count, a=0.0, b=1.0):
    """Clamped knots, evenly spaced between a and b."""
    return _generated(degree, count, lib.nurbs_knots_open_uniform, count, a, b)


def knots_bezier(degree, breaks):
    """Piecewise Bezier knots: `breaks` is the number of pieces in [0, 1], or an array of breaks."""
    given = None if numpy.ndim(breaks) == 0 else vector(breaks)
    pieces = int(breaks) if given is None else given.size - 1
    count = pieces * max(degree, 0) + 1 if degree else pieces
    return _generated(degree, count, lib.nurbs_knots_bezier, pieces, None if given is None else given.ctypes.data)


def knots_averaged(degree, params):
    """Clamped knots averaged from parameters, for interpolation."""
    params = vector(params)
    return _generated(degree, params.size, lib.nurbs_knots_averaged, params.size, params.ctypes.data)


def knots_periodic(degree, breaks, multiplicities=None):
    """Periodic knots from the breaks of one period."""
    breaks = vector(breaks)
    given = numpy.ones(breaks.size, numpy.int32) if multiplicities is None else vector(multiplicities, numpy.int32)
    if given.size != breaks.size:
        raise ValueError(f"{given.size} multiplicities for {breaks.size} breaks")
    count = int(given[:-1].sum(dtype=numpy.int64)) + degree
    return _generated(degree, count, lib.nurbs_knots_periodic, breaks.size, breaks.ctypes.data, given.ctypes.data)


def _knot_arguments(degree, knots):
    return degree, knots.size - degree - 1, knots.ctypes.data, knots.size


def find_spans(degree, knots, params, flags=0):
    """The span of each parameter in a full knot vector."""
    knots, given = vector(knots), records(params, 1)
    spans = numpy.empty(numpy.shape(params), numpy.int64)
    check(lib.nurbs_find_spans(*_knot_arguments(degree, knots), given.n, given.address, given.stride,
                               spans.ctypes.data, flags))
    return spans


def bernstein(degree, params, order=0, out=None):
    """Bernstein polynomials and derivatives at params of shape S: an array S + (order + 1, degree + 1)."""
    given = records(params, 1)
    output = _basis_output(degree, order, params, out)
    check(lib.nurbs_bernstein(degree, order, given.n, given.address, given.stride, *output.layout))
    return output.finish()


def basis(degree, knots, params, order=0, flags=0, out=None):
    """Spans of shape S, and the B-spline basis functions that do not vanish with their derivatives, of shape
    S + (order + 1, degree + 1), at params of shape S."""
    knots, given = vector(knots), records(params, 1)
    output = _basis_output(degree, order, params, out)
    spans = numpy.empty(numpy.shape(params), numpy.int64)
    check(lib.nurbs_basis(*_knot_arguments(degree, knots), order, given.n, given.address, given.stride,
                          spans.ctypes.data, *output.layout, flags))
    return spans, output.finish()


def _basis_output(degree, order, params, out):
    rows, columns = max(order + 1, 0), max(degree + 1, 0)
    return Output(out, numpy.shape(params) + (rows, columns), rows * columns)
