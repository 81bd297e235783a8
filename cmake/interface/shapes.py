# SPDX-License-Identifier: MIT
"""The shapes of the arrays of a function of nurbs.h, "[n][dim + 1]", without the table's methods.

    Shapes(function).terms(entry.shape)    one term of extents.py for each index
    Shapes(function).extent(index)         the number of elements from the first to the last one of a parameter, in C++

Letters that nurbs.h explains in words are those of the table of the bindings: where.M = "active()". The expressions of C++
call the functions of tests/capi/guarded/shape_terms.h.
"""

import functools
import tomllib
from pathlib import Path

import extents

TABLE = Path(__file__).resolve().parents[2] / "capi/bindings/table"
PROPERTIES = {"axes": "axes_of", "dim": "dim_of", "N": "points_of", "rational": "rational_of"}
OF_SPLINE = {"degree": "degree_of", "count": "count_of", "active": "order_product"}
OWNERS = ("nurbs", "nurbs_statistics", "nurbs_face", "nurbs_data")  # what knows a number of axes and a dimension
STRIDES = ("_stride", "_component_stride")


@functools.cache
def definitions():
    """{function: what letters in its shapes are}"""
    files = [tomllib.loads(path.read_text(encoding="utf-8")) for path in TABLE.glob("*.toml")]
    return {name: entry["where"] for file in files for name, entry in file.items() if "where" in entry}


class Shapes:
    def __init__(self, function):
        self.parameters = function.parameters
        numbers = {entry.name for entry in self.parameters if not entry.pointers}
        self.arrays = {entry.name: entry for entry in self.parameters if entry.shape}
        self.splines = {entry.name: entry for entry in self.parameters if entry.base in OWNERS and entry.is_const}
        where = definitions().get(function.name.removesuffix("_with"), {})
        self.reader = extents.Reader(numbers, self.arrays, list(self.splines), where)

    def terms(self, shape):
        return self.reader.shape(shape)

    def parts(self, shape):
        """The indices of records and those within one; dots stand between indices of records."""
        terms = self.terms(shape)
        records = 1 + shape.startswith("[pieces][p_0 + 1]...")
        return terms[:records], terms[records:]

    def strides(self, index):
        """The parameters behind an array that say how it is stored."""
        behind = self.parameters[index + 1:index + 3]
        return [after.name for after, end in zip(behind, STRIDES) if after.name.endswith(end)]

    # In C++.

    def extent(self, index):
        records, width = map(self.product, self.parts(self.parameters[index].shape))
        return f"extent({', '.join([records, width, *self.strides(index)])})"

    def product(self, terms):
        return " * ".join(f"({self.text(term)})" for term in terms) or "1"

    def text(self, term):
        if term.op in ("number", "parameter"):
            return str(term.name)
        if term.op == "property":
            return f"{PROPERTIES[term.name]}({self.spline(term.of)})"
        if term.op == "call":
            return self.called(term)
        left, right = (f"({self.text(side)})" if side.op in extents.OPERATORS.values() else self.text(side)
                       for side in term.arguments)
        return f"{left} {term.op} {right}"

    def spline(self, name):
        """Of an array of splines the first one."""
        return name + "[0]" * (self.splines[name].pointers - 1)

    def called(self, term):
        if term.name in ("sum", "product"):
            return self.of_array(term.name, term.arguments[0])
        words = [self.text(argument) for argument in term.arguments]
        if term.name == "slots":
            return f"slots(axes_of({self.spline(term.of)}), {words[0]})"
        if term.name == "monomials":
            return f"monomials({', '.join(words)})"
        if term.name == "homogeneous":
            return f"(({words[0]} & NURBS_HOMOGENEOUS) != 0)"
        if term.name in OF_SPLINE:
            return f"{OF_SPLINE[term.name]}({', '.join([self.spline(term.of), *words])})"
        raise extents.ExtentError(f"shape_terms.h has no function {term.name}")

    def of_array(self, name, argument):
        """Numbers of pieces that only the call tells are those of the spline; degrees + 1 are orders."""
        if argument.op == "+":
            name, argument = "order_product", argument.arguments[0]
        array = self.arrays[argument.name]
        if array.direction == "out":
            return f"pieces_{'of' if name == 'product' else name}({self.spline(next(iter(self.splines)))})"
        length, = self.terms(array.shape)
        return f"{name}({self.text(length)}, {array.name})"
