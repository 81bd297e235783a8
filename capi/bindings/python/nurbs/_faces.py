# SPDX-License-Identifier: MIT
"""Trimmed faces: the part of a surface that loops of curves bound."""

from __future__ import annotations

import ctypes
import math
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, List, NamedTuple, Optional, SupportsIndex, Tuple, Type
from typing import TypeVar, Union

import numpy

from ._arrays import address, addresses, exactly, if_given, parameters, vector
from ._base import handle_of
from ._bounds import Box
from ._bytes import given as given_bytes, pickled, written
from ._calls import watched
from ._closest import ClosestPoints, largest_distances, smallest_distance
from ._errors import NurbsError
from ._intersections import cast
from ._library import call, get, lib
from ._measure import Measured, Moments, Quadrature, moments_of
from ._meets import Meet
from ._mesh import Mesh
from ._plot import _COLOR, plot_mesh
from ._spline import Spline
from .constants import NURBS_AS_ORIENTED, NURBS_CHECK_CROSSINGS, NURBS_KEEP_GAPS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s
    from ._bytes import Contents
    from ._calls import Progress
    from ._closest import Distance, HausdorffDistance
    from ._intersections import Rays
    from ._meets import Meet
    from ._models import Model

    #: One curve that closes, or curves that follow one another; None where the other array has one.
    Loop = Union[Spline, Iterable[Optional[Spline]]]

__all__ = ["Face", "FaceDeviation", "FaceEdge"]

_Face = TypeVar("_Face", bound="Face")
_SMALL = 0.05  # sides of triangles that are drawn: what is smaller is sorted by its depth without faults


class FaceEdge(NamedTuple):
    """The curve in space that belongs to a curve of a loop, and its number, negative if it runs against the loop."""

    spline: Spline
    key: int


class FaceDeviation(NamedTuple):
    """How far a curve of a loop and its edge are apart, and whether that is a bound, not only the largest one seen."""

    distance: float
    proven: bool


def _handle_of(face: Face) -> Optional[int]:
    if not isinstance(face, Face):
        raise TypeError(f"a Face is expected, not {type(face).__name__}")
    return face._handle


def _listed(loops: Optional[Iterable[Any]]) -> Optional[List[List[Any]]]:
    """What is given for each loop as lists; one thing alone is that of a single curve."""
    if loops is None:
        return None
    return [list(loop) if isinstance(loop, Iterable) else [loop] for loop in loops]


def _flat(name: str, loops: Optional[List[List[Any]]], sizes: List[int]) -> Optional[List[Any]]:
    """What is given for the curves, one loop after the other; the loops have these sizes."""
    if loops is None:
        return None
    if [len(loop) for loop in loops] != sizes:
        raise ValueError(f"{name} of {[len(loop) for loop in loops]} curves, expected {sizes}")
    return [item for loop in loops for item in loop]


def _some_handles(name: str, splines: Optional[Iterable[Optional[Spline]]], count: int) -> Any:
    """Handles of splines of which some may be missing, or None."""
    if splines is None:
        return None
    given = list(splines)
    if len(given) != count:
        raise ValueError(f"{name} of {len(given)} splines, expected {count}, the sum of the sizes")
    array: Any = (ctypes.c_void_p * count)(*(None if spline is None else handle_of(spline) for spline in given))
    array.splines = given  # kept alive
    return array


