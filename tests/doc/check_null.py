"""The library refuses NULL where nurbs.h does not mark a pointer with "or NULL", and nowhere else.

usage: check_null.py TOP_FOLDER libnurbs.so

Every function is called with one pointer NULL and arguments made up from the names and types of its parameters, which
are good enough for most of them; with several kinds of splines, because each function is for some. A required pointer
has to be refused by NURBS_ERROR_NULL with its name in some of these calls, and none may succeed; one that may be NULL is
refused in none.
"""

import ctypes
import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project

ROOM = 1 << 14  # values in an array, more than any of these calls uses
INTEGERS = {"int32_t": ctypes.c_int32, "int64_t": ctypes.c_int64, "uint32_t": ctypes.c_uint32,
            "nurbs_status": ctypes.c_int32}
ERROR_NULL = 1
# Values that differ from 1/4, which any real number is, and elements of arrays that differ from 1.
UPPER = {"b": 1, "end": 1, "upper": 1, "top": 1, "north": 1, "top_radius": 0.5}
ELEMENTS = {"degrees": 2, "counts": 3, "distinct_counts": 2, "multiplicities": 3}
# Numbers of points or parameters, and numbers of knots.
AMOUNTS = ((1, 1), (3, 6), (9, 9), (6, 6), (3, 4))


def knots(degree, count):
    return [0.0] * degree + [i / (count - degree) for i in range(count - degree + 1)] + [1.0] * degree


class Splines:
    """A curve, surface or volume in some dimension, of degree 2 with 3 control points along each axis."""

    def __init__(self, library, axes, dim):
        count = 3 ** axes
        places = [[(k // 3 ** (axes - 1 - axis)) % 3 for axis in range(axes)] for k in range(count)]
        points = [float((place + [0] * dim)[c]) + 0.1 * (sum(place) % 2) * (c == dim - 1) for place in places
                  for c in range(dim)]
        vector = knots(2, 3) * axes
        self.axes, self.dim, self.handle = axes, dim, ctypes.c_void_p()
        status = library.nurbs_create(
            axes, (ctypes.c_int32 * axes)(*[2] * axes), (ctypes.c_int64 * axes)(*[3] * axes),
            (ctypes.c_double * len(vector))(*vector), ctypes.c_int64(len(vector)), dim,
            (ctypes.c_double * len(points))(*points), ctypes.c_int64(0), ctypes.c_int64(0), None, ctypes.c_int64(0), 0,
            ctypes.byref(self.handle))
        assert status == 0


class Border:
    """The library, with calls that are made up."""

    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        kinds = ((1, 2), (2, 3), (1, 3), (2, 2), (3, 3), (1, 1))
        self.splines = [Splines(self.library, axes, dim) for axes, dim in kinds]
        self.list = ctypes.c_void_p()
        assert self.library.nurbs_decompose(self.splines[0].handle, ctypes.byref(self.list)) == 0

    def message(self):
        text = ctypes.create_string_buffer(1000)
        self.library.nurbs_last_error(text, ctypes.c_int64(1000))
        return text.value.decode()

    def refusal(self, function, absent, spline, amounts):
        """Whether the call fails for want of a pointer; its message; whether it succeeds."""
        cap = 0 if absent.null == " when cap is 0" else 64
        arguments = [None if entry is absent else self.argument(entry, spline, *amounts, cap)
                     for entry in function.parameters]
        call = getattr(self.library, function.name)
        call.restype = ctypes.c_int32
        status = call(*arguments)
        return status == ERROR_NULL, self.message(), status == 0

    def argument(self, entry, spline, count, knot_count, cap):
        if entry.pointers:
            return self.pointer(entry, spline)
        if entry.base == "double":
            return ctypes.c_double(UPPER.get(entry.name, 0.25))
        values = {"dim": spline.dim, "axes": spline.axes, "out_dim": spline.dim, "count": count, "n": count,
                  "size": count, "knot_count": knot_count, "break_count": 2 * spline.axes, "cap": cap, "degree": 2,
                  "pieces": 4, "parts": 4, "sides": 4}
        return INTEGERS[entry.base](values.get(entry.name, 0))

    def pointer(self, entry, spline):
        if entry.base == "nurbs":
            if entry.pointers == 1:
                return spline.handle
            several = (ctypes.c_void_p * 16)(*[spline.handle.value] * 16)
            return several if entry.is_const else ctypes.byref(ctypes.c_void_p())
        if entry.base == "nurbs_list":
            return self.list if entry.pointers == 1 else ctypes.byref(ctypes.c_void_p())
        if entry.base in INTEGERS:
            return (INTEGERS[entry.base] * ROOM)(*[ELEMENTS.get(entry.name, 1)] * 64)
        if entry.base in ("double", "float"):
            kind = ctypes.c_double if entry.base == "double" else ctypes.c_float
            return (kind * ROOM)(*[0.5 + i / 256 for i in range(64)])
        return ctypes.create_string_buffer(b"\0" * 8 * ROOM)


def outcome(border, function, entry):
    """What is wrong, or None; and whether a call without the pointer succeeds."""
    refused = succeeded = False
    for spline, amounts in itertools.product(border.splines, AMOUNTS):
        null, message, good = border.refusal(function, entry, spline, amounts)
        refused = refused or (null and message.startswith(f"{entry.name} is NULL"))
        succeeded = succeeded or good
    if entry.nullable and refused:
        return "is marked with 'or NULL', and refused", succeeded
    if not entry.nullable and succeeded:
        return "may be NULL, and is not marked", succeeded
    return None if entry.nullable or refused else "is required, and never refused here", succeeded


def main():
    manual = header.read(sys.argv[1])
    border = Border(sys.argv[2])
    pointers = [(function, entry) for function in manual.functions if function.result == "nurbs_status"
                for entry in function.parameters if entry.pointers]
    found, accepted = [], 0
    for function, entry in pointers:
        text, succeeded = outcome(border, function, entry)
        accepted += succeeded
        found += [f"{function.name}: {entry.name} {text}"] if text else []
    nullable = sum(entry.nullable for _, entry in pointers)
    print("\n".join(found) or f"{len(pointers) - nullable} pointers are required, {nullable} may be NULL, "
          f"{accepted} of them in calls that succeed")
    return 1 if found or not pointers else 0


if __name__ == "__main__":
    sys.exit(main())
