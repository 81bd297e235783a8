# SPDX-License-Identifier: MIT
"""Dummy arguments: what is declared for the arguments of a method."""

from dataclasses import dataclass

from methods import KINDS
from model import HANDLES
from signature import Each, Several, Struct, Take


@dataclass
class Dummy:
    """An argument; value is the parameter behind it, if it is one alone."""

    name: str
    argument: object
    value: object
    kind: str  # that of the value, "several", "record" or "records"

    @property
    def optional(self):
        return self.argument.optional

    @property
    def allocated(self):
        return self.argument.allocated

    @property
    def is_array(self):
        return self.kind == "array"


def dummies(method):
    return [dummy(method, argument) for argument in method.arguments]


def dummy(method, argument):
    pattern = argument.pattern
    if isinstance(pattern, Take):
        return Dummy(argument.name, argument, method.values[pattern.name], method.values[pattern.name].kind)
    kinds = {Several: "several", Struct: "record", Each: "records"}
    return Dummy(argument.name, argument, None, kinds[type(pattern)])


class Declarations:
    """Of the dummy arguments of one procedure."""

    def __init__(self, method, words, flat=""):
        self.method, self.words = method, words
        self.flat = flat  # the array that has one rank less
        self.cleared = method.entry.option("fortran", "failing") == "cleared"

    def of(self, dummy):
        """(attributes, name with its shape)"""
        kind, name = self.type_and_name(dummy)
        words = [kind]
        if dummy.allocated:
            words.append("allocatable")
        words.append(f"intent({self.intent(dummy)})")
        if dummy.optional:
            words.append("optional")
        if dummy.kind == "bytes":
            words.append("target")
        return ", ".join(words), name

    def intent(self, dummy):
        if dummy.kind == "text":
            return "out"
        if dummy.kind in ("record", "records"):
            return "inout"
        if dummy.value is None or not dummy.value.is_output:
            return "in"
        return "out" if self.cleared and dummy.kind not in HANDLES else "inout"

    def type_and_name(self, dummy):
        value, name = dummy.value, dummy.name
        if dummy.kind == "several":
            items = dummy.argument.pattern.items
            return self.words.type_of(self.method.values[items[0].name]), f"{name}({len(items)})"
        if dummy.kind in ("record", "records"):
            return f"type({self.record(dummy).name('fortran')})", name + "(:)" * (dummy.kind == "records")
        if dummy.kind in HANDLES:
            return self.handle(value), name
        if dummy.kind in ("splines", "handles"):
            return f"type(nurbs_{KINDS[value.base]})", f"{name}({self.shape(value)})"
        if dummy.kind in ("text", "path", "bytes"):
            return "character(len=:)" if dummy.kind == "text" else "character(kind=c_char, len=*)", name
        if dummy.kind == "options":
            return f"type({value.base})", name
        return self.words.type_of(value), name + (f"({self.shape(value)})" if dummy.is_array else "")

    def record(self, dummy):
        pattern = dummy.argument.pattern
        return self.words.records[(pattern.item if isinstance(pattern, Each) else pattern).record]

    def handle(self, value):
        return f"{'type' if value.is_output else 'class'}(nurbs_{value.kind})"

    def shape(self, value):
        extents = self.words.extents(value)
        if self.words.is_fixed(value):
            return ", ".join(str(extent.name) for extent in extents)
        return ", ".join(":" for _ in (extents[:1] if value.name == self.flat else extents))
