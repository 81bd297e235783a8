# SPDX-License-Identifier: MIT
"""Points and derivatives at parameters, at lists of them and on grids."""

from __future__ import annotations

import ctypes
import operator
from math import comb, prod
from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from ._arrays import Output, vector
from ._base import SplineBase
from ._library import call, get, lib, single

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int64s, Singles
    from ._spline import Spline

__all__ = ["BasisGradients", "RationalBasis", "derivative_slot", "derivative_slots"]


class BasisGradients(NamedTuple):
    """Spans S + (axes,), and the gradients of the functions of the active control points there, S + (degree + 1 of each
    axis) + (dimension,)."""

    spans: Int64s
    gradients: Floats


class RationalBasis(NamedTuple):
    """Spans S + (axes,), and the functions R_i of the active control points there, S + (degree + 1 of each axis)."""

    spans: Int64s
    values: Floats


def derivative_slots(axes: int, order: int) -> int:
    """Number of partial derivatives of orders 0 to `order`: binomial(order + axes, axes)."""
    return int(get(ctypes.c_int64, lib.nurbs_derivative_slots, axes, order))


def derivative_slot(*orders: int) -> int:
    """Place of a partial derivative among those of Spline.eval_derivs(), given its order along each axis.

    derivative_slot(k) is k; derivative_slot(i, j) is (i + j) (i + j + 1) / 2 + j.
    """
    axes = len(orders)
    return sum(comb(sum(orders[axis:]) + axes - axis - 1, axes - axis) for axis in range(axes))


