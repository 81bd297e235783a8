# SPDX-License-Identifier: MIT
"""Where shapes meet; every answer says whether it is complete."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy

from ._arrays import address, exactly, if_given, parameters, vector
from ._base import SplineBase, handle_of
from ._calls import listed, watched
from ._library import call, lib

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s
    from ._calls import Progress
    from ._meets import Meet

__all__ = ["CommonPoints", "Hits", "PairHits", "RayHits", "Rays", "SurfaceHits"]


class Hits(NamedTuple):
    """Parameters (n,) in rising order, a NURBS_HIT_ constant each, ranges (n, 2) of parameters outside of which there is no
    solution, and whether none of them is undecided."""

    params: Floats
    kinds: Int32s
    ranges: Floats
    complete: bool


class PairHits(NamedTuple):
    """Parameters (n,) on both curves, rising on the first one, a NURBS_HIT_ constant each, ranges (n, 2) of parameters of
    both (falling, where an overlap runs against the second one), and whether nothing is undecided."""

    params_a: Floats
    params_b: Floats
    kinds: Int32s
    ranges_a: Floats
    ranges_b: Floats
    complete: bool


class SurfaceHits(NamedTuple):
    """Parameters (n,) on a curve, rising, and (n, 2) on a surface, a NURBS_HIT_ constant each, ranges (n, 2) of parameters of
    the curve and (n, 2, 2) of both axes of the surface, and whether nothing is undecided."""

    params_curve: Floats
    params_surface: Floats
    kinds: Int32s
    ranges_curve: Floats
    ranges_surface: Floats
    complete: bool


class CommonPoints(NamedTuple):
    """Parameters (n, 3, 2) on three surfaces, points (n, 3), NURBS_HIT_CROSSING or NURBS_HIT_UNDECIDED each, ranges
    (n, 3, 2, 2) of parameters, and whether nothing is undecided."""

    params: Floats
    points: Floats
    kinds: Int32s
    ranges: Floats
    complete: bool


class Rays(NamedTuple):
    """Parameters (..., 2) of a surface where rays meet it first, t (...), and NURBS_RAY_ bits (...)."""

    params: Floats
    distances: Floats
    status: Int32s


class RayHits(NamedTuple):
    """Parameters (n, 2) of a surface where a ray meets it, t (n,) rising, NURBS_RAY_ bits, and whether these are all."""

    params: Floats
    distances: Floats
    kinds: Int32s
    complete: bool


def _arrays(n: int) -> Tuple[Any, ...]:
    return numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty((n, 2))


def _pair_arrays(n: int) -> Tuple[Any, ...]:
    return numpy.empty(n), numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty((n, 2)), numpy.empty((n, 2))


def _surface_arrays(n: int) -> Tuple[Any, ...]:
    return (numpy.empty(n), numpy.empty((n, 2)), numpy.empty(n, numpy.int32), numpy.empty((n, 2)),
            numpy.empty((n, 2, 2)))


def _common_arrays(n: int) -> Tuple[Any, ...]:
    return numpy.empty((n, 3, 2)), numpy.empty((n, 3)), numpy.empty(n, numpy.int32), numpy.empty((n, 3, 2, 2))


def cast(function: Any, handle: Any, origins: ArrayLike, directions: ArrayLike) -> Rays:
    """The rays of a surface or a face."""
    starts, ways = numpy.broadcast_arrays(numpy.asarray(origins, float), numpy.asarray(directions, float))
    (given, batch), (along, _) = parameters(starts, 3), parameters(ways, 3)
    params, distances, status = numpy.empty((*batch, 2)), numpy.empty(batch), numpy.empty(batch, numpy.int32)
    call(function, handle, given.n, *given.layout, *along.layout, params.ctypes.data, distances.ctypes.data,
         status.ctypes.data)
    return Rays(params, distances, status)


class Intersections(SplineBase):
    """Where the shape meets others."""

    def roots(self, value: float = 0.0, tolerance: float = 0.0, *, progress: Progress = None,
              work: Optional[int] = None) -> Hits:
        """Where a scalar curve has a value, with proof that there are no other places."""
        return listed(Hits, _arrays, watched(lib.nurbs_roots, progress, work, 2), self._handle, value, tolerance)

    def curve_level(self, degree: int, coefficients: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                    work: Optional[int] = None) -> Hits:
        """Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree is 0.
        Its coefficients are those of the products x_i x_j ... of `degree` factors with i <= j <= ..., in lexicographic
        order, where x_dim stands for 1: of a line (a, b, c), of a plane (a, b, c, d), of a conic those of xx, xy, x, yy,
        y and 1."""
        given = exactly(coefficients, math.comb(self.dimension + max(degree, 0), max(degree, 0)), "coefficients")
        return listed(Hits, _arrays, watched(lib.nurbs_curve_level, progress, work, 2), self._handle, degree,
                      given.ctypes.data, tolerance)

    def curve_intersections(self, other: SplineBase, tolerance: float = 0.0, *, progress: Progress = None,
                            work: Optional[int] = None) -> PairHits:
        """Where two curves meet, with proof that there are no other places."""
        return listed(PairHits, _pair_arrays, watched(lib.nurbs_curve_intersections, progress, work, 2), self._handle,
                      handle_of(other), tolerance)

    def self_intersections(self, tolerance: float = 0.0, *, progress: Progress = None,
                           work: Optional[int] = None) -> PairHits:
        """Where a curve meets itself, with proof that there are no other places."""
        return listed(PairHits, _pair_arrays, watched(lib.nurbs_curve_self_intersections, progress, work, 2),
                      self._handle, tolerance)

    def surface_intersections(self, surface: SplineBase, tolerance: float = 0.0, *, progress: Progress = None,
                              work: Optional[int] = None) -> SurfaceHits:
        """Where a curve meets a surface, with proof that there are no other places."""
        return listed(SurfaceHits, _surface_arrays, watched(lib.nurbs_curve_surface_intersections, progress, work, 2),
                      self._handle, handle_of(surface), tolerance)

    def common_points(self, b: SplineBase, c: SplineBase, tolerance: float = 0.0, *, progress: Progress = None,
                      work: Optional[int] = None) -> CommonPoints:
        """The points that three surfaces have in common, with proof that there are no others."""
        return listed(CommonPoints, _common_arrays, watched(lib.nurbs_surfaces_common_points, progress, work, 2),
                      self._handle, handle_of(b), handle_of(c), tolerance)

    def rays(self, origins: ArrayLike, directions: ArrayLike, *, progress: Progress = None,
             work: Optional[int] = None) -> Rays:
        """Where rays origin + t direction, t >= 0, arrays (..., 3), meet a surface first, with proof. One origin or
        direction serves all."""
        return cast(watched(lib.nurbs_surface_rays, progress, work), self._handle, origins, directions)

    def ray_hits(self, origin: ArrayLike, direction: ArrayLike, part: Optional[ArrayLike] = None) -> RayHits:
        """All places where a ray meets a surface, by rising t."""
        start, way = exactly(origin, 3, "origin"), exactly(direction, 3, "direction")
        limits = if_given(part, 2, "part")

        def arrays(n: int) -> Tuple[Any, ...]:
            return numpy.empty((n, 2)), numpy.empty(n), numpy.empty(n, numpy.int32)

        return listed(RayHits, arrays, lib.nurbs_surface_ray_hits, self._handle, start.ctypes.data, way.ctypes.data,
                      address(limits))

    def sections(self, normal: ArrayLike, offsets: ArrayLike, tolerance: float, *, progress: Progress = None,
                 work: Optional[int] = None) -> Meet:
        """Where planes normal . x = offset cut a surface, one offset or an array (n,): all curves to within a tolerance,
        with proof that there are no others."""
        from ._meets import Meet  # which holds splines, and so cannot come before them

        across, planes = exactly(normal, 3, "normal"), vector(offsets)
        return Meet._made(watched(lib.nurbs_surface_sections, progress, work), self._handle, across.ctypes.data,
                          planes.size, planes.ctypes.data, tolerance)

    def contours(self, kind: int, d: Optional[ArrayLike] = None, cosines: ArrayLike = (), *, tolerance: float,
                 progress: Progress = None, work: Optional[int] = None) -> Meet:
        """Contours of a NURBS_CONTOUR_ kind of a surface, with proof that there are no others: silhouettes along a
        direction `d` (3,) or seen from the point `d`, isophotes of cosines (n,) of the angle to `d`, parabolic curves."""
        from ._meets import Meet

        way, all_cosines = if_given(d, 3, "d"), vector(cosines)
        return Meet._made(watched(lib.nurbs_surface_contours, progress, work), self._handle, kind, address(way),
                          all_cosines.size, all_cosines.ctypes.data, tolerance)

    def reflections(self, kind: int, direction: ArrayLike, points: ArrayLike, eye: Optional[ArrayLike] = None, *,
                    tolerance: float, progress: Progress = None, work: Optional[int] = None) -> Meet:
        """Lines of light through points (n, 3) along a direction (3,) that a surface mirrors, with proof that there are no
        others: of a NURBS_REFLECTION_ kind, seen along the direction `eye` (3,) or from the point `eye`, or where normals
        meet the lines (highlight lines, circular silhouettes)."""
        from ._meets import Meet

        seen, way, (lights, _) = if_given(eye, 3, "eye"), exactly(direction, 3, "direction"), parameters(points, 3)
        return Meet._made(watched(lib.nurbs_surface_reflections, progress, work), self._handle, kind, address(seen),
                          way.ctypes.data, lights.n, *lights.layout, tolerance)

    def surface_level(self, degree: int, coefficients: ArrayLike, tolerance: float, *, progress: Progress = None,
                      work: Optional[int] = None) -> Meet:
        """Where an implicit polynomial of space, of a degree and with the coefficients of Spline.curve_level(), vanishes on a
        surface, with proof that it does nowhere else."""
        from ._meets import Meet

        given = exactly(coefficients, math.comb(self.dimension + max(degree, 0), max(degree, 0)), "coefficients")
        return Meet._made(watched(lib.nurbs_surface_level, progress, work), self._handle, degree, given.ctypes.data,
                          tolerance)

    def level_curves(self, scalar: SplineBase, values: ArrayLike, tolerance: float, *, progress: Progress = None,
                     work: Optional[int] = None) -> Meet:
        """Where a scalar spline over the domain of a surface has values (n,), with proof that it has them nowhere else."""
        from ._meets import Meet

        levels = vector(values)
        return Meet._made(watched(lib.nurbs_surface_level_curves, progress, work), self._handle, handle_of(scalar),
                          levels.size, levels.ctypes.data, tolerance)

    def meet(self, other: SplineBase, tolerance: float, *, progress: Progress = None,
             work: Optional[int] = None) -> Meet:
        """Where two surfaces meet in curves, with proof that there are no others: Meet.branch() has curves in the domain of
        this one, Meet.branch_second() in that of the other one."""
        from ._meets import Meet

        return Meet._made(watched(lib.nurbs_surface_intersections, progress, work), self._handle, handle_of(other),
                          tolerance)

    def meet_itself(self, tolerance: float, *, progress: Progress = None, work: Optional[int] = None) -> Meet:
        """Where a surface meets itself in curves, with proof that there are no others: with `complete` and no branches and nodes it
        is proven to be simple. Meet.branch() and Meet.branch_second() have both curves in its domain."""
        from ._meets import Meet

        return Meet._made(watched(lib.nurbs_surface_self_intersections, progress, work), self._handle, tolerance)

    def project_curve(self, curve: SplineBase, direction: Optional[ArrayLike], tolerance: float, *,
                      progress: Progress = None, work: Optional[int] = None) -> Meet:
        """A curve projected onto a surface along a direction (3,) or, with None, normally, to all orthogonal feet: all curves
        on it, with proof that there are no others. On each branch the parameter t of the curve rises: Meet.branch_second() has
        (t, distance along the direction, or along the normal of the surface)."""
        from ._meets import Meet

        along = if_given(direction, 3, "direction")
        return Meet._made(watched(lib.nurbs_surface_project_curve, progress, work), self._handle, handle_of(curve),
                          address(along), tolerance)
