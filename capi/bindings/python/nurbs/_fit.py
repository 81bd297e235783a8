# SPDX-License-Identifier: MIT
"""Parameters of data, and splines through them."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from ._arrays import if_given, packed, vector
from ._base import SplineBase
from ._library import call, lib
from ._net import concatenated, Net
from .constants import NURBS_PARAMS_CENTRIPETAL, NURBS_PERIODIC, on_axis

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s
    from ._spline import Spline

    #: One for all axes, or one for each.
    Whether = Union[bool, Sequence[bool]]

__all__ = ["Interpolated", "parametrize"]


class Interpolated(NamedTuple):
    """The spline, and the largest distance of a point from it at its parameter."""

    spline: Spline
    residual: float


def _flags(periodic: Whether, axes: int) -> int:
    each = numpy.broadcast_to(numpy.asarray(periodic, dtype=bool), (axes,))
    return sum(on_axis(axis, NURBS_PERIODIC) for axis in range(axes) if each[axis])


def _ends(ends: Optional[ArrayLike], axes: int) -> Optional[Int32s]:
    """One constant for all ends, one each for the start and the end of all axes, or one each for those of each axis."""
    if ends is None:
        return None
    return numpy.ascontiguousarray(numpy.broadcast_to(numpy.asarray(ends, dtype=numpy.int32), (axes, 2)))


def parametrize(points: ArrayLike, rule: int = NURBS_PARAMS_CENTRIPETAL, exponent: float = 1.0,
                periodic: Whether = False) -> List[Floats]:
    """Parameters of points (counts..., dimension) from the distances between them, a vector from 0 to 1 for each axis.
    `rule` is a NURBS_PARAMS_ constant, `exponent` for NURBS_PARAMS_POWER. Along a periodic axis the last point is the
    first one again."""
    net = packed(points)
    if net.ndim < 2:
        raise ValueError(f"points of shape {net.shape}, expected (counts..., dimension)")
    counts = vector(net.shape[:-1], numpy.int64)
    found = numpy.empty(int(counts.sum()))
    call(lib.nurbs_parametrize, counts.size, counts.ctypes.data, net.shape[-1], net.ctypes.data, 0, 0, rule, exponent,
         _flags(periodic, counts.size), found.ctypes.data)
    return numpy.split(found, numpy.cumsum(counts)[:-1])


class Fitting(SplineBase):
    """Splines through data."""

    @staticmethod
    def _data(degrees: Union[int, Sequence[int]], params: Union[ArrayLike, Sequence[ArrayLike]],
              points: ArrayLike) -> Tuple[Net, Floats]:
        net = Net(degrees, points, None)
        joined, lengths = concatenated(params, net.axes)
        if lengths != list(net.counts):
            raise ValueError(f"{lengths} params for points {tuple(net.counts)}")
        return net, joined

    @classmethod
    def interpolate(cls, degrees: Union[int, Sequence[int]], params: Union[ArrayLike, Sequence[ArrayLike]],
                    points: ArrayLike, ends: Optional[ArrayLike] = None, periodic: Whether = False) -> Interpolated:
        """The spline through points (counts..., dimension) on a grid of parameters, a vector or one for each axis.
        `ends` are NURBS_ENDS_ constants: one, one for the start and the end (2,), or (axes, 2); by default
        NURBS_ENDS_NOT_A_KNOT. Along a periodic axis the last point is the first one again.

            params, = nurbs.parametrize(points)
            curve, residual = nurbs.Spline.interpolate(3, params, points)
        """
        net, joined = cls._data(degrees, params, points)
        at_ends = _ends(ends, net.axes)
        residual = ctypes.c_double()
        made = cls._made(lib.nurbs_interpolate, *net.sizes, joined.ctypes.data, net.width, *net.points.layout,
                         None if at_ends is None else at_ends.ctypes.data, _flags(periodic, net.axes),
                         ctypes.byref(residual))
        return Interpolated(made, residual.value)

    @classmethod
    def interpolate_over_knots(cls, degrees: Union[int, Sequence[int]], params: Union[ArrayLike, Sequence[ArrayLike]],
                               knots: Union[ArrayLike, Sequence[ArrayLike]], points: ArrayLike,
                               periodic: Whether = False) -> Spline:
        """The same over given full knot vectors; along a periodic axis no point is repeated."""
        net, joined = cls._data(degrees, params, points)
        vectors, _ = concatenated(knots, net.axes)
        return cls._made(lib.nurbs_interpolate_over_knots, *net.sizes, joined.ctypes.data, vectors.ctypes.data,
                         vectors.size, net.width, *net.points.layout, _flags(periodic, net.axes))

    @classmethod
    def interpolate_curve(cls, degree: int, params: ArrayLike, targets: ArrayLike, orders: Optional[ArrayLike] = None,
                          knots: Optional[ArrayLike] = None, periodic: bool = False) -> Spline:
        """The curve with derivatives `targets` (n, dimension) of `orders` (n,), by default 0, at parameters (n,) that do
        not decrease; over full knots, by default averaged ones."""
        at, values = vector(params), packed(targets)
        if values.ndim != 2 or len(values) != at.size:
            raise ValueError(f"targets of shape {values.shape} for {at.size} parameters")
        order = if_given(orders, at.size, "orders", numpy.int32)
        given = None if knots is None else vector(knots)
        return cls._made(lib.nurbs_curve_interpolate, degree, at.size, at.ctypes.data,
                         None if order is None else order.ctypes.data, values.shape[1], values.ctypes.data, 0, 0,
                         None if given is None else given.ctypes.data, 0 if given is None else given.size,
                         _flags(periodic, 1))
