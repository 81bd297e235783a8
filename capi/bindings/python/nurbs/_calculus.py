# SPDX-License-Identifier: MIT
"""Derivatives, integrals, sums, products and compositions, and the operators that stand for them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Optional, Union

import numpy

from ._arrays import exactly, packed, vector
from ._base import SplineBase, handle_of
from ._calls import watched
from ._library import call, lib
from .constants import NURBS_PRODUCT_DOT

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats
    from ._calls import Progress
    from ._spline import Spline


class Calculus(SplineBase):
    """Splines as functions. The operators are those of values: (f op x)(t) is f(t) op x at every t.

    f + g, f - g, f * g (by components) and f @ g (dot product, of dimension 1) take splines over the same domain;
    f + v, f - v, f * v, f / v take numbers or vectors (dimension,), v + f, v - f, v * f too; A @ f a matrix
    (out, dimension); -f.
    """

    #: NumPy leaves operators between its arrays and splines to these.
    __array_ufunc__ = None

    def derivative(self, order: int = 1, *, axis: int = 0) -> Spline:
        """The partial derivative along an axis, as a spline (hodograph)."""
        return self._made(lib.nurbs_derivative, self._handle, axis, order)

    def eval_knot_derivative(self, knot: int, *, axis: int = 0) -> Spline:
        """The derivative with respect to a knot of the full vector of an axis, as a spline of the same parameters. On a
        periodic axis the knot moves with its copies."""
        return self._made(lib.nurbs_eval_knot_derivative, self._handle, axis, knot)

    def antiderivative(self, *, axis: int = 0) -> Spline:
        """The integral of a polynomial spline along an axis, 0 at the start of its domain. Raises ArgumentError if it
        is rational."""
        return self._made(lib.nurbs_antiderivative, self._handle, axis)

    def blossom(self, params: ArrayLike, args: ArrayLike, flags: int = 0) -> Floats:
        """Polar form of the polynomial piece at params (axes,) at arguments, `degree` of them for each axis:
        (dimension,), of a rational spline (dimension + 1,). At equal arguments it is the spline."""
        at, arguments = exactly(params, self.axes, "parameters"), vector(args)
        values = numpy.empty(self.dimension + self.rational)
        call(lib.nurbs_blossom, self._handle, at.ctypes.data, arguments.size, arguments.ctypes.data,
             values.ctypes.data, flags)
        return values

    def product(self, other: SplineBase, flags: int = 0, *, progress: Progress = None,
                work: Optional[int] = None) -> Spline:
        """The product self(t) other(t): by components, or with NURBS_PRODUCT_DOT or NURBS_PRODUCT_CROSS. One of them
        may have dimension 1 and multiplies all components of the other."""
        return self._made(watched(lib.nurbs_product, progress, work), self._handle, handle_of(other), flags)

    def compose(self, inner: SplineBase, *, progress: Progress = None, work: Optional[int] = None) -> Spline:
        """The curve self(inner(t)) for a curve in the parameter space of this spline, polynomial or with positive
        weights, such as a circle on a surface."""
        return self._made(watched(lib.nurbs_compose, progress, work), self._handle, handle_of(inner))

    def sum(self, other: SplineBase, alpha: float = 1.0, beta: float = 1.0) -> Spline:
        """The spline alpha self(t) + beta other(t)."""
        return self._made(lib.nurbs_sum, self._handle, alpha, handle_of(other), beta)

    # --- Operators ---

    def _affine(self, factors: Any, shift: Any = 0.0) -> Spline:
        """factors * self + shift, each a number or a vector (dimension,)."""
        matrix = numpy.diag(numpy.broadcast_to(factors, self.dimension).astype(numpy.float64))
        translation = numpy.broadcast_to(shift, self.dimension).astype(numpy.float64)
        return self._made(lib.nurbs_transform, self._handle, self.dimension, matrix.ctypes.data,
                          translation.ctypes.data)

    def _with(self, other: Any, operation: Callable[[Any], Spline]) -> Any:
        """What an operation does with a number or a vector; NotImplemented for anything else."""
        given = numpy.asarray(other)
        if given.dtype.kind not in "biuf" or given.shape not in ((), (1,), (self.dimension,)):
            return NotImplemented
        return operation(given.astype(numpy.float64))

    def __add__(self, other: Union[SplineBase, ArrayLike]) -> Spline:
        if isinstance(other, SplineBase):
            return self.sum(other)
        made: Spline = self._with(other, lambda v: self._affine(1.0, v))
        return made

    __radd__ = __add__

    def __sub__(self, other: Union[SplineBase, ArrayLike]) -> Spline:
        if isinstance(other, SplineBase):
            return self.sum(other, 1.0, -1.0)
        made: Spline = self._with(other, lambda v: self._affine(1.0, -v))
        return made

    def __rsub__(self, other: ArrayLike) -> Spline:
        made: Spline = self._with(other, lambda v: self._affine(-1.0, v))
        return made

    def __mul__(self, other: Union[SplineBase, ArrayLike]) -> Spline:
        made: Spline = self.product(other) if isinstance(other, SplineBase) else self._with(other, self._affine)
        return made

    __rmul__ = __mul__

    def __truediv__(self, other: ArrayLike) -> Spline:
        with numpy.errstate(divide="ignore"):  # the library refuses what is not finite
            made: Spline = self._with(other, lambda v: self._affine(1.0 / v))
        return made

    def __neg__(self) -> Spline:
        return self._affine(-1.0)

    def __matmul__(self, other: SplineBase) -> Spline:
        return self.product(other, NURBS_PRODUCT_DOT) if isinstance(other, SplineBase) else NotImplemented

    def __rmatmul__(self, matrix: ArrayLike) -> Spline:
        given = packed(matrix)
        if given.ndim != 2 or given.shape[1] != self.dimension:
            return NotImplemented
        return self._made(lib.nurbs_transform, self._handle, len(given), given.ctypes.data, None)
