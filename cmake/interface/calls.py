# SPDX-License-Identifier: MIT
"""The good calls of tests/capi/calls in C++, for the tests of tests/capi that share them.

A group becomes an array of Call (tests/capi/calls/calls.h), an input a function that makes it.
"""

import math
import re
import textwrap
from pathlib import Path

import calls_model
import calls_reader
import header
from calls_model import (Bytes, Handle, Handles, Items, NewHandle, NewStruct, Null, Number, Numbers, Packed, Slot, Struct,
                         StructSize)

TOP = Path(__file__).resolve().parents[2]
FOLDER = f"{calls_model.FOLDER}/generated"
WIDTH = 110
SCALAR = "scalar"  # the group that allocates nothing
NOTICE = f"""\
/* SPDX-License-Identifier: MIT */
// Generated from {calls_model.FOLDER}/*.toml and {header.PATH} by: {header.COMMAND} - do not edit.
// clang-format off
"""


def read(manual):
    try:
        return calls_reader.read(manual, TOP)
    except calls_model.CallsError as error:
        raise SystemExit(str(error)) from error


# Values.


def number(value):
    if value.constants:
        return value.constants
    if isinstance(value.value, float) and not math.isfinite(value.value):
        return "NAN" if math.isnan(value.value) else "HUGE_VAL" if value.value > 0 else "-HUGE_VAL"
    return repr(value.value)


def element(entry):
    return entry.base + " *" * (entry.pointers - 1)


def handle(model, name, entry):
    if model.inputs[name].shared:
        return f"in.{name}"
    return f"made_{name}" if entry.is_const else f"made_{name}.release()"


def argument(model, entry, value, place):
    """place: how the new handle is told apart, "o." for a call."""
    match value:
        case Null() | Numbers(values=()):
            return "nullptr"
        case Number():
            return number(value)
        case Numbers():
            return f"arrays::{value.name}" if value.name else entry.name
        case Handle():
            return handle(model, value.name, entry)
        case Handles() | Items():
            return entry.name
        case Bytes():
            return f"texts::{value.text}"
        case calls_model.Path():
            return f"{value.text}_path"
        case Struct() | NewStruct() | Packed():
            return f"&{entry.name}"
        case StructSize():
            return f"sizeof({value.type})"
        case NewHandle():
            return f"&o.{value.place}" if place == "o." else "out"
        case Slot():
            return f"o.{value.array}" + f" + {value.first}" * (value.first > 0)


# What stands before a call.


