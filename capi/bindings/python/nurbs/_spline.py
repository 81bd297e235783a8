# SPDX-License-Identifier: MIT
"""Curves, surfaces and volumes."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Sequence, SupportsIndex, Tuple, Type, Union

import numpy

from ._arrays import vector
from ._library import lib
from ._net import Net, concatenated
from ._bytes import given as given_bytes, pickled, written
from ._analysis import Analysis
from ._bounds import Bounds
from ._calculus import Calculus
from ._closest import Distances
from ._cloud import Clouds
from ._constrain import Constraints
from ._continuation import Continuation
from ._deform import Deformations
from ._edit import Edits
from ._evaluation import Evaluation
from ._forms import Forms, Transformations
from ._frames import Frames
from ._intersections import Intersections
from ._linear import Linear
from ._measure import Measures
from ._mesh import Meshes
from ._plot import Plots
from ._reduce import Reduction
from ._refinement import Refinement
from ._segments import Segments
from ._sweeps import Sweeps
from .constants import NURBS_PERIODIC

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._bytes import Contents

__all__ = ["Spline"]


class Spline(Evaluation, Calculus, Refinement, Forms, Transformations, Continuation, Reduction, Segments, Sweeps,
             Frames, Distances, Measures, Bounds, Analysis, Intersections, Edits, Constraints, Deformations, Clouds,
             Linear, Meshes, Plots):
    """A curve, surface or volume: C(t) = sum_i w_i N_i(t) P_i / sum_j w_j N_j(t).

        s = nurbs.Spline(2, [0, 0, 0, 1, 1, 1], [[1, 0], [1, 1], [0, 1]], [1, 0.5**0.5, 1])
        s(t), s(t, nu=1), s.derivative(), s.insert_knot(0.5), s.knots, s.points, s.weights, s.domain

    What it is made of are properties; those of axes are tuples with one entry for each axis, of a curve too. Every C
    function whose first argument is a spline is a method. A spline never changes: methods return new ones, arrays are
    copies (with_points() makes a spline of changed ones), and many threads may use one at once.

    Splines are equal if they are so bit for bit, in degrees, knots, points, weights and periodicity, not if they only
    have the same shape (see deviation()). They can be hashed, and pickled without a loss.
    """

    def __init__(self, degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]],
                 points: ArrayLike, weights: Optional[ArrayLike] = None, flags: int = 0) -> None:
        """From full knot vectors: `degrees` a number or one for each axis, `knots` a vector (count + degree + 1,) or
        one for each axis, `points` (counts..., dimension), `weights` (counts...) or None, `flags` NURBS_PERIODIC by
        axis. Raises ArgumentError."""
        if self._handle:
            raise TypeError("a Spline does not change: it cannot be initialised again")
        net = Net(degrees, points, weights)
        vectors, _ = concatenated(knots, net.axes)
        made = self._made(lib.nurbs_create, *net.sizes, vectors.ctypes.data, vectors.size, net.width,
                          *net.points.layout, *net.weight_layout, flags)
        # The handle goes from one owner to the other.
        self.__dict__["_handle"] = made.__dict__.pop("_handle")

    @classmethod
    def create_homogeneous(cls, degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]],
                           points: ArrayLike, flags: int = 0) -> Spline:
        """A rational spline from points (counts..., dimension + 1) that are (w x, w y, ..., w): weights may be
        negative, or 0, which is a control point at infinity."""
        net = Net(degrees, points, None)
        vectors, _ = concatenated(knots, net.axes)
        return cls._made(lib.nurbs_create_homogeneous, *net.sizes, vectors.ctypes.data, vectors.size, net.width - 1,
                         *net.points.layout, flags)

    @classmethod
    def create_short(cls, degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]],
                     points: ArrayLike, weights: Optional[ArrayLike] = None, flags: int = 0) -> Spline:
        """From knot vectors (count + degree - 1,) without their first and last knot, as openNURBS, Rhino and Maya write
        them."""
        net = Net(degrees, points, weights)
        vectors, _ = concatenated(knots, net.axes)
        return cls._made(lib.nurbs_create_short, *net.sizes, vectors.ctypes.data, vectors.size, net.width,
                         *net.points.layout, *net.weight_layout, flags)

    @classmethod
    def create_multiplicities(cls, degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]],
                              multiplicities: Union[ArrayLike, Sequence[ArrayLike]], points: ArrayLike,
                              weights: Optional[ArrayLike] = None, flags: int = 0) -> Spline:
        """From distinct knots and how often each occurs, two vectors or two for each axis, as STEP and Open CASCADE
        write them."""
        net = Net(degrees, points, weights)
        vectors, lengths = concatenated(knots, net.axes)
        times, others = concatenated(multiplicities, net.axes, numpy.int32)
        if lengths != others:
            raise ValueError(f"{others} multiplicities for {lengths} knots")
        sizes = vector(lengths, numpy.int64)
        return cls._made(lib.nurbs_create_multiplicities, *net.sizes, sizes.ctypes.data, vectors.ctypes.data,
                         times.ctypes.data, net.width, *net.points.layout, *net.weight_layout, flags)

    @classmethod
    def bezier(cls, points: ArrayLike, weights: Optional[ArrayLike] = None) -> Spline:
        """A Bezier spline over [0, 1] on every axis, of the degrees that the shape (degree + 1..., dimension) of points
        has."""
        given = numpy.asarray(points, dtype=numpy.float64)
        net = Net([count - 1 for count in given.shape[:-1]], given, weights)
        return cls._made(lib.nurbs_create_bezier, net.axes, net.degrees.ctypes.data, net.width, *net.points.layout,
                         *net.weight_layout)

    @classmethod
    def create_periodic(cls, degrees: Union[int, Sequence[int]], knots: Union[ArrayLike, Sequence[ArrayLike]],
                        points: ArrayLike, weights: Optional[ArrayLike] = None, flags: int = NURBS_PERIODIC) -> Spline:
        """From control points that are given once: along an axis with flag NURBS_PERIODIC the points (m...) do not
        repeat, and the knots are the m + 1 of one period with its end. Other axes are as Spline() takes them."""
        net = Net(degrees, points, weights)
        vectors, _ = concatenated(knots, net.axes)
        return cls._made(lib.nurbs_create_periodic, *net.sizes, vectors.ctypes.data, vectors.size, net.width,
                         *net.points.layout, *net.weight_layout, flags)

    # --- A value: bytes, copies, equality, pickles ---

    def to_bytes(self) -> bytes:
        """The spline as bytes, to be kept or sent: the same on every machine for the same spline. nurbs.h says where
        in them the control points are."""
        return written(lib.nurbs_to_bytes, self._handle).tobytes()

    @classmethod
    def from_bytes(cls, contents: Contents) -> Spline:
        """The spline of what to_bytes() gave, in bytes or any memory that holds them. Raises ContentsError for other
        bytes."""
        given = given_bytes(contents)
        return cls._made(lib.nurbs_from_bytes, given.ctypes.data, given.size)

    def copy(self) -> Spline:
        """Another handle on the same spline, in constant time; copy.copy() and copy.deepcopy() do the same."""
        return self._made(lib.nurbs_clone, self._handle)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Spline:
        return self.copy()

    def __reduce_ex__(self, protocol: SupportsIndex) -> Tuple[Callable[..., Spline], Tuple[Any, ...]]:
        return _restored_spline, (type(self), pickled(lib.nurbs_to_bytes, self._handle, protocol))

    @cached_property
    def _key(self) -> bytes:
        return self.to_bytes()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Spline):
            return NotImplemented
        return self is other or (self.degrees == other.degrees and self.counts == other.counts
                                 and self._key == other._key)

    def __hash__(self) -> int:
        return hash(self._key)

    def __repr__(self) -> str:
        kind = {1: "curve", 2: "surface"}.get(self.axes, "volume")
        form = "rational" if self.rational else "polynomial"
        domain = " x ".join(f"[{low:g}, {high:g}]" for low, high in self.domain)
        return (f"<Spline: {form} {kind} in {self.dimension}D: degree {_by_axis(self.degrees)}, "
                f"{_by_axis(self.counts)} points, domain {domain}{_periodic_axes(self.periodic)}>")


def _by_axis(values: Tuple[int, ...]) -> str:
    return " x ".join(map(str, values))


def _periodic_axes(periodic: Tuple[bool, ...]) -> str:
    axes = [str(axis) for axis, is_so in enumerate(periodic) if is_so]
    where = f" on axis {' and '.join(axes)}" if len(periodic) > 1 else ""
    return f", periodic{where}" if axes else ""


# A function, since cloudpickle, by which Dask sends programs, does not know class methods by their names.
def _restored_spline(kind: Type[Spline], contents: Any) -> Spline:
    """A pickled spline."""
    return kind.from_bytes(contents)


# Of the pickles of version 1.0.
def _restored(homogeneous: bool, degrees: Tuple[int, ...], knots: Any, points: Any, weights: Any, flags: int,
              kind: Optional[Type[Spline]] = None) -> Spline:
    """The spline that a constructor makes of these arguments, of a derived class if there is one: its instances are made
    without its __init__(), as by all methods."""
    made = (Spline.create_homogeneous(degrees, knots, points, flags) if homogeneous
            else Spline(degrees, knots, points, weights, flags))
    return made if kind is None else kind._owner(made.__dict__.pop("_handle"))
