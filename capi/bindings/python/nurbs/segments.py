# SPDX-License-Identifier: MIT
"""Hermite data, and the matrices between bases of a segment."""

import numpy

from ._arrays import vector
from ._library import check, lib
from .spline import Spline


def create_hermite(params, points, tangents):
    """The piecewise cubic through points (n, dim) with tangents (n, dim)."""
    params = vector(params, numpy.float64)
    nets = [numpy.ascontiguousarray(values, numpy.float64) for values in (points, tangents)]
    if any(net.ndim != 2 or len(net) != params.size or net.shape != nets[0].shape for net in nets):
        raise ValueError(f"points {nets[0].shape} and tangents {nets[1].shape} for {params.size} parameters")
    return Spline._made(lib.nurbs_create_hermite, params.size, params.ctypes.data, nets[0].shape[1],
                        nets[0].ctypes.data, 0, 0, nets[1].ctypes.data, 0, 0)


def basis_matrix(from_basis, to_basis, degree):
    """The matrix that takes coefficients of one basis (a NURBS_BASIS_ constant) to those of another."""
    matrix = numpy.empty((max(degree, 0) + 1,) * 2)
    check(lib.nurbs_basis_matrix(from_basis, to_basis, degree, matrix.size, matrix.ctypes.data))
    return matrix
