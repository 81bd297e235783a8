# SPDX-License-Identifier: MIT
"""Derivatives, integrals, sums, products and compositions of splines, and changes of their weights."""

import numpy

from ._arrays import vector
from ._library import check, lib
from .spline import Spline


def blossom(spline, params, args, flags=0):
    """Polar form of the piece at params at one argument for each degree: (dim,), or (dim + 1,) if rational."""
    params, args = vector(params), vector(args)
    if params.size != spline.axes:
        raise ValueError(f"{params.size} parameters for {spline.axes} axes")
    values = numpy.empty(spline.dimension + (1 if spline.rational else 0))
    check(lib.nurbs_blossom(spline._handle, params.ctypes.data, args.size, args.ctypes.data, values.ctypes.data,
                            flags))
    return values


def derivative(spline, order=1, *, axis=0):
    """The partial derivative along an axis, as a spline."""
    return Spline._made(lib.nurbs_derivative, spline._handle, axis, order)


def antiderivative(spline, *, axis=0):
    """The integral of a polynomial spline along an axis from the start of its domain."""
    return Spline._made(lib.nurbs_antiderivative, spline._handle, axis)


def product(a, b, flags=0):
    """a(t) b(t): by components, or flags NURBS_PRODUCT_DOT or NURBS_PRODUCT_CROSS."""
    return Spline._made(lib.nurbs_product, a._handle, b._handle, flags)


def compose(g, f):
    """g(f(t)) for a curve f in the parameter space of g."""
    return Spline._made(lib.nurbs_compose, g._handle, f._handle)


def sum(a, b, alpha=1.0, beta=1.0):
    """alpha a(t) + beta b(t)."""
    return Spline._made(lib.nurbs_sum, a._handle, alpha, b._handle, beta)


def normalize_weights(spline):
    """The same shape with the largest weight 1; equal weights are dropped."""
    return Spline._made(lib.nurbs_normalize_weights, spline._handle)


def reparametrize_moebius(spline, ratio, *, axis=0):
    """The same shape with the ratio of the end weights, last over first, multiplied."""
    return Spline._made(lib.nurbs_reparametrize_moebius, spline._handle, axis, ratio)


def equalize_end_weights(spline, *, axis=0):
    """The same shape with equal weights at the ends of an axis."""
    return Spline._made(lib.nurbs_equalize_end_weights, spline._handle, axis)
