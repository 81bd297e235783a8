# SPDX-License-Identifier: MIT
"""The terms of shapes.py for Python: lengths of arrays, from the arguments of a call and from what is known of its inputs.

They are those of tests/capi/guarded/shape_terms.h, which asks the library instead.
"""

import math
from itertools import accumulate

from calls_model import CallsError, Numbers


TELLING = ("nurbs_create", "nurbs_create_homogeneous", "nurbs_create_bezier")


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


def extent(records, width, stride=0, component_stride=0):
    step = component_stride or 1
    record = stride or width * step
    return (records - 1) * record + (width - 1) * step + 1 if records > 0 and width > 0 else 0


def order_product(first, degrees=None):
    return math.prod(degree + 1 for degree in (first.degrees if degrees is None else degrees))


TERMS = {
    "extent": extent,
    "order_product": order_product,
    "axes_of": lambda g: len(g.degrees),
    "dim_of": lambda g: g.dim,
    "points_of": lambda g: math.prod(g.counts),
    "rational_of": lambda g: g.rational,
    "degree_of": lambda g, axis: g.degrees[axis],
    "count_of": lambda g, axis: g.counts[axis],
    "pieces_of": lambda g: math.prod(g.spans(axis) for axis in range(len(g.degrees))),
    "pieces_sum": lambda g: sum(g.spans(axis) for axis in range(len(g.degrees))),
    "product": lambda axes, counts: math.prod(counts[:axes]),
    "sum": lambda axes, counts: sum(counts[:axes]),
    "slots": lambda axes, order: math.comb(order + axes, axes),
}
