#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The smoke test of the declarations of Python's package: every good call through ctypes, see smoke_reference.cpp.

Nothing is generated: the table is read.
"""

import ctypes
import os

import smoke_table
from smoke_table import TYPES, show, text_of

import calls_model  # from the project, as smoke
import smoke
from calls_model import (Bytes, Handle, Handles, Items, NewHandle, NewStruct, Null, Number, Numbers, Packed, Path, Slot,
                         Struct, StructSize)
from nurbs._prototypes import PROTOTYPES

LETTERS = {"i": ctypes.c_int32, "l": ctypes.c_int64, "u": ctypes.c_uint32, "d": ctypes.c_double, "p": ctypes.c_void_p,
           "s": ctypes.c_char_p, "v": None}
UNWRITTEN = b"\x5a"


class Library:
    """The functions with the types of the package's declarations, and what the calls are given."""

    def __init__(self, manual, model):
        self.manual, self.model = manual, model
        self.library = ctypes.CDLL(os.environ["NURBS_LIBRARY"])
        for name, letters in PROTOTYPES.items():
            result, arguments = letters.split(" ")
            function = getattr(self.library, name)
            function.restype, function.argtypes = LETTERS[result], [LETTERS[letter] for letter in arguments]
        self.structs = {struct.name: self.struct(struct) for struct in manual.structs}
        self.handles = {}
        for name, entry in model.inputs.items():
            if entry.shared:
                self.handles[name] = self.made(entry.call)

    def struct(self, found):
        fields = [(field.name, ctypes.c_void_p if field.pointers or field.base not in TYPES else TYPES[field.base])
                  for field in found.fields]
        return type(found.name, (ctypes.Structure,), {"_fields_": fields})

    def call(self, name, *arguments):
        status = getattr(self.library, name)(*arguments)
        if status != 0:
            text = ctypes.create_string_buffer(1000)
            self.library.nurbs_last_error(text, 1000)
            raise RuntimeError(f"{name}: {text.value.decode()}")

    def made(self, call):
        return Call(self, call).run()["out"].value

    def answer(self, name, ctype, *arguments):
        value = ctype()
        self.call(name, *arguments, ctypes.byref(value))
        return value.value


