# SPDX-License-Identifier: MIT
"""Calls of every function with arguments that are made up from the names and types of its parameters, which are good enough
for most of them; with several kinds of splines, because each function is for some."""

import ctypes
import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project
import slots  # noqa: E402 - from the project

ROOM = 1 << 14  # values in an array, more than any of these calls uses
# Values that differ from 1/4, which any real number is, and elements of arrays that differ from 1.
UPPER = {"b": 1, "end": 1, "upper": 1, "top": 1, "north": 1, "top_radius": 0.5}
ELEMENTS = {"degrees": 2, "counts": 3, "distinct_counts": 2, "multiplicities": 3, "break_counts": 2}
# Numbers of points or parameters, and numbers of knots.
AMOUNTS = ((1, 1), (3, 6), (9, 9), (6, 6), (3, 4))


def new_handles(value=None):
    """Where one goes, or an array of them."""
    return ctypes.cast((ctypes.c_void_p * 64)(*[value] * 64), ctypes.POINTER(ctypes.c_void_p))


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
    """The library, and arguments for its functions."""

    def __init__(self, top, library):
        self.manual = header.read(top)
        self.library = ctypes.CDLL(library)
        kinds = ((1, 2), (2, 3), (1, 3), (2, 2), (3, 3), (1, 1))
        self.splines = [Splines(self.library, axes, dim) for axes, dim in kinds]
        self.list = ctypes.c_void_p()
        assert self.library.nurbs_decompose(self.splines[0].handle, ctypes.byref(self.list)) == 0
        self.statistics = ctypes.c_void_p()
        assert self.library.nurbs_statistics_create(
            1, (ctypes.c_int32 * 1)(2), (ctypes.c_int64 * 1)(2), (ctypes.c_double * 2)(0, 1), ctypes.c_int64(2), 1,
            ctypes.c_double(1), ctypes.c_double(1), ctypes.byref(self.statistics)) == 0
        surface = self.splines[1].handle
        self.face, self.model = ctypes.c_void_p(), ctypes.c_void_p()
        assert self.library.nurbs_face_create(surface, ctypes.c_int64(0), None, None, None, None, ctypes.c_double(0.25), 0, None,
                                              ctypes.byref(self.face)) == 0
        assert self.library.nurbs_model_create(ctypes.c_int64(1), ctypes.byref(self.face), ctypes.c_double(0),
                                               ctypes.byref(self.model)) == 0
        self.meet = ctypes.c_void_p()
        assert self.library.nurbs_surface_sections(surface, (ctypes.c_double * 3)(0, 0, 1), ctypes.c_int64(1),
                                                   (ctypes.c_double * 1)(0.25), ctypes.c_double(0.25),
                                                   ctypes.byref(self.meet)) == 0
        self.mesh = ctypes.c_void_p()
        assert self.library.nurbs_mesh_model(self.model, None, ctypes.byref(self.mesh)) == 0
        self.handles = {"nurbs_list": self.list, "nurbs_statistics": self.statistics, "nurbs_face": self.face,
                        "nurbs_model": self.model, "nurbs_meet": self.meet, "nurbs_mesh": self.mesh}
        self.structs = {struct.name: slots.struct_class(self.manual, struct) for struct in self.manual.structs}
        self.callbacks = {name: slots.callback_type(self.manual, name)(lambda *_: 0) for name in self.manual.callbacks}

    def functions(self):
        """Those that can fail."""
        return [function for function in self.manual.functions if function.result == "nurbs_status"]

    def call(self, function, found, values):
        """The status of a call with these values."""
        entry = getattr(self.library, function.name)
        entry.restype = ctypes.c_int32
        return entry(*slots.passed(found, values))

    def message(self):
        text = ctypes.create_string_buffer(1000)
        self.library.nurbs_last_error(text, ctypes.c_int64(1000))
        return text.value.decode()

    def kinds(self):
        """Of calls of one function: with which spline, and how many points."""
        return itertools.product(self.splines, AMOUNTS)

    def slots(self, function):
        return list(slots.slots(self.manual, function))

    def values(self, found, spline, amounts, cap=64):
        """{key of a slot: value}"""
        return {slot.key: self.value(slot, spline, *amounts, cap) for slot in found}

    def value(self, slot, spline, count, knot_count, cap):
        entry = slot.entry
        if slot.is_callback:
            return self.callbacks[entry.base]
        if entry.pointers:
            return self.pointer(entry, spline) if slot.used else None
        if entry.base == "double":
            return ctypes.c_double(UPPER.get(entry.name, 0.25) * slot.used)
        values = {"dim": spline.dim, "axes": spline.axes, "out_dim": spline.dim, "count": count, "n": count,
                  "count_a": count, "count_b": count,
                  "size": count, "knot_count": knot_count, "break_count": 2 * spline.axes,
                  "break_total": 2 * spline.axes, "cap": cap, "degree": 2, "pieces": 4, "parts": 4, "sides": 4}
        if slot.holder and entry.name == "struct_size":
            values["struct_size"] = slots.known_size(self.structs[slot.holder.base])
        return slots.INTEGERS[entry.base](values.get(entry.name, 0) * slot.used)

    def pointer(self, entry, spline):
        if entry.base in self.structs:
            return self.structs[entry.base]()
        if entry.base == "nurbs":
            if entry.pointers == 1:
                return spline.handle
            several = (ctypes.c_void_p * 16)(*[spline.handle.value] * 16)
            return several if entry.is_const else new_handles()
        if entry.base in self.handles:
            one = self.handles[entry.base]
            several = (ctypes.c_void_p * 16)(*[one.value] * 16)
            if entry.pointers == 1:
                return one
            return several if entry.is_const else new_handles()
        if entry.base in slots.INTEGERS:
            return (slots.INTEGERS[entry.base] * ROOM)(*[ELEMENTS.get(entry.name, 1)] * 64)
        if entry.base in ("double", "float"):
            return (slots.NUMBERS[entry.base] * ROOM)(*[0.5 + i / 256 for i in range(64)])
        return ctypes.create_string_buffer(b"\0" * 8 * ROOM)
