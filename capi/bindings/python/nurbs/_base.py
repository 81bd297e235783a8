# SPDX-License-Identifier: MIT
"""What all methods of a spline stand on: the handle, and what the spline is made of."""

from __future__ import annotations

import ctypes
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple, Optional, Tuple, cast

import numpy

from ._arrays import Output, addresses, exactly, if_given, parameters, vector
from ._library import call, get, lib
from .constants import NURBS_FORM_PERIODIC

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._arrays import Floats, Int32s, Records, Shape
    from ._files import SplineList
    from ._spline import Spline


class DistinctKnots(NamedTuple):
    """Knots (n,) of an axis without repetitions, and how often each occurs (n,)."""

    knots: Floats
    multiplicities: Int32s


class SplineBase:
    """The handle of a spline, which never changes, and its properties: numbers and tuples, and arrays that are
    copies."""

    _handle: Optional[int] = None

    # --- Handles ---

    @classmethod
    def _owner(cls, handle: Optional[int]) -> Spline:
        spline = cls.__new__(cls)
        spline.__dict__["_handle"] = handle
        return cast("Spline", spline)

    @classmethod
    def _made(cls, function: Any, *arguments: Any) -> Spline:
        """The spline that a function writes through its last argument."""
        spline, handle = cls._owner(None), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            spline.__dict__["_handle"] = handle.value
        return spline

    @staticmethod
    def _listed(function: Any, *arguments: Any) -> SplineList:
        """The list that a function writes through its last argument."""
        from ._files import SplineList  # which makes splines, and so cannot come before them

        return SplineList._made(function, *arguments)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Spline does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Spline does not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_destroy(handle)

    # --- What it is made of; what axes have comes in tuples, of curves too ---

    @cached_property
    def axes(self) -> int:
        """Number of parametric axes: 1 curve, 2 surface, 3 volume."""
        return int(get(ctypes.c_int32, lib.nurbs_axes, self._handle))

    @cached_property
    def dimension(self) -> int:
        """Number of coordinates of a point."""
        return int(get(ctypes.c_int32, lib.nurbs_dimension, self._handle))

    @cached_property
    def rational(self) -> bool:
        """Whether it has weights, equal ones included."""
        return bool(get(ctypes.c_int32, lib.nurbs_is_rational, self._handle))

    @cached_property
    def is_homogeneous(self) -> bool:
        """Whether homogeneous points are stored, and not Cartesian ones with or without weights."""
        return bool(get(ctypes.c_int32, lib.nurbs_is_homogeneous, self._handle))

    @cached_property
    def degrees(self) -> Tuple[int, ...]:
        """Degree of each axis."""
        return tuple(get(ctypes.c_int32, lib.nurbs_degree, self._handle, axis) for axis in range(self.axes))

    @cached_property
    def counts(self) -> Tuple[int, ...]:
        """Number of control points along each axis."""
        return tuple(get(ctypes.c_int64, lib.nurbs_count, self._handle, axis) for axis in range(self.axes))

    @cached_property
    def point_count(self) -> int:
        """Number of control points: the product of counts."""
        return int(get(ctypes.c_int64, lib.nurbs_point_count, self._handle))

    @cached_property
    def knot_forms(self) -> Tuple[int, ...]:
        """Form of each knot vector, a sum of NURBS_FORM_ constants: clamped at the start, at the end, periodic."""
        return tuple(get(ctypes.c_int32, lib.nurbs_knot_form, self._handle, axis) for axis in range(self.axes))

    @cached_property
    def periodic(self) -> Tuple[bool, ...]:
        """Whether each axis was declared periodic."""
        return tuple(bool(form & NURBS_FORM_PERIODIC) for form in self.knot_forms)

    @cached_property
    def domain(self) -> Tuple[Tuple[float, float], ...]:
        """The interval [knots[degree], knots[count]] of each axis, as (lower, upper)."""
        return tuple((float(ends[0]), float(ends[1])) for ends in self._each(lib.nurbs_domain, [2] * self.axes, False))

    @property
    def knots(self) -> Tuple[Floats, ...]:
        """Full knot vector of each axis, (count + degree + 1,)."""
        sizes = [count + degree + 1 for count, degree in zip(self.counts, self.degrees)]
        return self._each(lib.nurbs_knots, sizes)

    @property
    def greville(self) -> Tuple[Floats, ...]:
        """Greville abscissae of each axis, (count,): x_i = (t_(i+1) + ... + t_(i+p)) / p."""
        return self._each(lib.nurbs_greville, self.counts)

    @property
    def distinct_knots(self) -> Tuple[DistinctKnots, ...]:
        """Distinct knots of each axis, and their multiplicities."""
        return tuple(self._distinct(axis) for axis in range(self.axes))

    @property
    def short_knots(self) -> Tuple[Floats, ...]:
        """Knot vector (count + degree - 1,) of each axis without its first and last knot, as openNURBS and Rhino have it.
        Raises ArgumentError if a degree is 0."""
        return tuple(self._counted(lib.nurbs_short_knots, axis) for axis in range(self.axes))

    @cached_property
    def unwrapped_counts(self) -> Tuple[int, ...]:
        """Number of control points along each axis, each counted once: count - degree where it is periodic."""
        return tuple(get(ctypes.c_int64, lib.nurbs_unwrapped_count, self._handle, axis) for axis in range(self.axes))

    @property
    def unwrapped_knots(self) -> Tuple[Floats, ...]:
        """Knots of each axis as create_periodic() takes them: those of one period with its end where it is periodic."""
        return tuple(self._counted(lib.nurbs_unwrapped_knots, axis) for axis in range(self.axes))

    @property
    def unwrapped_points(self) -> Floats:
        """Cartesian control points (unwrapped_counts..., dimension), each once, as create_periodic() takes them."""
        return self._unwrapped()[0]

    @property
    def unwrapped_weights(self) -> Optional[Floats]:
        """Weights (unwrapped_counts...), each once; None of a polynomial spline."""
        return self._unwrapped()[1] if self.rational else None

    @property
    def points(self) -> Floats:
        """Cartesian control points (counts..., dimension), bit for bit as they were given. Those built homogeneous are
        divided by their weights, one at infinity has infinite and NaN coordinates."""
        return self._net(lib.nurbs_points, self.dimension)

    @property
    def weights(self) -> Optional[Floats]:
        """Weights (counts...); None of a polynomial spline."""
        if not self.rational:
            return None
        output = Output(None, self.counts, 1)
        call(lib.nurbs_weights, self._handle, output.records.n, *output.layout[:2])
        return output.finish()

    @property
    def homogeneous_points(self) -> Floats:
        """Homogeneous control points (w x, w y, ..., w), (counts..., dimension + 1)."""
        return self._net(lib.nurbs_homogeneous_points, self.dimension + 1)

    def _each(self, function: Any, sizes: Iterable[int], sized: bool = True) -> Tuple[Floats, ...]:
        """A vector of each axis."""
        vectors = tuple(numpy.empty(size) for size in sizes)
        for axis, values in enumerate(vectors):
            call(function, self._handle, axis, *[values.size] * sized, values.ctypes.data)
        return vectors

    def _distinct(self, axis: int) -> DistinctKnots:
        size = get(ctypes.c_int64, lib.nurbs_distinct_knots, self._handle, axis, 0, None, None)
        found = DistinctKnots(numpy.empty(size), numpy.empty(size, numpy.int32))
        get(ctypes.c_int64, lib.nurbs_distinct_knots, self._handle, axis, size, *addresses(*found))
        return found

    def _counted(self, function: Any, axis: int) -> Floats:
        """A vector of an axis that is as long as the function says."""
        values = numpy.empty(get(ctypes.c_int64, function, self._handle, axis, 0, None))
        get(ctypes.c_int64, function, self._handle, axis, values.size, values.ctypes.data)
        return values

    def _unwrapped(self) -> Tuple[Floats, Floats]:
        points = numpy.empty((*self.unwrapped_counts, self.dimension))
        weights = numpy.empty(self.unwrapped_counts)
        get(ctypes.c_int64, lib.nurbs_unwrapped_points, self._handle, weights.size, *addresses(points, weights))
        return points, weights

    def _net(self, function: Any, width: int) -> Floats:
        output = Output(None, (*self.counts, width), width)
        call(function, self._handle, output.records.n, *output.layout)
        return output.finish()

    # --- Arguments that many methods take ---

    def _params(self, params: ArrayLike) -> Tuple[Records, Shape]:
        return parameters(params, self.axes)

    def _part(self, part: Optional[ArrayLike]) -> Optional[NDArray[Any]]:
        """A part (axes, 2) of the domain, or None."""
        return if_given(part, 2 * self.axes, "a range")

    def _coordinates(self, values: ArrayLike, what: str) -> NDArray[Any]:
        """A point or vector of the space of the spline."""
        given, dim = vector(values), self.dimension
        if given.size > dim:
            raise ValueError(f"{what} of {given.size} numbers, expected {dim}, the dimension of the spline; "
                             f"transform(numpy.eye({given.size}, {dim})) lifts it")
        return exactly(given, dim, what)


def handle_of(spline: SplineBase) -> Optional[int]:
    """The handle of another spline than `self`."""
    if not isinstance(spline, SplineBase):
        raise TypeError(f"a Spline is expected, not {type(spline).__name__}")
    return spline._handle


def handles(splines: Iterable[SplineBase], count: Optional[int] = None) -> Any:
    """Splines as an array of handles, which keeps them alive."""
    given = list(splines)
    if count is not None and len(given) != count:
        raise ValueError(f"{len(given)} splines, expected {count}")
    array: Any = (ctypes.c_void_p * len(given))(*map(handle_of, given))
    array.splines = given
    return array
