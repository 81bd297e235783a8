# SPDX-License-Identifier: MIT
"""NumPy arrays as the library's pointers and strides."""

from __future__ import annotations

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
    """n records of `width` numbers in memory that the library can use directly; strides count those numbers."""

    def __init__(self, array: NDArray[Any], width: int) -> None:
        self.array = array  # keeps the memory alive
        self.n = array.shape[0]
        self.address = array.ctypes.data
        record, component = (step // array.itemsize for step in array.strides)
        # NumPy leaves the strides of axes of length 1 undefined.
        self.component_stride = component if width > 1 else 1
        self.stride = record if self.n > 1 else width * self.component_stride
        if array.size == 0:
            self.stride = self.component_stride = 0

    @property
    def layout(self) -> Tuple[int, int, int]:
        """Pointer, stride and component stride."""
        return self.address, self.stride, self.component_stride


def _direct(array: NDArray[Any], dtype: DTypeLike = numpy.float64) -> bool:
    """Whether the library can address a 2-D array: whole positive strides, and no place used twice."""
    flags = array.flags
    if array.dtype != dtype or not array.dtype.isnative or not flags.aligned:
        return False
    if flags.c_contiguous or array.size == 0:
        return True
    unit = array.itemsize
    if any(size > 1 and (step <= 0 or step % unit) for size, step in zip(array.shape, array.strides)):
        return False
    (n, width), (record, component) = array.shape, array.strides
    return n <= 1 or width <= 1 or record >= (width - 1) * component + unit or component >= (n - 1) * record + unit


def records(values: ArrayLike, width: int) -> Records:
    """An input of records: a view where possible, otherwise a packed copy."""
    array = numpy.asarray(values, dtype=numpy.float64)
    if array.size % max(width, 1):
        raise ValueError(f"an array of shape {array.shape} does not hold records of {width} components")
    array = array.reshape(-1, width) if width else array.reshape(0, 0)
    return Records(array if _direct(array) else numpy.ascontiguousarray(array), width)


def vector(values: ArrayLike, dtype: DTypeLike = numpy.float64) -> NDArray[Any]:
    """A packed vector; a plain number is a vector of one."""
    return numpy.ascontiguousarray(values, dtype=dtype).reshape(-1)


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


def _as_table(array: NDArray[Any], width: int, dtype: DTypeLike) -> Optional[NDArray[Any]]:
    """The array as (records, width) without a copy, or None."""
    table = array.view()
    try:
        table.shape = (array.size // width if width else 0, width)
    except AttributeError:
        return None
    return table if _direct(table, dtype) else None


class Output:
    """An array to be filled: `out` itself where the library can address it, else a packed array copied to it."""

    def __init__(self, out: Optional[NDArray[Any]], shape: Shape, width: int,
                 dtype: DTypeLike = numpy.float64) -> None:
        if out is not None and (not isinstance(out, numpy.ndarray) or out.shape != tuple(shape)
                                or out.dtype != dtype or not out.flags.writeable):
            raise ValueError(f"out must be a writeable {numpy.dtype(dtype)} array of shape {tuple(shape)}")
        self.result: NDArray[Any] = numpy.empty(shape, dtype) if out is None else out
        table = _as_table(self.result, width, dtype)
        self._copy = None
        if table is None:
            self._copy = numpy.empty(shape, dtype)
            table = self._copy.reshape(-1, width)
        self.records = Records(table, width)

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

    def __init__(self, out: Optional[NDArray[Any]], shape: Shape, width: int, add: bool) -> None:
        super().__init__(out, shape, width)
        if add and out is None:
            self.result[...] = 0
        elif add and self._copy is not None:
            self._copy[...] = self.result
