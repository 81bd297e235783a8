# SPDX-License-Identifier: MIT
"""Hermite data, the power basis of pieces, and the matrices between bases of a segment."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import vector
from ._library import check, get, lib
from .constants import NURBS_HOMOGENEOUS
from .spline import Spline

#: params (n,), points (n, dim) and tangents (n, dim), as create_hermite() takes them.
Hermite = namedtuple("Hermite", "params points tangents")
#: coefficients (pieces..., degree + 1..., width) and the breaks of each axis, as create_power() takes them.
PowerForm = namedtuple("PowerForm", "coefficients breaks")


def create_hermite(params, points, tangents):
    """The piecewise cubic through points (n, dim) with tangents (n, dim)."""
    params = vector(params, numpy.float64)
    nets = [numpy.ascontiguousarray(values, numpy.float64) for values in (points, tangents)]
    if any(net.ndim != 2 or len(net) != params.size or net.shape != nets[0].shape for net in nets):
        raise ValueError(f"points {nets[0].shape} and tangents {nets[1].shape} for {params.size} parameters")
    return Spline._made(lib.nurbs_create_hermite, params.size, params.ctypes.data, nets[0].shape[1],
                        nets[0].ctypes.data, 0, 0, nets[1].ctypes.data, 0, 0)


def to_hermite(spline):
    """The points and tangents of a C^1 piecewise cubic at its breaks."""
    n = get(ctypes.c_int64, lib.nurbs_to_hermite, spline._handle, 0, None, None, None)
    params, nets = numpy.empty(n), numpy.empty((2, n, spline.dimension))
    get(ctypes.c_int64, lib.nurbs_to_hermite, spline._handle, n, params.ctypes.data, nets[0].ctypes.data,
        nets[1].ctypes.data)
    return Hermite(params, nets[0], nets[1])


def to_power(spline):
    """The power basis of every piece, of homogeneous points if the spline is rational."""
    pieces = numpy.empty(spline.axes, numpy.int64)
    count = get(ctypes.c_int64, lib.nurbs_to_power, spline._handle, 0, None, None, pieces.ctypes.data)
    widths = tuple(spline.degree(k) + 1 for k in range(spline.axes))
    coefficients = numpy.empty(tuple(pieces) + widths + (spline.dimension + spline.rational,))
    breaks = numpy.empty(int(pieces.sum()) + spline.axes)
    get(ctypes.c_int64, lib.nurbs_to_power, spline._handle, count, coefficients.ctypes.data, breaks.ctypes.data,
        None)
    return PowerForm(coefficients, numpy.split(breaks, numpy.cumsum(pieces + 1)[:-1]))


def create_power(coefficients, breaks, homogeneous=False):
    """The spline of the pieces with the given coefficients (pieces..., degree + 1..., width) over breaks, one array for
    each axis."""
    values = numpy.ascontiguousarray(coefficients, numpy.float64)
    parts = [vector(axis, numpy.float64) for axis in breaks]
    axes = len(parts)
    pieces = numpy.array([axis.size - 1 for axis in parts], numpy.int64)
    if values.ndim != 2 * axes + 1 or values.shape[:axes] != tuple(pieces):
        raise ValueError(f"coefficients {values.shape} for {tuple(pieces)} pieces")
    degrees = numpy.array(values.shape[axes:-1], numpy.int32) - numpy.int32(1)
    joined = numpy.concatenate(parts) if parts else numpy.empty(0)
    return Spline._made(lib.nurbs_create_power, axes, degrees.ctypes.data, pieces.ctypes.data, joined.ctypes.data,
                        joined.size, values.shape[-1] - bool(homogeneous), values.ctypes.data, 0, 0,
                        NURBS_HOMOGENEOUS if homogeneous else 0)


def basis_matrix(from_basis, to_basis, degree):
    """The matrix that takes coefficients of one basis (a NURBS_BASIS_ constant) to those of another."""
    matrix = numpy.empty((max(degree, 0) + 1,) * 2)
    check(lib.nurbs_basis_matrix(from_basis, to_basis, degree, matrix.size, matrix.ctypes.data))
    return matrix
