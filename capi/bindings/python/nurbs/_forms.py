# SPDX-License-Identifier: MIT
"""The same shape in other forms: degree, direction, parameters, weights; and affine and projective images."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy

from ._arrays import address, exactly, if_given, packed
from ._base import SplineBase
from ._library import lib
from .constants import NURBS_KEEP_DOMAIN

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._spline import Spline


def _matrix(values: ArrayLike, columns: int) -> NDArray[Any]:
    matrix = packed(values)
    if matrix.ndim != 2 or matrix.shape[1] != columns:
        raise ValueError(f"a matrix of shape {matrix.shape}, expected {columns} columns")
    return matrix


class Forms(SplineBase):
    """Other forms of the same shape."""

    def elevate(self, times: int = 1, *, axis: int = 0) -> Spline:
        """The same shape with the degree of an axis raised."""
        return self._made(lib.nurbs_elevate, self._handle, axis, times)

    def reverse(self, *, axis: int = 0, keep_domain: bool = False) -> Spline:
        """The axis turned round: at -t what was at t, exactly; with keep_domain at lower + upper - t."""
        return self._made(lib.nurbs_reverse, self._handle, axis, NURBS_KEEP_DOMAIN if keep_domain else 0)

    def transpose(self, *permutation: int) -> Spline:
        """The axes in another order, as numpy.transpose() does it; without arguments the opposite one."""
        order = exactly(permutation or range(self.axes)[::-1], self.axes, "a permutation", numpy.int32)
        return self._made(lib.nurbs_transpose, self._handle, order.ctypes.data)

    def reparametrize(self, lower: float, upper: float, *, axis: int = 0) -> Spline:
        """The same shape with the domain of an axis mapped to [lower, upper]."""
        return self._made(lib.nurbs_reparametrize, self._handle, axis, lower, upper)

    def make_rational(self) -> Spline:
        """The same spline with weights: of 1 if it had none."""
        return self._made(lib.nurbs_make_rational, self._handle)

    def to_homogeneous(self) -> Spline:
        """The polynomial spline of the points (w x, w y, ..., w), of dimension + 1."""
        return self._made(lib.nurbs_to_homogeneous, self._handle)

    def from_homogeneous(self) -> Spline:
        """The rational spline, of dimension - 1, whose homogeneous points are the points of this polynomial one."""
        return self._made(lib.nurbs_from_homogeneous, self._handle)

    def normalize_weights(self) -> Spline:
        """The same shape with the largest weight 1; equal weights are dropped."""
        return self._made(lib.nurbs_normalize_weights, self._handle)

    def reparametrize_moebius(self, ratio: float, *, axis: int = 0) -> Spline:
        """The same shape with the ratio of the weights at the ends of an axis, last over first, multiplied: by a
        rational linear map of its domain to itself."""
        return self._made(lib.nurbs_reparametrize_moebius, self._handle, axis, ratio)

    def equalize_end_weights(self, *, axis: int = 0) -> Spline:
        """The same shape with equal weights at the ends of an axis."""
        return self._made(lib.nurbs_equalize_end_weights, self._handle, axis)


class Transformations(SplineBase):
    """Images under affine and projective maps; vectors have the shape (dimension,)."""

    def transform(self, matrix: ArrayLike, translation: Optional[ArrayLike] = None) -> Spline:
        """The shape under x -> matrix x + translation: (out, dimension) and (out,)."""
        given = _matrix(matrix, self.dimension)
        moved = if_given(translation, len(given), "a translation")
        return self._made(lib.nurbs_transform, self._handle, len(given), given.ctypes.data, address(moved))

    def transform_projective(self, matrix: ArrayLike) -> Spline:
        """The shape under a map of its homogeneous points: (out + 1, dimension + 1)."""
        given = _matrix(matrix, self.dimension + 1)
        return self._made(lib.nurbs_transform_projective, self._handle, len(given) - 1, given.ctypes.data)

    def mirror(self, point: ArrayLike, normal: ArrayLike) -> Spline:
        """The mirror image in the plane (line, hyperplane) through a point: x -> x - 2 n (n . (x - point)) / (n .
        n)."""
        at, n = self._coordinates(point, "a point"), self._coordinates(normal, "a normal")
        return self._made(lib.nurbs_mirror, self._handle, at.ctypes.data, n.ctypes.data)

    def project_to_plane(self, point: ArrayLike, normal: ArrayLike, direction: Optional[ArrayLike] = None) -> Spline:
        """The image on the plane through a point along a direction, or along the normal:
        x -> x - d (n . (x - point)) / (n . d)."""
        at, n = self._coordinates(point, "a point"), self._coordinates(normal, "a normal")
        along = if_given(direction, self.dimension, "a direction")
        return self._made(lib.nurbs_project_to_plane, self._handle, at.ctypes.data, n.ctypes.data, address(along))

    def project_from(self, eye: ArrayLike, point: ArrayLike, normal: ArrayLike) -> Spline:
        """The image on the plane through a point seen from an eye:
        x -> eye + (x - eye) (n . (point - eye)) / (n . (x - eye))."""
        named = (eye, "an eye"), (point, "a point"), (normal, "a normal")
        vectors = [self._coordinates(values, name) for values, name in named]
        return self._made(lib.nurbs_project_from, self._handle, *(v.ctypes.data for v in vectors))
