# SPDX-License-Identifier: MIT
"""Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which they belong."""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Callable, Dict, Generic, Iterable, List, NamedTuple, Optional, SupportsIndex
from typing import Tuple, Type, TypeVar, Union, overload

import numpy

from ._arrays import address, exactly, if_given, parameters, vector
from ._bytes import given as given_bytes, pickled, written
from ._base import handles
from ._calls import listed, watched
from ._faces import _SMALL, Face
from ._files import Note, SplineList, _options
from ._library import call, get, lib, text
from ._measure import EnclosedVolume, Measured, moments_of
from ._meets import Meet
from ._mesh import Mesh
from ._plot import plot_model
from ._spline import Spline
from ._write import file_bytes, to_file
from .constants import NURBS_FILL_NON_ZERO, NURBS_FORMAT_STEP

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s, Int64s
    from ._bytes import Contents
    from ._calls import Progress

__all__ = ["EdgeGaps", "EdgeUse", "FaceSolid", "Model", "ModelCounts", "ModelEdge", "ModelFace", "ModelInstances", "ModelPoints",
           "ModelRayHits", "ModelRays", "ModelUse"]

_Item = TypeVar("_Item")


class ModelCounts(NamedTuple):
    """How many parts, uses of parts, faces, edges and vertices a model has."""

    parts: int
    uses: int
    faces: int
    edges: int
    vertices: int


class EdgeUse(NamedTuple):
    """A place where a face uses an edge: the face, the loop, and the place in the loop."""

    face: int
    loop: int
    place: int


class EdgeGaps(NamedTuple):
    """Of each edge (n,) the number of its uses, 1 where a face ends, how far the curves of faces are from it at most, and
    whether that is a bound: 1, or 0 if it is the largest distance seen."""

    uses: Int64s
    gaps: Floats
    bounded: Int32s


class FaceSolid(NamedTuple):
    """The solid that a face bounds, -1 for none, and whether the face belongs to a void of it."""

    solid: int
    in_void: bool


class ModelInstances(NamedTuple):
    """Where parts stand in the whole: the instance in which each stands (-1: the whole), the last use on the way to it and
    the part of that, all (n,), and placements (n, 3, 4) in the whole, rows of (M | t)."""

    parents: Int64s
    uses: Int64s
    parts: Int64s
    placements: Floats


class ModelPoints(NamedTuple):
    """Points of a model: parameters (..., 2) on the surface of a face, points (..., 3), distances (...,), sums of
    NURBS_CLOSEST_ bits (...,), and the face with the instance of its part (..., 2), -1 if there are no faces."""

    params: Floats
    points: Floats
    distances: Floats
    status: Int32s
    places: Int64s


class ModelRays(NamedTuple):
    """Parameters (..., 2) of the faces that rays meet first, t (...), NURBS_RAY_ bits (...), and places (..., 2): the face,
    and the instance of its part."""

    params: Floats
    distances: Floats
    status: Int32s
    places: Int64s


class ModelRayHits(NamedTuple):
    """Parameters (n, 2) of the faces that a ray meets, t (n,) rising, NURBS_RAY_ bits, places (n, 2): the face, and the
    instance of its part; and whether these are all."""

    params: Floats
    distances: Floats
    kinds: Int32s
    places: Int64s
    complete: bool


class ModelEdge(NamedTuple):
    """An edge of a model: its curve, the vertices where that begins and ends (-1 for none), the kind of the curve, a
    NURBS_SHAPE_ constant (NURBS_SHAPE_NONE for a spline), the part that it belongs to, and where faces use it, once at a
    free boundary, twice inside a shell."""

    spline: Spline
    vertices: Tuple[int, int]
    shape: int
    part: int
    uses: Tuple[EdgeUse, ...]


class ModelUse(NamedTuple):
    """A use of a part: the part in which it is placed (-1 for the whole), the part, and the placement (3, 4): a point x
    of the part is at M x + t, rows of (M | t)."""

    parent: int
    part: int
    placement: Floats


