# SPDX-License-Identifier: MIT
"""Shapes of arrays, "[n][dim + 1]", as products of terms that a backend can write in its language.

A name in a shape is, in this order: a parameter of the function that is a number, a definition of the entry (where.S =
"slots(order)"), or a property of the spline: axes, dim, N (the number of control points), rational.

What functions a term may call is in FUNCTIONS; the core of each language has them.
"""

import ast
import re
from dataclasses import dataclass

PROPERTIES = ("axes", "dim", "N", "rational")
FUNCTIONS = {
    "sum": "of the elements of an array",
    "product": "of the elements of an array, or of an array + 1",
    "size": "the number of elements of an array",
    "axes": "of another spline",
    "degree": "of the spline along an axis",
    "count": "of control points of the spline along an axis",
    "slots": "the number of derivatives of the spline up to an order",
    "active": "the number of basis functions of the spline that are not 0 at a parameter",
    "positive": "a number, or 0 if it is negative",
    "homogeneous": "1 if the flags have NURBS_HOMOGENEOUS, otherwise 0",
    "knot_count": "knots of a degree and a number of control points; 0 where the library refuses them",
    "bezier_count": "control points of a degree and a number of pieces",
    "periodic_count": "control points of a degree, breaks of a period and multiplicities",
    "basis_width": "(order + 1) (degree + 1); 0 where the library refuses them",
    "matrix_size": "(degree + 1)^2; 0 where the library refuses the degree",
    "monomials": "coefficients of a polynomial of a degree in so many variables; 0 where the library refuses the degree",
}
OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*"}


class ExtentError(Exception):
    """A shape cannot be understood."""


@dataclass(frozen=True)
class Term:
    """op is "number", "parameter" or "property" (of the spline in `of`), with its value in `name`; "call" of the function
    `name`; or an operator."""

    op: str
    name: object = None
    of: str = ""
    arguments: tuple = ()

    def names(self):
        """All parameters in it."""
        own = {self.name} if self.op == "parameter" else {self.of} if self.of else set()
        return own.union(*(argument.names() for argument in self.arguments))


def brackets(shape, orders="active()"):
    """The texts in the outermost brackets; those of all axes, [counts[0]]...[counts[axes-1]] or [p_0 + 1]..., become one
    product, and of k only the sum stays: sum of (pieces[k] + 1)."""
    shape = re.sub(r"\[(\w+)\[0\]\]\.\.\.\[\1\[axes-1\]\]", r"[product(\1)]", shape)
    shape = shape.replace("[p_0 + 1]...", f"[{orders}]")
    shape = re.sub(r"sum of \((\w+)\[k\] \+ 1\)", r"sum of \1 + axes", shape)
    if not re.fullmatch(r"(\[[^\[\]]*\])*", shape):
        raise ExtentError(f"the shape {shape} needs one that is written out: shape.NAME = \"[n][dim]\"")
    return re.findall(r"\[([^\[\]]*)\]", shape)


def plain(text):
    """sum of counts: sum(counts)."""
    return re.sub(r"\b(\w+) of (\w+)", r"\1(\2)", text)


class Reader:
    """numbers: the parameters that are numbers; arrays: those that are arrays; spline: the first one, or ""."""

    def __init__(self, numbers, arrays, splines, definitions):
        self.numbers, self.arrays, self.splines = numbers, arrays, splines
        self.definitions = definitions

    def shape(self, text):
        orders = "product(degrees + 1)" if "degrees" in self.arrays else "active()"
        return tuple(self.term(extent) for extent in brackets(text, orders))

    def term(self, text):
        try:
            return self.convert(ast.parse(plain(text), mode="eval").body)
        except SyntaxError as error:
            raise ExtentError(f"cannot read {text!r}") from error

    def convert(self, node):
        if isinstance(node, ast.Constant) and isinstance(node.value, int):
            return Term("number", node.value)
        if isinstance(node, ast.Name):
            return self.named(node.id)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            return Term(OPERATORS[type(node.op)], arguments=(self.convert(node.left), self.convert(node.right)))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            return self.called(node.func.id, node.args)
        raise ExtentError(f"cannot read {ast.unparse(node)!r}")

    def named(self, name):
        if name in self.numbers or name in self.arrays:
            return Term("parameter", name)
        if name in self.definitions:
            return self.term(self.definitions[name])
        if name in PROPERTIES and self.splines:
            return Term("property", name, self.splines[0])
        raise ExtentError(f"what is {name!r}? It is no number among the parameters; define it: where.{name} = ...")

    def called(self, name, arguments):
        if name not in FUNCTIONS:
            raise ExtentError(f"there is no function {name!r}; there are {', '.join(FUNCTIONS)}")
        if name in PROPERTIES:
            return Term("property", name, arguments[0].id)
        own = self.splines[0] if name in ("degree", "count", "slots", "active") and self.splines else ""
        return Term("call", name, own, tuple(self.convert(argument) for argument in arguments))
