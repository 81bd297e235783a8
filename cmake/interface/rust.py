# SPDX-License-Identifier: MIT
"""Rust: the module sys, in the form that rustfmt gives it."""

import re

import header
import layout

WIDTH = 110
TYPES = {"int32_t": "i32", "int64_t": "i64", "uint32_t": "u32", "double": "f64", "float": "f32", "char": "c_char",
         "void": "c_void"}
KEYWORDS = {"type", "in", "ref", "box", "move", "match", "final", "use", "where", "loop"}
# The header's ints that are passed as uint32_t.
UNSIGNED = ("NURBS_FEATURE_", "NURBS_EXTREMUM_")

HEAD = f"""\
// SPDX-License-Identifier: MIT
// {header.NOTICE}
//! The C interface as it stands: the names, arguments and constants of `nurbs.h`, which is the manual.

#![allow(non_camel_case_types)]

use std::os::raw::{{c_char, c_void}};
"""


def documentation(text, indent=""):
    """Markdown in which brackets, stars and less-than signs stand for themselves."""
    parts = re.split(r"(`[^`]*`)", text)
    escaped = [part if part.startswith("`") else re.sub(r"([\[\]<>*])", r"\\\1", part) for part in parts]
    return layout.comment(f"{indent}/// ", "".join(escaped), WIDTH)


def rust_type(c_type):
    base = re.sub(r"\bconst\b|\*", "", c_type).strip()
    one = "*const " if c_type.startswith("const ") else "*mut "
    return one * c_type.count("*") + TYPES.get(base, base)


def rust_name(name):
    return f"r#{name}" if name in KEYWORDS else name


# Types and constants.


def opaque(name, text):
    yield from documentation(text + " Never made or moved on this side.")
    yield from ("#[repr(C)]", f"pub struct {name} {{", "    _private: [u8; 0],", "}", "")


def alias(name, kind, text):
    yield from documentation(text)
    yield f"pub type {name} = {rust_type(kind)};"
    yield ""


def callback(entry):
    parameters = ", ".join(f"{told.name}: {rust_type(told.c_type)}" for told in entry.parameters)
    yield from documentation(entry.text)
    line = f"pub type {entry.name} = Option<unsafe extern \"C\" fn({parameters}) -> {rust_type(entry.result)}>;"
    yield from (line, "")


def structure(struct):
    yield from documentation(struct.text)
    yield from ("#[repr(C)]", "#[derive(Clone, Copy, Debug)]", f"pub struct {struct.name} {{")
    for entry in struct.fields:
        yield from documentation(entry.described, "    ")
        yield f"    pub {entry.name}: {rust_type(entry.c_type)},"
    yield from ("}", "")


def constant_type(group, constant):
    if group.is_status:
        return "nurbs_status"
    return "u32" if constant.literal.endswith("u") or constant.name.startswith(UNSIGNED) else "i32"


def constant_group(group):
    yield from layout.comment("// --- ", group.title, WIDTH)
    for constant in group.constants:
        value = constant.literal.strip("()").rstrip("u")
        yield from documentation(constant.text)
        yield f"pub const {constant.name}: {constant_type(group, constant)} = {value};"
    yield ""


# Functions.


def signature(function):
    arguments = [f"{rust_name(entry.name)}: {rust_type(entry.c_type)}" for entry in function.parameters]
    result = "" if function.result == "void" else f" -> {rust_type(function.result)}"
    line = f"    pub fn {function.name}({', '.join(arguments)}){result};"
    if len(line) < WIDTH:
        return [line]
    if len(line) == WIDTH:  # rustfmt forgets the semicolon before it breaks the line
        return [line.removesuffix(f"{result};"), f"       {result};"]
    return [f"    pub fn {function.name}(", *(f"        {argument}," for argument in arguments), f"    ){result};"]


def declaration(function):
    yield from documentation(function.brief, "    ")
    nullable = [f"`{entry.name}`" for entry in function.parameters if entry.nullable]
    if nullable:
        yield "    ///"
        yield from documentation("May be null: " + ", ".join(nullable) + ".", "    ")
    yield from signature(function)


def module(manual):
    lines = [HEAD]
    for name, text in manual.handles.items():
        lines += opaque(name, text)
    for name, (kind, text) in manual.aliases.items():
        lines += alias(name, kind, text)
    for entry in manual.callbacks.values():
        lines += callback(entry)
    for struct in manual.structs:
        lines += structure(struct)
    for group in manual.groups:
        lines += constant_group(group)
    lines += ['#[link(name = "nurbs")]', 'extern "C" {']
    for chapter in manual.modules:
        lines.append(f"    // --- {chapter.title}")
        lines += [line for function in chapter.functions for line in declaration(function)]
    return "\n".join(lines) + "\n}\n"


FILES = {"capi/bindings/rust/src/sys.rs": module}
