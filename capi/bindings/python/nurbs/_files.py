# SPDX-License-Identifier: MIT
"""Reading files: the splines that a file held, their names, and notes on the rest."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from typing import (TYPE_CHECKING, Any, Callable, Iterable, List, NamedTuple, Optional, SupportsIndex, Tuple, Type, Union,
                    overload)

from ._base import handles
from ._bytes import given as given_bytes, pickled, written
from ._calls import watched
from ._library import call, get, lib, text
from ._spline import Spline
from ._write import file_bytes, to_file
from .constants import NURBS_FORMAT_STEP

if TYPE_CHECKING:
    from ._bytes import Contents
    from ._calls import Progress

    _Splines = Sequence[Spline]
else:
    _Splines = Sequence

__all__ = ["Note", "SplineList", "read", "read_file"]


class Note(NamedTuple):
    """An entity of a file that did not become a spline: its type number, its line in the directory, a NURBS_ERROR_
    constant, and what is wrong with it."""

    entity_type: int
    line: int
    reason: int
    text: str


class _Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("unit", ctypes.c_double), ("max_bytes", ctypes.c_int64),
                ("tolerance", ctypes.c_double), ("kinds", ctypes.c_uint32), ("reserved", ctypes.c_uint32)]


def _options(unit: float, max_bytes: Optional[int], tolerance: float, kinds: int) -> Any:
    options = _Options()
    call(lib.nurbs_read_options_init, ctypes.byref(options), ctypes.sizeof(options))
    options.unit, options.tolerance, options.kinds = unit, tolerance, kinds
    if max_bytes is not None:
        options.max_bytes = max_bytes
    return ctypes.byref(options)


class SplineList(_Splines):
    """A sequence of splines, parts of one or those of a file, with names and notes."""

    _handle: Optional[int] = None

    def __init__(self, *_: object) -> None:
        raise TypeError("a SplineList comes from the library, or is made of splines by SplineList.create()")

    @classmethod
    def create(cls, splines: Iterable[Spline], names: Optional[Iterable[str]] = None, unit: float = 0.0) -> SplineList:
        """A list of splines with their names, by default "0", "1", ..., and the metres per unit of length, 0 if that is
        not known."""
        given = handles(splines)
        texts = None if names is None else [os.fsencode(name) for name in names]
        if texts is not None and len(texts) != len(given):
            raise ValueError(f"{len(texts)} names for {len(given)} splines")
        if any(b"\0" in text for text in texts or ()):
            raise ValueError("a name with a zero in it")
        each = None if texts is None else (ctypes.c_char_p * len(texts))(*texts)
        return cls._made(lib.nurbs_list_create, len(given), given, each, unit)

    def to_bytes(self) -> bytes:
        """The list as bytes, to be kept or sent, with names, notes and unit: the same on every machine for the same
        list."""
        return written(lib.nurbs_list_to_bytes, self._handle).tobytes()

    @classmethod
    def from_bytes(cls, contents: Contents) -> SplineList:
        """The list of what to_bytes() gave. Raises ContentsError for other bytes."""
        given = given_bytes(contents)
        return cls._made(lib.nurbs_list_from_bytes, given.ctypes.data, given.size)

    @classmethod
    def _made(cls, function: Any, *arguments: Any) -> SplineList:
        """The list that a function writes through its last argument."""
        splines, handle = cls.__new__(cls), ctypes.c_void_p()
        try:
            call(function, *arguments, ctypes.byref(handle))
        finally:  # an interrupt may come after the call
            splines._handle = handle.value
        return splines

    def __del__(self) -> None:
        if lib is not None and self._handle:
            lib.nurbs_list_destroy(self._handle)

    def __len__(self) -> int:
        return int(get(ctypes.c_int64, lib.nurbs_list_count, self._handle))

    @overload
    def __getitem__(self, index: int) -> Spline: ...

    @overload
    def __getitem__(self, index: slice) -> List[Spline]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Spline, List[Spline]]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        position = index + len(self) if index < 0 else index
        if not 0 <= position < len(self):
            raise IndexError(f"list index {index} out of range")
        return Spline._made(lib.nurbs_list_get, self._handle, position)

    def __repr__(self) -> str:
        return f"<SplineList of {len(self)}: {', '.join(self.names[:4])}{', ...' if len(self) > 4 else ''}>"

    def __reduce_ex__(self, protocol: SupportsIndex) -> Tuple[Callable[..., SplineList], Tuple[Any, ...]]:
        return _restored_list, (type(self), pickled(lib.nurbs_list_to_bytes, self._handle, protocol))

    @property
    def names(self) -> List[str]:
        """Name of each spline: that in the file, or which part it is."""
        return [text(lib.nurbs_list_name, self._handle, i) for i in range(len(self))]

    def write(self, format: int = NURBS_FORMAT_STEP, unit: float = 0.0, tolerance: float = 0.0, *,
              progress: Progress = None, work: Optional[int] = None) -> bytes:
        """The contents of a file that holds the list, the same for the same list. `unit` is that of the file in
        metres, 0 keeps its own; `tolerance`, in that unit, is the distance that counts as none, 0 takes that of the
        faces. Raises ArgumentError for what the format cannot hold."""
        return file_bytes(lib.nurbs_list_write, self._handle, format, unit, tolerance, progress, work)

    def write_file(self, path: Union[str, bytes, os.PathLike[str]], format: Optional[int] = None, unit: float = 0.0,
                   tolerance: float = 0.0, *, progress: Progress = None, work: Optional[int] = None) -> None:
        """Writes what write() gives to a file, which is replaced whole or not at all; without a format that of the
        suffix, such as ".step". Raises FileError if it cannot be written."""
        to_file(lib.nurbs_list_write_file, self._handle, path, format, unit, tolerance, progress, work)

    @property
    def notes(self) -> List[Note]:
        """What of a file did not become a spline."""
        return [self._note(i) for i in range(get(ctypes.c_int64, lib.nurbs_list_note_count, self._handle))]

    @property
    def unit(self) -> float:
        """Metres per unit of length; 0 if the file names a unit that is not known."""
        return float(get(ctypes.c_double, lib.nurbs_list_unit, self._handle))

    def _note(self, index: int) -> Note:
        kind, line, reason = ctypes.c_int32(), ctypes.c_int64(), ctypes.c_int32()
        words = text(lib.nurbs_list_note, self._handle, index, ctypes.byref(kind), ctypes.byref(line),
                     ctypes.byref(reason))
        return Note(kind.value, line.value, reason.value, words)


# A function, since cloudpickle, by which Dask sends programs, does not know class methods by their names.
def _restored_list(kind: Type[SplineList], contents: Any) -> SplineList:
    """A pickled list."""
    return kind.from_bytes(contents)


def read(contents: Union[bytes, bytearray, memoryview], unit: float = 0.0, max_bytes: Optional[int] = None, *,
         tolerance: float = 0.0, kinds: int = 0, progress: Progress = None, work: Optional[int] = None) -> SplineList:
    """The curves and surfaces of an IGES or STEP file in memory; unit is the wanted one in metres, 0 keeps the file's own;
    tolerance is the distance in it that counts as none, 0 takes what the file states; kinds is a sum of NURBS_READ_
    constants, 0 for all. Raises ContentsError if it is none, ResourceError if it is longer than max_bytes (by default
    2^30)."""
    given = contents if isinstance(contents, bytes) else memoryview(contents).tobytes()
    return SplineList._made(watched(lib.nurbs_read, progress, work), given, len(given), _options(unit, max_bytes, tolerance, kinds))


def read_file(path: Union[str, bytes, os.PathLike[str]], unit: float = 0.0, max_bytes: Optional[int] = None, *,
              tolerance: float = 0.0, kinds: int = 0, progress: Progress = None, work: Optional[int] = None) -> SplineList:
    """The curves and surfaces of an IGES or STEP file, as read() gives them. Raises FileError if it cannot be read."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError("a path with a zero in it")
    return SplineList._made(watched(lib.nurbs_read_file, progress, work), name, _options(unit, max_bytes, tolerance, kinds))
