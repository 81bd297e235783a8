# SPDX-License-Identifier: MIT
"""Surfaces and volumes from curves.

`center`, `axis` and `x` place a shape in space; without them it stands at the origin, its axis along z. Angles are in
radians, and shapes of revolution turn fully unless told otherwise.
"""

import ctypes

import numpy

from ._arrays import records
from ._library import get, lib
from ._placement import FULL_TURN, Vectors, space
from .constants import NURBS_ARC_QUARTERS, NURBS_HEMISPHERE, NURBS_RULED_CARTESIAN, NURBS_TWO_SHEETS
from .files import SplineList
from .spline import Spline


def _placed(function, center, axis, x, *arguments):
    where, _alive = space(center, axis, x)
    return Spline._made(function, *where, *arguments)


def extrude(spline, vector):
    """A curve or surface moved along a vector, which becomes a new last axis over [0, 1]."""
    given = Vectors(vector)
    if given.dim != spline.dimension:
        raise ValueError(f"a vector of {given.dim} for a spline of dimension {spline.dimension}")
    return Spline._made(lib.nurbs_extrude, spline._handle, *given.addresses)


def revolve(spline, sweep=FULL_TURN, point=None, axis=None, form=NURBS_ARC_QUARTERS):
    """A curve or surface turned about an axis through a point, the angle being a new axis 0 over [0, 1]."""
    given = Vectors(point, axis, otherwise=3)
    if given.dim != 3:
        raise ValueError(f"an axis of revolution of dimension {given.dim}")
    return Spline._made(lib.nurbs_revolve, spline._handle, *given.addresses, sweep, form)


def ruled(a, b, *, cartesian=False):
    """Straight lines from a to b, a new last axis over [0, 1]; cartesian ones are divided evenly."""
    return Spline._made(lib.nurbs_ruled, a._handle, b._handle, NURBS_RULED_CARTESIAN if cartesian else 0)


def tensor_sum(a, b, alpha=1.0, beta=1.0):
    """The translational sweep alpha a(u) + beta b(v)."""
    return Spline._made(lib.nurbs_tensor_sum, a._handle, alpha, b._handle, beta)


def tensor_product(a, b):
    """The product a(u) b(v), component by component."""
    return Spline._made(lib.nurbs_tensor_product, a._handle, b._handle)


def swung(trajectory, profile, scale=1.0):
    """(scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and the profile (r, z)."""
    return Spline._made(lib.nurbs_surface_swung, trajectory._handle, profile._handle, scale)


def plane(u, v, origin=None):
    """The parallelogram with two sides from an origin."""
    given = Vectors(origin, u, v)
    return Spline._made(lib.nurbs_surface_plane, given.dim, *given.addresses)


def _corners(function, corners, axes):
    array = numpy.asarray(corners, dtype=numpy.float64)
    if array.shape[:-1] not in ((2**axes,), (2,) * axes):
        raise ValueError(f"corners of shape {array.shape}, expected {(2,) * axes} and the dimension")
    return Spline._made(function, array.shape[-1], *records(array, array.shape[-1]).layout)


def bilinear(corners):
    """The bilinear patch over corners (2, 2, dim), or (4, dim)."""
    return _corners(lib.nurbs_surface_bilinear, corners, 2)


def trilinear(corners):
    """The trilinear volume over corners (2, 2, 2, dim), or (8, dim)."""
    return _corners(lib.nurbs_volume_trilinear, corners, 3)


def sphere(radius=1.0, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """The sphere by longitude and latitude, with poles."""
    return _placed(lib.nurbs_surface_sphere, center, axis, x, radius, form)


def spherical_patch(radius, start, sweep, south, north, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """A patch between two meridians and two circles of latitude."""
    return _placed(lib.nurbs_surface_spherical_patch, center, axis, x, radius, start, sweep, south, north, form)


def sphere_patches(radius=1.0, center=None, axis=None, x=None, hemisphere=False):
    """The sphere without poles: six patches of degree 4 x 4, or five for the half towards the axis; a SplineList."""
    where, _alive = space(center, axis, x)
    made = get(ctypes.c_void_p, lib.nurbs_surface_sphere_patches, *where, radius, NURBS_HEMISPHERE if hemisphere else 0)
    return SplineList(made)


def ellipsoid(radius_x, radius_y, radius_z, center=None, axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """The ellipsoid with three semi-axes, parametrized as the sphere."""
    return _placed(lib.nurbs_surface_ellipsoid, center, axis, x, radius_x, radius_y, radius_z, form)


def cylinder(radius=1.0, height=1.0, start=0.0, sweep=FULL_TURN, center=None, axis=None, x=None,
             form=NURBS_ARC_QUARTERS):
    """A circular cylinder, the centre being that of its base."""
    return _placed(lib.nurbs_surface_cylinder, center, axis, x, radius, height, start, sweep, form)


def cone(base_radius=1.0, top_radius=0.0, height=1.0, start=0.0, sweep=FULL_TURN, center=None, axis=None, x=None,
         form=NURBS_ARC_QUARTERS):
    """A circular cone or its frustum, the centre being that of its base."""
    return _placed(lib.nurbs_surface_cone, center, axis, x, base_radius, top_radius, height, start, sweep, form)


def torus(major_radius, minor_radius, start=0.0, sweep=FULL_TURN, tube_start=0.0, tube_sweep=FULL_TURN, center=None,
          axis=None, x=None, form=NURBS_ARC_QUARTERS):
    """A torus."""
    return _placed(lib.nurbs_surface_torus, center, axis, x, major_radius, minor_radius, start, sweep, tube_start,
                   tube_sweep, form)


def paraboloid(radius_x=1.0, radius_y=1.0, height=1.0, start=0.0, sweep=FULL_TURN, vertex=None, axis=None, x=None,
               form=NURBS_ARC_QUARTERS):
    """A bowl from its vertex to a rim with two semi-axes."""
    return _placed(lib.nurbs_surface_paraboloid, vertex, axis, x, radius_x, radius_y, height, start, sweep, form)


def saddle(radius_x=1.0, radius_y=1.0, height=1.0, center=None, axis=None, x=None):
    """The hyperbolic paraboloid over a rectangle."""
    return _placed(lib.nurbs_surface_saddle, center, axis, x, radius_x, radius_y, height)


def hyperboloid(radius_x, radius_y, radius_z, bottom, top, start=0.0, sweep=FULL_TURN, center=None, axis=None, x=None,
                form=NURBS_ARC_QUARTERS, two_sheets=False):
    """A band of a hyperboloid of one sheet, or of two, between two heights."""
    return _placed(lib.nurbs_surface_hyperboloid, center, axis, x, radius_x, radius_y, radius_z, bottom, top, start,
                   sweep, form, NURBS_TWO_SHEETS if two_sheets else 0)
