# SPDX-License-Identifier: MIT
"""Shapes made of what is straight and flat, within a proven distance."""

from __future__ import annotations

import ctypes
import math
import os
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, NoReturn, Optional, SupportsIndex, Type, TypeVar, Union

import numpy

from ._arrays import addresses, vector
from ._base import SplineBase
from ._calls import watched
from ._library import call, get, lib
from ._plot import _COLOR, plot_mesh
from ._write import MESH_SUFFIXES, file_bytes, to_file
from .constants import NURBS_FORMAT_STL, NURBS_MESH_WELDED

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._arrays import Floats, Int32s, Int64s, Shape, Singles
    from ._calls import Progress

__all__ = ["BezierCells", "BezierCellPoints", "CurvePolyline", "DrawableVertices", "Mesh", "MeshBound", "MeshCounts",
           "MeshEdges", "MeshFaces", "MeshHexahedra", "MeshQuads", "MeshVertices"]

_Mesh = TypeVar("_Mesh", bound="Mesh")
_Array = TypeVar("_Array", bound="numpy.ndarray[Any, Any]")


class CurvePolyline(NamedTuple):
    """Parameters (n,), rising, and points (n, dimension) of the vertices of a polyline in place of a curve; a bound of its
    distance from the curve, as proven, and whether all segments keep to the limits."""

    params: Floats
    points: Floats
    bound: float
    reached: bool


class MeshCounts(NamedTuple):
    """How many points, vertices, triangles, faces and polylines of edges a mesh has, and how many vertices these have."""

    points: int
    vertices: int
    triangles: int
    faces: int
    edges: int
    edge_points: int


class MeshBound(NamedTuple):
    """Proven: no point of the shape is farther from the mesh than `from_shape`, and none of the mesh farther from the shape
    than `from_mesh`; and whether all that was asked for is reached."""

    from_shape: float
    from_mesh: float
    reached: bool


class MeshVertices(NamedTuple):
    """Of each vertex the point (n,) at which it is, the parameters (n, 2) of the surface of its face, and the normal (n, 3) of
    that, of length 1; NaN where there is none."""

    points: Int64s
    params: Floats
    normals: Floats


class DrawableVertices(NamedTuple):
    """Points (n, 3), parameters (n, 2) and normals (n, 3) of all vertices, in single precision."""

    points: Singles
    params: Singles
    normals: Singles


class MeshQuads(NamedTuple):
    """Corners (n, 4) of pairs of triangles that are all of a cell, of which 0, 1, 2 and 0, 2, 3 are the triangles; the first one (n,)
    of these, of which the next one is the second; and the triangles (m,) that are in no pair."""

    corners: Int64s
    triangles: Int64s
    rest: Int64s


class MeshFaces(NamedTuple):
    """Of each face (n,) the first one and the number of its vertices, and of its triangles, the proven distances of the face from
    its triangles and of these from the face, and whether all that was asked for is reached."""

    first_vertices: Int64s
    vertex_counts: Int64s
    first_triangles: Int64s
    triangle_counts: Int64s
    from_shape: Floats
    from_mesh: Floats
    reached: Int32s


class MeshEdges(NamedTuple):
    """Of each polyline (n,) the edge of the model (-1: one that belongs to one face only), its first one of Mesh.edge_points and
    the number of these, a proven bound of its distance from the edge, and whether all that was asked for is reached."""

    edges: Int64s
    firsts: Int64s
    sizes: Int64s
    bounds: Floats
    reached: Int32s


class MeshHexahedra(NamedTuple):
    """Of each hexahedron (n,) its corners (n, 8), points in the order of VTK_HEXAHEDRON, its ends (n, 3, 2) along each axis of the
    volume, a NURBS_FOLD_ constant that tells whether the volume folds there, and 1 or -1, the sign of its Jacobian there, if it
    is proven to be one."""

    corners: Int64s
    domains: Floats
    folds: Int32s
    signs: Int32s