class ModelFace(Face):
    """A face of a model: a Face, and what the model knows of it."""

    def __init__(self, *_: object, **__: object) -> None:
        raise TypeError("a ModelFace comes from a Model; a Face is made of a surface and loops")

    def __repr__(self) -> str:
        return f"<ModelFace {self.name!r} {super().__repr__().removeprefix('<Face ')}"

    @property
    def name(self) -> str:
        """Its name in the file; else "#" and the number of its entity, or its index in other models."""
        return str(self.__dict__["_name"])

    @property
    def shape(self) -> int:
        """The kind of its surface: a NURBS_SHAPE_ constant, NURBS_SHAPE_NONE for a spline."""
        return int(self.__dict__["_shape"])

    @property
    def against(self) -> bool:
        """Whether the outer normal is against the normal S_u x S_v of the surface."""
        return bool(self.__dict__["_against"])

    @property
    def colour(self) -> Optional[Tuple[float, float, float]]:
        """Red, green and blue from 0 to 1; None where the file gives none."""
        red, green, blue = self.__dict__["_colour"]
        return None if red != red else (red, green, blue)

    @property
    def part(self) -> int:
        """The part that it belongs to."""
        return int(self.__dict__["_part"])


class _Items(Sequence, Generic[_Item]):  # type: ignore[type-arg]
    """So many things, each asked for when it is needed."""

    def __init__(self, size: int, item: Callable[[int], _Item], what: str) -> None:
        self._size, self._item, self._what = size, item, what

    def __len__(self) -> int:
        return self._size

    @overload
    def __getitem__(self, index: int) -> _Item: ...

    @overload
    def __getitem__(self, index: slice) -> List[_Item]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[_Item, List[_Item]]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(self._size))]
        position = index + self._size if index < 0 else index
        if not 0 <= position < self._size:
            raise IndexError(f"index {index} out of range of the {self._size} {self._what}")
        return self._item(position)

    def __repr__(self) -> str:
        return f"<{self._size} {self._what} of a Model>"


def _handles_of(faces: List[Face]) -> Any:
    for face in faces:
        if not isinstance(face, Face):
            raise TypeError(f"expected faces, not a {type(face).__name__}")
    return (ctypes.c_void_p * len(faces))(*(face._handle for face in faces))


