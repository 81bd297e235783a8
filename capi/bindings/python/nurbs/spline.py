# SPDX-License-Identifier: MIT
"""Curves, surfaces and volumes."""

import ctypes

import numpy

from ._arrays import Output, records, vector
from ._library import check, get, lib
from .constants import NURBS_KEEP_DOMAIN
from .constants import NURBS_FORM_CLAMPED_END, NURBS_FORM_CLAMPED_START


def derivative_slots(axes, order):
    """Number of partial derivatives of orders 0 to `order`: binomial(order + axes, axes)."""
    return get(ctypes.c_int64, lib.nurbs_derivative_slots, axes, order)


def _concatenated(vectors, axes, dtype=numpy.float64):
    """The vectors of all axes one after the other; a curve may give its own alone."""
    if axes == 1 and numpy.ndim(vectors[0]) == 0:
        vectors = [vectors]
    if len(vectors) != axes:
        raise ValueError(f"{len(vectors)} vectors for {axes} axes")
    return numpy.concatenate([vector(v, dtype) for v in vectors]), [len(v) for v in vectors]


def _matrix(values, columns):
    matrix = numpy.ascontiguousarray(values, dtype=numpy.float64)
    if matrix.ndim != 2 or matrix.shape[1] != columns:
        raise ValueError(f"a matrix of shape {matrix.shape}, expected {columns} columns")
    return matrix


class _Net:
    """Degrees, counts, points and weights as the constructors of the library take them."""

    def __init__(self, degrees, points, weights):
        self.degrees = vector(degrees, numpy.int32)
        self.axes = self.degrees.size
        points = numpy.asarray(points, dtype=numpy.float64)
        if points.ndim != self.axes + 1:
            raise ValueError(f"points must have {self.axes + 1} dimensions: one for each degree, one for coordinates")
        self.counts = vector(points.shape[:-1], numpy.int64)
        self.width = points.shape[-1]
        self.points = records(points, self.width)
        self.weights = None if weights is None else records(weights, 1)
        if weights is not None and self.weights.n != self.points.n:
            raise ValueError(f"{self.weights.n} weights for {self.points.n} points")

    @property
    def sizes(self):
        return self.axes, self.degrees.ctypes.data, self.counts.ctypes.data

    @property
    def weight_layout(self):
        return (None, 0) if self.weights is None else (self.weights.address, self.weights.stride)


