# SPDX-License-Identifier: MIT
"""The headers: which groups go where, what they include, and the classes."""

import re

import header
import model

from . import methods, records, words

FOLDER = "include/nurbs/cpp"
SOURCES = "capi/bindings/table"
NOTICE = f"Generated from {header.PATH} and {SOURCES} by: {header.COMMAND} - do not edit."
BRIEFS = {"spline": "The class of curves, surfaces and volumes."}
#: Classes: the core that they start from, and what they are.
CLASSES = {
    "Spline": ("SplineHandle",
               "A curve, surface or volume: a handle that is copied in constant time and freed by its destructor."),
    "List": ("ListHandle", "Splines in an order: the parts of one, or what a file held. It cannot be copied."),
    "Statistics": ("StatisticsHandle",
                   "What fits need to know of data: a handle that is copied in constant time and freed by its destructor."),
    "Face": ("FaceHandle", "A trimmed face: a handle that is copied in constant time and freed by its destructor."),
    "Model": ("ModelHandle",
              "Faces and the edges that they share: a handle that is copied in constant time and freed by its destructor."),
    "Meet": ("MeetHandle",
             "Curves where shapes meet: a handle that is copied in constant time and freed by its destructor."),
    "Mesh": ("MeshHandle",
             "Triangles in place of shapes: a handle that is copied in constant time and freed by its destructor."),
}
STANDARD = {"algorithm": r"std::copy_n", "array": r"std::array", "cstddef": r"std::byte|std::size_t",
            "cstdint": r"std::u?int", "limits": r"std::numeric_limits", "optional": r"std::optional",
            "span": r"std::span", "string": r"std::string|std::to_string", "utility": r"std::pair|std::move",
            "vector": r"std::vector"}
OURS = {"list": r"\bList\b|\bReadOptions\b|\bWriteOptions\b", "face": r"\bFace\b", "model": r"\bconst Model &", "data": r"\bconst Data &", "placement": r"\bPlacement\b|\barc_\w+|\bfull_turn\b"}


def files(binding):
    """{path: text}"""
    homes = {record.name("cpp"): group.file("cpp") for group in binding.groups for record in group.records("cpp")}
    homes.update({record.outputs("cpp"): home for group in binding.groups for record in group.records("cpp")
                  for home in [group.file("cpp")] if record.outputs("cpp")})
    names = dict.fromkeys(group.file("cpp") for group in binding.groups if methods_of(group))
    return {f"{FOLDER}/{name}.hpp": text(name, [group for group in binding.groups if group.file("cpp") == name],
                                         binding, homes) for name in names}


def methods_of(group):
    return [method for entry in group.entries for method in entry.methods.get("cpp", ())]


def text(name, groups, binding, homes):
    body = "\n".join(content(groups, binding))
    guard = f"NURBS_CPP_{name.upper()}_HPP"
    brief = BRIEFS.get(name, groups[0].doc)
    return "\n".join([
        "/* SPDX-License-Identifier: MIT */", f"/* {NOTICE} */",
        f"/// \\file {name}.hpp", f"/// \\brief {words.text(brief)}",
        f"#ifndef {guard}", f"#define {guard}", "", *includes(name, body, homes), "",
        "namespace libnurbs {", "inline namespace NURBS_CPP_POLICY {", "", body, "",
        "} // namespace NURBS_CPP_POLICY", "} // namespace libnurbs", "", f"#endif // {guard}", ""])


def includes(name, body, homes):
    own = {"handles", "sizes"} if name == "spline" else {"spline"}
    own |= {file for file, pattern in OURS.items() if re.search(pattern, body)}
    own |= {home for record, home in homes.items() if re.search(rf"\b{record}\b", body)}
    yield from (f"#include <nurbs/cpp/{file}.hpp>" for file in sorted(own - {name}))
    yield ""
    yield from (f"#include <{file}>" for file, pattern in STANDARD.items() if re.search(pattern, body))


def content(groups, binding):
    """Constants, records and free functions in the order of the table, then the classes."""
    blocks = []
    for group in groups:
        blocks += [records.constants(prefix, about, binding) for prefix, about in group.constants.items()]
        blocks += group_blocks(group, binding)
    for name in CLASSES:
        members = [(group, [method for method in methods_of(group) if class_of(method) == name]) for group in groups]
        if any(found for _, found in members):
            blocks.append(class_lines(name, members, binding))
    for place, block in enumerate(blocks):
        if place:
            yield ""
        yield from block


def group_blocks(group, binding):
    """A record stands before the first function that uses it."""
    waiting = list(group.records("cpp"))
    yield from (records.lines(record, binding) for record in waiting if not record.uses)
    for method in methods_of(group):
        used = [record for record in waiting if uses(record, method)]
        yield from (records.lines(record, binding) for record in used)
        waiting = [record for record in waiting if record not in used]
        if class_of(method) is None:
            yield with_section(method, methods.lines(method, binding))


def uses(record, method):
    return any(method is user for user, _, _ in record.uses.get("cpp", ()))


def with_section(method, lines):
    if method.entry.section and method is method.entry.methods["cpp"][0]:
        yield f"// {method.entry.section}"
        yield ""
    yield from lines


def class_of(method):
    if method.receiver in CLASSES:
        return method.receiver
    value = method.values.get(method.receiver)
    return model.HANDLES.get(value.kind) if value else None


def class_lines(name, members, binding):
    core, about = CLASSES[name]
    yield from words.comment(about)
    yield f"class {name} : public detail::{core} {{"
    yield "public:"
    yield f"using {core}::{core};"
    for group, found in members:
        if found:
            yield ""
            yield f"// {group.doc.rstrip('.')}"
            yield ""
        for method in found:
            yield from methods.lines(method, binding)
    yield "};"
