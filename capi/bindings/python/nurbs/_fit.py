# SPDX-License-Identifier: MIT
"""Parameters of data, and splines through them."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from ._arrays import if_given, packed, vector
from ._layers import Layers
from ._library import call, lib
from ._net import Net, concatenated
from ._spline import Spline
from .constants import NURBS_PARAMS_CENTRIPETAL, NURBS_TANGENTS_BESSEL, NURBS_WRAP

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s
    from ._layers import Derivatives

    #: A vector of a curve, or one for each axis.
    ByAxis = Union[ArrayLike, Sequence[ArrayLike]]

__all__ = ["Interpolated", "parametrize", "params_universal", "interpolate", "interpolate_over_knots",
           "interpolate_derivatives", "curve_interpolate", "tangent_lengths", "tangents"]


class Interpolated(NamedTuple):
    """The spline, and the largest distance of a point from it at its parameter."""

    spline: Spline
    residual: float


def parametrize(points: ArrayLike, rule: int = NURBS_PARAMS_CENTRIPETAL, exponent: float = 1.0,
                flags: int = 0) -> List[Floats]:
    """Parameters of points (counts..., dimension) from the distances between them: a vector from 0 to 1 for each axis.
    `rule` is a NURBS_PARAMS_ constant, `exponent` for NURBS_PARAMS_POWER; with NURBS_PERIODIC by axis the last point is
    the first one again."""
    net = packed(points)
    if net.ndim < 2:
        raise ValueError(f"points of shape {net.shape}, expected (counts..., dimension)")
    counts = vector(net.shape[:-1], numpy.int64)
    found = numpy.empty(int(counts.sum()))
    call(lib.nurbs_parametrize, counts.size, counts.ctypes.data, net.shape[-1], net.ctypes.data, 0, 0, rule, exponent,
         flags, found.ctypes.data)
    return numpy.split(found, numpy.cumsum(counts)[:-1])


def params_universal(degree: int, count: int) -> Floats:
    """Parameters (count,) where the basis functions over knots_open_uniform(degree, count) are largest, for
    interpolation over these knots: they do not depend on the points."""
    found = numpy.empty(max(count, 0))
    call(lib.nurbs_params_universal, degree, count, found.ctypes.data)
    return found


def _data(degrees: Union[int, Sequence[int], Int32s], params: ByAxis, points: ArrayLike) -> Tuple[Net, Floats]:
    net = Net(degrees, points, None)
    joined, lengths = concatenated(params, net.axes)
    if lengths != list(net.counts):
        raise ValueError(f"{lengths} params for points {tuple(net.counts)}")
    return net, joined


def _ends(ends: Optional[ArrayLike], axes: int) -> Optional[Int32s]:
    return None if ends is None else numpy.array(numpy.broadcast_to(numpy.asarray(ends, numpy.int32), (axes, 2)))


def interpolate(degrees: Union[int, Sequence[int]], params: ByAxis, points: ArrayLike, ends: Optional[ArrayLike] = None,
                flags: int = 0, derivatives: Optional[Derivatives] = None) -> Interpolated:
    """The spline through points (counts..., dimension) on a grid of parameters: a vector, or one for each axis.

        params, = nurbs.parametrize(points)
        curve, residual = nurbs.interpolate(3, params, points)

    `ends` are NURBS_ENDS_ constants: one, one each for the start and the end, or (axes, 2); by default
    NURBS_ENDS_NOT_A_KNOT. Along an axis that is NURBS_PERIODIC the last point is the first one again. `derivatives` are
    those at ends of axes: for (axis, NURBS_START or NURBS_END) an array (orders, counts of the other axes..., dimension)
    of derivatives of orders 1, 2, ... along the axis, in place of not-a-knot conditions; mixed ones are estimated, as
    interpolate_derivatives() does."""
    net, joined = _data(degrees, params, points)
    if derivatives:
        return _with_derivatives(net, joined, points, ends, flags, derivatives)
    at_ends = _ends(ends, net.axes)
    residual = ctypes.c_double()
    made = Spline._made(lib.nurbs_interpolate, *net.sizes, joined.ctypes.data, net.width, *net.points.layout,
                        None if at_ends is None else at_ends.ctypes.data, flags, ctypes.byref(residual))
    return Interpolated(made, residual.value)


def _with_derivatives(net: Net, joined: Floats, points: ArrayLike, ends: Optional[ArrayLike], flags: int,
                      derivatives: Derivatives) -> Interpolated:
    own = numpy.split(joined, numpy.cumsum(net.counts)[:-1])
    given = numpy.asarray(points, numpy.float64)
    layers = Layers(own, given, derivatives)
    made = interpolate_derivatives(net.degrees, layers.params, layers.orders, layers.values, ends, flags)
    # Data of a periodic axis may lie beyond its domain; wrapping changes nothing on the others.
    missed = numpy.abs(made.eval_grid(*own, flags=NURBS_WRAP if flags else 0) - given)
    unit = missed.max() or 1.0
    return Interpolated(made, float(unit * numpy.linalg.norm(missed / unit, axis=-1).max()))


def interpolate_over_knots(degrees: Union[int, Sequence[int]], params: ByAxis, knots: ByAxis, points: ArrayLike,
                           flags: int = 0) -> Spline:
    """The spline over given full knot vectors through points (counts..., dimension) on a grid of parameters; along an
    axis that is NURBS_PERIODIC no point is repeated."""
    net, joined = _data(degrees, params, points)
    vectors, _ = concatenated(knots, net.axes)
    return Spline._made(lib.nurbs_interpolate_over_knots, *net.sizes, joined.ctypes.data, vectors.ctypes.data,
                        vectors.size, net.width, *net.points.layout, flags)


def interpolate_derivatives(degrees: Union[int, Sequence[int], Int32s], params: ByAxis, orders: ByAxis, values: ArrayLike,
                            ends: Optional[ArrayLike] = None, flags: int = 0) -> Spline:
    """The spline through layers of points and, at the ends of axes, of derivatives: `values` (counts..., dimension) on a
    grid of parameters and orders of derivatives, a vector, or one for each axis. Mixed derivatives may be NaN: these are
    estimated. interpolate() puts such a grid together from points and slopes."""
    net, joined = _data(degrees, params, values)
    order, lengths = concatenated(orders, net.axes, numpy.int32)
    if lengths != list(net.counts):
        raise ValueError(f"{lengths} orders for values {tuple(net.counts)}")
    at_ends = _ends(ends, net.axes)
    return Spline._made(lib.nurbs_interpolate_derivatives, *net.sizes, joined.ctypes.data, order.ctypes.data, net.width,
                        *net.points.layout, None if at_ends is None else at_ends.ctypes.data, flags)


def _conditions(degree: int, params: ArrayLike, targets: ArrayLike, orders: Optional[ArrayLike],
                knots: Optional[ArrayLike]) -> Tuple[Tuple[Optional[int], ...], Tuple[object, ...]]:
    """What the functions of conditions take, and the arrays that have to live as long."""
    at, values = vector(params), packed(targets)
    if values.ndim != 2 or len(values) != at.size:
        raise ValueError(f"targets of shape {values.shape} for {at.size} parameters")
    order = if_given(orders, at.size, "orders", numpy.int32)
    given = None if knots is None else vector(knots)
    return (degree, at.size, at.ctypes.data, None if order is None else order.ctypes.data, values.shape[1],
            values.ctypes.data, 0, 0, None if given is None else given.ctypes.data,
            0 if given is None else given.size), (at, values, order, given)


def curve_interpolate(degree: int, params: ArrayLike, targets: ArrayLike, orders: Optional[ArrayLike] = None,
                      knots: Optional[ArrayLike] = None, flags: int = 0) -> Spline:
    """The curve with derivatives `targets` (n, dimension) of `orders` (n,), by default 0, at parameters (n,) that do not
    decrease; over a full knot vector, by default the averaged one. The order NURBS_ORDER_DIRECTION is that of a tangent of
    which only the direction is known."""
    arguments, _arrays = _conditions(degree, params, targets, orders, knots)
    return Spline._made(lib.nurbs_curve_interpolate, *arguments, flags)


def tangent_lengths(degree: int, params: ArrayLike, targets: ArrayLike, orders: ArrayLike,
                    knots: Optional[ArrayLike] = None, flags: int = 0) -> Floats:
    """Factors (n,) that make derivatives of targets of which curve_interpolate() is told the directions: those of the least
    integral of the squared second derivative, of either sign; 1 for other targets."""
    arguments, _arrays = _conditions(degree, params, targets, orders, knots)
    found = numpy.empty(numpy.shape(params))
    call(lib.nurbs_tangent_lengths, *arguments, flags, found.ctypes.data)
    return found


def tangents(params: ArrayLike, points: ArrayLike, rule: int = NURBS_TANGENTS_BESSEL, flags: int = 0) -> Floats:
    """Derivatives (n, dimension) at points (n, dimension) with parameters (n,), each from the points near it, as
    Spline.hermite() takes them. `rule` is a NURBS_TANGENTS_ constant; with NURBS_PERIODIC the last point is the first one
    again."""
    at, values = vector(params), packed(points)
    if values.ndim != 2 or len(values) != at.size:
        raise ValueError(f"points of shape {values.shape} for {at.size} parameters")
    found = numpy.empty(values.shape)
    call(lib.nurbs_tangents, rule, at.size, at.ctypes.data, values.shape[1], values.ctypes.data, 0, 0, flags,
         found.ctypes.data, 0, 0)
    return found
