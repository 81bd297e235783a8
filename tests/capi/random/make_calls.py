#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the calls of tests/capi/calls again, with random arguments in place of the good ones.

    make_calls.py TOP OUTPUT       writes a file of C++
"""

import re
import sys
from pathlib import Path

TOP = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(TOP / "cmake/interface"))

import calls  # noqa: E402 - from the project
import header  # noqa: E402 - from the project
import shapes  # noqa: E402 - from the project
from calls_model import (Bytes, Handle, Handles, Items, NewHandle, NewStruct, Null, Number, Numbers, Packed, Path as FilePath,  # noqa: E402
                         Slot, Struct, StructSize)

INTEGERS = {"int64_t": "integer", "int32_t": "small_integer", "nurbs_status": "small_integer"}


def lengths_of_handles(arguments, where=()):
    """The numbers that say how many handles or bytes there are, which the library cannot check; `where` defines some."""
    fixed = (Handles, Items, Bytes, NewHandle)
    names = {name for entry, value in arguments if isinstance(value, fixed) for name in re.findall(r"[a-z_]+", entry.shape)}
    names = names.union(*(re.findall(r"[a-z_]+", where[name]) for name in names if name in where))
    return names.union(*(re.findall(r"[a-z_]+", entry.shape) for entry, _ in arguments if entry.name in names))


class Writer:
    """The declarations before a call, and its arguments."""

    def __init__(self, model):
        self.model, self.before = model, []

    def declare(self, text):
        self.before.append(text)

    def spline(self, name):
        return f"r.spline({self.input(name)})"

    def input(self, name):
        return f"in.{name}" if self.model.inputs[name].shared else f"made_{name}"

    def number(self, entry, value, fixed):
        if entry.name in fixed:
            return calls.number(value)
        if entry.base == "double":
            return f'r.real("{entry.name}", {calls.number(value)})'
        if entry.base == "uint32_t":
            return f"r.flags({calls.number(value)})"
        return f'r.{INTEGERS[entry.base]}("{entry.name}", {calls.number(value)})'

    def numbers(self, entry, value, fixed):
        if not value.values or entry.base not in ("double", "int64_t", "int32_t"):
            return calls.argument(self.model, entry, value, "o.")
        usual = ", ".join(map(calls.number, value.values))
        self.declare(f"static constexpr {entry.base} usual_{entry.name}[] = {{{usual}}};")
        if entry.name in fixed:
            return f"usual_{entry.name}"
        return f'r.array("{entry.name}", std::span<const {entry.base}>(usual_{entry.name}))'

    def handle(self, entry, value):
        if self.model.inputs[value.name].kind != "nurbs":
            return self.input(value.name) + ("" if entry.is_const else ".release()")
        if entry.is_const:
            self.declare(f"const nurbs *const {entry.name} = {self.spline(value.name)};")
        else:
            self.declare(f"nurbs *{entry.name} = nullptr;")
            self.declare(f"(void)nurbs_clone({self.spline(value.name)}, &{entry.name});")
        return entry.name

    def struct(self, entry, value):
        fields = {field.name: field for struct in manual.structs if struct.name == value.type for field in struct.fields}
        self.declare(f"{value.type} {entry.name};")
        self.declare(f"(void){value.type}_init(&{entry.name}, sizeof {entry.name});")
        for name, of in value.fields:
            self.declare(f"{entry.name}.{name} = {self.number(fields[name], of, ())};")
        return f"&{entry.name}"

    def packed(self, entry, value):
        self.declare(f"{value.type} {entry.name} = {{}};")
        fixed = lengths_of_handles(value.fields)
        for field, of in value.fields:
            self.declare(f"{entry.name}.{field.name} = {self.argument(field, of, fixed)};")
        return f"&{entry.name}"

    def new_handle(self, value):
        own = value.place in ("list", "statistics", "face", "model", "meet", "mesh")
        self.declare(f"nurbs{f'_{value.place}' * own} *{value.place} = nullptr;")
        self.after = getattr(self, "after", []) + [
            f"nurbs_{value.place}_destroy({value.place});" if own else f"r.keep({value.place});"]
        return f"&{value.place}"

    def argument(self, entry, value, fixed):
        match value:
            case Number():
                return self.number(entry, value, fixed)
            case Numbers():
                return self.numbers(entry, value, fixed)
            case Handle():
                return self.handle(entry, value)
            case Handles():
                name = self.spline if entry.base == "nurbs" else self.input
                self.declare(f"const {entry.base} *const {entry.name}[] = {{{', '.join(map(name, value.names))}}};")
                return entry.name
            case Items():
                self.declare(f"const Items<{value.count}> {entry.name}({self.input(value.list)});")
                return entry.name
            case Struct():
                return self.struct(entry, value)
            case Packed():
                return self.packed(entry, value)
            case NewStruct():
                self.declare(f"{value.type} {entry.name};")
                return f"&{entry.name}"
            case StructSize():
                return f"r.struct_size(sizeof({value.type}))"
            case NewHandle():
                return self.new_handle(value)
            case Slot():
                return f"r.room<{entry.base}>()"
            case Bytes() | FilePath():
                return calls.argument(self.model, entry, value, "o.")
            case Null():
                return "nullptr"
        raise TypeError(value)


def function(model, call, number):
    writer = Writer(model)
    where = shapes.definitions().get(call.function.name.removesuffix("_with"), {})
    fixed = lengths_of_handles(call.arguments, where)
    lines = []
    for index, (entry, value) in enumerate(call.arguments):
        text = writer.argument(entry, value, fixed)
        if not isinstance(value, (Handle, Handles, Items, Struct, Packed, NewStruct, NewHandle, Null)):
            writer.declare(f"const auto given_{index} = {text};")
            text = f"given_{index}"
        lines.append(text)
    name = call.function.name
    yield f"nurbs_status call_{number}([[maybe_unused]] Source &r, [[maybe_unused]] const Inputs &in, Clock &clock) {{"
    yield from (f"    Made made_{made}(in, make_{made});" for made in call.made)
    yield from (f"    {line}" for line in writer.before)
    text = f"{name}({', '.join(lines)})"
    if call.function.result != "nurbs_status":
        text = f"(void({text}), NURBS_OK)"
    yield f"    const nurbs_status status = clock.time([&] {{ return {text}; }});"
    yield from (f"    {line}" for line in getattr(writer, "after", []))
    yield "    return status;"
    yield "}"


def program(model):
    yield from ["// clang-format off", '#include "random/caller.h"', "namespace random_calls {", "using namespace calls;", "namespace {"]
    listed = [call for call in model.calls() if call.function.name != "nurbs_last_error"]
    for number, call in enumerate(listed):
        yield from function(model, call, number)
    yield "const RandomCall table[] = {"
    yield from (f'    {{"{call.function.name}", "{call.name}", call_{number}}},' for number, call in enumerate(listed))
    yield from ["};", "} // namespace", "std::span<const RandomCall> random_calls() { return table; }", "} // namespace random_calls"]


manual = header.read(TOP)
Path(sys.argv[2]).write_text("\n".join(program(calls.read(manual))) + "\n", encoding="utf-8")
