# SPDX-License-Identifier: MIT
"""Frames and curvature of curves and surfaces."""

from typing import NamedTuple, Optional

import numpy

from ._arrays import records, vector
from ._library import check, lib


class SurfaceFrames(NamedTuple):
    """Arrays of shape S + (3,), and the status of shape S."""

    points: numpy.ndarray
    du: numpy.ndarray
    dv: numpy.ndarray
    normals: numpy.ndarray
    status: numpy.ndarray


class Curvatures(NamedTuple):
    """Shapes S + (2,), S + (2, 3), S, S and S."""

    principal: numpy.ndarray
    directions: numpy.ndarray
    mean: numpy.ndarray
    gaussian: numpy.ndarray
    status: numpy.ndarray


class CurveFrames(NamedTuple):
    """Vectors of shape S + (dim,), the others of shape S; in the plane binormals and torsions are None."""

    points: numpy.ndarray
    tangents: numpy.ndarray
    normals: numpy.ndarray
    binormals: Optional[numpy.ndarray]
    curvatures: numpy.ndarray
    torsions: Optional[numpy.ndarray]
    status: numpy.ndarray


class MinimalFrames(NamedTuple):
    """Vectors of shape (n, 3), and the status of shape (n,)."""

    points: numpy.ndarray
    tangents: numpy.ndarray
    normals: numpy.ndarray
    binormals: numpy.ndarray
    status: numpy.ndarray


def _layouts(arrays):
    """Pointer, stride and component stride of packed records; of single values, pointer and stride."""
    for array, is_vector in arrays:
        yield None if array is None else array.ctypes.data
        yield from (0, 0) if is_vector else (0,)


def _vectors(*arrays):
    return list(_layouts((array, True) for array in arrays))


def _values(*arrays):
    return list(_layouts((array, False) for array in arrays))


def _pairs(params):
    shape = numpy.shape(params)
    if not shape or shape[-1] != 2:
        raise ValueError("params must have shape (..., 2)")
    return records(params, 2), shape[:-1]


def surface_frames(spline, params, flags=0):
    """Points, derivatives and unit normals at params of shape S + (2,)."""
    given, shape = _pairs(params)
    result = SurfaceFrames(*(numpy.empty((*shape, 3)) for _ in range(4)), numpy.empty(shape, numpy.int32))
    check(lib.nurbs_surface_eval_frames(spline._handle, given.n, *given.layout, *_vectors(*result[:4]),
                                        result.status.ctypes.data, flags))
    return result


def surface_grid_frames(spline, u, v, flags=0):
    """The same on the grid of u and v, of shape (len(u), len(v))."""
    u, v = vector(u), vector(v)
    given, counts = numpy.concatenate([u, v]), vector([u.size, v.size], numpy.int64)
    shape = (u.size, v.size)
    result = SurfaceFrames(*(numpy.empty((*shape, 3)) for _ in range(4)), numpy.empty(shape, numpy.int32))
    check(lib.nurbs_surface_eval_grid_frames(spline._handle, counts.ctypes.data, given.ctypes.data,
                                             *_vectors(*result[:4]), result.status.ctypes.data, flags))
    return result


def surface_curvatures(spline, params, flags=0):
    """Principal curvatures and directions, mean and Gaussian curvature at params of shape S + (2,)."""
    given, shape = _pairs(params)
    result = Curvatures(numpy.empty((*shape, 2)), numpy.empty((*shape, 2, 3)), numpy.empty(shape), numpy.empty(shape),
                        numpy.empty(shape, numpy.int32))
    check(lib.nurbs_surface_eval_curvatures(spline._handle, given.n, *given.layout, *_vectors(*result[:2]),
                                            *_values(result.mean, result.gaussian), result.status.ctypes.data, flags))
    return result


def curve_frames(spline, params, flags=0):
    """Frenet frames, curvatures and torsions at params of shape S."""
    given, shape, dim = records(params, 1), numpy.shape(params), spline.dimension
    in_space = dim == 3
    result = CurveFrames(*(numpy.empty((*shape, dim)) for _ in range(3)),
                         numpy.empty((*shape, 3)) if in_space else None, numpy.empty(shape),
                         numpy.empty(shape) if in_space else None, numpy.empty(shape, numpy.int32))
    check(lib.nurbs_curve_eval_frames(spline._handle, given.n, *given.layout[:2], *_vectors(*result[:4]),
                                      *_values(result.curvatures, result.torsions), result.status.ctypes.data, flags))
    return result


def rotation_minimizing_frames(spline, params, first_normal=None, flags=0):
    """Frames that turn as little as possible along a sequence of parameters."""
    given = records(vector(params), 1)
    first = None if first_normal is None else vector(first_normal)
    if first is not None and first.size != 3:
        raise ValueError("first_normal must have 3 coordinates")
    result = MinimalFrames(*(numpy.empty((given.n, 3)) for _ in range(4)), numpy.empty(given.n, numpy.int32))
    check(lib.nurbs_curve_rotation_minimizing_frames(
        spline._handle, given.n, *given.layout[:2], None if first is None else first.ctypes.data,
        *_vectors(*result[:4]), result.status.ctypes.data, flags))
    return result
