# SPDX-License-Identifier: MIT
"""C++ words for types, constants and comments."""

import re

import layout

WIDTH = 110
SCALARS = {"int32_t": "std::int32_t", "int64_t": "std::int64_t", "uint32_t": "std::uint32_t", "double": "double",
           "float": "float", "nurbs_status": "Status"}
RECORDS = {"double": ("Input", "Output"), "float": ("", "FloatOutput")}
#: Constants whose names would say too little, or clash.
NAMES = {"NURBS_HOMOGENEOUS": "homogeneous_records", "NURBS_START": "start_of_axis", "NURBS_END": "end_of_axis"}
VALUES = {"infinity": "std::numeric_limits<double>::infinity()", "-infinity": "-std::numeric_limits<double>::infinity()"}


def constant(name):
    """NURBS_ARC_THIRDS: arc_thirds. Also of a prefix, NURBS_ARC_."""
    return NAMES.get(name, name.removeprefix("NURBS_").lower())


def text(sentence):
    """A comment of the table, with the names of this language."""
    sentence = re.sub(r"\bNURBS_ERROR_(\w+)", lambda match: f"Status::{match[1].lower()}", sentence)
    return re.sub(r"\bNURBS_[A-Z_0-9]+", lambda match: constant(match[0]), sentence)


def comment(sentence, indent=""):
    return layout.comment(f"{indent}/// ", text(sentence), WIDTH)


def default(value):
    """Of an argument or a field. Sums of constants stay as they are in C, where they are of one type."""
    value = str(value)
    if re.fullmatch(r"NURBS_\w+", value):
        return constant(value)
    return VALUES.get(value, value)


def scalar(value):
    """Type of a number that comes back, or goes in."""
    return "bool" if value.truth else SCALARS[value.base]


def element(value):
    return "std::uint32_t" if value.unsigned else SCALARS[value.base]


def struct_type(value, binding):
    """The record that holds a struct of nurbs.h."""
    return next(record.key for record in binding.all_records.values() if record.struct == value.base)


def fixed(extents):
    """The extents, if all of them are numbers."""
    sizes = [extent.name for extent in extents if extent.op == "number"]
    return sizes if extents and len(sizes) == len(extents) else None


def array_of(kind, sizes):
    """std::array<std::array<double, 2>, 4> for [4, 2]."""
    for size in reversed(sizes):
        kind = f"std::array<{kind}, {size}>"
    return kind


def owned(value):
    """Type of an array that comes back, or of a field."""
    sizes = fixed(value.extents)
    return array_of(element(value), sizes) if sizes and not value.strides else f"std::vector<{element(value)}>"
