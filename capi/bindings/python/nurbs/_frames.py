# SPDX-License-Identifier: MIT
"""Frames and curvature of curves and surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, NamedTuple, Optional, Tuple

import numpy

from ._arrays import Records, address, if_given, records, vector
from ._base import SplineBase
from ._library import call, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s, Shape

__all__ = ["SurfaceFrames", "Curvatures", "CurveFrames", "MinimalFrames"]


class SurfaceFrames(NamedTuple):
    """Points, first derivatives and unit normals, of shape S + (3,), and NURBS_FRAME_ bits of shape S."""

    points: Floats
    du: Floats
    dv: Floats
    normals: Floats
    status: Int32s


class Curvatures(NamedTuple):
    """Principal curvatures S + (2,), the larger one first, their directions S + (2, 3), mean and Gaussian curvature S,
    and NURBS_FRAME_ bits S."""

    principal: Floats
    directions: Floats
    mean: Floats
    gaussian: Floats
    status: Int32s


class CurveFrames(NamedTuple):
    """Vectors of shape S + (dimension,), the others of shape S; in the plane binormals and torsions are None."""

    points: Floats
    tangents: Floats
    normals: Floats
    binormals: Optional[Floats]
    curvatures: Floats
    torsions: Optional[Floats]
    status: Int32s


class MinimalFrames(NamedTuple):
    """Vectors of shape (n, 3), and NURBS_FRAME_ bits of shape (n,)."""

    points: Floats
    tangents: Floats
    normals: Floats
    binormals: Floats
    status: Int32s


def _vectors(*arrays: Optional[Floats]) -> Iterator[Any]:
    """Pointer, stride and component stride of packed records."""
    for array in arrays:
        yield from (address(array), 0, 0)


def _values(*arrays: Optional[Floats]) -> Iterator[Any]:
    """Pointer and stride of packed values."""
    for array in arrays:
        yield from (address(array), 0)


def _pairs(params: ArrayLike) -> Tuple[Records, Shape]:
    given = numpy.asarray(params, dtype=numpy.float64)
    if given.ndim == 0 or given.shape[-1] != 2:
        raise ValueError(f"params of shape {given.shape}, expected (..., 2)")
    return records(given, 2), given.shape[:-1]


def _surface_frames(shape: Shape) -> SurfaceFrames:
    points, du, dv, normals = (numpy.empty((*shape, 3)) for _ in range(4))
    return SurfaceFrames(points, du, dv, normals, numpy.empty(shape, numpy.int32))


class Frames(SplineBase):
    """Frames and curvature. A status tells where a result is a limit, was chosen by a rule, or does not exist (NaN)."""

    def surface_frames(self, params: ArrayLike, flags: int = 0) -> SurfaceFrames:
        """Points, derivatives and unit normals S_u x S_v / |S_u x S_v| of a surface in space at params S + (2,); at
        poles and collapsed edges the limit of the normal."""
        given, shape = _pairs(params)
        result = _surface_frames(shape)
        call(lib.nurbs_surface_eval_frames, self._handle, given.n, *given.layout, *_vectors(*result[:4]),
             result.status.ctypes.data, flags)
        return result

    def surface_grid_frames(self, u: ArrayLike, v: ArrayLike, flags: int = 0) -> SurfaceFrames:
        """The same on the grid of u and v, of shape (len(u), len(v))."""
        u, v = vector(u), vector(v)
        given, counts = numpy.concatenate([u, v]), vector([u.size, v.size], numpy.int64)
        result = _surface_frames((u.size, v.size))
        call(lib.nurbs_surface_eval_grid_frames, self._handle, counts.ctypes.data, given.ctypes.data,
             *_vectors(*result[:4]), result.status.ctypes.data, flags)
        return result

    def surface_curvatures(self, params: ArrayLike, flags: int = 0) -> Curvatures:
        """Curvature of a surface in space at params S + (2,), positive where it bends towards its normal: a sphere
        whose normals point outwards has -1 / radius."""
        given, shape = _pairs(params)
        result = Curvatures(numpy.empty((*shape, 2)), numpy.empty((*shape, 2, 3)), numpy.empty(shape),
                            numpy.empty(shape), numpy.empty(shape, numpy.int32))
        call(lib.nurbs_surface_eval_curvatures, self._handle, given.n, *given.layout, *_vectors(*result[:2]),
             *_values(result.mean, result.gaussian), result.status.ctypes.data, flags)
        return result

    def curve_frames(self, params: ArrayLike, flags: int = 0) -> CurveFrames:
        """Frenet frames of a curve at params S. In space T = C' / |C'|, B = C' x C'' / |C' x C''|, N = B x T, curvature
        |C' x C''| / |C'|^3 and torsion (C' x C'') . C''' / |C' x C''|^2; in the plane N is T turned by +90 degrees and
        the curvature has a sign."""
        given, dim = records(params, 1), self.dimension
        shape = given.shape
        points, tangents, normals = (numpy.empty((*shape, dim)) for _ in range(3))
        binormals, torsions = (numpy.empty((*shape, 3)), numpy.empty(shape)) if dim == 3 else (None, None)
        result = CurveFrames(points, tangents, normals, binormals, numpy.empty(shape), torsions,
                             numpy.empty(shape, numpy.int32))
        call(lib.nurbs_curve_eval_frames, self._handle, given.n, *given.layout[:2], *_vectors(*result[:4]),
             *_values(result.curvatures, result.torsions), result.status.ctypes.data, flags)
        return result

    def rotation_minimizing_frames(self, params: ArrayLike, first_normal: Optional[ArrayLike] = None,
                                   flags: int = 0) -> MinimalFrames:
        """Frames of a curve in space that turn about the tangent as little as possible along a sequence of parameters
        (n,), by double reflection (Wang et al. 2008); first_normal (3,) is made perpendicular to the tangent."""
        given, first = records(vector(params), 1), if_given(first_normal, 3, "a first normal")
        points, tangents, normals, binormals = (numpy.empty((given.n, 3)) for _ in range(4))
        result = MinimalFrames(points, tangents, normals, binormals, numpy.empty(given.n, numpy.int32))
        call(lib.nurbs_curve_rotation_minimizing_frames, self._handle, given.n, *given.layout[:2], address(first),
             *_vectors(*result[:4]), result.status.ctypes.data, flags)
        return result
