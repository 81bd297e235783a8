# SPDX-License-Identifier: MIT
"""Lengths in C++, and the local variables that hold those that are needed more than once."""

import re
from dataclasses import dataclass

PROPERTIES = {"axes": "detail::axes({})", "dim": "detail::dimension({})", "N": "detail::point_count({})",
              "rational": "detail::is_rational({})"}
LOCALS = {"axes": "axes", "dim": "dim", "N": "net_size", "rational": "rational"}


@dataclass
class Local:
    name: str
    value: str
    kept: bool = False  # a variable even if it is used once


class Locals:
    """Values that are written once where they are used, or become variables. In texts they are @key@ until resolved."""

    def __init__(self):
        self.known = {}

    def add(self, key, name, value, kept=False):
        self.known.setdefault(key, Local(name, value, kept))
        return f"@{key}@"

    def resolved(self, statements):
        """The statements, with declarations before the first use."""
        variables = [key for key, local in self.known.items() if local.kept or self.uses(key, statements) > 1]
        declared, lines = set(), []
        for statement in statements:
            for key in self.needed(statement, variables):
                if key not in declared:
                    declared.add(key)
                    lines.append(self.written(f"const std::int64_t {self.known[key].name} = {self.known[key].value};",
                                              variables))
            if not re.fullmatch(r"(@\w+@)?", statement):  # a value alone only asks for its variable
                lines.append(self.written(statement, variables))
        return lines

    def keys(self, text):
        return re.findall(r"@(\w+)@", text)

    def uses(self, key, statements):
        count = sum(self.keys(statement).count(key) for statement in statements if statement != f"@{key}@")
        for other, local in self.known.items():
            inside = self.keys(local.value).count(key)
            if inside:
                uses = self.uses(other, statements)
                count += inside * (1 if local.kept or uses > 1 else uses)
        return count

    def needed(self, text, variables):
        """Variables that a text needs, those first that others are made of."""
        for key in self.keys(text):
            yield from self.needed(self.known[key].value, variables)
            if key in variables:
                yield key

    def written(self, text, variables):
        while self.keys(text):
            text = re.sub(r"@(\w+)@", lambda match: self.known[match[1]].name if match[1] in variables
                          else self.known[match[1]].value, text)
        return text


class Terms:
    """Prints terms of extents.py. names: {parameter: how it is written}; handle: of a spline parameter."""

    def __init__(self, method, locals_, names, handle):
        self.method, self.locals, self.names, self.handle = method, locals_, names, handle

    def product(self, extents):
        """One length for all of the extents."""
        numbers = [extent.name for extent in extents if extent.op == "number"]
        factor = 1
        for number in numbers:
            factor *= number
        terms = [extent for extent in extents if extent.op != "number"]
        if len(extents) == 1:
            return self.text(extents[0])
        others = [self.factor(extent) for extent in terms]
        if len(others) > 1 and any(extent.name == "product" for extent in extents):
            return f"detail::times({', '.join(self.text(extent) for extent in terms)})"
        return " * ".join(([str(factor)] if factor != 1 or not others else []) + others)

    def factor(self, term):
        text = self.text(term)
        return f"({text})" if term.op in ("+", "-") else text

    def text(self, term):
        if term.op == "number":
            return str(term.name)
        if term.op == "parameter":
            return self.names[term.name]
        if term.op == "property":
            handle = self.handle(term.of)
            same = term.of == self.splines()[0]
            name = LOCALS[term.name] + ("" if same else f"_of_{term.of}")
            return self.locals.add(f"{term.name}_of_{term.of}", name, PROPERTIES[term.name].format(handle))
        if term.op == "call":
            return self.called(term)
        left, right = (self.operand(term.op, side) for side in term.arguments)
        return f"{left} {term.op} {right}"

    def operand(self, op, side):
        """What the caller gives may be the largest number of 32 bits."""
        text = self.factor(side) if op == "*" else self.text(side)
        narrow = side.op == "parameter" and self.method.values[side.name].base == "int32_t"
        return f"std::int64_t{{{text}}}" if narrow else text

    def splines(self):
        return [value.name for value in self.method.values.values()
                if value.kind in ("spline", "splines", "statistics", "face") and not value.is_output
                or value.base == "nurbs_data"]

    def called(self, term):
        arguments = [argument for argument in term.arguments]
        if term.name == "size":
            return f"detail::length({self.text(arguments[0])})"
        if term.name == "product":
            return self.product_of(arguments[0])
        if term.name == "sum":
            return self.locals.add(f"sum_{arguments[0].name}", "total", f"detail::sum({self.text(arguments[0])})")
        own = [self.handle(term.of)] if term.of else []
        words = ", ".join(own + [self.text(argument) for argument in arguments])
        return f"detail::{term.name}({words})"

    def product_of(self, argument):
        """Of counts, or of degrees + 1."""
        if argument.op == "+":
            return self.locals.add("pieces", "net_size", f"detail::piece_points({self.text(argument.arguments[0])})")
        words = f"detail::product<std::int64_t>({self.text(argument)})"
        return self.locals.add(f"product_{argument.name}", "net_size", words)
