# SPDX-License-Identifier: MIT
"""Reading files: the splines that a file held, their names, and notes on the rest."""

import ctypes
import os
from collections import namedtuple
from collections.abc import Sequence

from ._library import check, get, lib, text
from .spline import Spline

Note = namedtuple("Note", "entity_type line reason text")


class _Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("unit", ctypes.c_double), ("max_bytes", ctypes.c_int64)]


def _options(unit, max_bytes):
    options = _Options()
    check(lib.nurbs_read_options_init(ctypes.byref(options), ctypes.sizeof(options)))
    options.unit = unit
    if max_bytes is not None:
        options.max_bytes = max_bytes
    return ctypes.byref(options)


class SplineList(Sequence):
    """A sequence of the splines of a file, with `names`, `notes` and `unit` (metres per unit, 0 if not said)."""

    def __init__(self, handle):
        self._handle = handle

    def __del__(self):
        if lib is not None and getattr(self, "_handle", None):
            lib.nurbs_list_destroy(self._handle)

    def __len__(self):
        return get(ctypes.c_int64, lib.nurbs_list_count, self._handle)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        position = index + len(self) if index < 0 else index
        if not 0 <= position < len(self):
            raise IndexError(f"list index {index} out of range")
        return Spline._made(lib.nurbs_list_get, self._handle, position)

    @property
    def names(self):
        return [text(lib.nurbs_list_name, self._handle, i) for i in range(len(self))]

    @property
    def notes(self):
        count = get(ctypes.c_int64, lib.nurbs_list_note_count, self._handle)
        return [self._note(i) for i in range(count)]

    @property
    def unit(self):
        return get(ctypes.c_double, lib.nurbs_list_unit, self._handle)

    def _note(self, index):
        kind, line, reason = ctypes.c_int32(), ctypes.c_int64(), ctypes.c_int32()
        words = text(lib.nurbs_list_note, self._handle, index, ctypes.byref(kind), ctypes.byref(line),
                     ctypes.byref(reason))
        return Note(kind.value, line.value, reason.value, words)


def read(contents, unit=0.0, max_bytes=None):
    """The splines of an IGES file held in memory (bytes); unit in metres, 0 keeps the file's own."""
    contents = bytes(contents)
    handle = get(ctypes.c_void_p, lib.nurbs_read, contents, len(contents), _options(unit, max_bytes))
    return SplineList(handle)


def read_file(path, unit=0.0, max_bytes=None):
    """The splines of an IGES file; unit in metres, 0 keeps the file's own."""
    handle = get(ctypes.c_void_p, lib.nurbs_read_file, os.fsencode(path), _options(unit, max_bytes))
    return SplineList(handle)
