# SPDX-License-Identifier: MIT
"""Hermite data, the power basis of pieces, and the matrices between bases of a segment."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, List, NamedTuple, Sequence

import numpy

from ._arrays import addresses, packed, vector
from ._base import SplineBase
from ._library import call, get, lib
from .constants import NURBS_HOMOGENEOUS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats
    from ._spline import Spline

__all__ = ["Hermite", "PowerForm", "basis_matrix"]


class Hermite(NamedTuple):
    """Parameters (n,), points (n, dimension) and tangents (n, dimension), as Spline.hermite() takes them."""

    params: Floats
    points: Floats
    tangents: Floats


class PowerForm(NamedTuple):
    """Coefficients (pieces..., degree + 1..., width) and the breaks of each axis, as Spline.power() takes them; of a
    rational spline the width is dimension + 1."""

    coefficients: Floats
    breaks: List[Floats]


class Segments(SplineBase):
    """Piecewise cubics by points and tangents, and the power basis of pieces."""

    @classmethod
    def hermite(cls, params: ArrayLike, points: ArrayLike, tangents: ArrayLike) -> Spline:
        """The C^1 piecewise cubic curve through points (n, dimension) with derivatives (n, dimension) at parameters
        (n,)."""
        at = vector(params)
        nets = [packed(values) for values in (points, tangents)]
        if any(net.ndim != 2 or len(net) != at.size or net.shape != nets[0].shape for net in nets):
            raise ValueError(f"points {nets[0].shape} and tangents {nets[1].shape} for {at.size} parameters")
        return cls._made(lib.nurbs_create_hermite, at.size, at.ctypes.data, nets[0].shape[1], nets[0].ctypes.data, 0, 0,
                         nets[1].ctypes.data, 0, 0)

    def to_hermite(self) -> Hermite:
        """The points and derivatives of a C^1 piecewise cubic at its breaks."""
        n = get(ctypes.c_int64, lib.nurbs_to_hermite, self._handle, 0, None, None, None)
        found = Hermite(numpy.empty(n), numpy.empty((n, self.dimension)), numpy.empty((n, self.dimension)))
        get(ctypes.c_int64, lib.nurbs_to_hermite, self._handle, n, *addresses(*found))
        return found

    @classmethod
    def power(cls, coefficients: ArrayLike, breaks: Sequence[ArrayLike], homogeneous: bool = False) -> Spline:
        """The spline of pieces sum_k c_k (t - a)^k, a the start of the piece: coefficients (pieces..., degree + 1...,
        width) over the breaks of each axis, homogeneous or not."""
        values = packed(coefficients)
        parts = [vector(axis) for axis in breaks]
        axes = len(parts)
        pieces = numpy.array([axis.size - 1 for axis in parts], numpy.int64)
        if values.ndim != 2 * axes + 1 or values.shape[:axes] != tuple(pieces):
            raise ValueError(f"coefficients {values.shape} for {tuple(pieces)} pieces")
        degrees = numpy.array(values.shape[axes:-1], numpy.int32) - numpy.int32(1)
        joined = numpy.concatenate(parts) if parts else numpy.empty(0)
        return cls._made(lib.nurbs_create_power, axes, degrees.ctypes.data, pieces.ctypes.data, joined.ctypes.data,
                         joined.size, values.shape[-1] - bool(homogeneous), values.ctypes.data, 0, 0,
                         NURBS_HOMOGENEOUS if homogeneous else 0)

    def to_power(self) -> PowerForm:
        """The power basis of every piece, of homogeneous points if the spline is rational."""
        pieces = numpy.empty(self.axes, numpy.int64)
        count = get(ctypes.c_int64, lib.nurbs_to_power, self._handle, 0, None, None, pieces.ctypes.data)
        widths = tuple(degree + 1 for degree in self.degrees)
        coefficients = numpy.empty((*pieces, *widths, self.dimension + self.rational))
        breaks = numpy.empty(int(pieces.sum()) + self.axes)
        get(ctypes.c_int64, lib.nurbs_to_power, self._handle, count, coefficients.ctypes.data, breaks.ctypes.data, None)
        return PowerForm(coefficients, numpy.split(breaks, numpy.cumsum(pieces + 1)[:-1]))


def basis_matrix(from_basis: int, to_basis: int, degree: int) -> Floats:
    """The matrix (degree + 1, degree + 1) that takes the coefficients of a polynomial over [0, 1] in one basis, a
    NURBS_BASIS_ constant, to those in another."""
    matrix = numpy.empty((max(degree, 0) + 1,) * 2)
    call(lib.nurbs_basis_matrix, from_basis, to_basis, degree, matrix.size, matrix.ctypes.data)
    return matrix
