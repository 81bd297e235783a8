# SPDX-License-Identifier: MIT
"""NumPy arrays as the library's pointers and strides."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, DTypeLike, NDArray

    #: Arrays that the functions return.
    Floats = NDArray[numpy.float64]
    Singles = NDArray[numpy.float32]
    Int32s = NDArray[numpy.int32]
    Int64s = NDArray[numpy.int64]
    Booleans = NDArray[numpy.bool_]
    Shape = Tuple[int, ...]


class Records:
    """n records of numbers in memory that the library can use directly; strides count those numbers, 0 is packed.

    A layout is addresses, which keep nothing alive: the object has to live until the library has returned.
    """

    __slots__ = ("array", "n", "layout", "shape")

    def __init__(self, array: NDArray[Any], n: int, stride: int = 0, component_stride: int = 0) -> None:
        self.array = array  # keeps the memory alive
        self.n = n
        self.layout = array.ctypes.data, stride, component_stride
        self.shape: Shape = array.shape  # of what was given, once records() is done

    @classmethod
    def of_table(cls, table: NDArray[Any]) -> Records:
        """The rows of a table that _direct() lets through."""
        n, width = table.shape
        record, component = (step // table.itemsize for step in table.strides)
        # NumPy leaves the strides of axes of length 1 undefined.
        component = component if width > 1 else 1
        return cls(table, n, record if n > 1 else width * component, component)


def _direct(table: NDArray[Any]) -> bool:
    """Whether the library can address the rows of a table: whole positive strides, and no place used twice."""
    if not table.dtype.isnative or not table.flags.aligned:
        return False
    unit = table.itemsize
    if any(size > 1 and (step <= 0 or step % unit) for size, step in zip(table.shape, table.strides)):
        return False
    (n, width), (record, component) = table.shape, table.strides
    return n <= 1 or width <= 1 or record >= (width - 1) * component + unit or component >= (n - 1) * record + unit


def records(values: ArrayLike, width: int) -> Records:
    """An input of records: a view where possible, otherwise a packed copy."""
    array = numpy.asarray(values, dtype=numpy.float64)
    if array.size % max(width, 1):
        raise ValueError(f"an array of shape {array.shape} does not hold records of {width} components")
    n = array.size // max(width, 1)
    flags = array.flags
    if flags.c_contiguous and flags.aligned or n == 0:
        return Records(array, n)
    table = array.reshape(-1, width)
    found = Records.of_table(table) if _direct(table) else Records(numpy.array(table, order="C"), n)
    found.shape = array.shape
    return found


def one_each(values: ArrayLike, counts: Tuple[int, ...], name: str) -> Records:
    """A number for each control point: of that shape, because another order would be taken for it."""
    array = numpy.asarray(values, dtype=numpy.float64)
    if array.shape != counts:
        raise ValueError(f"{name} of shape {array.shape}, expected {counts}")
    return records(array, 1)


def parameters(params: ArrayLike, axes: int) -> Tuple[Records, Shape]:
    """Parameters, and the shape of the batch, which lacks the last dimension if that holds (u, v...)."""
    array = numpy.asarray(params, dtype=numpy.float64)
    if axes == 1:
        return records(array, 1), array.shape
    if array.ndim == 0 or array.shape[-1] != axes:
        raise ValueError(f"params of shape {array.shape}, expected (..., {axes})")
    return records(array, axes), array.shape[:-1]


def packed(values: ArrayLike, dtype: DTypeLike = numpy.float64) -> NDArray[Any]:
    """An array as C has it: without gaps, and aligned, which views of bytes need not be."""
    array = numpy.ascontiguousarray(values, dtype=dtype)
    return array if array.flags.aligned else array.copy()


def _integers(values: ArrayLike, dtype: DTypeLike) -> NDArray[Any]:
    """Integers, which NumPy would round and cut off to make others fit."""
    array = numpy.asarray(values)
    if array.dtype.kind not in "iub" and array.size:
        array = numpy.array([operator.index(value) for value in array.ravel().tolist()], object)
    limits = numpy.iinfo(dtype)
    if array.size and not limits.min <= array.min() <= array.max() <= limits.max:
        raise OverflowError(f"integers from {array.min()} to {array.max()} do not fit {limits.dtype}")
    return array


def vector(values: ArrayLike, dtype: DTypeLike = numpy.float64) -> NDArray[Any]:
    """A packed vector; a plain number is a vector of one."""
    given = values if dtype is numpy.float64 else _integers(values, dtype)
    return packed(given, dtype).reshape(-1)


def exactly(values: ArrayLike, size: int, what: str, dtype: DTypeLike = numpy.float64) -> NDArray[Any]:
    """A packed vector of one length."""
    array = vector(values, dtype)
    if array.size != size:
        raise ValueError(f"{what} of {array.size} numbers, expected {size}")
    return array


def if_given(values: Optional[ArrayLike], size: int, what: str,
             dtype: DTypeLike = numpy.float64) -> Optional[NDArray[Any]]:
    """The same, or None."""
    return None if values is None else exactly(values, size, what, dtype)


def address(array: Optional[NDArray[Any]]) -> Optional[int]:
    """The pointer of an array, NULL for None."""
    return None if array is None else array.ctypes.data


def addresses(*arrays: Optional[NDArray[Any]]) -> Tuple[Optional[int], ...]:
    """The pointers of arrays, NULL for None."""
    return tuple(address(array) for array in arrays)


def _in_place(array: NDArray[Any], width: int) -> Optional[Records]:
    """The array as records without a copy, or None."""
    flags = array.flags
    if array.size == 0 or flags.c_contiguous and flags.aligned and array.dtype.isnative:
        return Records(array, array.size // max(width, 1))
    table = array.view()
    try:
        table.shape = (array.size // width, width)
    except AttributeError:
        return None
    return Records.of_table(table) if _direct(table) else None


class Output:
    """An array to be filled: `out` itself where the library can address it, else a packed array copied to it."""

    __slots__ = ("result", "_copy", "records")

    def __init__(self, out: Optional[NDArray[Any]], shape: Shape, width: int,
                 dtype: DTypeLike = numpy.float64) -> None:
        self._copy: Optional[NDArray[Any]] = None
        if out is None:
            self.result: NDArray[Any] = numpy.empty(shape, dtype)
            self.records = Records(self.result, self.result.size // max(width, 1))
            return
        if (not isinstance(out, numpy.ndarray) or out.shape != tuple(shape) or out.dtype != dtype
                or not out.flags.writeable):
            raise ValueError(f"out must be a writeable {numpy.dtype(dtype)} array of shape {tuple(shape)}")
        self.result = out
        direct = _in_place(out, width)
        if direct is None:
            self._copy = numpy.empty(shape, dtype)
            direct = Records(self._copy, out.size // max(width, 1))
        self.records = direct

    @property
    def layout(self) -> Tuple[int, int, int]:
        """Pointer, stride and component stride."""
        return self.records.layout

    def finish(self) -> NDArray[Any]:
        """The filled array."""
        if self._copy is not None:
            self.result[...] = self._copy
        return self.result


class Gradient(Output):
    """An output that may be added to."""

    __slots__ = ()

    def __init__(self, out: Optional[NDArray[Any]], shape: Shape, width: int, add: bool) -> None:
        super().__init__(out, shape, width)
        if add and out is None:
            self.result[...] = 0
        elif add and self._copy is not None:
            self._copy[...] = self.result
