# SPDX-License-Identifier: MIT
"""Handles as bytes: the same on every machine for the same contents."""

from __future__ import annotations

import ctypes
import operator
import pickle
from typing import TYPE_CHECKING, Any, NamedTuple, SupportsIndex, Union

import numpy

from ._library import call, get, lib

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Contents = Union[bytes, bytearray, memoryview]

__all__ = ["BytesKind", "bytes_kind"]


class BytesKind(NamedTuple):
    """What bytes hold, a NURBS_BYTES_ constant, and the version of their form."""

    kind: int
    major: int
    minor: int


def written(function: Any, handle: Any) -> NDArray[numpy.uint8]:
    """The bytes that a function writes to (cap, bytes, length), its last arguments."""
    contents = numpy.empty(get(ctypes.c_int64, function, handle, 0, None), numpy.uint8)
    get(ctypes.c_int64, function, handle, contents.size, contents.ctypes.data)
    return contents


def given(contents: Contents) -> NDArray[numpy.uint8]:
    """Bytes as an array, without a copy where they lie side by side."""
    view = memoryview(contents)
    return numpy.frombuffer(view if view.c_contiguous else view.tobytes(), numpy.uint8)


def pickled(function: Any, handle: Any, protocol: SupportsIndex) -> Any:
    """The bytes of a handle as pickles hold them: from protocol 5 on beside the pickle, where that is wanted."""
    contents = written(function, handle)
    return pickle.PickleBuffer(contents.data) if operator.index(protocol) >= 5 else contents.tobytes()


def bytes_kind(contents: Contents) -> BytesKind:
    """Of which kind bytes are that to_bytes() gave, and in which version of the form, from the first 64 of them. Raises
    ContentsError for others."""
    head, numbers = given(contents), numpy.empty(3, numpy.int32)
    call(lib.nurbs_bytes_kind, head.ctypes.data, head.size, *(numbers[i:].ctypes.data for i in range(3)))
    return BytesKind(*numbers.tolist())
