# SPDX-License-Identifier: MIT
"""Lengths, areas and moments."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional, Tuple

import numpy

from ._arrays import Output, address, addresses, records
from ._base import SplineBase, handles
from ._calls import watched
from ._errors import NurbsError
from ._library import call, get, lib
from .constants import NURBS_CLAMP, NURBS_EQUAL_CHORDS, NURBS_ERROR_LENGTH, NURBS_ERROR_NOT_REPRESENTABLE

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats
    from ._calls import Progress

__all__ = ["Measured", "Division", "Moments", "EnclosedArea", "EnclosedVolume", "Quadrature", "enclosed_area",
           "enclosed_volume"]


class Measured(NamedTuple):
    """An integral, and an estimate of its error."""

    value: float
    error: float


class Division(NamedTuple):
    """Parameters (parts + 1,), and the length or chord of a part."""

    params: Floats
    size: float


class Moments(NamedTuple):
    """Length, area or volume, centroid (dimension,), inertia (dimension, dimension) about it, and an estimate of the
    error of the content. Where the content is 0 there is no centroid: it and the inertia are NaN, as is what overflows;
    the same holds for what curves and surfaces enclose."""

    content: float
    centroid: Floats
    inertia: Floats
    error: float


class EnclosedArea(NamedTuple):
    """Area, centroid (2,), inertia (2, 2) about it, and an estimate of the error of the area."""

    area: float
    centroid: Floats
    inertia: Floats
    error: float


class EnclosedVolume(NamedTuple):
    """Volume, centroid (3,), inertia (3, 3) about it, the length of the vector area, which is 0 of a closed shell, and
    an estimate of the error of the volume."""

    volume: float
    centroid: Floats
    inertia: Floats
    openness: float
    error: float


class Quadrature(NamedTuple):
    """Parameters (n, axes), of a curve (n,), span by span, their weights (n,), and the weights (n,) of lengths, areas or
    volumes."""

    params: Floats
    weights: Floats
    measures: Floats


def moments_of(dim: int, function: Any, before: Tuple[Any, ...], after: Tuple[Any, ...]) -> Tuple[Floats, Floats]:
    """Centroid (dim,) and inertia (dim, dim), NaN where they do not exist, from a function to which their addresses are
    passed between other arguments. It refuses what it cannot give if that is asked for: then it is asked for less."""
    centroid, inertia = numpy.full(dim, numpy.nan), numpy.full((dim, dim), numpy.nan)
    try:
        call(function, *before, centroid.ctypes.data, inertia.ctypes.data, *after)
        return centroid, inertia
    except NurbsError as error:
        if error.status not in (NURBS_ERROR_LENGTH, NURBS_ERROR_NOT_REPRESENTABLE):
            raise
        first = error.status
    if first == NURBS_ERROR_NOT_REPRESENTABLE:
        try:
            call(function, *before, centroid.ctypes.data, None, *after)
            return centroid, inertia
        except NurbsError:
            pass  # the last call says what is wrong
    call(function, *before, None, None, *after)
    return centroid, inertia


class Measures(SplineBase):
    """Integrals to a relative tolerance (0: the library's smallest), with an estimate of the error. A `range` is a part
    (axes, 2) of the domain, of a curve (2,)."""

    def _measured(self, function: Any, relative_tolerance: float, part: Optional[ArrayLike]) -> Measured:
        limits, value, error = self._part(part), ctypes.c_double(), ctypes.c_double()
        call(function, self._handle, address(limits), relative_tolerance, ctypes.byref(value), ctypes.byref(error))
        return Measured(value.value, error.value)

    def length(self, relative_tolerance: float = 0.0, *, range: Optional[ArrayLike] = None, progress: Progress = None,
               work: Optional[int] = None) -> Measured:
        """Length of a curve, or of a part of it."""
        return self._measured(watched(lib.nurbs_curve_length, progress, work), relative_tolerance, range)

    def area(self, relative_tolerance: float = 0.0, *, range: Optional[ArrayLike] = None, progress: Progress = None,
             work: Optional[int] = None) -> Measured:
        """Area of a surface, or of a part of it."""
        return self._measured(watched(lib.nurbs_surface_area, progress, work), relative_tolerance, range)

    def lengths(self, params: ArrayLike, relative_tolerance: float = 0.0, *, out: Optional[Floats] = None,
                progress: Progress = None, work: Optional[int] = None) -> Floats:
        """Lengths of a curve from the start of its domain to parameters S, of their shape."""
        given = records(params, 1)
        output = Output(out, given.shape, 1)
        call(watched(lib.nurbs_curve_lengths, progress, work), self._handle, given.n, *given.layout[:2],
             relative_tolerance, *output.layout[:2])
        return output.finish()

    def params_at_lengths(self, lengths: ArrayLike, relative_tolerance: float = 0.0, *, clamp: bool = False,
                          out: Optional[Floats] = None, progress: Progress = None,
                          work: Optional[int] = None) -> Floats:
        """Parameters of a curve at lengths S from the start of its domain, of their shape; with clamp lengths outside
        give the nearer end, otherwise they raise ArgumentError."""
        given = records(lengths, 1)
        output = Output(out, given.shape, 1)
        call(watched(lib.nurbs_curve_params_at_lengths, progress, work), self._handle, given.n, *given.layout[:2],
             relative_tolerance, *output.layout[:2], NURBS_CLAMP if clamp else 0)
        return output.finish()

    def divide(self, parts: int, relative_tolerance: float = 0.0, *, equal_chords: bool = False,
               range: Optional[ArrayLike] = None, progress: Progress = None, work: Optional[int] = None) -> Division:
        """A curve in parts of equal length, or with points at equal distances."""
        limits, params, size = self._part(range), numpy.empty(max(parts, 0) + 1), ctypes.c_double()
        call(watched(lib.nurbs_curve_divide, progress, work), self._handle, address(limits), parts,
             relative_tolerance, NURBS_EQUAL_CHORDS if equal_chords else 0, params.ctypes.data, ctypes.byref(size))
        return Division(params, size.value)

    def moments(self, relative_tolerance: float = 0.0, *, progress: Progress = None,
                work: Optional[int] = None) -> Moments:
        """Content, centroid and inertia of the spline itself: a wire, a sheet or a body."""
        content, error = ctypes.c_double(), ctypes.c_double()
        centroid, inertia = moments_of(self.dimension, watched(lib.nurbs_moments, progress, work),
                                     (self._handle, relative_tolerance, ctypes.byref(content)), (ctypes.byref(error),))
        return Moments(content.value, centroid, inertia, error.value)

    def quadrature(self, nodes: int = 0) -> Quadrature:
        """Points and weights for integrals of any function: rules of Gauss on each span, of so many nodes along each axis, 0
        for one more than its degree. The sum of measures * f(points) is that over the shape."""
        n = get(ctypes.c_int64, lib.nurbs_quadrature, self._handle, nodes, 0, None, None, None)
        found = Quadrature(numpy.empty((n, self.axes) if self.axes > 1 else n), numpy.empty(n), numpy.empty(n))
        get(ctypes.c_int64, lib.nurbs_quadrature, self._handle, nodes, n, *addresses(*found))
        return found


def enclosed_area(curves: Iterable[SplineBase], tolerance: float = 0.0, relative_tolerance: float = 0.0, *,
                  progress: Progress = None, work: Optional[int] = None) -> EnclosedArea:
    """What closed chains of curves in the plane enclose, counterclockwise ones counting positive; ends meet to within
    the tolerance. Raises ArgumentError if a chain does not close."""
    given, area, error = handles(curves), ctypes.c_double(), ctypes.c_double()
    centroid, inertia = moments_of(2, watched(lib.nurbs_enclosed_area, progress, work),
                                 (len(given), given, tolerance, relative_tolerance, ctypes.byref(area)),
                                 (ctypes.byref(error),))
    return EnclosedArea(area.value, centroid, inertia, error.value)


def enclosed_volume(surfaces: Iterable[SplineBase], relative_tolerance: float = 0.0, *, progress: Progress = None,
                    work: Optional[int] = None) -> EnclosedVolume:
    """What surfaces enclose whose normals point outwards: 1/3 of the integral of S . (S_u x S_v)."""
    given, (volume, openness, error) = handles(surfaces), (ctypes.c_double(), ctypes.c_double(), ctypes.c_double())
    centroid, inertia = moments_of(3, watched(lib.nurbs_enclosed_volume, progress, work),
                                 (len(given), given, relative_tolerance, ctypes.byref(volume)),
                                 (ctypes.byref(openness), ctypes.byref(error)))
    return EnclosedVolume(volume.value, centroid, inertia, openness.value, error.value)
