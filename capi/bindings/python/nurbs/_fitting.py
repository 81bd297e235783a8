# SPDX-License-Identifier: MIT
"""Splines closest to data, and statistics of data."""

from __future__ import annotations

import ctypes
from functools import cached_property
from typing import (TYPE_CHECKING, Any, Callable, Dict, Iterable, NamedTuple, Optional, Sequence, SupportsIndex, Tuple,
                    Type, Union)

import numpy

from ._arrays import address, exactly, if_given, one_each, packed, records, vector
from ._bytes import given as given_bytes, pickled, written
from ._calls import watched
from ._library import call, get, int32, lib, uint32
from ._net import concatenated
from ._spline import Spline
from .constants import (NURBS_ROBUST_HUBER, NURBS_ROBUST_NONE, NURBS_ROBUST_TUKEY, NURBS_SMOOTHING_DISCREPANCY, NURBS_SMOOTHING_GCV, NURBS_SMOOTHING_LAMBDA, NURBS_SMOOTHING_NONE, NURBS_SMOOTHING_REML,
                        NURBS_TREND_CONCAVE, NURBS_TREND_CONVEX, NURBS_TREND_FALLING, NURBS_TREND_RISING)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._calls import Progress
    from ._fit import ByAxis

    #: Parameters, orders of derivatives or None for 0, and targets.
    Conditions = Tuple[ArrayLike, Optional[ArrayLike], ArrayLike]
    #: Words with spaces between them, or sums of NURBS_TREND_ constants.
    Shape = Union[str, ArrayLike, None]

__all__ = ["FitReport", "Fitted", "Statistics", "cloud_start", "fit_points", "fit_tolerance"]

_SMOOTHINGS = {"none": NURBS_SMOOTHING_NONE, "lambda": NURBS_SMOOTHING_LAMBDA, "gcv": NURBS_SMOOTHING_GCV,
               "reml": NURBS_SMOOTHING_REML, "discrepancy": NURBS_SMOOTHING_DISCREPANCY}
_ROBUST = {"none": NURBS_ROBUST_NONE, "huber": NURBS_ROBUST_HUBER, "tukey": NURBS_ROBUST_TUKEY}
_TRENDS = {"rising": NURBS_TREND_RISING, "falling": NURBS_TREND_FALLING, "convex": NURBS_TREND_CONVEX,
           "concave": NURBS_TREND_CONCAVE}


class FitReport(NamedTuple):
    """The number of data that count and the sum of their weights, sum_i w_i |y_i - s(t_i)|^2 and the root of its mean,
    the factor lambda of the penalty, the number of parameters that count, the standard deviation of a coordinate of
    weight 1, the residual of the normal equations, the largest |y_i - s(t_i)| and where it is (NaN and -1 of
    statistics), a sum of NURBS_FIT_ bits, and of a robust fit the number of rounds and of outliers."""

    data_count: int
    weight: float
    squares: float
    rms: float
    lam: float
    freedom: float
    sigma: float
    residual: float
    largest: float
    largest_index: int
    bits: int
    rounds: int
    outliers: int


class Fitted(NamedTuple):
    """The spline, and how close to the data it is."""

    spline: Spline
    report: FitReport


# --- The structs ---

class _Data(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("n", ctypes.c_int64), ("axes", ctypes.c_int32),
                ("dim", ctypes.c_int32), ("params", ctypes.c_void_p), ("param_stride", ctypes.c_int64),
                ("param_component_stride", ctypes.c_int64), ("values", ctypes.c_void_p),
                ("value_stride", ctypes.c_int64), ("value_component_stride", ctypes.c_int64),
                ("weights", ctypes.c_void_p), ("weight_stride", ctypes.c_int64), ("flags", ctypes.c_uint32),
                ("reserved", ctypes.c_uint32)]