class Model:
    """Faces with the edges that they share, the vertices at which edges meet, and the parts to which they belong.

        model = nurbs.Model.read_file("part.step")
        for face in model.faces:
            print(face.name, face.area(1e-6).value)

    Faces, edges, parts and uses are sequences whose items are asked for one by one. Models never change, and many threads
    may use them at once; copies are made in constant time.
    """

    _handle: Optional[int] = None

    def __init__(self, faces: Iterable[Face] = (), metres: float = 0.0) -> None:
        """Of faces, with one part and one use of it: faces with a common key share an edge. `metres` are those in a unit
        of length, 0 leaves it open. Raises ArgumentError."""
        if self._handle:
            raise TypeError("a Model does not change: it cannot be initialised again")
        made = self.create(faces, metres)
        # The handle goes from one owner to the other.
        self.__dict__["_handle"] = made.__dict__.pop("_handle")

    @classmethod
    def create(cls, faces: Iterable[Face], metres: float = 0.0) -> Model:
        """The same as Model(faces, metres)."""
        given = list(faces)
        return cls._made(lib.nurbs_model_create, len(given), _handles_of(given), metres)

    @classmethod
    def sew(cls, faces: Iterable[Face], tolerance: float, metres: float = 0.0, *, progress: Progress = None,
            work: Optional[int] = None) -> Model:
        """A model of faces that do not know each other: pieces of their boundaries that are within the tolerance of each
        other become common edges. edge_gaps() tells how well they meet, and which edges are free. Raises ArgumentError."""
        given = list(faces)
        return cls._made(watched(lib.nurbs_model_sew, progress, work), len(given), _handles_of(given), tolerance, metres)

    @classmethod
    def region(cls, curves: Iterable[Spline], rule: int = NURBS_FILL_NON_ZERO, tolerance: float = 0.0, *,
               progress: Progress = None, work: Optional[int] = None) -> Model:
        """The region that closed curves of the plane enclose, as faces in one piece each: a curve begins where the one
        before it ends, or where that one closes a loop, a loop of its own. rule is one of the NURBS_FILL_ constants.
        Raises ArgumentError, and NumericError where rounding would have to decide what meets."""
        given = handles(curves)
        return cls._made(watched(lib.nurbs_region_create, progress, work), len(given), given, rule, tolerance)

    @classmethod
    def combine(cls, rule: int, a: Iterable[Face], b: Iterable[Face] = (), tolerance: float = 0.0, *,
                progress: Progress = None, work: Optional[int] = None) -> Model:
        """The union, intersection or difference of two regions, each of which is what its faces cover; rule is one of
        the NURBS_REGION_ constants. Raises what region() does."""
        first, second = list(a), list(b)
        return cls._made(watched(lib.nurbs_region_combine, progress, work), rule, len(first), _handles_of(first),
                         len(second), _handles_of(second), tolerance)

    @classmethod
    def split(cls, face: Face, curves: Iterable[Spline], tolerance: float = 0.0, *, progress: Progress = None,
              work: Optional[int] = None) -> Model:
        """The parts of a face that curves in the domain of its surface divide it into; they share edges. Raises what
        region() does. The same as face.split()."""
        given = handles(curves)
        return cls._made(watched(lib.nurbs_face_split, progress, work), _handles_of([face])[0], len(given), given, tolerance)

    @classmethod
    def trim(cls, face: Face, surface: Spline, side: int, tolerance: float, *, progress: Progress = None,
             work: Optional[int] = None) -> Model:
        """What of a face lies on one side of a surface, which divides it where both meet; side is one of the NURBS_TRIM_
        constants. Raises ArgumentError, also where the surface ends inside of the face, and NumericError where it is
        undecided how both meet. The same as face.trim()."""
        return cls._made(watched(lib.nurbs_face_trim, progress, work), _handles_of([face])[0], handles([surface])[0], side,
                         tolerance)

    @classmethod
    def read(cls, contents: Union[bytes, bytearray, memoryview], unit: float = 0.0, max_bytes: Optional[int] = None, *,
             tolerance: float = 0.0, kinds: int = 0, progress: Progress = None, work: Optional[int] = None) -> Model:
        """The faces, edges and vertices of a STEP or an IGES file in memory; unit is the wanted one in metres, 0 keeps
        the file's own; tolerance is the distance in it that counts as none, that of the faces, 0 takes what the file
        states; kinds is a sum of NURBS_READ_ constants, 0 for all. Raises ContentsError if it is none, ResourceError if
        it is longer than max_bytes (by default 2^30)."""
        given = contents if isinstance(contents, bytes) else memoryview(contents).tobytes()
        return cls._made(watched(lib.nurbs_read_model, progress, work), given, len(given), _options(unit, max_bytes, tolerance, kinds))

    @classmethod
    def read_file(cls, path: Union[str, bytes, os.PathLike[str]], unit: float = 0.0, max_bytes: Optional[int] = None, *,
                  tolerance: float = 0.0, kinds: int = 0, progress: Progress = None, work: Optional[int] = None) -> Model:
        """Those of a STEP or an IGES file, as read() gives them. Raises FileError if it cannot be read."""
        name = os.fsencode(path)
        if b"\0" in name:
            raise ValueError("a path with a zero in it")
        return cls._made(watched(lib.nurbs_read_model_file, progress, work), name, _options(unit, max_bytes, tolerance, kinds))

    @classmethod
    def _made(cls, function: Any, *arguments: Any) -> Model:
        """The model that a function writes through its last argument."""
        model, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            model.__dict__["_handle"] = handle.value
        return model

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Model does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Model does not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_model_destroy(handle)

    def copy(self) -> Model:
        """Another handle on the same model, in constant time; copy.copy() and copy.deepcopy() do the same."""
        return self._made(lib.nurbs_model_clone, self._handle)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Model:
        return self.copy()

    def to_bytes(self) -> bytes:
        """The model as bytes, to be kept or sent, with everything that it holds: the same on every machine for the same
        model."""
        return written(lib.nurbs_model_to_bytes, self._handle).tobytes()

    @classmethod
    def from_bytes(cls, contents: Contents) -> Model:
        """The model of what to_bytes() gave. Raises ContentsError for other bytes."""
        given = given_bytes(contents)
        return cls._made(lib.nurbs_model_from_bytes, given.ctypes.data, given.size)

    def __reduce_ex__(self, protocol: SupportsIndex) -> Tuple[Callable[..., Model], Tuple[Any, ...]]:
        return _restored_model, (type(self), pickled(lib.nurbs_model_to_bytes, self._handle, protocol))

    def __repr__(self) -> str:
        counts = self.counts
        return f"<Model of {counts.faces} faces, {counts.edges} edges and {counts.vertices} vertices>"

    def write(self, format: int = NURBS_FORMAT_STEP, unit: float = 0.0, tolerance: float = 0.0, *,
              progress: Progress = None, work: Optional[int] = None) -> bytes:
        """The contents of a file that holds the model, by NURBS_FORMAT_STEP or NURBS_FORMAT_IGES, the same for the same
        model. `unit` is that of the file in metres, 0 keeps its own; `tolerance`, in that unit, is the distance that
        counts as none, 0 takes that of the faces. Raises ArgumentError for what the format cannot hold."""
        return file_bytes(lib.nurbs_model_write, self._handle, format, unit, tolerance, progress, work)

    def write_file(self, path: Union[str, bytes, os.PathLike[str]], format: Optional[int] = None, unit: float = 0.0,
                   tolerance: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> None:
        """Writes what write() gives to a file, which is replaced whole or not at all; without a format that of the
        suffix, such as ".step". Raises FileError if it cannot be written."""
        to_file(lib.nurbs_model_write_file, self._handle, path, format, unit, tolerance, progress, work)

    # --- What it holds ---

    @property
    def counts(self) -> ModelCounts:
        """How many parts, uses of parts, faces, edges and vertices it has."""
        numbers = [ctypes.c_int64() for _ in ModelCounts._fields]
        call(lib.nurbs_model_counts, self._handle, *map(ctypes.byref, numbers))
        return ModelCounts(*(number.value for number in numbers))

    @property
    def faces(self) -> Sequence[ModelFace]:
        """Its faces."""
        return _Items(self.counts.faces, self.face, "faces")

    @property
    def edges(self) -> Sequence[ModelEdge]:
        """Its edges."""
        return _Items(self.counts.edges, self.edge, "edges")

    @property
    def vertices(self) -> Floats:
        """The points of its vertices (vertices, 3), each in the coordinates of its part."""
        points = numpy.empty((self.counts.vertices, 3))
        for index, point in enumerate(points):
            call(lib.nurbs_model_vertex, self._handle, index, point.ctypes.data)
        return points

    @property
    def parts(self) -> Sequence[str]:
        """The names of its parts."""
        return _Items(self.counts.parts, self.part, "parts")

    @property
    def uses(self) -> Sequence[ModelUse]:
        """Where its parts are placed."""
        return _Items(self.counts.uses, self.use, "uses")

    @property
    def layers(self) -> Sequence[str]:
        """The names of the layers that its faces and splines are in."""
        return _Items(self.layer_count(), self.layer, "layers")

    @property
    def splines(self) -> SplineList:
        """The curves and surfaces of a file that no face or edge consists of."""
        return SplineList._made(lib.nurbs_model_splines, self._handle)

    @property
    def notes(self) -> List[Note]:
        """What of a file was not read, and why."""
        return self.splines.notes

    @property
    def unit(self) -> float:
        """Metres per unit of length; 0 if that is not known."""
        return self.splines.unit

    # --- One by one ---

    def face(self, index: int) -> ModelFace:
        """A face, with its name, part, shape and colour."""
        part, shape, against = ctypes.c_int64(), ctypes.c_int32(), ctypes.c_int32()
        colour = (ctypes.c_double * 3)()
        face = ModelFace._made(lib.nurbs_model_face, self._handle, index, ctypes.byref(part), ctypes.byref(shape),
                               ctypes.byref(against), colour)
        face.__dict__.update(_name=self.face_name(index), _part=part.value, _shape=shape.value,
                             _against=bool(against.value), _colour=tuple(colour))
        return face

    def face_name(self, index: int) -> str:
        """The name of a face."""
        return text(lib.nurbs_model_face_name, self._handle, index)

    def face_solid(self, index: int) -> FaceSolid:
        """The solid that a face bounds, -1 for none, and whether the face belongs to a void of it."""
        solid, in_void = ctypes.c_int64(), ctypes.c_int32()
        call(lib.nurbs_model_face_solid, self._handle, index, ctypes.byref(solid), ctypes.byref(in_void))
        return FaceSolid(solid.value, bool(in_void.value))

    def face_layers(self, index: int) -> Tuple[int, ...]:
        """The layers that a face is in."""
        return self._layers_by(lib.nurbs_model_face_layers, index)

    def edge(self, index: int) -> ModelEdge:
        """An edge, with its vertices and uses."""
        part, ends, shape = ctypes.c_int64(), (ctypes.c_int64 * 2)(), ctypes.c_int32()
        spline = Spline._made(lib.nurbs_model_edge, self._handle, index, ctypes.byref(part), ends, ctypes.byref(shape))
        return ModelEdge(spline, (ends[0], ends[1]), shape.value, part.value, self.edge_uses(index))

    def edge_uses(self, index: int) -> Tuple[EdgeUse, ...]:
        """Where faces use an edge."""
        places = numpy.empty((get(ctypes.c_int64, lib.nurbs_model_edge_uses, self._handle, index, 0, None), 3),
                             numpy.int64)
        get(ctypes.c_int64, lib.nurbs_model_edge_uses, self._handle, index, len(places), places.ctypes.data)
        return tuple(EdgeUse(*place) for place in places.tolist())

    def edge_gaps(self) -> EdgeGaps:
        """How well faces meet at its edges."""
        n = self.counts.edges
        found = EdgeGaps(numpy.empty(n, numpy.int64), numpy.empty(n), numpy.empty(n, numpy.int32))
        get(ctypes.c_int64, lib.nurbs_model_edge_gaps, self._handle, n, found.uses.ctypes.data, found.gaps.ctypes.data,
            found.bounded.ctypes.data)
        return found

    def vertex(self, index: int) -> Floats:
        """The point of a vertex (3,), in the coordinates of its part."""
        point: Floats = numpy.empty(3)
        call(lib.nurbs_model_vertex, self._handle, index, point.ctypes.data)
        return point

    def part(self, index: int) -> str:
        """The name of a part."""
        return text(lib.nurbs_model_part, self._handle, index)

    def layer_count(self) -> int:
        """How many layers its faces and splines are in."""
        return int(get(ctypes.c_int64, lib.nurbs_model_layer_count, self._handle))

    def layer(self, index: int) -> str:
        """The name of a layer."""
        return text(lib.nurbs_model_layer, self._handle, index)

    def spline_layers(self, index: int) -> Tuple[int, ...]:
        """The layers that one of `splines` is in."""
        return self._layers_by(lib.nurbs_model_spline_layers, index)

    def _layers_by(self, function: Any, index: int) -> Tuple[int, ...]:
        layers = numpy.empty(get(ctypes.c_int64, function, self._handle, index, 0, None), numpy.int64)
        get(ctypes.c_int64, function, self._handle, index, len(layers), layers.ctypes.data)
        return tuple(layers.tolist())

    def use(self, index: int) -> ModelUse:
        """A use of a part: where it is placed."""
        parent, part, placement = ctypes.c_int64(), ctypes.c_int64(), numpy.empty((3, 4))
        call(lib.nurbs_model_use, self._handle, index, ctypes.byref(parent), ctypes.byref(part), placement.ctypes.data)
        return ModelUse(parent.value, part.value, placement)

    # --- Rays ---

    def instances(self) -> ModelInstances:
        """Where the parts stand in the whole: each way through uses of parts in parts."""
        count = get(ctypes.c_int64, lib.nurbs_model_instances, self._handle, 0, None, None, None, None)
        parents, uses, parts = (numpy.empty(count, numpy.int64) for _ in range(3))
        placements: Floats = numpy.empty((count, 3, 4))
        call(lib.nurbs_model_instances, self._handle, count, parents.ctypes.data, uses.ctypes.data, parts.ctypes.data,
             placements.ctypes.data, None)
        return ModelInstances(parents, uses, parts, placements)

    def rays(self, origins: ArrayLike, directions: ArrayLike, *, progress: Progress = None,
             work: Optional[int] = None) -> ModelRays:
        """Where rays origin + t direction, t >= 0, arrays (..., 3), meet its faces first, with proof. One origin or
        direction serves all."""
        starts, ways = (_points(rows) for rows in numpy.broadcast_arrays(numpy.asarray(origins, float),
                                                                        numpy.asarray(directions, float)))
        batch = starts.shape[:-1]
        params, distances, status = numpy.empty((*batch, 2)), numpy.empty(batch), numpy.empty(batch, numpy.int32)
        places = numpy.empty((*batch, 2), numpy.int64)
        call(watched(lib.nurbs_model_rays, progress, work), self._handle, distances.size, starts.ctypes.data,
             ways.ctypes.data, params.ctypes.data, distances.ctypes.data, status.ctypes.data, places.ctypes.data)
        return ModelRays(params, distances, status, places)

    def ray_hits(self, origin: ArrayLike, direction: ArrayLike, part: Optional[ArrayLike] = None, *,
                 progress: Progress = None, work: Optional[int] = None) -> ModelRayHits:
        """All places where a ray meets its faces, by rising t."""
        start, way = exactly(origin, 3, "origin"), exactly(direction, 3, "direction")
        limits = if_given(part, 2, "part")

        def arrays(n: int) -> Tuple[Any, ...]:
            return numpy.empty((n, 2)), numpy.empty(n), numpy.empty(n, numpy.int32), numpy.empty((n, 2), numpy.int64)

        return listed(ModelRayHits, arrays, watched(lib.nurbs_model_ray_hits, progress, work, 2), self._handle,
                      start.ctypes.data, way.ctypes.data, address(limits))

    def closest_points(self, points: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                       work: Optional[int] = None) -> ModelPoints:
        """The points of its faces, where they stand, that are nearest to points (..., 3), with proof that none is nearer by
        more than `tolerance`."""
        given, batch = parameters(points, 3)
        params, feet, distances = numpy.empty((*batch, 2)), numpy.empty((*batch, 3)), numpy.empty(batch)
        status, places = numpy.empty(batch, numpy.int32), numpy.empty((*batch, 2), numpy.int64)
        call(watched(lib.nurbs_model_closest_points, progress, work), self._handle, given.n, *given.layout, tolerance,
             params.ctypes.data, feet.ctypes.data, distances.ctypes.data, status.ctypes.data, places.ctypes.data)
        return ModelPoints(params, feet, distances, status, places)

    def classify(self, points: ArrayLike, tolerance: float = 0.0, *, progress: Progress = None,
                 work: Optional[int] = None) -> Int32s:
        """Whether points (..., 3) are inside its solids: NURBS_SIDE_ constants, NURBS_SIDE_ON within `tolerance` of a
        face."""
        given, batch = parameters(points, 3)
        sides = numpy.empty(batch, numpy.int32)
        call(watched(lib.nurbs_model_classify, progress, work), self._handle, given.n, *given.layout, tolerance,
             sides.ctypes.data)
        return sides

    def area(self, relative_tolerance: float = 0.0, *, progress: Progress = None,
             work: Optional[int] = None) -> Measured:
        """The area of all its faces where they stand; a tolerance of 0 asks for the best that there is."""
        area = ctypes.c_double()
        error = get(ctypes.c_double, watched(lib.nurbs_model_area, progress, work), self._handle, relative_tolerance,
                    ctypes.byref(area))
        return Measured(area.value, error)

    def volume(self, relative_tolerance: float = 0.0, *, progress: Progress = None,
               work: Optional[int] = None) -> EnclosedVolume:
        """What its solids hold where they stand. Raises ArgumentError if it is not closed."""
        volume, openness, error = ctypes.c_double(), ctypes.c_double(), ctypes.c_double()
        centroid, inertia = moments_of(3, watched(lib.nurbs_model_volume, progress, work),
                                       (self._handle, relative_tolerance, ctypes.byref(volume)),
                                       (ctypes.byref(openness), ctypes.byref(error)))
        return EnclosedVolume(volume.value, centroid, inertia, openness.value, error.value)

    # --- Sections ---

    def sections(self, normals: ArrayLike, offsets: ArrayLike, tolerance: float, *, progress: Progress = None,
                 work: Optional[int] = None) -> Meet:
        """Where planes normal . x = offset, arrays (n, 3) and (n,), cut its faces where they stand, joined to ways over the edges
        that faces share. One normal serves all offsets."""
        planes = vector(offsets)
        across = _points(numpy.broadcast_to(numpy.asarray(normals, float), (planes.size, 3)))
        return Meet._made(watched(lib.nurbs_model_sections, progress, work), self._handle, planes.size,
                          across.ctypes.data, planes.ctypes.data, tolerance)

    def meet(self, other: Model, tolerance: float, *, progress: Progress = None, work: Optional[int] = None) -> Meet:
        """Where the faces of two models meet, joined to ways over the edges that faces share. Meet.faces has those of this
        one, Meet.faces_second those of the other one."""
        return Meet._made(watched(lib.nurbs_model_intersections, progress, work), self._handle, other._handle, tolerance)

    # --- Meshes ---

    def mesh(self, chord: float = math.inf, relative: float = 1e-3, longest: float = 0.0, angle: float = 0.0,
             minimum_angle: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> Mesh:
        """Triangles in place of all faces, in the coordinates of their parts, with common points along common edges; the limits
        are those of Spline.mesh()."""
        return Mesh._of(watched(lib.nurbs_mesh_model, progress, work), self._handle, chord, relative, longest, angle,
                        minimum_angle)

    def mesh_levels(self, chords: ArrayLike, longest: float = 0.0, angle: float = 0.0, minimum_angle: float = 0.0, *,
                    progress: Progress = None, work: Optional[int] = None) -> List[Mesh]:
        """A mesh for each of the distances, in their order: each as mesh(chord, relative=0, ...) makes it."""
        return Mesh._levels(watched(lib.nurbs_mesh_model_levels, progress, work), self._handle, chords, longest, angle,
                            minimum_angle)

    def plot(self, ax: Any = None, *, color: Any = None, edges: bool = True, alpha: float = 1.0,
             relative: float = 1e-3) -> Any:
        """Draws triangles in place of its faces, shaded, within the share `relative` of the extent of each, as proven, and
        its edges, each part where it stands, into Matplotlib axes, new ones if None, and returns them. The colours are
        those of the faces where the file gives some, unless `color` is given. Raises ImportError without Matplotlib, ValueError if
        there are no faces."""
        faces = list(self.faces)
        if not faces:
            raise ValueError("the model has no faces that could be drawn")
        known = numpy.array([face.colour or [math.nan] * 3 for face in faces])
        boxes = [face.box(math.inf) for face in faces]
        longest = _SMALL * max(float(max(box.upper - box.lower)) for box in boxes)
        return plot_model(self.mesh(relative=relative, longest=longest), ax, color, edges, alpha, known,
                          numpy.array([face.part for face in faces], int), self.instances())


def _points(rows: Floats) -> Floats:
    """Points (..., 3), one after the other."""
    if rows.ndim == 0 or rows.shape[-1] != 3:
        raise ValueError(f"points of shape {rows.shape}, expected (..., 3)")
    return numpy.ascontiguousarray(rows)


# A function, since cloudpickle, by which Dask sends programs, does not know class methods by their names.
def _restored_model(kind: Type[Model], contents: Any) -> Model:
    """A pickled model."""
    return kind.from_bytes(contents)
