# SPDX-License-Identifier: MIT
"""The shared library: where it is found, the types of its functions, its errors."""

import ctypes
import operator
import os

from ._prototypes import PROTOTYPES
from .constants import NURBS_OK


def _integer(ctype, low, high):
    """An argument type that refuses what does not fit, where ctypes would cut it off, and takes NumPy's integers."""

    class Argument:
        @staticmethod
        def from_param(value):
            number = operator.index(value)
            if not low <= number <= high:
                raise OverflowError(f"{number} does not fit {ctype.__name__}")
            return ctype(number)

    return Argument


class _Double:
    @staticmethod
    def from_param(value):
        return ctypes.c_double(value)


# The letters of _prototypes.py.
_RESULTS = {"i": ctypes.c_int32, "l": ctypes.c_int64, "s": ctypes.c_char_p, "v": None}
_ARGUMENTS = {
    "i": _integer(ctypes.c_int32, -(2**31), 2**31 - 1),
    "u": _integer(ctypes.c_uint32, 0, 2**32 - 1),
    "l": _integer(ctypes.c_int64, -(2**63), 2**63 - 1),
    "d": _Double,
    "p": ctypes.c_void_p,
}


class NurbsError(Exception):
    """A call that failed: its status, the name of the status, and the library's message."""

    def __init__(self, status, name, message):
        super().__init__(status, name, message)
        self.status = status
        self.name = name
        self.message = message

    def __str__(self):
        return f"{self.name}: {self.message}"


def _load():
    # CDLL, unlike PyDLL, releases the interpreter's lock during calls.
    library = ctypes.CDLL(os.environ.get("NURBS_LIBRARY") or "libnurbs.so.1")
    for name, types in PROTOTYPES.items():
        result, arguments = types.split(" ")
        function = getattr(library, name)
        function.restype = _RESULTS[result]
        function.argtypes = [_ARGUMENTS[letter] for letter in arguments]
    return library


lib = _load()


def version():
    """Version of the library: major * 10000 + minor * 100 + patch."""
    return lib.nurbs_version()


def status_name(status):
    """Name of a status, such as "NURBS_ERROR_NULL"."""
    return lib.nurbs_status_name(status).decode()


def last_error():
    """Message of the last failed call in this thread."""
    size = lib.nurbs_last_error(None, 0) + 1
    text = ctypes.create_string_buffer(size)
    lib.nurbs_last_error(text, size)
    return text.value.decode(errors="replace")


def check(status):
    """Raises NurbsError unless the status is success."""
    if status != NURBS_OK:
        raise NurbsError(status, status_name(status), last_error())


def get(ctype, function, *arguments):
    """The one value that a function writes through its last argument."""
    value = ctype()
    check(function(*arguments, ctypes.byref(value)))
    return value.value


def text(function, *arguments):
    """The text that a function writes to (buf, cap, length), its last arguments."""
    length = ctypes.c_int64()
    check(function(*arguments, None, 0, ctypes.byref(length)))
    buffer = ctypes.create_string_buffer(length.value + 1)
    check(function(*arguments, buffer, length.value + 1, None))
    return buffer.value.decode(errors="replace")
