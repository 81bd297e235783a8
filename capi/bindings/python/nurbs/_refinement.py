# SPDX-License-Identifier: MIT
"""Knots that go in, and parts that come out, without a change of shape."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, NamedTuple, Tuple

import numpy

from ._arrays import addresses, exactly, vector
from ._base import SplineBase
from ._library import get, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int64s
    from ._files import SplineList
    from ._spline import Spline

__all__ = ["BezierPieces", "Extraction"]


class BezierPieces(NamedTuple):
    """Control points (pieces..., degree + 1..., dimension), weights (pieces..., degree + 1...) and domains (pieces...,
    axes, 2) of the polynomial pieces, with a number of pieces and a degree for each axis."""

    points: Floats
    weights: Floats
    domains: Floats


class Extraction(NamedTuple):
    """Bezier extraction operators (spans, degree + 1, degree + 1), the first control point of each span (spans,), and
    its domain (spans, 2)."""

    operators: Floats
    firsts: Int64s
    domains: Floats


class Refinement(SplineBase):
    """Insertion of knots, and division. The knots of an axis may come up to degree + 1 times."""

    def insert_knot(self, knot: float, times: int = 1, *, axis: int = 0) -> Spline:
        """The same shape with a knot inserted (Boehm 1980). Raises DomainError outside the domain."""
        return self._made(lib.nurbs_insert_knot, self._handle, axis, knot, times)

    def refine(self, knots: ArrayLike, *, axis: int = 0) -> Spline:
        """The same shape with a list of knots (n,) inserted at once, in any order."""
        values = vector(knots)
        return self._made(lib.nurbs_refine, self._handle, axis, values.size, values.ctypes.data)

    def refine_uniform(self, parts: int, *, axis: int = 0) -> Spline:
        """The same shape with every span of the domain divided into equal parts."""
        return self._made(lib.nurbs_refine_uniform, self._handle, axis, parts)

    def split(self, param: float, *, axis: int = 0) -> Tuple[Spline, Spline]:
        """The parts below and above a parameter, which they keep."""
        lower = ctypes.c_void_p()
        upper = self._made(lib.nurbs_split, self._handle, axis, param, ctypes.byref(lower))
        return self._owner(lower.value), upper

    def extract(self, lower: ArrayLike, upper: ArrayLike) -> Spline:
        """The part over a box in the domain: a number or one for each axis. It keeps its parameters."""
        low, high = exactly(lower, self.axes, "lower"), exactly(upper, self.axes, "upper")
        return self._made(lib.nurbs_extract, self._handle, low.ctypes.data, high.ctypes.data)

    def decompose(self) -> SplineList:
        """The polynomial pieces as Bezier splines over their own domains, last axis fastest."""
        return self._listed(lib.nurbs_decompose, self._handle)

    def bezier_pieces(self) -> BezierPieces:
        """The pieces of decompose() as arrays, in one call."""
        pieces = numpy.empty(self.axes, numpy.int64)
        count = get(ctypes.c_int64, lib.nurbs_bezier_pieces, self._handle, 0, None, None, None, pieces.ctypes.data)
        widths = tuple(degree + 1 for degree in self.degrees)
        found = BezierPieces(numpy.empty((*pieces, *widths, self.dimension)), numpy.empty((*pieces, *widths)),
                             numpy.empty((*pieces, self.axes, 2)))
        get(ctypes.c_int64, lib.nurbs_bezier_pieces, self._handle, count, *addresses(*found), None)
        return found

    def split_at_knots(self, order: int, *, axis: int = 0) -> SplineList:
        """The parts between the knots at which the order of continuity, degree - multiplicity, is less than `order`: 0
        at jumps, 1 also at kinks."""
        return self._listed(lib.nurbs_split_at_knots, self._handle, axis, order)

    def boundaries(self) -> SplineList:
        """The four curves of a surface or the six faces of a volume, by axis, then by end: "0-", "0+", "1-", ..."""
        return self._listed(lib.nurbs_boundaries, self._handle)

    def bezier_extraction(self, *, axis: int = 0) -> Extraction:
        """On span e the basis functions are N_(f+j)(t) = sum_k operators[e, j, k] B_k(x), f = firsts[e], B_k the
        Bernstein polynomials and x in [0, 1] across domains[e]."""
        spans = get(ctypes.c_int64, lib.nurbs_bezier_extraction, self._handle, axis, 0, None, None, None)
        width = self.degrees[axis] + 1
        found = Extraction(numpy.empty((spans, width, width)), numpy.empty(spans, numpy.int64), numpy.empty((spans, 2)))
        get(ctypes.c_int64, lib.nurbs_bezier_extraction, self._handle, axis, spans, *addresses(*found))
        return found