class Spline:
    """A spline: immutable, shared by its copies, usable by many threads at once."""

    __slots__ = ("_handle",)

    def __init__(self, degrees, knots, points, weights=None, flags=0):
        """A spline from full knot vectors: `degrees` a number or one for each axis, `knots` a vector or one for each
        axis, `points` of shape (counts..., dim), `weights` of shape (counts...) or None."""
        self._handle = None
        net = _Net(degrees, points, weights)
        knots, _ = _concatenated(knots, net.axes)
        self._handle = get(ctypes.c_void_p, lib.nurbs_create, *net.sizes, knots.ctypes.data, knots.size, net.width,
                           *net.points.layout, *net.weight_layout, flags)

    @classmethod
    def _made(cls, function, *arguments):
        spline = cls.__new__(cls)
        spline._handle = None
        spline._handle = get(ctypes.c_void_p, function, *arguments)
        return spline

    @classmethod
    def homogeneous(cls, degrees, knots, points, flags=0):
        """A rational spline from points (w x, w y, ..., w)."""
        net = _Net(degrees, points, None)
        knots, _ = _concatenated(knots, net.axes)
        return cls._made(lib.nurbs_create_homogeneous, *net.sizes, knots.ctypes.data, knots.size, net.width - 1,
                         *net.points.layout, flags)

    @classmethod
    def short(cls, degrees, knots, points, weights=None, flags=0):
        """A spline from knot vectors without their first and last knot."""
        net = _Net(degrees, points, weights)
        knots, _ = _concatenated(knots, net.axes)
        return cls._made(lib.nurbs_create_short, *net.sizes, knots.ctypes.data, knots.size, net.width,
                         *net.points.layout, *net.weight_layout, flags)

    @classmethod
    def from_multiplicities(cls, degrees, knots, multiplicities, points, weights=None, flags=0):
        """A spline from distinct knots and their multiplicities, a vector or one for each axis."""
        net = _Net(degrees, points, weights)
        knots, lengths = _concatenated(knots, net.axes)
        multiplicities, others = _concatenated(multiplicities, net.axes, numpy.int32)
        if lengths != others:
            raise ValueError(f"{others} multiplicities for {lengths} knots")
        lengths = vector(lengths, numpy.int64)
        return cls._made(lib.nurbs_create_multiplicities, *net.sizes, lengths.ctypes.data, knots.ctypes.data,
                         multiplicities.ctypes.data, net.width, *net.points.layout, *net.weight_layout, flags)

    @classmethod
    def bezier(cls, points, weights=None):
        """A Bezier spline over [0, 1] on every axis, of the degrees that the shape of points has."""
        degrees = [count - 1 for count in numpy.shape(points)[:-1]]
        net = _Net(degrees, points, weights)
        return cls._made(lib.nurbs_create_bezier, net.axes, net.degrees.ctypes.data, net.width, *net.points.layout,
                         *net.weight_layout)

    def with_points(self, points, weights=None):
        """The same knots with other points, and other weights if any are given."""
        net = _Net(self.degrees, points, weights)
        if (*net.counts, net.width) != self.counts + (self.dimension,):
            raise ValueError(f"points must have shape {self.counts + (self.dimension,)}")
        return self._made(lib.nurbs_with_points, self._handle, *net.points.layout, *net.weight_layout)

    def clone(self):
        """Another handle on the same spline, in constant time."""
        return self._made(lib.nurbs_clone, self._handle)

    __copy__ = clone

    def __deepcopy__(self, memo):
        return self.clone()

    def __del__(self):
        if lib is not None and self._handle:
            lib.nurbs_destroy(self._handle)

    def __repr__(self):
        kind = {1: "curve", 2: "surface", 3: "volume"}.get(self.axes)
        form = "rational" if self.rational else "polynomial"
        return f"<Spline: {form} {kind} in {self.dimension}D, degrees {self.degrees}, counts {self.counts}>"

    # Inspection

    @property
    def axes(self):
        return get(ctypes.c_int32, lib.nurbs_axes, self._handle)

    @property
    def dimension(self):
        return get(ctypes.c_int32, lib.nurbs_dimension, self._handle)

    @property
    def rational(self):
        return bool(get(ctypes.c_int32, lib.nurbs_is_rational, self._handle))

    @property
    def point_count(self):
        return get(ctypes.c_int64, lib.nurbs_point_count, self._handle)

    @property
    def degrees(self):
        return tuple(self.degree(axis) for axis in range(self.axes))

    @property
    def counts(self):
        return tuple(self.count(axis) for axis in range(self.axes))

    def degree(self, axis=0):
        return get(ctypes.c_int32, lib.nurbs_degree, self._handle, axis)

    def count(self, axis=0):
        return get(ctypes.c_int64, lib.nurbs_count, self._handle, axis)

    def knot_form(self, axis=0):
        """Sum of NURBS_FORM_ bits."""
        return get(ctypes.c_int32, lib.nurbs_knot_form, self._handle, axis)

    def domain(self, axis=0):
        ends = numpy.empty(2)
        check(lib.nurbs_domain(self._handle, axis, ends.ctypes.data))
        return tuple(ends.tolist())

    def knots(self, axis=0):
        values = numpy.empty(self.count(axis) + self.degree(axis) + 1)
        check(lib.nurbs_knots(self._handle, axis, values.size, values.ctypes.data))
        return values

    def distinct_knots(self, axis=0):
        """Distinct knots and multiplicities, two arrays."""
        size = get(ctypes.c_int64, lib.nurbs_distinct_knots, self._handle, axis, 0, None, None)
        values, times = numpy.empty(size), numpy.empty(size, numpy.int32)
        get(ctypes.c_int64, lib.nurbs_distinct_knots, self._handle, axis, size, values.ctypes.data, times.ctypes.data)
        return values, times

    def greville(self, axis=0):
        values = numpy.empty(self.count(axis))
        check(lib.nurbs_greville(self._handle, axis, values.size, values.ctypes.data))
        return values

    def points(self, out=None):
        """Control points (counts..., dim)."""
        output = Output(out, self.counts + (self.dimension,), self.dimension)
        check(lib.nurbs_points(self._handle, output.records.n, *output.layout))
        return output.finish()

    def weights(self, out=None):
        """Weights (counts...), all 1 for a polynomial spline."""
        output = Output(out, self.counts, 1)
        check(lib.nurbs_weights(self._handle, output.records.n, *output.layout[:2]))
        return output.finish()

    def homogeneous_points(self, out=None):
        """Homogeneous control points (counts..., dim + 1)."""
        output = Output(out, self.counts + (self.dimension + 1,), self.dimension + 1)
        check(lib.nurbs_homogeneous_points(self._handle, output.records.n, *output.layout))
        return output.finish()

    # Evaluation

    def _params(self, params):
        """The parameters, and the shape of the batch, which lacks the last dimension if that holds (u, v...)."""
        shape, axes = numpy.shape(params), self.axes
        if axes > 1 and (not shape or shape[-1] != axes):
            raise ValueError(f"params must have shape (..., {axes})")
        return records(params, axes), shape if axes == 1 else shape[:-1]

    def _batch(self, function, params, tail, width, flags, out, dtype=numpy.float64):
        given, shape = self._params(params)
        output = Output(out, shape + tail, width, dtype)
        check(function(given.n, *given.layout, *output.layout, flags))
        return output.finish()

    def eval(self, params, flags=0, out=None):
        """Points: params of shape S (a curve) or S + (axes,) give S + (dim,)."""
        return self._batch(lambda *rest: lib.nurbs_eval(self._handle, *rest), params, (self.dimension,),
                           self.dimension, flags, out)

    __call__ = eval

    def eval_derivs(self, params, order, flags=0, out=None):
        """Points and partial derivatives: S + (slots, dim), the slots in the order of nurbs_eval_derivs()."""
        slots = derivative_slots(self.axes, order)
        return self._batch(lambda *rest: lib.nurbs_eval_derivs(self._handle, order, *rest), params,
                           (slots, self.dimension), slots * self.dimension, flags, out)

    def eval_f32(self, params, flags=0, out=None):
        """Points in single precision: those of eval(), rounded once."""
        return self._batch(lambda *rest: lib.nurbs_eval_f32(self._handle, *rest), params, (self.dimension,),
                           self.dimension, flags, out, numpy.float32)

    def hull_size(self, params, flags=0, out=None):
        """The `hull` of the accuracy contract at each parameter."""
        given, shape = self._params(params)
        output = Output(out, shape, 1)
        check(lib.nurbs_hull_size(self._handle, given.n, *given.layout, *output.layout[:2], flags))
        return output.finish()

    def rational_basis(self, params, flags=0, out=None):
        """Spans S + (axes,), and R_i of the active points S + (degree_0 + 1, ...)."""
        given, shape = self._params(params)
        active = tuple(degree + 1 for degree in self.degrees)
        output = Output(out, shape + active, int(numpy.prod(active)))
        spans = numpy.empty(shape + (self.axes,), numpy.int64)
        check(lib.nurbs_rational_basis(self._handle, given.n, *given.layout, spans.ctypes.data, *output.layout, flags))
        return spans, output.finish()

    def _grid(self, params):
        if len(params) != self.axes:
            raise ValueError(f"{len(params)} parameter vectors for {self.axes} axes")
        vectors = [vector(values) for values in params]
        return numpy.concatenate(vectors), vector([v.size for v in vectors], numpy.int64)

    def eval_grid(self, *params, flags=0, out=None):
        """Points on a grid, one vector of parameters for each axis: (n_0, ..., dim)."""
        given, counts = self._grid(params)
        output = Output(out, (*counts, self.dimension), self.dimension)
        check(lib.nurbs_eval_grid(self._handle, counts.ctypes.data, given.ctypes.data, *output.layout, flags))
        return output.finish()

    def eval_grid_derivs(self, *params, order, flags=0, out=None):
        """Points and partial derivatives on a grid: (n_0, ..., slots, dim)."""
        given, counts = self._grid(params)
        slots = derivative_slots(self.axes, order)
        output = Output(out, (*counts, slots, self.dimension), slots * self.dimension)
        check(lib.nurbs_eval_grid_derivs(self._handle, order, counts.ctypes.data, given.ctypes.data, *output.layout,
                                         flags))
        return output.finish()

    def eval_grid_f32(self, *params, flags=0, out=None):
        """Points on a grid in single precision: those of eval_grid(), rounded once."""
        given, counts = self._grid(params)
        output = Output(out, (*counts, self.dimension), self.dimension, numpy.float32)
        check(lib.nurbs_eval_grid_f32(self._handle, counts.ctypes.data, given.ctypes.data, *output.layout, flags))
        return output.finish()

    # Operations

    def iso(self, axis, param, flags=0):
        """The spline of one axis less on which the parameter of `axis` is fixed."""
        return self._made(lib.nurbs_iso, self._handle, axis, param, flags)

    def insert_knot(self, knot, *, times=1, axis=0):
        """The same shape with a knot inserted."""
        return self._made(lib.nurbs_insert_knot, self._handle, axis, knot, times)

    def elevate(self, times=1, *, axis=0):
        """The same shape with a degree raised."""
        return self._made(lib.nurbs_elevate, self._handle, axis, times)

    def reverse(self, *, axis=0, keep_domain=False):
        """The axis turned round: t becomes -t, or lower + upper - t."""
        return self._made(lib.nurbs_reverse, self._handle, axis, NURBS_KEEP_DOMAIN if keep_domain else 0)

    def transpose(self, *permutation):
        """The axes in another order, as numpy.transpose() does it; without arguments the opposite one."""
        order = vector(permutation or range(self.axes)[::-1], numpy.int32)
        if order.size != self.axes:
            raise ValueError(f"{order.size} axes for {self.axes}")
        return self._made(lib.nurbs_transpose, self._handle, order.ctypes.data)

    def reparametrize(self, lower, upper, *, axis=0):
        """The same shape over another domain."""
        return self._made(lib.nurbs_reparametrize, self._handle, axis, lower, upper)

    def make_rational(self):
        """The same spline with weights."""
        return self._made(lib.nurbs_make_rational, self._handle)

    def to_homogeneous(self):
        """The polynomial spline of the points (w x, w y, ..., w)."""
        return self._made(lib.nurbs_to_homogeneous, self._handle)

    def from_homogeneous(self):
        """The rational spline whose homogeneous points these are."""
        return self._made(lib.nurbs_from_homogeneous, self._handle)

    def transform(self, matrix, translation=None):
        """The shape under x -> matrix x + translation; matrix is (out_dim, dim)."""
        matrix = _matrix(matrix, self.dimension)
        given = None if translation is None else vector(translation)
        if given is not None and given.size != len(matrix):
            raise ValueError(f"a translation of {given.size} for a matrix of {len(matrix)} rows")
        return self._made(lib.nurbs_transform, self._handle, len(matrix), matrix.ctypes.data,
                          None if given is None else given.ctypes.data)

    def transform_projective(self, matrix):
        """The shape under a map of homogeneous points; matrix is (out_dim + 1, dim + 1)."""
        matrix = _matrix(matrix, self.dimension + 1)
        return self._made(lib.nurbs_transform_projective, self._handle, len(matrix) - 1, matrix.ctypes.data)

    def refine(self, knots, *, axis=0):
        """The same shape with a list of knots inserted, in any order."""
        knots = vector(knots, numpy.float64)
        return self._made(lib.nurbs_refine, self._handle, axis, knots.size, knots.ctypes.data)

    def refine_uniform(self, parts, *, axis=0):
        """The same shape with every non-empty span divided into equal parts."""
        return self._made(lib.nurbs_refine_uniform, self._handle, axis, parts)

    def split(self, param, *, axis=0):
        """The parts below and above a parameter."""
        lower, upper = self.__class__.__new__(self.__class__), self.__class__.__new__(self.__class__)
        lower._handle = upper._handle = None
        handle = ctypes.c_void_p()
        upper._handle = get(ctypes.c_void_p, lib.nurbs_split, self._handle, axis, param, ctypes.byref(handle))
        lower._handle = handle.value
        return lower, upper

    def extract(self, lower, upper):
        """The part over a box in the domain: a number or one for each axis."""
        lower, upper = vector(lower, numpy.float64), vector(upper, numpy.float64)
        if not lower.size == upper.size == self.axes:
            raise ValueError(f"{lower.size} lower and {upper.size} upper ends for {self.axes} axes")
        return self._made(lib.nurbs_extract, self._handle, lower.ctypes.data, upper.ctypes.data)

    def clamp(self, flags=NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, *, axis=0):
        """The same shape with clamped ends; 0 only opens a periodic axis."""
        return self._made(lib.nurbs_clamp_ends, self._handle, axis, flags)

    def move_seam(self, param, *, axis=0):
        """The same shape on a periodic axis over [param, param + period]."""
        return self._made(lib.nurbs_move_seam, self._handle, axis, param)