class _Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("smoothing", ctypes.c_int32), ("penalty_order", ctypes.c_int32),
                ("lam", ctypes.c_double), ("target", ctypes.c_double), ("regularize", ctypes.c_int32),
                ("reserved", ctypes.c_int32), ("conditions", ctypes.c_int64), ("condition_params", ctypes.c_void_p),
                ("condition_orders", ctypes.c_void_p), ("condition_targets", ctypes.c_void_p),
                ("robust", ctypes.c_int32), ("reserved2", ctypes.c_int32), ("robust_width", ctypes.c_double),
                ("shapes", ctypes.c_void_p), ("lower", ctypes.c_void_p), ("upper", ctypes.c_void_p)]


class _Report(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("data_count", ctypes.c_int64), ("weight", ctypes.c_double),
                ("squares", ctypes.c_double), ("rms", ctypes.c_double), ("lam", ctypes.c_double),
                ("freedom", ctypes.c_double), ("sigma", ctypes.c_double), ("residual", ctypes.c_double),
                ("largest", ctypes.c_double), ("largest_index", ctypes.c_int64), ("bits", ctypes.c_int32),
                ("rounds", ctypes.c_int32), ("outliers", ctypes.c_int64)]


def _width(array: NDArray[Any]) -> int:
    """The number of columns; a vector has one."""
    return int(array.shape[1]) if array.ndim == 2 else 1


def _data(params: ArrayLike, values: ArrayLike, weights: Optional[ArrayLike], flags: int) -> Any:
    """Data as the library takes them, with the arrays that they are in."""
    at, given = numpy.asarray(params, numpy.float64), numpy.asarray(values, numpy.float64)
    for array, name, what in (at, "params", "axes"), (given, "values", "dim"):
        if array.ndim not in (1, 2):
            raise ValueError(f"{name} of shape {array.shape}, expected (n,) or (n, {what})")
    n = len(at)
    if len(given) != n:
        raise ValueError(f"values of shape {given.shape} for {n} parameters")
    places, points = records(at, _width(at)), records(given, _width(given))
    each = None if weights is None else one_each(weights, (n,), "weights")
    data = _Data()
    call(lib.nurbs_data_init, ctypes.byref(data), ctypes.sizeof(data))
    data.n, data.axes, data.dim, data.flags = n, int32(_width(at)), int32(_width(given)), uint32(flags)
    data.params, data.param_stride, data.param_component_stride = places.layout
    data.values, data.value_stride, data.value_component_stride = points.layout
    if each is not None:
        data.weights, data.weight_stride = each.layout[:2]
    data.arrays = places, points, each  # kept alive
    return data


def _constant(given: Union[int, str], names: Dict[str, int], what: str) -> int:
    """A constant that may be named."""
    if isinstance(given, str):
        if given not in names:
            raise ValueError(f"{what} = {given!r}, expected one of {', '.join(names)}")
        return names[given]
    return int32(given)


def _trends(shape: Shape, axes: int, dim: int) -> Optional[NDArray[Any]]:
    """Sums of constants for each coordinate along each axis."""
    if shape is None:
        return None
    if isinstance(shape, str):
        shape = sum({_constant(word, _TRENDS, "shape") for word in shape.split()})
    return packed(numpy.broadcast_to(numpy.asarray(shape, numpy.int32), (axes, dim)), numpy.int32)


def _bounds(bounds: Optional[ArrayLike], dim: int) -> Optional[NDArray[Any]]:
    """One for each coordinate."""
    return None if bounds is None else packed(numpy.broadcast_to(numpy.asarray(bounds, numpy.float64), (dim,)))


def _options(axes: int, dim: int, smoothing: Union[int, str], penalty_order: int, lam: float, target: float,
             regularize: bool, conditions: Optional[Conditions], shape: Shape, lower: Optional[ArrayLike],
             upper: Optional[ArrayLike]) -> Any:
    """Options as the library takes them, with the arrays that they are in."""
    options = _Options()
    call(lib.nurbs_fit_options_init, ctypes.byref(options), ctypes.sizeof(options))
    options.smoothing, options.penalty_order = _constant(smoothing, _SMOOTHINGS, "smoothing"), int32(penalty_order)
    options.lam, options.target, options.regularize = lam, target, bool(regularize)
    kept = [_trends(shape, axes, dim), _bounds(lower, dim), _bounds(upper, dim)]
    options.shapes, options.lower, options.upper = map(address, kept)
    if conditions is not None:
        params, orders, targets = conditions
        at = records(packed(params), axes)
        given = if_given(orders, at.n * axes, "orders of conditions", numpy.int32)
        goals = exactly(targets, at.n * dim, "targets of conditions")
        options.conditions, options.condition_params = at.n, at.layout[0]
        options.condition_orders, options.condition_targets = address(given), goals.ctypes.data
        options.conditions_arrays = at, given, goals  # kept alive
    options.arrays = kept
    return options


