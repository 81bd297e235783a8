# SPDX-License-Identifier: MIT
"""Knot vectors, span search and basis functions: what needs knots but no spline."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple, Union, cast

import numpy

from ._arrays import Output, if_given, records, vector
from ._library import call, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int64s, Records

__all__ = ["BasisFunctions", "knots_uniform", "knots_open_uniform", "knots_bezier", "knots_averaged", "knots_periodic",
           "find_spans", "bernstein", "basis"]


class BasisFunctions(NamedTuple):
    """Spans S, and derivative k of the function N_(span - degree + j) in values[..., k, j]: S + (order + 1,
    degree + 1)."""

    spans: Int64s
    values: Floats


def _generated(degree: int, count: int, function: Any, *arguments: Any) -> Floats:
    knots = numpy.empty(max(count + degree + 1, 0))
    call(function, degree, *arguments, knots.size, knots.ctypes.data)
    return knots


def knots_uniform(degree: int, count: int, a: float = 0.0, b: float = 1.0) -> Floats:
    """Uniform unclamped knots (count + degree + 1,) with the domain [a, b]; they suit periodic axes."""
    return _generated(degree, count, lib.nurbs_knots_uniform, count, a, b)


def knots_open_uniform(degree: int, count: int, a: float = 0.0, b: float = 1.0) -> Floats:
    """Clamped knots (count + degree + 1,), evenly spaced between a and b."""
    return _generated(degree, count, lib.nurbs_knots_open_uniform, count, a, b)


def knots_bezier(degree: int, breaks: Union[int, ArrayLike]) -> Floats:
    """Piecewise Bezier knots: `breaks` is the number of pieces in [0, 1], or an array of breaks (pieces + 1,)."""
    given = None if numpy.ndim(breaks) == 0 else vector(breaks)
    pieces = operator.index(cast(int, breaks)) if given is None else given.size - 1
    count = pieces * max(degree, 0) + 1 if degree else pieces
    return _generated(degree, count, lib.nurbs_knots_bezier, pieces, None if given is None else given.ctypes.data)


def knots_averaged(degree: int, params: ArrayLike) -> Floats:
    """Clamped knots averaged from parameters (n,), for interpolation: t_(j+p) = (s_j + ... + s_(j+p-1)) / p."""
    given = vector(params)
    return _generated(degree, given.size, lib.nurbs_knots_averaged, given.size, given.ctypes.data)


def knots_periodic(degree: int, breaks: ArrayLike, multiplicities: Optional[ArrayLike] = None) -> Floats:
    """Periodic knots from the breaks (n,) of one period, with their multiplicities (n,), by default 1."""
    given = vector(breaks)
    times = if_given(multiplicities, given.size, "multiplicities", numpy.int32)
    times = numpy.ones(given.size, numpy.int32) if times is None else times
    count = int(times[:-1].sum(dtype=numpy.int64)) + degree
    return _generated(degree, count, lib.nurbs_knots_periodic, given.size, given.ctypes.data, times.ctypes.data)


def _knot_arguments(degree: int, knots: NDArray[Any]) -> Tuple[int, int, int, int]:
    return degree, knots.size - degree - 1, knots.ctypes.data, knots.size


def find_spans(degree: int, knots: ArrayLike, params: ArrayLike, flags: int = 0) -> Int64s:
    """The span of each parameter S in a full knot vector: s with knots[s] <= t < knots[s + 1]."""
    vectors, given = vector(knots), records(params, 1)
    spans = numpy.empty(given.shape, numpy.int64)
    call(lib.nurbs_find_spans, *_knot_arguments(degree, vectors), given.n, *given.layout[:2],
         spans.ctypes.data, flags)
    return spans


def bernstein(degree: int, params: ArrayLike, order: int = 0, out: Optional[Floats] = None) -> Floats:
    """Bernstein polynomials binomial(p, j) t^j (1 - t)^(p - j) and their derivatives at params S: an array
    S + (order + 1, degree + 1)."""
    given = records(params, 1)
    output = _basis_output(degree, order, given, out)
    call(lib.nurbs_bernstein, degree, order, given.n, *given.layout[:2], *output.layout)
    return output.finish()


def basis(degree: int, knots: ArrayLike, params: ArrayLike, order: int = 0, flags: int = 0,
          out: Optional[Floats] = None) -> BasisFunctions:
    """The B-spline basis functions that do not vanish at params S, and their derivatives; `out` is filled with the
    values if it is given."""
    vectors, given = vector(knots), records(params, 1)
    output, spans = _basis_output(degree, order, given, out), numpy.empty(given.shape, numpy.int64)
    call(lib.nurbs_basis, *_knot_arguments(degree, vectors), order, given.n, *given.layout[:2],
         spans.ctypes.data, *output.layout, flags)
    return BasisFunctions(spans, output.finish())


def _basis_output(degree: int, order: int, params: Records, out: Optional[Floats]) -> Output:
    rows, columns = max(order + 1, 0), max(degree + 1, 0)
    return Output(out, (*params.shape, rows, columns), rows * columns)