class BezierCells(NamedTuple):
    """Control points (n, M) of each Bezier cell in the order of VTK, places in Spline.bezier_cell_points(), what VTK calls such
    cells, and the number of control points."""

    cells: Int64s
    kind: int
    point_count: int


class BezierCellPoints(NamedTuple):
    """Control points (n, dimension) of Bezier cells, each once, and their weights (n,)."""

    points: Floats
    weights: Floats


class _Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("chord", ctypes.c_double), ("relative_chord", ctypes.c_double),
                ("longest", ctypes.c_double), ("angle", ctypes.c_double), ("minimum_angle", ctypes.c_double)]


def _options(chord: float, relative: float, longest: float, angle: float, minimum_angle: float) -> Any:
    options: Any = _Options()
    call(lib.nurbs_mesh_options_init, ctypes.byref(options), ctypes.sizeof(options))
    options.chord, options.relative_chord, options.longest = chord, relative, longest
    options.angle, options.minimum_angle = angle, minimum_angle
    return options


class Mesh:
    """Triangles in place of a surface, a face or a model, as their methods mesh() make them; or hexahedra in place of a volume.

        mesh = surface.mesh(chord=0.01)
        mesh.write_file("surface.stl")
        meshio.Mesh(mesh.points, [("triangle", mesh.triangles)])

    Points are those in space. Vertices are at points, and have parameters and a normal of one face: a point has several of
    them where faces meet, at seams, poles and creases. Meshes never change, and many threads may use them at once; copies
    are made in constant time.
    """

    _handle: Optional[int] = None

    def __init__(self) -> None:
        raise TypeError("a Mesh is an answer: of Spline.mesh(), Spline.mesh_volume(), Face.mesh() or Model.mesh()")

    @classmethod
    def _made(cls: Type[_Mesh], function: Any, *arguments: Any) -> _Mesh:
        """The mesh that a function writes through its last argument."""
        mesh, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            mesh.__dict__["_handle"] = handle.value
        return mesh

    @classmethod
    def _of(cls: Type[_Mesh], function: Any, shape: Any, chord: float, relative: float, longest: float,
            angle: float, minimum_angle: float, *more: Any) -> _Mesh:
        options = _options(chord, relative, longest, angle, minimum_angle)
        return cls._made(function, shape, ctypes.byref(options), *more)

    @classmethod
    def _levels(cls: Type[_Mesh], function: Any, shape: Any, chords: ArrayLike, longest: float, angle: float,
                minimum_angle: float) -> List[_Mesh]:
        """The meshes that a function makes for each distance."""
        own = vector(chords)
        options = _options(math.inf, 0.0, longest, angle, minimum_angle)
        meshes, handles = [cls.__new__(cls) for _ in own], (ctypes.c_void_p * len(own))()
        try:
            call(function, shape, len(own), own.ctypes.data, ctypes.byref(options), handles)
        finally:  # an interrupt may come after the call
            for mesh, handle in zip(meshes, handles):
                mesh.__dict__["_handle"] = handle
        return meshes

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Mesh does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Mesh does not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_mesh_destroy(handle)

    def copy(self: _Mesh) -> _Mesh:
        """Another handle on the same mesh, in constant time; copy.copy() and copy.deepcopy() do the same."""
        return self._made(lib.nurbs_mesh_clone, self._handle)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Mesh:
        return self.copy()

    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn:
        raise TypeError("a Mesh has no bytes: keep its arrays")

    def __repr__(self) -> str:
        counts = self.counts
        return f"<Mesh of {counts.triangles} triangles, {counts.points} points and {counts.faces} faces>"

    def write(self, format: int = NURBS_FORMAT_STL, unit: float = 0.0, *, progress: Progress = None,
              work: Optional[int] = None) -> bytes:
        """The contents of a file that holds the triangles, by NURBS_FORMAT_STL, _STL_TEXT, _OBJ, _PLY, _GLB or _VTU, the
        same for the same mesh: parts where they stand in the whole, seen from outside. `unit` is that of the file in
        metres, 0 keeps its own. Raises ArgumentError for what the format cannot hold."""
        return file_bytes(lib.nurbs_mesh_write, self._handle, format, unit, 0.0, progress, work)

    def write_file(self, path: Union[str, bytes, os.PathLike[str]], format: Optional[int] = None, unit: float = 0.0, *,
                   progress: Progress = None, work: Optional[int] = None) -> None:
        """Writes what write() gives to a file, which is replaced whole or not at all; without a format that of the
        suffix, such as ".glb". Raises FileError if it cannot be written."""
        to_file(lib.nurbs_mesh_write_file, self._handle, path, format, unit, 0.0, progress, work, MESH_SUFFIXES)

    # --- What it holds ---

    @property
    def counts(self) -> MeshCounts:
        """How much it holds."""
        counts = [ctypes.c_int64() for _ in MeshCounts._fields]
        call(lib.nurbs_mesh_counts, self._handle, *(ctypes.byref(count) for count in counts))
        return MeshCounts(*(count.value for count in counts))

    @property
    def bound(self) -> MeshBound:
        """How far it and its shape are from each other, as proven."""
        from_shape, from_mesh, reached = ctypes.c_double(), ctypes.c_double(), ctypes.c_int32()
        call(lib.nurbs_mesh_bound, self._handle, ctypes.byref(from_shape), ctypes.byref(from_mesh),
             ctypes.byref(reached))
        return MeshBound(from_shape.value, from_mesh.value, bool(reached.value))

    @property
    def points(self) -> Floats:
        """The points (n, 3); of a surface in the plane z is 0."""
        return self._filled(lib.nurbs_mesh_points, numpy.empty((self.counts.points, 3)))

    @property
    def points_f32(self) -> Singles:
        """The points (n, 3) in single precision, each number rounded once."""
        return self._filled(lib.nurbs_mesh_points_f32, numpy.empty((self.counts.points, 3), numpy.float32))

    @property
    def triangles(self) -> Int64s:
        """The points (n, 3) that are the corners of each triangle, counterclockwise about the normal of the surface: two
        triangles at an edge have a side in common."""
        return self._corners(lib.nurbs_mesh_triangles, NURBS_MESH_WELDED, numpy.empty(self._three_each, numpy.int64))

    @property
    def vertex_triangles(self) -> Int64s:
        """The vertices (n, 3) that are the corners of each triangle."""
        return self._corners(lib.nurbs_mesh_triangles, 0, numpy.empty(self._three_each, numpy.int64))

    @property
    def quads(self) -> MeshQuads:
        """The points that are the corners of pairs of triangles which are all of a cell: most of them, but not along the
        border of a trimmed face. Distances are proven for the triangles."""
        return self._quads(NURBS_MESH_WELDED)

    @property
    def vertex_quads(self) -> MeshQuads:
        """The vertices that are the corners of these pairs of triangles."""
        return self._quads(0)

    def triangles_i32(self, welded: bool = False) -> Int32s:
        """The vertices, or points, (n, 3) that are the corners of each triangle, in 32 bits."""
        return self._corners(lib.nurbs_mesh_triangles_i32, NURBS_MESH_WELDED if welded else 0,
                             numpy.empty(self._three_each, numpy.int32))

    @property
    def vertices(self) -> MeshVertices:
        """The vertices, those of each face one after the other."""
        n = self.counts.vertices
        found = MeshVertices(numpy.empty(n, numpy.int64), numpy.empty((n, 2)), numpy.empty((n, 3)))
        call(lib.nurbs_mesh_vertices, self._handle, n, *addresses(*found), None)
        return found

    @property
    def params(self) -> Floats:
        """Parameters (n, 2) of the vertices alone."""
        params = numpy.empty((self.counts.vertices, 2))
        call(lib.nurbs_mesh_vertices, self._handle, len(params), None, params.ctypes.data, None, None)
        return params

    @property
    def normals(self) -> Floats:
        """Normals (n, 3) of the vertices alone."""
        normals = numpy.empty((self.counts.vertices, 3))
        call(lib.nurbs_mesh_vertices, self._handle, len(normals), None, None, normals.ctypes.data, None)
        return normals

    @property
    def vertices_f32(self) -> DrawableVertices:
        """All of the vertices in single precision, as triangles_i32() and programs that draw want them."""
        n = self.counts.vertices
        found = DrawableVertices(*(numpy.empty((n, width), numpy.float32) for width in (3, 2, 3)))
        call(lib.nurbs_mesh_vertices_f32, self._handle, n, *addresses(*found), None)
        return found

    @property
    def faces(self) -> MeshFaces:
        """What of it stands for which face, and how far that is from the face."""
        n = self.counts.faces
        found = MeshFaces(numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64),
                          numpy.empty(n, numpy.int64), numpy.empty(n), numpy.empty(n), numpy.empty(n, numpy.int32))
        call(lib.nurbs_mesh_faces, self._handle, n, *addresses(*found), None)
        return found

    @property
    def edges(self) -> MeshEdges:
        """The polylines that stand for edges."""
        n = self.counts.edges
        found = MeshEdges(numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64),
                          numpy.empty(n), numpy.empty(n, numpy.int32))
        call(lib.nurbs_mesh_edges, self._handle, n, *addresses(*found), None)
        return found

    @property
    def edge_points(self) -> Int64s:
        """The points (n,) that the polylines of edges have, one polyline after the other."""
        return self._filled(lib.nurbs_mesh_edge_points, numpy.empty(self.counts.edge_points, numpy.int64))

    @property
    def hexahedra(self) -> MeshHexahedra:
        """The hexahedra in place of a volume, last axis fastest."""
        n = get(ctypes.c_int64, lib.nurbs_mesh_hexahedra, self._handle, 0, None, None, None, None)
        found = MeshHexahedra(numpy.empty((n, 8), numpy.int64), numpy.empty((n, 3, 2)), numpy.empty(n, numpy.int32),
                              numpy.empty(n, numpy.int32))
        call(lib.nurbs_mesh_hexahedra, self._handle, n, *addresses(*found), None)
        return found

    # --- Pictures ---

    def plot(self, ax: Any = None, *, color: Any = _COLOR, edges: bool = True, alpha: float = 1.0) -> Any:
        """Draws the triangles, shaded, and the polylines of edges into Matplotlib axes, new ones in space if None, and
        returns them. Raises ImportError without Matplotlib."""
        return plot_mesh(self, ax, color, edges, alpha)

    def _filled(self, function: Any, array: _Array) -> _Array:
        call(function, self._handle, len(array), array.ctypes.data, None)
        return array

    def _corners(self, function: Any, flags: int, corners: _Array) -> _Array:
        call(function, self._handle, flags, len(corners), corners.ctypes.data, None)
        return corners

    def _quads(self, flags: int) -> MeshQuads:
        n = get(ctypes.c_int64, lib.nurbs_mesh_quads, self._handle, flags, 0, None, None)
        corners, triangles = numpy.empty((n, 4), numpy.int64), numpy.empty(n, numpy.int64)
        call(lib.nurbs_mesh_quads, self._handle, flags, n, *addresses(corners, triangles), None)
        rest = numpy.ones(self.counts.triangles, bool)
        rest[triangles] = rest[triangles + 1] = False
        return MeshQuads(corners, triangles, numpy.flatnonzero(rest))

    @property
    def _three_each(self) -> Shape:
        return self.counts.triangles, 3