# --- Fits ---

def _degrees(degrees: Union[int, Sequence[int]], axes: int) -> NDArray[Any]:
    """A degree for each parameter of data."""
    p = vector(degrees, numpy.int32)
    if p.size != axes:
        raise ValueError(f"{p.size} degrees for {axes} parameters of each datum")
    return p


class _Space:
    """Degrees, and full knot vectors."""

    def __init__(self, degrees: Union[int, Sequence[int]], knots: ByAxis, axes: int) -> None:
        self.degrees = _degrees(degrees, axes)
        self.knots, lengths = concatenated(knots, axes)
        self.counts = vector(lengths, numpy.int64) - self.degrees - 1

    @property
    def layout(self) -> Tuple[int, int, int, int]:
        """Degrees, counts, knots, and their number."""
        return self.degrees.ctypes.data, self.counts.ctypes.data, self.knots.ctypes.data, self.knots.size


def _fitted(function: Any, *arguments: Any) -> Fitted:
    """What a function finds that writes a report and a spline through its last arguments."""
    report: Any = _Report(ctypes.sizeof(_Report))
    made = Spline._made(function, *arguments, ctypes.byref(report))
    return Fitted(made, FitReport(*(getattr(report, name) for name in FitReport._fields)))


class Statistics:
    """What a fit needs to know of data: sums over the cells between breaks, which can be added and subtracted.

        empty = nurbs.Statistics(3, numpy.linspace(0, 1, 65), value_scale=10.0)
        parts = [empty.add(params, values) for params, values in chunks]
        spline, report = nurbs.Statistics.merge(parts).fit(3, nurbs.knots_open_uniform(3, 19), smoothing="gcv")

    Knots, among the breaks, degrees and smoothing are chosen afterwards, without the data. The sums are exact: those of
    parts, in any order, are those of all data at once, bit for bit. Statistics never change: methods return new ones,
    and many threads may use them at once. They are equal if all of their bits are, can be hashed, and pickled without a
    loss.
    """

    _handle: Optional[int] = None

    def __init__(self, degrees: Union[int, Sequence[int]], breaks: ByAxis, dim: int = 1, *, value_scale: float,
                 weight_scale: float = 1.0) -> None:
        """Of no data: `degrees` are the highest ones of splines that are to be fitted, a number or one for each axis,
        `breaks` increase, a vector or one for each axis, data lie from the first to the last one. Values have `dim`
        coordinates of at most `value_scale`, weights are at most `weight_scale`; both are rounded up to powers of two,
        and what is above them is refused. Raises ArgumentError."""
        if self._handle:
            raise TypeError("Statistics do not change: they cannot be initialised again")
        p = vector(degrees, numpy.int32)
        joined, lengths = concatenated(breaks, p.size)
        counts = vector(lengths, numpy.int64)
        made = self._made(lib.nurbs_statistics_create, p.size, p.ctypes.data, counts.ctypes.data, joined.ctypes.data,
                          joined.size, dim, value_scale, weight_scale)
        # The handle goes from one owner to the other.
        self.__dict__["_handle"] = made.__dict__.pop("_handle")

    @classmethod
    def _made(cls, function: Any, *arguments: Any) -> Statistics:
        """The statistics that a function writes through its last argument."""
        statistics, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            statistics.__dict__["_handle"] = handle.value
        return statistics

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"Statistics do not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"Statistics do not change: {name} cannot be deleted")

    def __del__(self) -> None:
        handle = self.__dict__.get("_handle")
        if lib is not None and handle:
            lib.nurbs_statistics_destroy(handle)

    # --- How much data they hold ---

    @cached_property
    def _size(self) -> Tuple[int, int, int, int, float]:
        axes, dim, count, cells = ctypes.c_int32(), ctypes.c_int32(), ctypes.c_int64(), ctypes.c_int64()
        weight = get(ctypes.c_double, lib.nurbs_statistics_size, self._handle,
                     *map(ctypes.byref, (axes, dim, count, cells)))
        return axes.value, dim.value, count.value, cells.value, weight

    @property
    def axes(self) -> int:
        """Number of parameters of each datum."""
        return self._size[0]

    @property
    def dim(self) -> int:
        """Dimension of the values."""
        return self._size[1]

    @property
    def count(self) -> int:
        """Number of data that count."""
        return self._size[2]

    @property
    def cells(self) -> int:
        """Number of cells that hold any of them."""
        return self._size[3]

    @property
    def weight(self) -> float:
        """Sum of their weights."""
        return self._size[4]

    # --- Sums ---

    def add(self, params: ArrayLike, values: ArrayLike, weights: Optional[ArrayLike] = None, flags: int = 0, *,
            progress: Progress = None, work: Optional[int] = None) -> Statistics:
        """Statistics with more data: values (n,) or (n, dim) at parameters (n,) or (n, axes), with weights (n,), by
        default 1. `flags` are evaluation flags for the parameters; with NURBS_NAN those outside leave their values out.
        Many chunks are better each added to statistics of no data, and then merged."""
        data = _data(params, values, weights, flags)
        return self._made(watched(lib.nurbs_statistics_add, progress, work), self._handle, ctypes.byref(data))

    @classmethod
    def merge(cls, parts: Iterable[Statistics], signs: Optional[ArrayLike] = None) -> Statistics:
        """The sum of statistics that agree in degrees, breaks, dimension and scales, as + and - make it of two; those
        with the sign (n,) -1 are subtracted. Raises ArgumentError where more is subtracted than was added."""
        given = list(parts)
        for part in given:
            if not isinstance(part, Statistics):
                raise TypeError(f"Statistics are expected, not {type(part).__name__}")
        handles = (ctypes.c_void_p * len(given))(*(part._handle for part in given))
        each = if_given(signs, len(given), "signs", numpy.int32)
        return cls._made(lib.nurbs_statistics_merge, len(given), handles, address(each))

    def __add__(self, other: Statistics) -> Statistics:
        return self.merge([self, other]) if isinstance(other, Statistics) else NotImplemented

    def __sub__(self, other: Statistics) -> Statistics:
        return self.merge([self, other], [1, -1]) if isinstance(other, Statistics) else NotImplemented

    # --- A value: bytes, copies, equality, pickles ---

    def to_bytes(self) -> bytes:
        """The statistics as bytes, to be kept or sent: the same on every machine for the same data, whatever their
        order."""
        return written(lib.nurbs_statistics_to_bytes, self._handle).tobytes()

    @classmethod
    def from_bytes(cls, contents: Union[bytes, bytearray, memoryview]) -> Statistics:
        """Statistics from what to_bytes() gave. Raises ContentsError for other bytes."""
        given = given_bytes(contents)
        return cls._made(lib.nurbs_statistics_from_bytes, given.ctypes.data, given.size)

    def copy(self) -> Statistics:
        """Another handle on the same statistics, in constant time; copy.copy() and copy.deepcopy() do the same."""
        return self._made(lib.nurbs_statistics_clone, self._handle)

    __copy__ = copy

    def __deepcopy__(self, memo: Dict[int, Any]) -> Statistics:
        return self.copy()

    def __reduce_ex__(self, protocol: SupportsIndex) -> Tuple[Callable[..., Statistics], Tuple[Any, ...]]:
        return _restored_statistics, (type(self), pickled(lib.nurbs_statistics_to_bytes, self._handle, protocol))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Statistics):
            return NotImplemented
        return self is other or (self._size == other._size and self.to_bytes() == other.to_bytes())

    @cached_property
    def _hash(self) -> int:
        return hash(self.to_bytes())

    def __hash__(self) -> int:
        return self._hash

    def __repr__(self) -> str:
        axes, dim, count, cells, weight = self._size
        return (f"<Statistics: {count} values in {dim}D on {axes} {'axis' if axes == 1 else 'axes'}, "
                f"in {cells} {'cell' if cells == 1 else 'cells'}, of weight {weight:g}>")

    # --- Fits ---

    def fit(self, degrees: Union[int, Sequence[int]], knots: ByAxis, flags: int = 0, *,
            smoothing: Union[int, str] = "none", penalty_order: int = 2, lam: float = 0.0,
            target: float = 0.0, regularize: bool = False, conditions: Optional[Conditions] = None,
            shape: Shape = None, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
            progress: Progress = None, work: Optional[int] = None) -> Fitted:
        """The spline over full knot vectors, a vector or one for each axis, that is closest to the data: least
        sum_i w_i |y_i - s(t_i)|^2 + lam sum_k int (d^m s / dx_k^m)^2 dx. Knots in the domain are breaks, its ends the
        first and the last one. `flags` are NURBS_PERIODIC by axis.

        smoothing is "none", "lambda" (for the factor `lam`), "gcv", "reml", "discrepancy" (as smooth as `target`, the
        largest sum of squares, allows), or a NURBS_SMOOTHING_ constant; penalty_order is m, and x_k goes from 0 to 1.
        regularize takes of several fits that of the smallest penalty, instead of refusing them. conditions, which have
        to hold, are parameters (n,) of a curve, else (n, axes), orders of derivatives of their shape, or None for 0,
        and targets (n, dim); one alone may leave n out. shape has "rising", "falling", "convex" and "concave", with
        spaces between them, or sums of NURBS_TREND_ constants (axes, dim), or one for all: what coordinates do along
        axes; lower and upper, numbers or (dim,), bound them. Raises ArgumentError if the data do not determine the
        result.
        """
        space = _Space(degrees, knots, self.axes)
        options = _options(self.axes, self.dim, smoothing, penalty_order, lam, target, regularize, conditions,
                           shape, lower, upper)
        return _fitted(watched(lib.nurbs_fit, progress, work), self._handle, *space.layout, flags,
                       ctypes.byref(options))

    def fit_errors(self, fitted: Fitted, params: ArrayLike, penalty_order: int = 2, flags: int = 0, *,
                   progress: Progress = None, work: Optional[int] = None) -> NDArray[numpy.float64]:
        """Pointwise standard errors (n,) of a fit of these data at parameters (n,) of a curve, else (n, axes): 1.96 of
        them on both sides of each coordinate cover the true function at 95 % of all places. Conditions and shapes are
        not regarded. `flags` are evaluation flags."""
        at = records(params, self.axes)
        errors = numpy.empty(at.n)
        call(watched(lib.nurbs_fit_errors, progress, work), self._handle, fitted.spline._handle,
             penalty_order, fitted.report.lam, fitted.report.sigma, at.n, *at.layout, flags, errors.ctypes.data)
        return errors

    def fit_criteria(self, spline: Spline, lams: ArrayLike, penalty_order: int = 2, *, progress: Progress = None,
                     work: Optional[int] = None) -> NDArray[numpy.float64]:
        """What factors (n,) of the penalty lead to, over the knots of a spline: an array (n, 4) of the squares that are
        left, the number of parameters that count, and what "gcv" and "reml" make as small as they can."""
        given = vector(lams)
        values = numpy.empty((given.size, 4))
        call(watched(lib.nurbs_fit_criteria, progress, work), self._handle, spline._handle, penalty_order, given.size,
             given.ctypes.data, values.ctypes.data)
        return values


