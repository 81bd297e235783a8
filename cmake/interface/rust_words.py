# SPDX-License-Identifier: MIT
"""Rust words for types of single values, shapes and comments."""

import re

import layout
import rust

SCALARS = {"int32_t": "i32", "int64_t": "i64", "uint32_t": "u32", "double": "f64", "float": "f32", "nurbs_status": "i32"}
# Names of parameters that are no names in Rust.
INSTEAD = {"type": "kind"}
# A shape, also behind the name of an array: [n][dim], half[k].
SHAPE = re.compile(r"\w*(?:\[[^\[\],]+\])+")


def name(word):
    return INSTEAD.get(word, word)


def comment(sentence, indent=""):
    """Lines of documentation of a text of the table: names of nurbs.h and shapes are code."""
    parts = re.split(r"(`[^`]*`)", sentence)
    text = "".join(part if part.startswith("`") else coded(part) for part in parts)
    return layout.comment(f"{indent}/// ", text, rust.WIDTH)


def coded(text):
    text = re.sub(r"\bnurbs_\w+\(\)", lambda match: f"`{match[0][:-2]}`", text)
    text = re.sub(r"\bNURBS_[A-Z_0-9]+", r"`\g<0>`", text)
    return SHAPE.sub(r"`\g<0>`", text)


def zero(value):
    """The first value of an output."""
    return "0.0" if value.base in ("double", "float") else "0"


def element(value):
    return "u32" if value.unsigned else "bool" if value.truth else SCALARS[value.base]


def fixed(extents):
    """The extents, if all of them are numbers."""
    sizes = [extent.name for extent in extents if extent.op == "number"]
    return sizes if extents and len(sizes) == len(extents) else None


def nested(kind, sizes):
    """[[f64; 2]; 4] for [4, 2]; of a type or of a value."""
    for size in reversed(sizes):
        kind = f"[{kind}; {size}]"
    return kind


def row(value):
    """The size of the rows of an array that is a vector of small arrays, as [cap][axes][2]; or 0."""
    last = value.extents[-1]
    return last.name if not value.strides and len(value.extents) > 1 and last.op == "number" else 0


def owned(value):
    """Type of an array that comes back."""
    sizes = fixed(value.extents)
    if sizes and not value.strides:
        return nested(element(value), sizes)
    return f"Vec<{nested(element(value), [row(value)] if row(value) else [])}>"


def number(value, is_size):
    return "bool" if value.truth else "usize" if is_size else SCALARS[value.base]
