# SPDX-License-Identifier: MIT
"""Terms of extents.py as numbers, for the arguments of a good call."""

import math

from calls_model import Handle, Number, Numbers, inputs_of
from calls_terms import Facts

OPERATORS = {"+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b}
FUNCTIONS = {
    "sum": sum,
    "product": lambda values: math.prod(values) if isinstance(values, list) else values,
    "size": len,
    "positive": lambda number: max(number, 0),
    "homogeneous": lambda flags: flags >> 30 & 1,  # NURBS_HOMOGENEOUS
    "basis_width": lambda order, degree: (order + 1) * (degree + 1),
    "matrix_size": lambda degree: (degree + 1) ** 2,
    "knot_count": lambda degree, count: degree + 1 + count,
    "bezier_count": lambda degree, pieces: degree * pieces + 1,
}
OF_SPLINE = {
    "degree": lambda facts, axis: facts.degrees[axis],
    "count": lambda facts, axis: facts.counts[axis],
    "slots": lambda facts, order: math.comb(order + len(facts.degrees), len(facts.degrees)),
    "active": lambda facts: math.prod(degree + 1 for degree in facts.degrees),
}
PROPERTIES = {"axes": lambda facts: len(facts.degrees), "dim": lambda facts: facts.dim,
              "N": lambda facts: math.prod(facts.counts), "rational": lambda facts: facts.rational}


class Sizes:
    """Of one step of smoke.py."""

    def __init__(self, step, model):
        self.step, self.model = step, model

    def of(self, value):
        """The extents of a parameter."""
        return [self.number(extent) for extent in value.extents]

    def facts(self, name):
        given = self.step.given(name)
        if isinstance(given, Handle):
            return Facts(given.name, self.model.inputs[given.name].call)
        first = next(iter(inputs_of(given)))
        return Facts(first, self.model.inputs[first].call)

    def number(self, term):
        if term.op == "number":
            return term.name
        if term.op == "parameter":
            given = self.step.given(term.name)
            return [item.value for item in given.values] if isinstance(given, Numbers) else self.plain(given)
        if term.op == "property":
            return PROPERTIES[term.name](self.facts(term.of))
        arguments = [self.number(argument) for argument in term.arguments]
        if term.op == "call":
            own = [self.facts(term.of)] if term.of else []
            return (OF_SPLINE if own else FUNCTIONS)[term.name](*own, *arguments)
        if isinstance(arguments[0], list):
            return [OPERATORS[term.op](item, arguments[1]) for item in arguments[0]]
        return OPERATORS[term.op](*arguments)

    @staticmethod
    def plain(given):
        return given.value if isinstance(given, Number) else 0