class Face:
    """A trimmed face: the part of a surface that lies to the left of loops of curves in its domain.

        face = nurbs.Face(surface, [outline, hole], tolerance=1e-6)        # of closed curves
        face = nurbs.Face(surface, [[south, east, north, west]], tolerance=1e-6)
        face.area().value, face.classify([0.5, 0.5]), face.box(1e-6)

    Which loops are outer ones, and which are holes, is found by which loops lie in which. Faces never change, and many
    threads may use them at once; copies are made in constant time.
    """

    _handle: Optional[int] = None
    _gaps: Optional[Floats] = None

    def __init__(self, surface: Spline, loops: Optional[Iterable[Loop]] = (), *,
                 edges: Optional[Iterable[Loop]] = None, keys: Optional[Iterable[Union[int, Iterable[int]]]] = None,
                 tolerance: float = 0.0, as_oriented: bool = False, keep_gaps: bool = False,
                 check_crossings: bool = False, progress: Progress = None, work: Optional[int] = None) -> None:
        """Of loops of curves in the domain, each a list, or a curve that closes; without loops the whole surface.
        `edges` are their curves in space, in lists as long; where a curve is None, or loops is, it is made under its
        edge. `keys` are numbers of edges, the same in all faces that share one, negative against the loop; 0 is none.
        `tolerance` is the largest distance in space that counts as none. With as_oriented the inside is to the left of
        the loops as they run, with keep_gaps larger gaps are closed by segments, too, with check_crossings loops that
        cross themselves or each other are refused. Raises ArgumentError, of NURBS_ERROR_GAP with `gaps` (loops,)."""
        if self._handle:
            raise TypeError("a Face does not change: it cannot be initialised again")
        of_curves, of_edges = _listed(loops), _listed(edges)
        sizes = [len(loop) for loop in of_curves or of_edges or ()]
        flags = (NURBS_AS_ORIENTED * bool(as_oriented) | NURBS_KEEP_GAPS * bool(keep_gaps) |
                 NURBS_CHECK_CROSSINGS * bool(check_crossings))
        made = self.create(surface, sizes, _flat("loops", of_curves or None, sizes), _flat("edges", of_edges, sizes),
                           _flat("keys", _listed(keys), sizes), tolerance, flags, progress=progress, work=work)
        # The handle goes from one owner to the other.
        self.__dict__["_gaps"], self.__dict__["_handle"] = made._gaps, made.__dict__.pop("_handle")

    @classmethod
    def create(cls, surface: Spline, sizes: ArrayLike, curves: Optional[Iterable[Optional[Spline]]] = None,
               edges: Optional[Iterable[Optional[Spline]]] = None, keys: Optional[ArrayLike] = None,
               tolerance: float = 0.0, flags: int = 0, *, progress: Progress = None,
               work: Optional[int] = None) -> Face:
        """The same of one list of curves: `sizes` are the numbers of curves of the loops, `flags` NURBS_AS_ORIENTED,
        NURBS_CHECK_CROSSINGS and NURBS_KEEP_GAPS."""
        counts = vector(sizes, numpy.int64)
        total = int(counts.clip(0).sum())
        numbers, gaps = if_given(keys, total, "keys", numpy.int64), numpy.full(counts.size, numpy.nan)
        try:
            face = cls._made(watched(lib.nurbs_face_create, progress, work), handle_of(surface), counts.size,
                             counts.ctypes.data, _some_handles("curves", curves, total),
                             _some_handles("edges", edges, total), address(numbers), tolerance, flags, gaps.ctypes.data)
        except NurbsError as error:
            error.gaps = gaps  # type: ignore[attr-defined]
            raise
        face.__dict__["_gaps"] = gaps
        return face

    @classmethod
    def _made(cls: Type[_Face], function: Any, *arguments: Any) -> _Face:
        """The face that a function writes through its last argument."""
        face, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            face.__dict__["_handle"] = handle.value
        return face

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Face does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Face does not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_face_destroy(handle)

    def copy(self: _Face) -> _Face:
        """Another handle on the same face, in constant time; copy.copy() and copy.deepcopy() do the same."""
        face = self._made(lib.nurbs_face_clone, self._handle)
        face.__dict__.update((name, value) for name, value in self.__dict__.items() if name != "_handle")
        return face

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Face:
        return self.copy()

    def to_bytes(self) -> bytes:
        """The face as bytes, to be kept or sent: the same on every machine for the same face."""
        return written(lib.nurbs_face_to_bytes, self._handle).tobytes()

    @classmethod
    def from_bytes(cls: Type[_Face], contents: Contents) -> _Face:
        """The face of what to_bytes() gave. Raises ContentsError for other bytes."""
        given = given_bytes(contents)
        return cls._made(lib.nurbs_face_from_bytes, given.ctypes.data, given.size)

    def __reduce_ex__(self, protocol: SupportsIndex) -> Tuple[Callable[..., Face], Tuple[Any, ...], Dict[str, Any]]:
        known = {name: value for name, value in self.__dict__.items() if name != "_handle"}
        return _restored_face, (type(self), pickled(lib.nurbs_face_to_bytes, self._handle, protocol)), known

    def __repr__(self) -> str:
        sizes = self.loops
        return f"<Face of {len(sizes)} {'loop' if len(sizes) == 1 else 'loops'} with {sum(sizes)} curves>"

    # --- What it is made of ---

    @property
    def surface(self) -> Spline:
        """Its surface."""
        return Spline._made(lib.nurbs_face_surface, self._handle)

    @property
    def loops(self) -> Tuple[int, ...]:
        """The number of curves of each loop."""
        sizes = numpy.empty(get(ctypes.c_int64, lib.nurbs_face_loops, self._handle, 0, None), numpy.int64)
        get(ctypes.c_int64, lib.nurbs_face_loops, self._handle, sizes.size, sizes.ctypes.data)
        return tuple(sizes.tolist())

    @property
    def curves(self) -> List[List[Spline]]:
        """The curves of each loop, as curve() gives them."""
        return [[self.curve(loop, index) for index in range(size)] for loop, size in enumerate(self.loops)]

    @property
    def gaps(self) -> Floats:
        """The largest distance in space of two ends that are to meet, for each loop as it was given (loops,)."""
        return numpy.empty(0) if self._gaps is None else self._gaps.copy()

    @property
    def tolerance(self) -> float:
        """The tolerance that it was created with."""
        return float(get(ctypes.c_double, lib.nurbs_face_tolerance, self._handle))

    def curve(self, loop: int, index: int) -> Spline:
        """A curve of a loop in the domain of the surface, as it runs with the inside to its left."""
        return Spline._made(lib.nurbs_face_curve, self._handle, loop, index)

    def edge(self, loop: int, index: int) -> FaceEdge:
        """The edge in space that belongs to a curve of a loop: the one that was given, or one that is made."""
        key = ctypes.c_int64()
        return FaceEdge(Spline._made(lib.nurbs_face_edge, self._handle, loop, index, ctypes.byref(key)), key.value)

    def deviation(self, loop: int, index: int) -> FaceDeviation:
        """How far a curve of a loop, mapped by the surface, and its edge are apart."""
        distance = ctypes.c_double()
        proven = get(ctypes.c_int32, lib.nurbs_face_deviation, self._handle, loop, index, ctypes.byref(distance))
        return FaceDeviation(distance.value, bool(proven))

    # --- What it is ---

    def classify(self, params: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                 work: Optional[int] = None) -> Int32s:
        """On which side of the boundary parameters (..., 2) lie: 1 inside, 0 within `tolerance` of the boundary, -1
        outside."""
        given, batch = parameters(params, 2)
        sides = numpy.empty(batch, numpy.int32)
        call(watched(lib.nurbs_face_classify, progress, work), self._handle, given.n, *given.layout, tolerance,
             sides.ctypes.data)
        return sides

    def rays(self, origins: ArrayLike, directions: ArrayLike, *, progress: Progress = None,
             work: Optional[int] = None) -> Rays:
        """Where rays origin + t direction, t >= 0, arrays (..., 3), meet it first, with proof. One origin or direction
        serves all."""
        return cast(watched(lib.nurbs_face_rays, progress, work), self._handle, origins, directions)

    def closest_points(self, points: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                       work: Optional[int] = None) -> ClosestPoints:
        """Its points that are nearest to points (..., dimension), with proof that none is nearer by more than
        `tolerance`."""
        dim = self.surface.dimension
        given, batch = parameters(points, dim)
        params, feet, distances = numpy.empty((*batch, 2)), numpy.empty((*batch, dim)), numpy.empty(batch)
        status = numpy.empty(batch, numpy.int32)
        call(watched(lib.nurbs_face_closest_points, progress, work), self._handle, given.n, *given.layout, tolerance,
             params.ctypes.data, feet.ctypes.data, distances.ctypes.data, status.ctypes.data)
        return ClosestPoints(params, feet, distances, status)

    def distance(self, other: Face, tolerance: float = 0.0, *, progress: Progress = None,
                 work: Optional[int] = None) -> Distance:
        """The smallest distance from another face, enclosed to the tolerance."""
        return smallest_distance(watched(lib.nurbs_face_distance, progress, work),
                                 (self._handle, _handle_of(other), tolerance), 2, 2)

    def hausdorff_distance(self, other: Face, tolerance: float, *, progress: Progress = None,
                           work: Optional[int] = None) -> HausdorffDistance:
        """How far the point of this face that is farthest from another one is from it, and the other way round, enclosed
        to the tolerance."""
        return largest_distances(watched(lib.nurbs_face_hausdorff_distance, progress, work),
                                 (self._handle, _handle_of(other), tolerance), 2, 2)

    def meet(self, other: Face, tolerance: float, *, progress: Progress = None, work: Optional[int] = None) -> Meet:
        """Where two faces meet: in the edges that they share, and in curves inside of both. Meet.branch() has curves in the
        domain of this one, Meet.branch_second() in that of the other one, Meet.kinds tells edges."""
        from ._meets import Meet

        return Meet._made(watched(lib.nurbs_face_intersections, progress, work), self._handle, _handle_of(other),
                          tolerance)

    def split(self, curves: Iterable[Spline], tolerance: float = 0.0, *, progress: Progress = None,
              work: Optional[int] = None) -> Model:
        """The parts that curves in the domain of the surface divide it into, as a model: they share edges. Raises
        ArgumentError, and NumericError where rounding would have to decide what meets."""
        from ._models import Model  # which is made of faces
        return Model.split(self, curves, tolerance, progress=progress, work=work)

    def project_curve(self, curve: Spline, direction: Optional[ArrayLike], tolerance: float, *,
                      progress: Progress = None, work: Optional[int] = None) -> Meet:
        """A curve projected onto the face along a direction (3,) or, with None, normally: what of Spline.project_curve() on its
        surface is inside of its loops."""
        along = if_given(direction, 3, "direction")
        return Meet._made(watched(lib.nurbs_face_project_curve, progress, work), self._handle, handle_of(curve),
                          address(along), tolerance)

    def trim(self, surface: Spline, side: int, tolerance: float, *, progress: Progress = None,
             work: Optional[int] = None) -> Model:
        """What of the face lies on one side of a surface, which divides it where both meet, as a model; side is one of
        the NURBS_TRIM_ constants. Raises ArgumentError, also where the surface ends inside of the face, and NumericError
        where it is undecided how both meet."""
        from ._models import Model  # which is made of faces
        return Model.trim(self, surface, side, tolerance, progress=progress, work=work)

    def area(self, relative_tolerance: float = 0.0, *, progress: Progress = None,
             work: Optional[int] = None) -> Measured:
        """Its area; a tolerance of 0 asks for the best that there is."""
        area = ctypes.c_double()
        error = get(ctypes.c_double, watched(lib.nurbs_face_area, progress, work), self._handle, relative_tolerance,
                    ctypes.byref(area))
        return Measured(area.value, error)

    def moments(self, relative_tolerance: float = 0.0, *, progress: Progress = None,
                work: Optional[int] = None) -> Moments:
        """Area, centroid and inertia, as those of a surface."""
        content, error = ctypes.c_double(), ctypes.c_double()
        centroid, inertia = moments_of(self.surface.dimension, watched(lib.nurbs_face_moments, progress, work),
                                       (self._handle, relative_tolerance, ctypes.byref(content)), (ctypes.byref(error),))
        return Moments(content.value, centroid, inertia, error.value)

    def quadrature(self, nodes: int = 0, *, progress: Progress = None, work: Optional[int] = None) -> Quadrature:
        """Points and weights for integrals of any function over it: rules of Gauss on cells, of so many nodes along each axis,
        0 for one more than the degree. The sum of measures * f(points) is that over the face."""
        function = watched(lib.nurbs_face_quadrature, progress, work)
        n = get(ctypes.c_int64, function, self._handle, nodes, 0, None, None, None)
        found = Quadrature(numpy.empty((n, 2)), numpy.empty(n), numpy.empty(n))
        get(ctypes.c_int64, function, self._handle, nodes, n, *addresses(*found))
        return found

    def box(self, tolerance: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> Box:
        """An axis-aligned box that contains it; no side is farther from it than the tolerance."""
        lower, upper = numpy.empty(self.surface.dimension), numpy.empty(self.surface.dimension)
        gap = get(ctypes.c_double, watched(lib.nurbs_face_box, progress, work), self._handle, tolerance,
                  lower.ctypes.data, upper.ctypes.data)
        return Box(lower, upper, gap)

    def mesh(self, chord: float = math.inf, relative: float = 1e-3, longest: float = 0.0, angle: float = 0.0,
             minimum_angle: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> Mesh:
        """Triangles in place of it; the limits are those of Spline.mesh()."""
        return Mesh._of(watched(lib.nurbs_mesh_face, progress, work), self._handle, chord, relative, longest, angle,
                        minimum_angle)

    def mesh_levels(self, chords: ArrayLike, longest: float = 0.0, angle: float = 0.0, minimum_angle: float = 0.0, *,
                    progress: Progress = None, work: Optional[int] = None) -> List[Mesh]:
        """A mesh for each of the distances, in their order: each as mesh(chord, relative=0, ...) makes it."""
        return Mesh._levels(watched(lib.nurbs_mesh_face_levels, progress, work), self._handle, chords, longest, angle,
                            minimum_angle)

    def plot(self, ax: Any = None, *, color: Any = _COLOR, edges: bool = True, alpha: float = 1.0,
             relative: float = 1e-3) -> Any:
        """Draws triangles in place of it, shaded, proven to be within the share `relative` of its extent, and its edges,
        into Matplotlib axes, new ones if None, and returns them. Raises ImportError without Matplotlib."""
        box = self.box(math.inf)
        longest = _SMALL * float(max(box.upper - box.lower))
        return plot_mesh(self.mesh(relative=relative, longest=longest), ax, color, edges, alpha, self.surface.dimension)


# A function, since cloudpickle, by which Dask sends programs, does not know class methods by their names.
def _restored_face(kind: Type[Face], contents: Any) -> Face:
    """A pickled face."""
    return kind.from_bytes(contents)
