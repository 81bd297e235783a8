# SPDX-License-Identifier: MIT
"""Curves where shapes meet, and the nodes where these end."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Dict, NamedTuple, NoReturn, Optional, SupportsIndex, Type, TypeVar

import numpy

from ._arrays import addresses
from ._calls import watched
from ._library import call, lib
from ._spline import Spline

if TYPE_CHECKING:
    from ._arrays import Floats, Int32s, Int64s
    from ._calls import Progress
    from ._faces import Face

__all__ = ["Meet", "MeetBranch", "MeetBranches", "MeetCounts", "MeetFaces", "MeetJoints", "MeetNodes", "MeetPlaces",
           "MeetWays"]

_Meet = TypeVar("_Meet", bound="Meet")


class MeetCounts(NamedTuple):
    """How many branches and nodes a meet has, and whether it is proven that there is nothing else."""

    branches: int
    nodes: int
    complete: bool


class MeetBranches(NamedTuple):
    """Of each branch the plane (n,), the nodes (n, 2) at which it begins and ends (-1: it closes), the closed way (n,) that
    it is a part of (-1: none; those of one way follow each other), and a proven bound (n,) of the distances of its curves
    from the section."""

    levels: Int64s
    end_nodes: Int64s
    loops: Int64s
    deviations: Floats


class MeetBranch(NamedTuple):
    """A branch: cubic curves with common knots, in space and in the parameter domain."""

    space: Spline
    on_surface: Spline


class MeetNodes(NamedTuple):
    """Of each node the plane (n,), a NURBS_NODE_ constant (n,), parameters (n, 2) of the surface, and of a part its range
    (n, 2, 2) on each axis."""

    levels: Int64s
    kinds: Int32s
    params: Floats
    ranges: Floats


class MeetPlaces(NamedTuple):
    """Of each node parameters (n, 2) of the second of two surfaces, and of a part its range (n, 2, 2) on each axis."""

    params: Floats
    ranges: Floats


class MeetWays(NamedTuple):
    """Of each way the plane (n,), its first branch (n,) and the number of its branches (n,), which follow each other, whether
    it closes (n,), and the largest distance (n,) in space between ends that go on in each other."""

    levels: Int64s
    firsts: Int64s
    sizes: Int64s
    closed: Int32s
    gaps: Floats


class MeetFaces(NamedTuple):
    """Of each branch the face (n,) of the model and the instance (n,) of its part; -1 in a meet of one surface."""

    faces: Int64s
    instances: Int64s


class MeetJoints(NamedTuple):
    """Of each node the node (n,) of the branch that goes on, or that came there (-1: none), how far apart in space (n,) the ends
    of both are, and the face (n,) of the model with the instance (n,) of its part, -1 in a meet of one surface."""

    next_nodes: Int64s
    gaps: Floats
    faces: Int64s
    instances: Int64s


class Meet:
    """Where a surface meets planes or another surface, or a model planes: curves, and the nodes where they end, as
    Spline.sections(), Spline.meet() and Model.sections() find them.

        meet = surface.sections([0, 0, 1], [0.25, 0.5], 1e-6)
        for i, level in enumerate(meet.branches.levels):
            space, on_surface = meet.branch(i)

    Meets never change, and many threads may use them at once; copies are made in constant time.
    """

    _handle: Optional[int] = None

    def __init__(self) -> None:
        raise TypeError("a Meet is an answer: of Spline.sections()")

    @classmethod
    def _made(cls: Type[_Meet], function: Any, *arguments: Any) -> _Meet:
        """The meet that a function writes through its last argument."""
        meet, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            meet.__dict__["_handle"] = handle.value
        return meet

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Meet does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Meet does not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_meet_destroy(handle)

    def copy(self: _Meet) -> _Meet:
        """Another handle on the same meet, in constant time; copy.copy() and copy.deepcopy() do the same."""
        return self._made(lib.nurbs_meet_clone, self._handle)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Meet:
        return self.copy()

    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn:
        raise TypeError("a Meet has no bytes: keep its curves")

    def __repr__(self) -> str:
        branches, nodes, complete = self.counts
        return f"<Meet of {branches} branches and {nodes} nodes{'' if complete else ', not complete'}>"

    # --- What is found ---

    @property
    def counts(self) -> MeetCounts:
        """How much it holds."""
        branches, nodes, complete = ctypes.c_int64(), ctypes.c_int64(), ctypes.c_int32()
        call(lib.nurbs_meet_counts, self._handle, *map(ctypes.byref, (branches, nodes, complete)))
        return MeetCounts(branches.value, nodes.value, bool(complete.value))

    @property
    def branches(self) -> MeetBranches:
        """What the branches belong to, and where they end."""
        n = self.counts.branches
        found = MeetBranches(numpy.empty(n, numpy.int64), numpy.empty((n, 2), numpy.int64), numpy.empty(n, numpy.int64),
                             numpy.empty(n))
        call(lib.nurbs_meet_branches, self._handle, n, *addresses(*found), None)
        return found

    def branch(self, index: int) -> MeetBranch:
        """The curves of a branch."""
        space = ctypes.c_void_p()
        on_surface = Spline._made(lib.nurbs_meet_branch, self._handle, index, ctypes.byref(space))
        return MeetBranch(Spline._owner(space.value), on_surface)

    @property
    def nodes(self) -> MeetNodes:
        """Where branches end, and where there may be more than they tell."""
        n = self.counts.nodes
        found = MeetNodes(numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int32), numpy.empty((n, 2)),
                          numpy.empty((n, 2, 2)))
        call(lib.nurbs_meet_nodes, self._handle, n, *addresses(*found), None)
        return found

    def branch_second(self, index: int) -> Spline:
        """The curve of a branch in the parameter domain of the second of two surfaces."""
        return Spline._made(lib.nurbs_meet_branch_second, self._handle, index)

    @property
    def nodes_second(self) -> MeetPlaces:
        """Where the nodes are on the second of two surfaces."""
        n = self.counts.nodes
        found = MeetPlaces(numpy.empty((n, 2)), numpy.empty((n, 2, 2)))
        call(lib.nurbs_meet_nodes_second, self._handle, n, *addresses(*found), None)
        return found

    @property
    def ways(self) -> MeetWays:
        """The ways that the branches make, from one to the next."""
        count = ctypes.c_int64()
        call(lib.nurbs_meet_ways, self._handle, 0, None, None, None, None, None, ctypes.byref(count))
        n = count.value
        found = MeetWays(numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64),
                         numpy.empty(n, numpy.int32), numpy.empty(n))
        call(lib.nurbs_meet_ways, self._handle, n, *addresses(*found), None)
        return found

    @property
    def branch_kinds(self) -> Int32s:
        """What the branches are: one of the NURBS_BRANCH_ constants each."""
        kinds = numpy.empty(self.counts.branches, numpy.int32)
        call(lib.nurbs_meet_branch_kinds, self._handle, len(kinds), *addresses(kinds), None)
        return kinds

    @property
    def faces(self) -> MeetFaces:
        """The faces of a model on which the branches are."""
        n = self.counts.branches
        found = MeetFaces(numpy.empty(n, numpy.int64), numpy.empty(n, numpy.int64))
        call(lib.nurbs_meet_faces, self._handle, n, *addresses(*found), None)
        return found

    @property
    def joints(self) -> MeetJoints:
        """How ways go on at the nodes, and on which faces of a model these are."""
        n = self.counts.nodes
        found = MeetJoints(numpy.empty(n, numpy.int64), numpy.empty(n), numpy.empty(n, numpy.int64),
                           numpy.empty(n, numpy.int64))
        call(lib.nurbs_meet_joints, self._handle, n, *addresses(*found), None)
        return found

    def trim(self: _Meet, face: Face, *, progress: Progress = None, work: Optional[int] = None) -> _Meet:
        """What of the branches lies in a face of the surface that they are on."""
        return self._made(watched(lib.nurbs_meet_trim, progress, work), self._handle, face._handle)
