# SPDX-License-Identifier: MIT
"""Rust: the modules above the small core that is written by hand, of the header and the table."""

import re

import header
import model
import rust_records as records
import rust_words as words
from rust_body import Body
from rust_types import Signature, output_record

FOLDER = "capi/bindings/rust/src"
NOTICE = f"Generated from {header.PATH} and capi/bindings/table by: {header.COMMAND} - do not edit."
# Names that a module uses: where they come from.
CRATE = {
    "arrays": ["bits", "by_axis", "counts_of", "exactly", "exactly_mut", "flat", "if_given", "knots_by_axis", "layout", "optional",
               "pairs_by_axis", "pointer_mut", "rows", "truths", "Records", "RecordsMut"],
    "call": ["Call"],
    "data": ["cloud_options_pointer", "fit_options_pointer", "CloudOptions", "CloudReport", "Data", "FitOptions", "FitReport"],
    "error": ["check", "value", "Result"],
    "list": ["options_pointer", "path_text", "write_options_pointer", "written", "List", "ReadOptions", "Texts",
             "WriteOptions"],
    "moments": ["moments_of"],
    "placement": ["dimension_of", "pointer", "require_length", "Placement", "Turn"],
    "sizes": ["axes_of", "basis_width", "bezier_count", "bezier_points", "homogeneous", "knot_count", "matrix_size", "monomials",
              "periodic_count", "positive", "product", "sum", "times"],
    "spline": ["handles", "some_handles", "Spline"],
    "statistics": ["statistics_handles", "Statistics"],
    "face": ["face_handles", "Face"],
    "model": ["Model"],
    "meet": ["Meet"],
    "mesh": ["mesh_options_pointer", "Mesh", "MeshOptions"],
}
STANDARD = {"std::path": ["Path"], "std::ptr": ["null", "null_mut"]}


def files(binding):
    """{path: text}"""
    homes = {name: group.file("rust") for group in binding.groups for record in group.records("rust")
             for name in (record.name("rust"), record.outputs("rust")) if name}
    return {f"{FOLDER}/{group.file('rust')}.rs": module(group, binding, homes) for group in binding.groups
            if methods_of(group)}


def methods_of(group):
    return [method for entry in group.entries for method in entry.methods.get("rust", ())]


def module(group, binding, homes):
    body = "\n".join(content(group, binding))
    return "\n".join(["// SPDX-License-Identifier: MIT", f"// {NOTICE}", *documentation(group), "",
                      *uses(group.file("rust"), body, homes), "", body, ""])


def documentation(group):
    return [line.replace("///", "//!", 1) for line in words.comment(group.doc)]


def uses(own, body, homes):
    code = re.sub(r"//.*", "", body)
    names = {f"crate::{home}": list(found) for home, found in CRATE.items()}
    by_hand = {name for found in CRATE.values() for name in found}
    for name, home in homes.items():
        if name not in by_hand:
            names.setdefault(f"crate::{home}", []).append(name)
    names.pop(f"crate::{own}", None)
    for home in sorted(names):
        yield from use(home, names[home], code)
    yield "use crate::sys;"
    for home, found in STANDARD.items():
        yield from use(home, found, code)


def use(home, names, code):
    """Functions stand before types."""
    found = sorted((name for name in names if is_used(name, code)), key=lambda name: (name[0].isupper(), name))
    if found:
        yield f"use {home}::{found[0]};" if len(found) == 1 else f"use {home}::{{{', '.join(found)}}};"


def is_used(name, code):
    return re.search(rf"(?<![\w.:])(?<!fn ){name}\(" if name[0].islower() else rf"\b{name}\b", code)


# What is in a module.


def content(group, binding):
    """Records, free functions, and the methods of each type, in the order of the table."""
    blocks = [list(records.lines(record, binding)) for record in group.records("rust") if record.uses.get("rust")]
    found = methods_of(group)
    blocks += [lines for method in found if class_of(method) == "" for lines in forms(method, binding)]
    for name in model.HANDLES.values():
        blocks += [list(block(name, about, members, binding)) for about, members in sections(group, name)]
    for place, lines in enumerate(blocks):
        if place:
            yield ""
        yield from lines


def class_of(method):
    value = method.values.get(method.receiver)
    return model.HANDLES[value.kind] if value else method.receiver


def sections(group, name):
    """(heading, methods) of a type: each section of the table is a block."""
    found = []
    for method in methods_of(group):
        about = method.entry.section
        if class_of(method) == name and (about or not found):
            found.append((f"{about}." if about else group.doc, []))
        if class_of(method) == name:
            found[-1][1].append(method)
    return found


def block(name, about, members, binding):
    yield from words.comment(about)
    yield f"impl {name} {{"
    for place, lines in enumerate(lines for method in members for lines in forms(method, binding, "    ")):
        if place:
            yield ""
        yield from lines
    yield "}"


def forms(method, binding, indent=""):
    """All functions of a method: the one that returns, the one that fills, and those that can be stopped."""
    for watched in (False, True) if method.entry.watched else (False,):
        end = "_with" if watched else ""
        about = WATCHED.format(method.name) if watched else method.entry.doc("rust", method)
        yield [*words.comment(about, indent),
               Signature(method, binding).text(end, watched=watched), *Body(method, binding, watched).returning(), "}"]
        if method.entry.fills("rust"):
            arrays = "arrays" if output_record(method, binding) else "an array"
            yield [*words.comment(f"The same, written to {arrays} of the caller.", indent),
                   Signature(method, binding).text(f"_into{end}", fills=True, watched=watched),
                   *Body(method, binding, watched).filling(), "}"]


WATCHED = "The same as `{}`; it can be watched and stopped."
