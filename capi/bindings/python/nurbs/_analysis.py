# SPDX-License-Identifier: MIT
"""Features of curves and surfaces, and the shapes that they are; `complete` tells that nothing was missed."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, NamedTuple, Optional

import numpy

from ._arrays import address, addresses, if_given
from ._base import SplineBase
from ._calls import listed, watched
from ._library import call, get, lib
from .constants import (NURBS_EXTREMUM_MAXIMUM, NURBS_EXTREMUM_MINIMUM, NURBS_EXTREMUM_PLATEAU, NURBS_EXTREMUM_SADDLE,
                        NURBS_EXTREMUM_UNDECIDED, NURBS_FEATURE_CURVATURE_MAXIMUM, NURBS_FEATURE_CURVATURE_MINIMUM,
                        NURBS_FEATURE_CUSP, NURBS_FEATURE_INFLECTION, NURBS_FEATURE_JUMP, NURBS_FEATURE_KINK,
                        NURBS_FEATURE_TORSION)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Booleans, Floats, Int32s
    from ._calls import Progress

__all__ = ["CurveFeatures", "MonotonePieces", "Straightness", "Planarity", "BoundaryContacts", "SingularPoints",
           "Extrema", "Fold", "FoldPieces", "Recognized", "ShapeFactor"]


class CurveFeatures(NamedTuple):
    """Parameters (n,) in rising order, a NURBS_FEATURE_ constant each, the curvature, turning angle or width there, and
    whether nothing was missed."""

    params: Floats
    found: Int32s
    values: Floats
    complete: bool


class MonotonePieces(NamedTuple):
    """Lower ends (n,) of pieces, 1, -1 or 0 where the curve rises, falls or stays, and whether nothing was missed."""

    starts: Floats
    signs: Int32s
    complete: bool


class Straightness(NamedTuple):
    """A line, and a proven bound of the distance from it."""

    origin: Floats
    direction: Floats
    bound: float


class Planarity(NamedTuple):
    """A plane, and a proven bound of the distance from it."""

    origin: Floats
    normal: Floats
    bound: float


class BoundaryContacts(NamedTuple):
    """Of each axis (axes,) whether it closes and a bound of the gap; of each boundary (axes, 2) whether it collapses,
    and its size."""

    closed: Booleans
    gaps: Floats
    collapsed: Booleans
    sizes: Floats


class SingularPoints(NamedTuple):
    """Parameters (n, axes), the boxes (n, axes, 2) in which the singular sets lie, and whether nothing was missed."""

    params: Floats
    boxes: Floats
    complete: bool


class Extrema(NamedTuple):
    """Parameters (n, axes) in rising order, the values there, a sum of NURBS_EXTREMUM_ constants each, the boxes
    (n, axes, 2) outside of which there is nothing, and whether nothing is undecided."""

    params: Floats
    values: Floats
    found: Int32s
    boxes: Floats
    complete: bool


class Fold(NamedTuple):
    """A NURBS_FOLD_ constant, and parameters (axes,) of either sign, NaN if none are known."""

    result: int
    positive: Floats
    negative: Floats


class FoldPieces(NamedTuple):
    """A NURBS_FOLD_ constant (n,) for each polynomial piece, and 1 or -1, the sign of its Jacobian, if there is no fold."""

    folds: Int32s
    signs: Int32s


class Recognized(NamedTuple):
    """A NURBS_SHAPE_ constant, origin, axis and x (3,), sizes (3,), and a proven bound of the distance from the
    shape."""

    shape: int
    origin: Floats
    axis: Floats
    x: Floats
    sizes: Floats
    deviation: float


class ShapeFactor(NamedTuple):
    """C_sf = w_1^2 / (w_0 w_2), and a NURBS_CONIC_ constant."""

    factor: float
    type: int


_PLANE = (NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM | NURBS_FEATURE_CURVATURE_MINIMUM
          | NURBS_FEATURE_CUSP | NURBS_FEATURE_KINK | NURBS_FEATURE_JUMP)
_EXTREMA = (NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM | NURBS_EXTREMUM_SADDLE | NURBS_EXTREMUM_PLATEAU
            | NURBS_EXTREMUM_UNDECIDED)


class Analysis(SplineBase):
    """Questions about the shape."""

    def features(self, kinds: Optional[int] = None, *, progress: Progress = None,
                 work: Optional[int] = None) -> CurveFeatures:
        """Inflections, extrema of curvature, cusps, kinks, jumps and, in space, changes of torsion along a curve; of
        all kinds unless a sum of NURBS_FEATURE_ constants is given."""
        if kinds is None:
            kinds = _PLANE | NURBS_FEATURE_TORSION if self.dimension == 3 else _PLANE
        return listed(CurveFeatures, lambda n: (numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty(n)),
                       watched(lib.nurbs_curve_features, progress, work, 2), self._handle, kinds)

    def extrema(self, kinds: int = _EXTREMA, *, progress: Progress = None, work: Optional[int] = None) -> Extrema:
        """Local minima and maxima, saddles and plateaus of a spline of dimension 1, and what is undecided; of all kinds
        unless a sum of NURBS_EXTREMUM_ constants is given."""
        axes = self.axes
        return listed(Extrema, lambda n: (numpy.empty((n, axes)), numpy.empty(n), numpy.empty(n, numpy.int32),
                                          numpy.empty((n, axes, 2))),
                      watched(lib.nurbs_extrema, progress, work, 2), self._handle, kinds)

    def monotone_pieces(self, direction: ArrayLike) -> MonotonePieces:
        """The pieces of a curve on which direction . C(t) rises, falls or stays; direction (dimension,)."""
        along = self._coordinates(direction, "a direction")
        return listed(MonotonePieces, lambda n: (numpy.empty(n), numpy.empty(n, numpy.int32)),
                       lib.nurbs_curve_monotone_pieces, self._handle, along.ctypes.data)

    def convexity(self) -> int:
        """A NURBS_CONVEXITY_ constant of a curve in the plane."""
        return int(get(ctypes.c_int32, lib.nurbs_curve_convexity, self._handle))

    def straightness(self) -> Straightness:
        """How far the spline is from a straight line near the best one."""
        origin, direction = numpy.empty(self.dimension), numpy.empty(self.dimension)
        bound = get(ctypes.c_double, lib.nurbs_straightness, self._handle, origin.ctypes.data, direction.ctypes.data)
        return Straightness(origin, direction, bound)

    def planarity(self) -> Planarity:
        """How far a spline in space is from a plane near the best one."""
        origin, normal = numpy.empty(3), numpy.empty(3)
        bound = get(ctypes.c_double, lib.nurbs_planarity, self._handle, origin.ctypes.data, normal.ctypes.data)
        return Planarity(origin, normal, bound)

    def boundary_contacts(self, tolerance: float = 0.0) -> BoundaryContacts:
        """Which axes close, and which boundaries collapse, to a tolerance."""
        axes = self.axes
        closed, collapsed = numpy.empty(axes, numpy.int32), numpy.empty((axes, 2), numpy.int32)
        gaps, sizes = numpy.empty(axes), numpy.empty((axes, 2))
        call(lib.nurbs_boundary_contacts, self._handle, tolerance, closed.ctypes.data, gaps.ctypes.data,
             collapsed.ctypes.data, sizes.ctypes.data)
        return BoundaryContacts(closed != 0, gaps, collapsed != 0, sizes)

    def singular_points(self, tolerance: float) -> SingularPoints:
        """Places where C' = 0, or S_u x S_v = 0; the tolerance is a part of the domain's length."""
        axes = self.axes
        return listed(SingularPoints, lambda n: (numpy.empty((n, axes)), numpy.empty((n, axes, 2))),
                       lib.nurbs_singular_points, self._handle, tolerance)

    def fold_test(self, reference: Optional[ArrayLike] = None, *, progress: Progress = None,
                  work: Optional[int] = None) -> Fold:
        """Whether a surface in the plane or a volume folds over, or a surface in space seen along `reference` (3,):
        whether the Jacobian changes its sign."""
        given = if_given(reference, 3, "a reference")
        positive, negative, result = numpy.empty(self.axes), numpy.empty(self.axes), ctypes.c_int32()
        call(watched(lib.nurbs_fold_test, progress, work), self._handle, address(given), ctypes.byref(result),
             positive.ctypes.data, negative.ctypes.data)
        return Fold(result.value, positive, negative)

    def fold_pieces(self, reference: Optional[ArrayLike] = None, *, progress: Progress = None,
                    work: Optional[int] = None) -> FoldPieces:
        """Whether each polynomial piece by itself folds over, as by fold_test(), in the order of bezier_pieces()."""
        given = if_given(reference, 3, "a reference")
        n = get(ctypes.c_int64, lib.nurbs_fold_pieces, self._handle, address(given), 0, None, None)
        found = FoldPieces(numpy.empty(n, numpy.int32), numpy.empty(n, numpy.int32))
        call(watched(lib.nurbs_fold_pieces, progress, work), self._handle, address(given), n, *addresses(*found), None)
        return found

    def recognize(self, tolerance: float, *, progress: Progress = None, work: Optional[int] = None) -> Recognized:
        """The first shape of the list of nurbs_recognize() (point, line, circle, plane, sphere, ...) from which no
        point is farther than the tolerance."""
        shape, deviation = ctypes.c_int32(), ctypes.c_double()
        placement, sizes = numpy.empty((3, 3)), numpy.empty(3)
        call(watched(lib.nurbs_recognize, progress, work), self._handle, tolerance, ctypes.byref(shape),
             placement.ctypes.data, sizes.ctypes.data, ctypes.byref(deviation))
        origin, axis, x = placement
        return Recognized(shape.value, origin, axis, x, sizes, deviation.value)

    def shape_factor(self) -> ShapeFactor:
        """Shape factor and kind of a conic segment: a curve of degree 2 with one piece."""
        factor, kind = ctypes.c_double(), ctypes.c_int32()
        call(lib.nurbs_curve_shape_factor, self._handle, ctypes.byref(factor), ctypes.byref(kind))
        return ShapeFactor(factor.value, kind.value)
