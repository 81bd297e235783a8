# SPDX-License-Identifier: MIT
"""Lengths, areas and moments. A `range` is a part (axes, 2) of the domain, of a curve (2,)."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import address, if_given, records
from ._library import check, lib
from .constants import NURBS_CLAMP, NURBS_EQUAL_CHORDS

#: An integral, and an estimate of its error.
Measured = namedtuple("Measured", "value error")
#: Parameters (parts + 1,), and the length or chord of a part.
Division = namedtuple("Division", "params size")
#: Length, area or volume, centroid (dim,), inertia (dim, dim) about it, and an estimate of the error of content.
Moments = namedtuple("Moments", "content centroid inertia error")
EnclosedArea = namedtuple("EnclosedArea", "area centroid inertia error")
#: openness is the length of the vector area, 0 of a closed shell.
EnclosedVolume = namedtuple("EnclosedVolume", "volume centroid inertia openness error")


def _measured(function, spline, relative_tolerance, part):
    part = if_given(part, 2 * spline.axes, "a range")
    value, error = ctypes.c_double(), ctypes.c_double()
    check(function(spline._handle, address(part), relative_tolerance, ctypes.byref(value), ctypes.byref(error)))
    return Measured(value.value, error.value)


def length(spline, relative_tolerance=0.0, *, range=None):
    """Length of a curve: (value, error)."""
    return _measured(lib.nurbs_curve_length, spline, relative_tolerance, range)


def area(spline, relative_tolerance=0.0, *, range=None):
    """Area of a surface: (value, error)."""
    return _measured(lib.nurbs_surface_area, spline, relative_tolerance, range)


def lengths(spline, params, relative_tolerance=0.0):
    """Lengths from the start of the domain to parameters, of their shape."""
    given, found = records(params, 1), numpy.empty(numpy.shape(params))
    check(lib.nurbs_curve_lengths(spline._handle, given.n, *given.layout[:2], relative_tolerance, found.ctypes.data, 0))
    return found


def params_at_lengths(spline, lengths, relative_tolerance=0.0, *, clamp=False):
    """Parameters at lengths from the start of the domain; with clamp lengths outside give the nearer end."""
    given, found = records(lengths, 1), numpy.empty(numpy.shape(lengths))
    check(lib.nurbs_curve_params_at_lengths(spline._handle, given.n, *given.layout[:2], relative_tolerance,
                                            found.ctypes.data, 0, NURBS_CLAMP if clamp else 0))
    return found


def divide(spline, parts, relative_tolerance=0.0, *, equal_chords=False, range=None):
    """A curve in parts of equal length, or with points at equal distances: (params, size)."""
    part = if_given(range, 2 * spline.axes, "a range")
    params, size = numpy.empty(max(parts, 0) + 1), ctypes.c_double()
    check(lib.nurbs_curve_divide(spline._handle, address(part), parts, relative_tolerance,
                                 NURBS_EQUAL_CHORDS if equal_chords else 0, params.ctypes.data, ctypes.byref(size)))
    return Division(params, size.value)


def moments(spline, relative_tolerance=0.0):
    """Of a spline itself: a wire, a sheet or a body."""
    dim = spline.dimension
    content, error = ctypes.c_double(), ctypes.c_double()
    centroid, inertia = numpy.empty(dim), numpy.empty((dim, dim))
    check(lib.nurbs_moments(spline._handle, relative_tolerance, ctypes.byref(content), centroid.ctypes.data,
                            inertia.ctypes.data, ctypes.byref(error)))
    return Moments(content.value, centroid, inertia, error.value)


def _handles(splines):
    return (ctypes.c_void_p * len(splines))(*(spline._handle for spline in splines))


def enclosed_area(curves, tolerance=0.0, relative_tolerance=0.0):
    """What closed chains of curves in the plane enclose; counterclockwise counts positive."""
    curves = list(curves)  # alive until the call is over
    area, error = ctypes.c_double(), ctypes.c_double()
    centroid, inertia = numpy.empty(2), numpy.empty((2, 2))
    check(lib.nurbs_enclosed_area(len(curves), _handles(curves), tolerance, relative_tolerance, ctypes.byref(area),
                                  centroid.ctypes.data, inertia.ctypes.data, ctypes.byref(error)))
    return EnclosedArea(area.value, centroid, inertia, error.value)


def enclosed_volume(surfaces, relative_tolerance=0.0):
    """What surfaces enclose whose normals point outwards."""
    surfaces = list(surfaces)
    volume, openness, error = ctypes.c_double(), ctypes.c_double(), ctypes.c_double()
    centroid, inertia = numpy.empty(3), numpy.empty((3, 3))
    check(lib.nurbs_enclosed_volume(len(surfaces), _handles(surfaces), relative_tolerance, ctypes.byref(volume),
                                    centroid.ctypes.data, inertia.ctypes.data, ctypes.byref(openness),
                                    ctypes.byref(error)))
    return EnclosedVolume(volume.value, centroid, inertia, openness.value, error.value)