def array(kind, name, items):
    line = f"{kind} {name}[] = {{{', '.join(items)}}};"
    return textwrap.wrap(line, WIDTH - 8, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def made(name):
    yield f"Made made_{name}(in, make_{name});"
    yield f"if (made_{name}.status() != NURBS_OK) {{"
    yield f"    return made_{name}.status();"
    yield "}"


def items(model, entry, value):
    source = f"in.{value.list}" if model.inputs[value.list].shared else f"made_{value.list}"
    yield f"const Items<{value.count}> {entry.name}({source});"
    yield f"if ({entry.name}.status() != NURBS_OK) {{"
    yield f"    return {entry.name}.status();"
    yield "}"


def struct(entry, value):
    yield f"{value.type} {entry.name};"
    yield f"(void){value.type}_init(&{entry.name}, sizeof {entry.name});"
    yield from (f"{entry.name}.{field} = {number(of)};" for field, of in value.fields)


def packed(model, entry, value):
    for field, of in value.fields:
        yield from declarations(model, field, of)
    yield f"{value.type} {entry.name} = {{}};"
    yield from (f"{entry.name}.{field.name} = {argument(model, field, of, 'o.')};" for field, of in value.fields)


def handles(model, entry, value):
    return array(f"const {entry.base} *const", entry.name, (handle(model, name, entry) for name in value.names))


def declarations(model, entry, value):
    match value:
        case Numbers(values=[_, *_], name=""):
            yield from array(f"static constexpr {entry.base}", entry.name, map(number, value.values))
        case Handles():
            yield from handles(model, entry, value)
        case Items():
            yield from items(model, entry, value)
        case Struct():
            yield from struct(entry, value)
        case Packed():
            yield from packed(model, entry, value)
        case NewStruct():
            yield f"{value.type} {entry.name};"


def answer(call, text):
    """The call, and what its status is."""
    if call.function.result == "nurbs_status":
        return [f"return {text};"]
    if call.result is None:
        return [f"{text};", "return NURBS_OK;"]
    if call.result.array == "text":
        return [f'snprintf(o.text, sizeof o.text, "%s", {text});', "return NURBS_OK;"]
    return [f"o.{call.result.array}[{call.result.first}] = {text};", "return NURBS_OK;"]


def body(model, call, place):
    """Its lines."""
    for name in call.made:
        yield from made(name)
    for entry, value in call.arguments:
        yield from declarations(model, entry, value)
    words = ", ".join(argument(model, entry, value, place) for entry, value in call.arguments)
    for line in answer(call, f"{call.function.name}({words})"):
        yield from textwrap.wrap(line, WIDTH - 8, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)


def parameters(lines, names):
    """"const Inputs &in, Output &o", without the names that no line has."""
    words = set(re.findall(r"\w+", "\n".join(lines)))
    return ", ".join(kind + name * (name in words) for kind, name in names)


# Files.


def entry_of(model, call):
    lines = list(body(model, call, "o."))
    given = parameters(lines, [("const Inputs &", "in"), ("Output &", "o")])
    yield f'    {{"{call.name}",'
    yield f"     []({given}) -> nurbs_status {{"
    yield from ("         " + line for line in lines)
    yield "     }" + ", true" * call.can_do_without + "},"


def group_file(name):
    def contents(manual):
        model = read(manual)
        lines = [NOTICE + '#include "calls/calls.h"\n', "namespace calls {\n", "namespace {\n", "const Call group[] = {"]
        lines += [line for call in model.groups[name] for line in entry_of(model, call)]
        lines += ["};\n", "} // namespace\n", f"std::span<const Call> {name}_calls() {{", "    return group;", "}\n"]
        return "\n".join([*lines, "} // namespace calls\n"])
    return contents


def members(model, kind):
    return [entry.name for entry in model.inputs.values() if entry.shared and entry.kind == kind]


def literal(text):
    for line in text.splitlines():
        yield '    "' + line.replace("\\", "\\\\").replace('"', '\\"') + '\\n"'


def struct_of_inputs(model):
    kinds = {"nurbs": "splines", "nurbs_list": "lists", "nurbs_statistics": "all_statistics", "nurbs_face": "faces_made",
             "nurbs_model": "models", "nurbs_meet": "meets", "nurbs_mesh": "meshes"}
    yield "// What is made once for all calls."
    yield "struct Inputs {"
    yield from (f"    {kind} *{', *'.join(members(model, kind))};" for kind in kinds)
    yield "};\n"
    for kind, name in kinds.items():
        names = members(model, kind)
        yield from array(f"inline constexpr {kind} *Inputs::*const", name, (f"&Inputs::{name}" for name in names))


def constants(model):
    yield "namespace arrays {"
    for name, values in model.arrays.items():
        yield from array("inline constexpr double", name, map(number, values))
    yield "} // namespace arrays\n"
    yield "namespace texts {"
    for name, text in model.texts.items():
        if isinstance(text, bytes):
            yield from array("inline constexpr unsigned char", name, map(str, text))
            continue
        *before, last = literal(text)
        yield from (f"inline constexpr char {name}[] =", *before, last + ";")
    yield "} // namespace texts\n"


def table_header(manual):
    model = read(manual)
    guard = "NURBS_TESTS_CAPI_CALLS_GENERATED_TABLE_H"
    lines = [NOTICE + f"#ifndef {guard}", f"#define {guard}\n", "#include <nurbs/nurbs.h>\n", "#include <span>\n",
             "namespace calls {\n", *struct_of_inputs(model), "", *constants(model)]
    lines += [f"nurbs_status make_{entry.name}(const Inputs &in, {entry.kind} **out);" for entry in model.inputs.values()]
    lines += ["", "// Those of one kind.", "struct Call;"]
    lines += [f"std::span<const Call> {name}_calls();" for name in model.groups]
    return "\n".join([*lines, "\n} // namespace calls\n", "#endif\n"])


def maker(model, entry):
    lines = list(body(model, entry.call, ""))
    given = parameters(lines, [("const Inputs &", "in"), (f"{entry.kind} **", "out")])
    yield f"nurbs_status make_{entry.name}({given}) {{"
    yield from ("    " + line for line in lines)
    yield "}\n"


def checks_of_output():
    for kind, name in calls_model.ARRAYS.items():
        if kind == "void":
            continue
        yield f"static_assert(sizeof(Output::{name}) == {calls_model.LENGTHS[name]} * sizeof({kind}));"


def table_source(manual):
    model = read(manual)
    lines = [NOTICE + '#include "calls/calls.h"\n', "namespace calls {\n", *checks_of_output(), ""]
    for entry in model.inputs.values():
        lines += maker(model, entry)
    lines += ["Inputs make_inputs() {", "    Inputs in{};"]
    lines += [f"    CHECK_OK(make_{entry.name}(in, &in.{entry.name}));" for entry in model.inputs.values() if entry.shared]
    lines += ["    return in;", "}\n", "std::vector<std::span<const Call>> allocating_groups() {"]
    lines.append(f"    return {{{', '.join(name + '_calls()' for name in model.groups if name != SCALAR)}}};")
    return "\n".join([*lines, "}\n", "} // namespace calls\n"])


def group_names():
    return [path.stem for path in sorted((TOP / calls_model.FOLDER).glob("*.toml")) if path.stem != calls_reader.INPUTS]


FILES = {f"{FOLDER}/table.h": table_header, f"{FOLDER}/table.cpp": table_source}
FILES |= {f"{FOLDER}/{name}_calls.cpp": group_file(name) for name in group_names()}
