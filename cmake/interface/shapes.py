# SPDX-License-Identifier: MIT
"""The shapes of arrays, "[n][dim + 1]", as expressions of the arguments of a call.

    Shapes(function).sizes(entry.shape)    one expression for each index
    Shapes(function).extent(index)         the number of elements from the first to the last one of a parameter

The expressions are valid in C++ and in Python alike: numbers, parameters by their names, +, -, *, and the functions of
tests/capi/guarded/shape_terms.h, which calls_model.py has for Python.
"""

import re

import header

GRID_FRAMES = "nurbs_surface_eval_grid_frames"
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


class Shapes:
    """The sizes of the arrays of a function, as expressions of C++."""

    def __init__(self, function):
        self.function = function
        self.numbers = {entry.name for entry in function.parameters if not entry.pointers}
        self.arrays = {entry.name for entry in function.parameters if entry.shape}
        splines = [entry for entry in function.parameters if entry.base == "nurbs" and entry.is_const]
        self.spline = (splines[0].name + "[0]" * (splines[0].pointers - 1)) if splines else None

    def letter(self, name):
        own = LETTERS.get(self.function.name.removesuffix("_with"), {})
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
