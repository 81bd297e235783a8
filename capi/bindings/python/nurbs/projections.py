# SPDX-License-Identifier: MIT
"""Reflections and projections."""

import numpy

from ._arrays import vector
from ._library import lib
from .spline import Spline


def _vectors(spline, *values):
    arrays = [vector(value, numpy.float64) for value in values]
    for array in arrays:
        if array.size != spline.dimension:
            raise ValueError(f"a vector of {array.size} for a spline of dimension {spline.dimension}")
    return arrays


def mirror(spline, point, normal):
    """The mirror image in the plane (line, hyperplane) through a point."""
    point, normal = _vectors(spline, point, normal)
    return Spline._made(lib.nurbs_mirror, spline._handle, point.ctypes.data, normal.ctypes.data)


def project_to_plane(spline, point, normal, direction=None):
    """Along a direction, or along the normal."""
    point, normal, along = _vectors(spline, point, normal, normal if direction is None else direction)
    return Spline._made(lib.nurbs_project_to_plane, spline._handle, point.ctypes.data, normal.ctypes.data,
                        None if direction is None else along.ctypes.data)


def project_from(spline, eye, point, normal):
    """From an eye."""
    eye, point, normal = _vectors(spline, eye, point, normal)
    return Spline._made(lib.nurbs_project_from, spline._handle, eye.ctypes.data, point.ctypes.data,
                        normal.ctypes.data)
