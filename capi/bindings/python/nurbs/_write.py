# SPDX-License-Identifier: MIT
"""What models, lists of splines and meshes have in common when they are written."""

from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Mapping, Optional, Union

import numpy

from ._calls import watched
from ._library import call, get, lib
from .constants import (NURBS_FORMAT_GLB, NURBS_FORMAT_IGES, NURBS_FORMAT_OBJ, NURBS_FORMAT_PLY, NURBS_FORMAT_STEP,
                        NURBS_FORMAT_STL, NURBS_FORMAT_VTU)

if TYPE_CHECKING:
    from ._calls import Progress

_SUFFIXES = {".step": NURBS_FORMAT_STEP, ".stp": NURBS_FORMAT_STEP, ".p21": NURBS_FORMAT_STEP,
             ".iges": NURBS_FORMAT_IGES, ".igs": NURBS_FORMAT_IGES}
MESH_SUFFIXES = {".stl": NURBS_FORMAT_STL, ".obj": NURBS_FORMAT_OBJ, ".ply": NURBS_FORMAT_PLY, ".glb": NURBS_FORMAT_GLB,
                 ".vtu": NURBS_FORMAT_VTU}


class _Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_int64), ("unit", ctypes.c_double), ("tolerance", ctypes.c_double)]


def _options(unit: float, tolerance: float) -> Any:
    options = _Options()
    call(lib.nurbs_write_options_init, ctypes.byref(options), ctypes.sizeof(options))
    options.unit, options.tolerance = unit, tolerance
    return ctypes.byref(options)


def file_bytes(function: Any, handle: Any, format: int, unit: float, tolerance: float, progress: Progress,
               work: Optional[int]) -> bytes:
    """What a function writes to (cap, bytes, length), its last arguments: once to ask how much that is."""
    write, options = watched(function, progress, work, 2), _options(unit, tolerance)
    contents = numpy.empty(get(ctypes.c_int64, write, handle, format, options, 0, None), numpy.uint8)
    get(ctypes.c_int64, write, handle, format, options, contents.size, contents.ctypes.data)
    return contents.tobytes()


def to_file(function: Any, handle: Any, path: Union[str, bytes, os.PathLike[str]], format: Optional[int], unit: float,
            tolerance: float, progress: Progress, work: Optional[int], suffixes: Mapping[str, int] = _SUFFIXES) -> None:
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError("a path with a zero in it")
    if format is None:
        suffix = os.path.splitext(os.fsdecode(name))[1]
        if suffix.lower() not in suffixes:
            raise ValueError(f"no format has the suffix {suffix!r}: expected one of {', '.join(suffixes)}, or a format")
        format = suffixes[suffix.lower()]
    call(watched(function, progress, work), handle, name, format, _options(unit, tolerance))