# A function, since cloudpickle, by which Dask sends programs, does not know class methods by their names.
def _restored_statistics(made: Type[Statistics], contents: Any) -> Statistics:
    """Pickled statistics."""
    return made.from_bytes(contents)


def fit_points(params: ArrayLike, values: ArrayLike, degrees: Union[int, Sequence[int]], knots: ByAxis,
               weights: Optional[ArrayLike] = None, flags: int = 0, *, data_flags: int = 0,
               smoothing: Union[int, str] = "none", penalty_order: int = 2, lam: float = 0.0,
               target: float = 0.0, regularize: bool = False, conditions: Optional[Conditions] = None,
               shape: Shape = None, lower: Optional[ArrayLike] = None, upper: Optional[ArrayLike] = None,
               robust: Union[int, str] = "none", robust_width: float = 0.0,
               progress: Progress = None, work: Optional[int] = None) -> Fitted:
    """The spline over full knot vectors that is closest to values (n,) or (n, dim) at parameters (n,) or (n, axes),
    with weights (n,), by default 1.

        spline, report = nurbs.fit_points(t, y, 3, nurbs.knots_open_uniform(3, 20), smoothing="gcv")

    `flags` are NURBS_PERIODIC by axis, `data_flags` evaluation flags for the parameters as Statistics.add() takes them;
    the other arguments are those of Statistics.fit(), but knots need not be breaks of anything. robust is "none",
    "huber" or "tukey", or a NURBS_ROBUST_ constant: what outliers are worth, which begin at `robust_width` standard
    deviations, 0 for the usual ones."""
    data = _data(params, values, weights, data_flags)
    space = _Space(degrees, knots, data.axes)
    options = _options(data.axes, data.dim, smoothing, penalty_order, lam, target, regularize, conditions,
                       shape, lower, upper)
    options.robust, options.robust_width = _constant(robust, _ROBUST, "robust"), robust_width
    return _fitted(watched(lib.nurbs_fit_points, progress, work), ctypes.byref(data), *space.layout, flags,
                   ctypes.byref(options))