class Call:
    """One of them: its memory, and what it leaves there."""

    def __init__(self, library, call):
        self.library, self.call, self.kept, self.outputs = library, call, [], {}
        self.own = {}

    def run(self):
        for name in self.call.made:
            self.own[name] = self.library.made(self.library.model.inputs[name].call)
        arguments = [self.argument(entry, value) for entry, value in self.call.arguments]
        function = getattr(self.library.library, self.call.function.name)
        result = function(*arguments)
        if self.call.result is not None:
            self.outputs["return"] = result
        elif self.call.function.result == "nurbs_status" and result != 0:
            self.library.call(self.call.function.name, *arguments)  # which says what is wrong
        return self.outputs

    def keep(self, thing):
        self.kept.append(thing)
        return ctypes.addressof(thing)

    def handle(self, name):
        return self.own.get(name) or self.library.handles[name]

    def argument(self, entry, value):
        match value:
            case Null():
                return None
            case Number():
                return value.value
            case Numbers():
                kind = TYPES[entry.base] * len(value.values)
                return self.keep(kind(*(item.value for item in value.values))) if value.values else None
            case Handle():
                return self.handle(value.name)
            case Handles():
                return self.keep((ctypes.c_void_p * len(value.names))(*(self.handle(name) for name in value.names)))
            case Items():
                return self.items(value)
            case Bytes():
                text = calls_model.encoded(self.library.model.texts[value.text])
                return self.keep(ctypes.create_string_buffer(text, len(text)))
            case Path():
                return self.keep(ctypes.create_string_buffer(smoke_table.file(value.text).encode()))
            case Struct() | Packed():
                return self.keep(self.struct(value))
            case NewStruct():
                return self.keep(self.library.structs[value.type]())
            case StructSize():
                return ctypes.sizeof(self.library.structs[value.type])
            case NewHandle():
                return self.output(entry.name if entry.name != "list" else "list", ctypes.c_void_p())
            case Slot():
                kind = ctypes.c_char if entry.base == "void" else TYPES[entry.base]
                return self.output(entry.name, (kind * max(value.length, 1)).from_buffer(
                    bytearray(UNWRITTEN * max(value.length, 1) * ctypes.sizeof(kind))))

    def output(self, name, memory):
        self.outputs[name] = memory
        if "out" not in self.outputs and isinstance(memory, ctypes.c_void_p):
            self.outputs.setdefault("out", memory)
        return self.keep(memory)

    def items(self, value):
        found = (ctypes.c_void_p * value.count)()
        for i in range(value.count):
            found[i] = self.library.answer("nurbs_list_get", ctypes.c_void_p, self.handle(value.list), i)
        return self.keep(found)

    def struct(self, value):
        made = self.library.structs[value.type]()
        if isinstance(value, Struct):
            self.library.call(f"{value.type}_init", ctypes.byref(made), ctypes.sizeof(made))
        for field, of in value.fields:
            if isinstance(value, Struct):
                setattr(made, field, of.value)
            else:
                setattr(made, field.name, self.argument(field, of))
        return made

    def show(self):
        name = self.call.name
        print(f"{name}|done|")
        for parameter, value in smoke.values_of(self.call).items():
            if isinstance(value, Slot) and value.length > 0:
                self.show_array(name, parameter, self.outputs[parameter])
            elif isinstance(value, NewHandle):
                shown = {"list": self.show_list, "statistics": self.show_statistics, "face": self.show_face,
                         "model": self.show_model, "meet": self.show_meet, "mesh": self.show_mesh}.get(value.place, self.show_spline)
                shown(name, parameter, self.outputs[parameter].value)
        if self.call.result is not None:
            found = self.outputs["return"]
            show(name, "return", [found.decode() if isinstance(found, bytes) else str(found)])

    def show_array(self, name, parameter, memory):
        if memory._type_ is ctypes.c_char:
            return show(name, parameter, [memory.value.decode()])
        raw = bytes(memory)
        size = ctypes.sizeof(memory._type_)
        show(name, parameter, [text_of(item, memory._type_) for i, item in enumerate(memory)
                               if raw[i * size:(i + 1) * size] != UNWRITTEN * size])

    def show_spline(self, name, parameter, g):
        answer = self.library.answer
        axes = range(answer("nurbs_axes", ctypes.c_int32, g))
        degrees = [answer("nurbs_degree", ctypes.c_int32, g, k) for k in axes]
        knots = [knot for k in axes for knot in self.doubles("nurbs_knots", g, k, degrees[k] + 1
                                                              + answer("nurbs_count", ctypes.c_int64, g, k))]
        count = answer("nurbs_point_count", ctypes.c_int64, g)
        points = (ctypes.c_double * (count * (answer("nurbs_dimension", ctypes.c_int32, g) + 1)))()
        self.library.call("nurbs_homogeneous_points", g, count, points, 0, 0)
        show(name, f"{parameter}.degrees", map(str, degrees))
        show(name, f"{parameter}.knots", (text_of(x, ctypes.c_double) for x in knots))
        show(name, f"{parameter}.points", (text_of(x, ctypes.c_double) for x in points))

    def doubles(self, function, g, axis, count):
        memory = (ctypes.c_double * count)()
        self.library.call(function, g, axis, count, memory)
        return list(memory)

    def show_statistics(self, name, parameter, handle):
        length = ctypes.c_int64()
        self.library.call("nurbs_statistics_to_bytes", handle, 0, None, ctypes.byref(length))
        memory = ctypes.create_string_buffer(length.value)
        self.library.call("nurbs_statistics_to_bytes", handle, length.value, memory, None)
        show(name, f"{parameter}.bytes", map(str, memory.raw))

    def show_face(self, name, parameter, face):
        loops = self.library.answer("nurbs_face_loops", ctypes.c_int64, face, 0, None)
        sizes = (ctypes.c_int64 * loops)()
        self.library.call("nurbs_face_loops", face, loops, sizes, None)
        show(name, f"{parameter}.sizes", map(str, sizes))
        for loop, size in enumerate(sizes):
            for i in range(size):
                g = self.library.answer("nurbs_face_curve", ctypes.c_void_p, face, loop, i)
                self.show_spline(name, f"{parameter}.curves", g)

    def show_model(self, name, parameter, model):
        counts = [ctypes.c_int64() for _ in range(5)]
        self.library.call("nurbs_model_counts", model, *map(ctypes.byref, counts))
        show(name, f"{parameter}.counts", [str(count.value) for count in counts])
        for i in range(counts[2].value):
            face = self.library.answer("nurbs_model_face", ctypes.c_void_p, model, i, None, None, None, None)
            self.show_face(name, f"{parameter}.faces", face)
        for i in range(counts[3].value):
            edge = self.library.answer("nurbs_model_edge", ctypes.c_void_p, model, i, None, None, None)
            self.show_spline(name, f"{parameter}.edges", edge)

    def show_meet(self, name, parameter, meet):
        branches, nodes = ctypes.c_int64(), ctypes.c_int64()
        self.library.call("nurbs_meet_counts", meet, ctypes.byref(branches), ctypes.byref(nodes), None)
        kinds = (ctypes.c_int32 * nodes.value)()
        self.library.call("nurbs_meet_nodes", meet, nodes.value, None, kinds, None, None, None)
        show(name, f"{parameter}.nodes", map(str, kinds))
        for i in range(branches.value):
            space, on_surface = ctypes.c_void_p(), ctypes.c_void_p()
            self.library.call("nurbs_meet_branch", meet, i, ctypes.byref(space), ctypes.byref(on_surface))
            for g in (space, on_surface):
                self.show_spline(name, f"{parameter}.branches", g.value)

    def show_mesh(self, name, parameter, mesh):
        points, triangles = ctypes.c_int64(), ctypes.c_int64()
        self.library.call("nurbs_mesh_counts", mesh, ctypes.byref(points), None, ctypes.byref(triangles), None, None, None)
        xyz = (ctypes.c_double * (3 * points.value))()
        corners = (ctypes.c_int64 * (3 * triangles.value))()
        self.library.call("nurbs_mesh_points", mesh, points.value, xyz, None)
        self.library.call("nurbs_mesh_triangles", mesh, 0, triangles.value, corners, None)
        self.show_array(name, f"{parameter}.points", xyz)
        show(name, f"{parameter}.corners", map(str, corners))

    def show_list(self, name, parameter, handle):
        count = self.library.answer("nurbs_list_count", ctypes.c_int64, handle)
        show(name, f"{parameter}.count", [str(count)])
        for i in range(count):
            g = self.library.answer("nurbs_list_get", ctypes.c_void_p, handle, i)
            self.show_spline(name, f"{parameter}[{i}]", g)


def main():
    library = Library(smoke_table.manual, smoke_table.model)
    for call in smoke_table.model.calls():
        made = Call(library, call)
        made.run()
        made.show()


if __name__ == "__main__":
    main()
