# SPDX-License-Identifier: MIT
"""Surfaces and volumes: planes, quadrics and tori.

`center`, `axis` and `x` (3,) place a shape in space; without them it stands at the origin, its axis along z. Angles are
in radians, and shapes of revolution turn fully unless told otherwise. `form` is a NURBS_ARC_ constant.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy

from ._arrays import records
from ._library import lib
from ._placement import FULL_TURN, Vectors, space
from .constants import NURBS_ARC_QUARTERS, NURBS_HEMISPHERE, NURBS_TWO_SHEETS
from ._files import SplineList
from ._spline import Spline

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["plane", "bilinear", "trilinear", "sphere", "spherical_patch", "sphere_patches", "ellipsoid", "cylinder",
           "cone", "torus", "paraboloid", "saddle", "hyperboloid"]


def _placed(function: Any, center: Optional[ArrayLike], axis: Optional[ArrayLike], x: Optional[ArrayLike],
            *arguments: Any) -> Spline:
    where, _alive = space(center, axis, x)
    return Spline._made(function, *where, *arguments)


def plane(u: ArrayLike, v: ArrayLike, origin: Optional[ArrayLike] = None) -> Spline:
    """The parallelogram origin + s u + t v; vectors of any dimension."""
    given = Vectors(origin, u, v)
    return Spline._made(lib.nurbs_surface_plane, given.dim, *given.addresses)


def _corners(function: Any, corners: ArrayLike, axes: int) -> Spline:
    array = numpy.asarray(corners, dtype=numpy.float64)
    if array.shape[:-1] not in ((2**axes,), (2,) * axes):
        raise ValueError(f"corners of shape {array.shape}, expected {(2,) * axes} and the dimension")
    given = records(array, array.shape[-1])
    return Spline._made(function, array.shape[-1], *given.layout)


def bilinear(corners: ArrayLike) -> Spline:
    """The bilinear patch over corners (2, 2, dimension), or (4, dimension), of degree 1."""
    return _corners(lib.nurbs_surface_bilinear, corners, 2)


def trilinear(corners: ArrayLike) -> Spline:
    """The trilinear volume over corners (2, 2, 2, dimension), or (8, dimension), of degree 1."""
    return _corners(lib.nurbs_volume_trilinear, corners, 3)


def sphere(radius: float = 1.0, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
           x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The sphere by longitude (axis 0) and latitude (axis 1), exact, with poles."""
    return _placed(lib.nurbs_surface_sphere, center, axis, x, radius, form)


def spherical_patch(radius: float, start: float, sweep: float, south: float, north: float,
                    center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
                    x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """A patch of a sphere from the longitude start to start + sweep, from the latitude south to north."""
    return _placed(lib.nurbs_surface_spherical_patch, center, axis, x, radius, start, sweep, south, north, form)


def sphere_patches(radius: float = 1.0, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
                   x: Optional[ArrayLike] = None, hemisphere: bool = False) -> SplineList:
    """The sphere without poles: six patches of degree 4 x 4, "+X" to "-Z", or five for the half towards the axis."""
    where, _alive = space(center, axis, x)
    return Spline._listed(lib.nurbs_surface_sphere_patches, *where, radius, NURBS_HEMISPHERE if hemisphere else 0)


def ellipsoid(radius_x: float, radius_y: float, radius_z: float, center: Optional[ArrayLike] = None,
              axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None,
              form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The ellipsoid with three semi-axes, parametrized as the sphere."""
    return _placed(lib.nurbs_surface_ellipsoid, center, axis, x, radius_x, radius_y, radius_z, form)


def cylinder(radius: float = 1.0, height: float = 1.0, start: float = 0.0, sweep: float = FULL_TURN,
             center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None,
             form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The circular cylinder center + radius (X cos a + Y sin a) + v height Z."""
    return _placed(lib.nurbs_surface_cylinder, center, axis, x, radius, height, start, sweep, form)


def cone(base_radius: float = 1.0, top_radius: float = 0.0, height: float = 1.0, start: float = 0.0,
         sweep: float = FULL_TURN, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
         x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """A circular cone or its frustum; the radius goes from base_radius at the centre to top_radius at the height."""
    return _placed(lib.nurbs_surface_cone, center, axis, x, base_radius, top_radius, height, start, sweep, form)


def torus(major_radius: float, minor_radius: float, start: float = 0.0, sweep: float = FULL_TURN,
          tube_start: float = 0.0, tube_sweep: float = FULL_TURN, center: Optional[ArrayLike] = None,
          axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The torus (R + r cos b) (X cos a + Y sin a) + r sin b Z about the centre; a is axis 0, b axis 1."""
    return _placed(lib.nurbs_surface_torus, center, axis, x, major_radius, minor_radius, start, sweep, tube_start,
                   tube_sweep, form)


def paraboloid(radius_x: float = 1.0, radius_y: float = 1.0, height: float = 1.0, start: float = 0.0,
               sweep: float = FULL_TURN, vertex: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
               x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS) -> Spline:
    """The bowl Z = height ((X / radius_x)^2 + (Y / radius_y)^2) from its vertex to the rim."""
    return _placed(lib.nurbs_surface_paraboloid, vertex, axis, x, radius_x, radius_y, height, start, sweep, form)


def saddle(radius_x: float = 1.0, radius_y: float = 1.0, height: float = 1.0, center: Optional[ArrayLike] = None,
           axis: Optional[ArrayLike] = None, x: Optional[ArrayLike] = None) -> Spline:
    """The saddle Z = height ((X / radius_x)^2 - (Y / radius_y)^2) over |X| <= radius_x, |Y| <= radius_y."""
    return _placed(lib.nurbs_surface_saddle, center, axis, x, radius_x, radius_y, height)


def hyperboloid(radius_x: float, radius_y: float, radius_z: float, bottom: float, top: float, start: float = 0.0,
                sweep: float = FULL_TURN, center: Optional[ArrayLike] = None, axis: Optional[ArrayLike] = None,
                x: Optional[ArrayLike] = None, form: int = NURBS_ARC_QUARTERS, two_sheets: bool = False) -> Spline:
    """The band of (X / radius_x)^2 + (Y / radius_y)^2 - (Z / radius_z)^2 = 1 from Z = bottom to Z = top, or of two
    sheets, where it is -1."""
    return _placed(lib.nurbs_surface_hyperboloid, center, axis, x, radius_x, radius_y, radius_z, bottom, top, start,
                   sweep, form, NURBS_TWO_SHEETS if two_sheets else 0)