def fit_tolerance(params: ArrayLike, values: ArrayLike, degrees: Union[int, Sequence[int]], tolerance: float,
                  domain: Optional[ArrayLike] = None, max_count: int = 0, weights: Optional[ArrayLike] = None,
                  flags: int = 0, *, data_flags: int = 0, smoothing: Union[int, str] = "none",
                  penalty_order: int = 2, lam: float = 0.0, target: float = 0.0,
                  conditions: Optional[Conditions] = None, shape: Shape = None, lower: Optional[ArrayLike] = None,
                  upper: Optional[ArrayLike] = None, progress: Progress = None,
                  work: Optional[int] = None) -> Fitted:
    """A spline with few control points, over knots where they are needed, that no value (n,) or (n, dim) at parameters
    (n,) or (n, axes) is farther from than a tolerance. If that takes more than max_count control points, 0 for as many
    as data, the report has the bit NURBS_FIT_TARGET_MISSED, and the spline is the closest one that was met.

    `domain` (axes, 2), of a curve (2,), is by default the range of the parameters; the other arguments are those of
    fit_points()."""
    data = _data(params, values, weights, data_flags)
    p, ends = _degrees(degrees, data.axes), if_given(domain, 2 * data.axes, "a domain")
    options = _options(data.axes, data.dim, smoothing, penalty_order, lam, target, False, conditions,
                       shape, lower, upper)
    return _fitted(watched(lib.nurbs_fit_tolerance, progress, work), ctypes.byref(data), p.ctypes.data, address(ends),
                   tolerance, max_count, flags, ctypes.byref(options))


# --- Points without parameters ---

def cloud_start(points: ArrayLike, degrees: Union[int, Sequence[int]], knots: ByAxis, flags: int = 0) -> Spline:
    """A spline over full knot vectors, a vector or one for each axis, from which Spline.fit_cloud() can begin: along the
    principal directions of points (n, dim), as far as these reach. `flags` are NURBS_PERIODIC for one axis of a curve or
    surface, for an ellipse or an elliptic cylinder."""
    axes = vector(degrees, numpy.int32).size
    space = _Space(degrees, knots, axes)
    given = packed(points)
    if given.ndim != 2:
        raise ValueError(f"points of shape {given.shape}, expected (n, dim)")
    return Spline._made(lib.nurbs_cloud_start, axes, *space.layout, *given.shape, given.ctypes.data, 0, 0, flags)
