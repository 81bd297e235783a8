# SPDX-License-Identifier: MIT
"""The shared library: where it is found, the types of its functions, how they are called."""

from __future__ import annotations

import ctypes
import operator
import os
from typing import TYPE_CHECKING, Any, Callable, Optional, TypeVar

import numpy

from ._errors import NumericError, error_class
from ._prototypes import PROTOTYPES
from .constants import NURBS_ERROR_NOT_REPRESENTABLE, NURBS_OK

if TYPE_CHECKING:
    from ._arrays import Floats

_Answer = TypeVar("_Answer")


def _integer(ctype: Any, name: str, low: int, high: int) -> Any:
    """An argument type that refuses what does not fit, where ctypes would cut it off, and takes NumPy's integers."""

    class Argument:
        @staticmethod
        def from_param(value: Any) -> Any:
            number = operator.index(value)
            if not low <= number <= high:
                raise OverflowError(f"{number} does not fit {name}")
            return ctype(number)

    return Argument


class _Double:
    @staticmethod
    def from_param(value: Any) -> ctypes.c_double:
        return ctypes.c_double(value)


# The letters of _prototypes.py.
_RESULTS = {"i": ctypes.c_int32, "l": ctypes.c_int64, "s": ctypes.c_char_p, "v": None}
_ARGUMENTS = {
    "i": _integer(ctypes.c_int32, "int32_t", -(2**31), 2**31 - 1),
    "u": _integer(ctypes.c_uint32, "uint32_t", 0, 2**32 - 1),
    "l": _integer(ctypes.c_int64, "int64_t", -(2**63), 2**63 - 1),
    "d": _Double,
    "p": ctypes.c_void_p,
}


def int32(value: Any) -> int:
    """An integer that the library takes as int32_t."""
    return int(_ARGUMENTS["i"].from_param(value).value)


def uint32(value: Any) -> int:
    """An integer that the library takes as uint32_t."""
    return int(_ARGUMENTS["u"].from_param(value).value)


def int64(value: Any) -> int:
    """An integer that the library takes as int64_t."""
    return int(_ARGUMENTS["l"].from_param(value).value)


def _load() -> ctypes.CDLL:
    name = os.environ.get("NURBS_LIBRARY") or "libnurbs.so.1"
    try:
        # CDLL, unlike PyDLL, releases the interpreter's lock during calls.
        library = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"the library {name} cannot be loaded ({error}); install libnurbs, or set NURBS_LIBRARY to "
                          "the path of libnurbs.so") from error
    for function, types in PROTOTYPES.items():
        result, arguments = types.split(" ")
        try:
            entry = getattr(library, function)
        except AttributeError:
            raise ImportError(f"the library {name} is older than this module: it has no {function}()") from None
        entry.restype = _RESULTS[result]
        entry.argtypes = [_ARGUMENTS[letter] for letter in arguments]
    return library


#: The C functions themselves, by their names in nurbs.h.
lib = _load()


def _address(function: Any) -> Optional[int]:
    return ctypes.cast(function, ctypes.c_void_p).value


def _load_single() -> Any:
    """The compiled module for calls that are made one at a time, or None where it is missing or not wanted."""
    if os.environ.get("NURBS_NO_EXTENSION"):
        return None
    try:
        from . import _single
    except ImportError:
        return None
    _single.bind(_address(lib.nurbs_eval), _address(lib.nurbs_eval_derivs), numpy.empty)
    return _single


#: Its functions return None for what is not a single place, or fails: the functions of this package do that too.
single = _load_single()


def version() -> int:
    """Version of the library that is loaded: major * 10000 + minor * 100 + patch."""
    return int(lib.nurbs_version())


def status_name(status: int) -> str:
    """Name of a status, such as "NURBS_ERROR_NULL"."""
    return str(_result(lib.nurbs_status_name, status).decode())


def last_error() -> str:
    """Message of the last failed call in this thread."""
    size = lib.nurbs_last_error(None, 0) + 1
    text = ctypes.create_string_buffer(size)
    lib.nurbs_last_error(text, size)
    return text.value.decode(errors="replace")


def _result(function: Any, *arguments: Any) -> Any:
    """What a function of the library returns; arguments that are no numbers, or do not fit, are natural errors."""
    try:
        return function(*arguments)
    except ctypes.ArgumentError as error:
        kind = OverflowError if "OverflowError" in str(error) else TypeError
        raise kind(f"{function.__name__}(), {error}") from None


def call(function: Any, *arguments: Any) -> None:
    """Calls a function of the library; raises NurbsError unless its status is success."""
    status = _result(function, *arguments)
    if status != NURBS_OK:
        raise error_class(status)(status, status_name(status), last_error())


def if_representable(ask: Callable[[Optional[int]], _Answer], values: Floats, otherwise: float) -> _Answer:
    """What ask(address of the values) returns; where that overflows, what ask(None) does, and the values become
    `otherwise`."""
    try:
        return ask(values.ctypes.data)
    except NumericError as error:
        if error.status != NURBS_ERROR_NOT_REPRESENTABLE:
            raise
    values.fill(otherwise)
    return ask(None)


def get(ctype: Any, function: Any, *arguments: Any) -> Any:
    """The one value that a function writes through its last argument."""
    value = ctype()
    call(function, *arguments, ctypes.byref(value))
    return value.value


def text(function: Any, *arguments: Any) -> str:
    """The text that a function writes to (buf, cap, length), its last arguments."""
    length = ctypes.c_int64()
    call(function, *arguments, None, 0, ctypes.byref(length))
    buffer = ctypes.create_string_buffer(length.value + 1)
    call(function, *arguments, buffer, length.value + 1, None)
    return buffer.value.decode(errors="replace")
