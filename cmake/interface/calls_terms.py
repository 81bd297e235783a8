# SPDX-License-Identifier: MIT
"""Terms of extents.py as numbers: lengths of arrays, from the arguments of a good call and from what is known of its inputs.

tests/capi/guarded/shape_terms.h asks the library instead.
"""

import math
import operator
from itertools import accumulate

from calls_model import CallsError, Number, Numbers, Packed, inputs_of


TELLING = ("nurbs_create", "nurbs_create_homogeneous", "nurbs_create_bezier", "nurbs_statistics_create")
# What others are made of, which knows the same.
BEHIND = {"nurbs_statistics_add": "statistics", "nurbs_face_create": "surface"}


class Facts:
    """What the arguments tell of a spline, if one of the functions above makes it."""

    def __init__(self, name, call):
        self.name = name
        self.maker = call.function.name
        self.given = {entry.name: value for entry, value in call.arguments}

    def argument(self, parameter):
        if self.maker not in TELLING:
            raise CallsError(f"a length depends on {self.name}, which only the library knows: make that by nurbs_create")
        return self.given.get(parameter)

    def numbers(self, parameter):
        """An array, or nothing."""
        value = self.argument(parameter)
        return [number.value for number in value.values] if isinstance(value, Numbers) else []

    @property
    def dim(self):
        return self.argument("dim").value

    @property
    def rational(self):
        return int("weights" not in self.given or self.numbers("weights") != [])

    @property
    def degrees(self):
        return self.numbers("degrees")

    @property
    def counts(self):
        """A Bezier spline has no others."""
        return self.numbers("counts") or [degree + 1 for degree in self.degrees]

    def spans(self, axis):
        """Of a length above 0, in the domain."""
        knots = self.numbers("knots")
        if not knots:
            return 1
        lengths = [count + degree + 1 for count, degree in zip(self.counts, self.degrees)]
        first = [0, *accumulate(lengths)][axis]
        return len(set(knots[first + self.degrees[axis]:first + self.counts[axis] + 1])) - 1


class Members:
    """What the fields of a struct tell."""

    def __init__(self, fields):
        self.fields = fields

    @property
    def dim(self):
        return self.fields["dim"].value

    @property
    def degrees(self):
        return [0] * self.fields["axes"].value


def extent(records, width, stride=0, component_stride=0):
    """From the first element to the last, strides included."""
    step = component_stride or 1
    record = stride or width * step
    return (records - 1) * record + (width - 1) * step + 1 if records > 0 and width > 0 else 0


OPERATORS = {"+": operator.add, "-": operator.sub, "*": operator.mul}
FUNCTIONS = {
    "sum": sum,
    "product": lambda values: math.prod(values) if isinstance(values, list) else values,
    "size": len,
    "positive": lambda number: max(number, 0),
    "homogeneous": lambda flags: flags >> 30 & 1,  # NURBS_HOMOGENEOUS
    "basis_width": lambda order, degree: (order + 1) * (degree + 1),
    "matrix_size": lambda degree: (degree + 1) ** 2,
    "monomials": lambda dim, degree: math.comb(dim + degree, degree) if 1 <= degree <= 8 else 0,
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
    """Of one call. given(name): the value of a parameter; inputs: those of the model."""

    def __init__(self, given, inputs):
        self.given, self.inputs = given, inputs

    def of(self, extents):
        return [self.number(extent) for extent in extents]

    def product(self, extents):
        return math.prod(self.of(extents))

    def facts(self, name):
        """Of several splines those of the first one; of statistics with data those of what they were added to; of a face
        those of its surface."""
        given = self.given(name)
        if isinstance(given, Packed):
            return Members({entry.name: value for entry, value in given.fields})
        first = next(iter(inputs_of(given)))
        while behind := BEHIND.get(self.inputs[first].call.function.name):
            first = self.inputs[first].call.value(behind).name
        return Facts(first, self.inputs[first].call)

    def number(self, term):
        if term.op == "number":
            return term.name
        if term.op == "parameter":
            return self.plain(self.given(term.name))
        if term.op == "property":
            return PROPERTIES[term.name](self.facts(term.of))
        arguments = self.of(term.arguments)
        if term.op == "call":
            own = [self.facts(term.of)] if term.of else []
            return (OF_SPLINE if own else FUNCTIONS)[term.name](*own, *arguments)
        if isinstance(arguments[0], list):
            return [OPERATORS[term.op](item, arguments[1]) for item in arguments[0]]
        return OPERATORS[term.op](*arguments)

    @staticmethod
    def plain(given):
        if isinstance(given, Numbers):
            return [item.value for item in given.values]
        return given.value if isinstance(given, Number) else 0