class Meshes(SplineBase):
    """What is straight and flat in place of a shape."""

    def mesh_curve(self, chord: float = math.inf, angle: float = 0.0, longest: float = 0.0, *,
                   progress: Progress = None, work: Optional[int] = None) -> CurvePolyline:
        """A polyline in place of a curve: every segment is within `chord` of its part of the curve, as proven. The angle
        between any two tangents of that part and the length of the segment are limited too, if they are not 0."""
        function = watched(lib.nurbs_mesh_curve, progress, work, 2)
        bound, reached, count = ctypes.c_double(), ctypes.c_int32(), ctypes.c_int64()
        given = self._handle, chord, angle, longest
        ends = ctypes.byref(bound), ctypes.byref(reached), ctypes.byref(count)
        call(function, *given, 0, None, None, *ends)
        params, points = numpy.empty(count.value), numpy.empty((count.value, self.dimension))
        call(function, *given, count.value, params.ctypes.data, points.ctypes.data, *ends)
        return CurvePolyline(params, points, bound.value, bool(reached.value))

    def mesh(self, chord: float = math.inf, relative: float = 1e-3, longest: float = 0.0, angle: float = 0.0,
             minimum_angle: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> Mesh:
        """Triangles in place of a surface of dimension 2 or 3, proven to be within `chord` of it, both ways, and within the
        share `relative` of its extent (the longest side of the box of the control points) unless that is 0; with sides no
        longer than `longest` and normals at corners of a triangle no more than `angle` (in radians) apart, unless these are
        0. Triangles inside, whose circles do not come to the border, have no angle below `minimum_angle`, at most pi / 6."""
        return Mesh._of(watched(lib.nurbs_mesh_surface, progress, work), self._handle, chord, relative, longest, angle,
                        minimum_angle)

    def mesh_levels(self, chords: ArrayLike, longest: float = 0.0, angle: float = 0.0, minimum_angle: float = 0.0, *,
                    progress: Progress = None, work: Optional[int] = None) -> List[Mesh]:
        """A mesh for each of the distances, in their order: each as mesh(chord, relative=0, ...) makes it."""
        return Mesh._levels(watched(lib.nurbs_mesh_surface_levels, progress, work), self._handle, chords, longest, angle,
                            minimum_angle)

    def mesh_volume(self, chord: float = math.inf, relative: float = 1e-3, longest: float = 0.0, limit: int = 0, *,
                    progress: Progress = None, work: Optional[int] = None) -> Mesh:
        """Hexahedra in place of a volume, on a grid of lines along its axes, with limits as for mesh(); at most `limit` of them
        (0: 2^20), or one for each polynomial piece."""
        return Mesh._of(watched(lib.nurbs_mesh_volume, progress, work), self._handle, chord, relative, longest, 0.0,
                        0.0, limit)

    def bezier_cells(self) -> BezierCells:
        """The polynomial pieces as Bezier cells in the order of VTK, by places in bezier_cell_points()."""
        kind, points, count = ctypes.c_int32(), ctypes.c_int64(), ctypes.c_int64()
        rest = ctypes.byref(kind), ctypes.byref(points), ctypes.byref(count)
        call(lib.nurbs_bezier_cells, self._handle, 0, None, *rest)
        cells = numpy.empty((count.value, math.prod(degree + 1 for degree in self.degrees)), numpy.int64)
        call(lib.nurbs_bezier_cells, self._handle, count.value, cells.ctypes.data, *rest)
        return BezierCells(cells, kind.value, points.value)

    def bezier_cell_points(self) -> BezierCellPoints:
        """The control points of the Bezier cells, each once, and their weights."""
        n = get(ctypes.c_int64, lib.nurbs_bezier_cell_points, self._handle, 0, None, None)
        found = BezierCellPoints(numpy.empty((n, self.dimension)), numpy.empty(n))
        call(lib.nurbs_bezier_cell_points, self._handle, n, *addresses(*found), None)
        return found
