# SPDX-License-Identifier: MIT
"""Writes a header with every function of nurbs.h again, each with its arrays replaced.

usage: make_calls.py TOP_FOLDER MEANS OUTPUT

The header replaces the functions of nurbs.h by macros, so that a file that is compiled with it (-include) calls others in
their place. MEANS is a header of this folder's parent, such as guarded/pages.h, which says how: in a namespace with the
name of its folder it has the classes Function and Argument, of which there is one for each function and for each array,
Running, which lives as long as a call, and Array, which gives the function the place of an array with as many elements as
the shapes of the comments in nurbs.h ask for.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "cmake/interface"))

import header  # noqa: E402 - from the project

HEAD = f'''\
/* SPDX-License-Identifier: MIT */
/* Generated from {header.PATH} by tests/capi/guarded/make_calls.py - do not edit. */
#pragma once

#include "guarded/shape_terms.h"
'''
# Letters that the texts of functions explain, in the terms of C++; a function's own come first.
LETTERS = {
    "nurbs_create_power": {"pieces": "product(axes, piece_counts)", "W": "dim + ((flags & NURBS_HOMOGENEOUS) != 0)"},
    "nurbs_to_power": {"pieces": "pieces_of(g)", "W": "dim_of(g) + rational_of(g)"},
    "nurbs_rational_basis": {"M": "order_product(g)"},
    "nurbs_surface_eval_grid_frames": {"M": "product(2, counts)"},
    "nurbs_refinement_matrix": {"m": "count_of(g, axis) + count"},
    "nurbs_free_form_deform": {"m": "axes_of(volume)"},
    "nurbs_bezier_extraction": {"p": "degree_of(g, axis)"},
    "nurbs_create_bezier": {"N": "order_product(axes, degrees)"},
}


def is_handle(entry):
    return entry.base in ("nurbs", "nurbs_list") and entry.pointers == 1


class Shapes:
    """The sizes of the arrays of a function, as expressions of C++."""

    def __init__(self, function):
        self.function = function
        self.numbers = {entry.name for entry in function.parameters if not entry.pointers}
        self.arrays = {entry.name for entry in function.parameters if entry.shape}
        splines = [entry for entry in function.parameters if entry.base == "nurbs" and entry.is_const]
        self.spline = (splines[0].name + "[0]" * (splines[0].pointers - 1)) if splines else None

    def letter(self, name):
        own = LETTERS.get(self.function.name, {})
        if name in own:
            return own[name]
        if name.isdigit() or name in self.numbers:
            return name
        if name == "N" and "counts" in self.arrays:
            return "product(axes, counts)"
        known = {"N": "points_of", "dim": "dim_of", "axes": "axes_of", "rational": "rational_of"}
        if name in known and self.spline:
            return f"{known[name]}({self.spline})"
        if name == "S":
            return f"slots({self.letter('axes')}, order)"
        raise header.HeaderError(f"{self.function.name}: what is {name}?")

    def term(self, text):
        """What stands in one pair of brackets."""
        total = re.fullmatch(r"sum of (?:(\w+)|\((\w+)\[k\] \+ 1\))", text)
        if total and (total[1] or total[2]) == "piece_counts":
            return f"pieces_sum({self.spline}) + {self.letter('axes')}"
        if total:
            return f"sum({self.letter('axes') if self.function.name != GRID_FRAMES else 2}, {total[1]})"
        of = re.fullmatch(r"axes of (\w+)", text)
        if of:
            return f"axes_of({of[1]})"
        return re.sub(r"\b[A-Za-z]\w*", lambda match: self.letter(match[0]), text)

    def sizes(self, shape):
        """Of every index."""
        if shape.startswith("[counts[0]]...[counts[axes-1]]"):
            shape = shape.removeprefix("[counts[0]]...[counts[axes-1]]")
            yield f"product({self.letter('axes')}, counts)"
        elif shape.startswith("[pieces][p_0 + 1]..."):
            shape = shape.removeprefix("[pieces][p_0 + 1]...")
            orders = "axes, degrees" if "degrees" in self.arrays else "g"
            yield f"({self.letter('pieces')}) * order_product({orders})"
        for inside in re.findall(r"\[((?:[^\[\]]|\[\w\])*)\]", shape):
            yield self.term(inside)

    def extent(self, index):
        """The number of elements from the first to the last one of an array, strides included."""
        entry, *behind = self.function.parameters[index:index + 3]
        records, *components = [f"({size})" for size in self.sizes(entry.shape)]
        width = " * ".join(components) or "1"
        strides = [after.name for after, end in zip(behind, ("_stride", "_component_stride")) if after.name.endswith(end)]
        return f"extent({', '.join([records, width, *strides])})"


GRID_FRAMES = "nurbs_surface_eval_grid_frames"


def moved(entry):
    """Whether an argument is memory of the caller's, and not a handle."""
    return entry.pointers > 0 and not is_handle(entry)


def size_of(function, shapes, index):
    entry = function.parameters[index]
    if entry.c_type == "const char *":
        return "text(" + entry.name + ")"
    return shapes.extent(index) if entry.shape else "1"


def result_of(function, call):
    """The end of a replacement."""
    if function.result == "void":
        return f"    {call};"
    return f"    return here.{'status' if function.result == 'nurbs_status' else 'other'}({call});"


def wrapper(space, function, number, first):
    """The function's replacement; `first` is the number of its first array."""
    shapes = Shapes(function)
    parameters = ", ".join(f"{entry.c_type} {entry.name}" for entry in function.parameters)
    yield f"inline {function.result} {space}_{function.name}({parameters}) {{"
    yield f"    using namespace {space};"
    yield "    using namespace shape_terms;"
    yield f"    [[maybe_unused]] Running here(functions[{number}]);"
    names = []
    for index, entry in enumerate(function.parameters):
        if moved(entry):
            yield f"    const Array {entry.name}_(arrays[{first}], {entry.name}, {size_of(function, shapes, index)});"
            first += 1
        names.append(entry.name + "_.place()" * moved(entry))
    yield result_of(function, f"{function.name}({', '.join(names)})")
    yield "}"


def tables(space, functions):
    """The classes' objects."""
    yield f"namespace {space} {{"
    yield "inline Function functions[] = {"
    yield from (f'    {{"{function.name}"}},' for function in functions)
    yield "};"
    yield "inline Argument arrays[] = {"
    for function in functions:
        for entry in filter(moved, function.parameters):
            yield f'    {{"{function.name}", "{entry.name}", {"true" if "in" in entry.direction.split(",") else "false"}}},'
    yield "};"
    yield f"}} // namespace {space}"


def contents(manual, means):
    space = means.split("/")[0]
    yield HEAD + f'#include "{means}"\n'
    yield from tables(space, manual.functions)
    first = 0
    for number, function in enumerate(manual.functions):
        yield from wrapper(space, function, number, first)
        first += sum(moved(entry) for entry in function.parameters)
    yield from (f"#define {function.name} {space}_{function.name}" for function in manual.functions)


def main(arguments):
    top, means, output = arguments
    Path(output).write_text("\n".join(contents(header.read(top), means)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
