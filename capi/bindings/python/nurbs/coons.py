# SPDX-License-Identifier: MIT
"""Surfaces and volumes from their boundaries, which are counted by axis, then by end."""

import ctypes
from collections import namedtuple

import numpy

from ._arrays import vector
from ._library import check, get, lib
from .constants import NURBS_TWIST_AVERAGE, NURBS_TWIST_BILINEAR, NURBS_TWIST_GIVEN
from .files import SplineList
from .spline import Spline

HermiteCoons = namedtuple("HermiteCoons", "spline bound")
#: positions (4,), tangents (4, 2) by u and by v, twists (4,)
CoonsGaps = namedtuple("CoonsGaps", "positions tangents twists")


def _handles(splines, count):
    """`count` splines as an array of handles, which keeps them alive; None stays None."""
    if splines is None:
        return None
    splines = list(splines)
    if len(splines) != count:
        raise ValueError(f"{len(splines)} splines, expected {count}")
    handles = (ctypes.c_void_p * count)(*(spline._handle for spline in splines))
    handles.splines = splines
    return handles


def boundaries(spline):
    """The four curves of a surface, or the six faces of a volume: a SplineList."""
    return SplineList(get(ctypes.c_void_p, lib.nurbs_boundaries, spline._handle))


def coons(curves, tolerance=0.0):
    """The bilinear blend of four curves."""
    return Spline._made(lib.nurbs_surface_coons, _handles(curves, 4), tolerance)


def coons_hermite(curves, cross=None, twist=None, twists=None, tolerance=0.0):
    """The bicubic blend of four curves and, unless None, derivatives across them: (surface, bound).

    twist is a NURBS_TWIST_ constant. Left out it is NURBS_TWIST_GIVEN where twists (4, dim) are given, the average with
    cross tangents, and the bilinear one without.
    """
    if twist is None:
        twist = NURBS_TWIST_AVERAGE if cross is not None else NURBS_TWIST_BILINEAR
        twist = twist if twists is None else NURBS_TWIST_GIVEN
    curves = list(curves)
    given = None if twists is None else vector(twists, numpy.float64)
    if given is not None and curves and given.size != 4 * curves[0].dimension:
        raise ValueError(f"twists of {given.size} numbers, expected 4 vectors of {curves[0].dimension}")
    bound = ctypes.c_double()
    made = Spline._made(lib.nurbs_surface_coons_hermite, _handles(curves, 4), _handles(cross, 4), twist,
                        None if given is None else given.ctypes.data, tolerance, ctypes.byref(bound))
    return HermiteCoons(made, bound.value)


def coons_gaps(curves, cross=None):
    """What does not meet at the corners (u0, v0), (u0, v1), (u1, v0), (u1, v1)."""
    gaps = CoonsGaps(numpy.empty(4), numpy.empty((4, 2)), numpy.empty(4))
    check(lib.nurbs_coons_gaps(_handles(curves, 4), _handles(cross, 4), *(part.ctypes.data for part in gaps)))
    return gaps


def coons_volume(faces, tolerance=0.0):
    """The linear blend of six faces."""
    return Spline._made(lib.nurbs_volume_coons, _handles(faces, 6), tolerance)