class Evaluation(SplineBase):
    """Points and derivatives.

    Parameters of a curve have any shape S; those of a surface or volume have the shape S + (axes,). Float64 arrays with
    positive strides, in either memory order, are read and filled where they are. `flags` is a sum of evaluation flags
    of nurbs.h, moved to their axis by on_axis() or on_all_axes(): NURBS_LEFT, NURBS_CLAMP, NURBS_EXTRAPOLATE,
    NURBS_WRAP, NURBS_NAN. Without any a parameter outside the domain raises DomainError.
    """

    def __call__(self, *params: ArrayLike, nu: Union[int, Sequence[int]] = 0, flags: int = 0,
                 out: Optional[Floats] = None) -> Floats:
        """Points, or partial derivatives of order nu: S + (dimension,).

            curve(t)                        t of shape S
            surface(uv), volume(uvw)        of shape S + (axes,), read where they are
            surface(u, v), volume(u, v, w)  arrays that are broadcast to the shape S, and packed
            curve(t, nu=1), surface(u, v, nu=(1, 0))

        nu is the order of the derivative, of a surface or volume one for each axis; `out` is filled if it is given. A
        point of dimension 1 has the shape (1,). All points of a grid are faster by eval_grid().
        """
        if single is not None and out is None:
            found: Optional[Floats] = self._single(params[0] if len(params) == 1 else params, nu, flags)
            if found is not None:
                return found
        at = params[0] if len(params) == 1 else self._together(params)
        orders = [int(nu)] if isinstance(nu, (int, numpy.integer)) else [operator.index(order) for order in nu]
        if not any(orders):
            return self.eval(at, flags, out)
        if len(orders) != self.axes or min(orders) < 0:
            raise ValueError(f"nu = {nu}, expected an order >= 0 for each of {self.axes} axes")
        values: Floats = self.eval_derivs(at, sum(orders), flags)[..., derivative_slot(*orders), :]
        return values if out is None else self._copied(values, out)

    def _single(self, params: Any, nu: Union[int, Sequence[int]], flags: int) -> Optional[Floats]:
        """A point or derivative at one place, or None of what is something else."""
        if type(nu) is int and nu == 0:
            point: Optional[Floats] = single.eval(self._handle, self.axes, self.dimension, params, flags)
            return point
        found: Optional[Floats] = single.derivative(self._handle, self.axes, self.dimension, params, nu, flags)
        return found

    def _together(self, params: Sequence[ArrayLike]) -> Floats:
        if len(params) != self.axes:
            raise ValueError(f"{len(params)} arrays of parameters for {self.axes} axes")
        packed: Floats = numpy.stack(numpy.broadcast_arrays(*params), axis=-1)
        return packed

    @staticmethod
    def _copied(found: Floats, out: Floats) -> Floats:
        output = Output(out, found.shape, found.shape[-1])
        output.result[...] = found
        return output.result

    def _batch(self, function: Any, before: Tuple[int, ...], params: ArrayLike, tail: Tuple[int, ...], flags: int,
               out: Optional[NDArray[Any]], dtype: Any = numpy.float64) -> NDArray[Any]:
        given, shape = self._params(params)
        output = Output(out, shape + tail, prod(tail), dtype)
        call(function, self._handle, *before, given.n, *given.layout, *output.layout, flags)
        return output.finish()

    def eval(self, params: ArrayLike, flags: int = 0, out: Optional[Floats] = None) -> Floats:
        """Points S + (dimension,): C(t) = sum_i R_i(t) P_i, R_i = w_i N_i / sum_j w_j N_j."""
        if single is not None and out is None:
            point: Optional[Floats] = self._single(params, 0, flags)
            if point is not None:
                return point
        return self._batch(lib.nurbs_eval, (), params, (self.dimension,), flags, out)

    def eval_derivs(self, params: ArrayLike, order: int, flags: int = 0, out: Optional[Floats] = None) -> Floats:
        """Points and all partial derivatives to an order: S + (slots, dimension), the places of derivative_slot()."""
        slots = derivative_slots(self.axes, order)
        return self._batch(lib.nurbs_eval_derivs, (order,), params, (slots, self.dimension), flags, out)

    def eval_f32(self, params: ArrayLike, flags: int = 0, out: Optional[Singles] = None) -> Singles:
        """Points in single precision: those of eval(), rounded once."""
        return self._batch(lib.nurbs_eval_f32, (), params, (self.dimension,), flags, out, numpy.float32)

    def hull_size(self, params: ArrayLike, flags: int = 0, out: Optional[Floats] = None) -> Floats:
        """The `hull` of the accuracy contract at each parameter, S: the largest |coordinate| of a control point that is
        active there."""
        given, shape = self._params(params)
        output = Output(out, shape, 1)
        call(lib.nurbs_hull_size, self._handle, given.n, *given.layout, *output.layout[:2], flags)
        return output.finish()

    def rational_basis(self, params: ArrayLike, flags: int = 0, out: Optional[Floats] = None) -> RationalBasis:
        """The functions R_i that do not vanish, and the spans where they belong: on axis k they are those of the
        control points spans[..., k] - degrees[k] to spans[..., k]."""
        given, shape = self._params(params)
        active = tuple(degree + 1 for degree in self.degrees)
        output = Output(out, shape + active, prod(active))
        spans = numpy.empty((*shape, self.axes), numpy.int64)
        call(lib.nurbs_rational_basis, self._handle, given.n, *given.layout, spans.ctypes.data, *output.layout, flags)
        return RationalBasis(spans, output.finish())

    def basis_gradients(self, params: ArrayLike, flags: int = 0, out: Optional[Floats] = None) -> BasisGradients:
        """The gradients in space of the functions of rational_basis(), on a curve or a surface along it; NaN where the
        derivatives of the spline are dependent."""
        given, shape = self._params(params)
        inner = (*(degree + 1 for degree in self.degrees), self.dimension)
        output = Output(out, shape + inner, prod(inner))
        spans = numpy.empty((*shape, self.axes), numpy.int64)
        call(lib.nurbs_basis_gradients, self._handle, given.n, *given.layout, spans.ctypes.data, *output.layout, flags)
        return BasisGradients(spans, output.finish())

    # --- Grids ---

    def _on_grid(self, function: Any, before: Tuple[int, ...], params: Sequence[ArrayLike], tail: Tuple[int, ...],
                 flags: int, out: Optional[NDArray[Any]], dtype: Any = numpy.float64) -> NDArray[Any]:
        if len(params) != self.axes:
            raise ValueError(f"{len(params)} parameter vectors for {self.axes} axes")
        vectors: List[Floats] = [vector(values) for values in params]
        counts, given = vector([v.size for v in vectors], numpy.int64), numpy.concatenate(vectors)
        output = Output(out, (*(v.size for v in vectors), *tail), prod(tail), dtype)
        call(function, self._handle, *before, counts.ctypes.data, given.ctypes.data, *output.layout, flags)
        return output.finish()

    def eval_grid(self, *params: ArrayLike, flags: int = 0, out: Optional[Floats] = None) -> Floats:
        """Points on a grid, from one vector of parameters for each axis: (n_0, ..., dimension)."""
        return self._on_grid(lib.nurbs_eval_grid, (), params, (self.dimension,), flags, out)

    def eval_grid_derivs(self, *params: ArrayLike, order: int, flags: int = 0, out: Optional[Floats] = None) -> Floats:
        """Points and partial derivatives on a grid: (n_0, ..., slots, dimension)."""
        slots = derivative_slots(self.axes, order)
        return self._on_grid(lib.nurbs_eval_grid_derivs, (order,), params, (slots, self.dimension), flags, out)

    def eval_grid_f32(self, *params: ArrayLike, flags: int = 0, out: Optional[Singles] = None) -> Singles:
        """Points on a grid in single precision: those of eval_grid(), rounded once."""
        return self._on_grid(lib.nurbs_eval_grid_f32, (), params, (self.dimension,), flags, out, numpy.float32)

    def iso(self, axis: int, param: float, flags: int = 0) -> Spline:
        """The spline of one axis less on which the parameter of `axis` is fixed; flags are those of that axis."""
        return self._made(lib.nurbs_iso, self._handle, axis, param, flags)
