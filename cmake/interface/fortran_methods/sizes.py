# SPDX-License-Identifier: MIT
"""What the shapes of arrays say: numbers that the caller does not give, and conditions that arrays have to meet.

Numbers are 64 bits wide. One that occurs once is written where it is needed; another becomes a local variable. While a
procedure is made, such a number is a mark in its statements, and settle() says what becomes of the marks.
"""

import re
from dataclasses import dataclass

from table import TableError

MARK = re.compile("\x01(\\w+)(,narrow)?\x02")
#: Functions that are called, so that no variable has their names.
RESERVED = {"knot_count", "size", "sum", "product"}
PROPERTIES = {"axes": "axes_of", "dim": "dim_of", "N": "points_of", "rational": "rational_of"}
OF_SPLINES = {"degree": "degree_of", "count": "count_of", "slots": "slots_of", "active": "active_of"}


@dataclass
class Number:
    """A number under a name: its text with 64 bits and as a default integer."""

    name: str
    wide: str
    narrow: str


class Sizes:
    def __init__(self, method, dummies, words, flat=""):
        self.method, self.words, self.flat = method, words, flat
        self.by_parameter = {name: dummy for dummy in dummies if dummy.value for name in [dummy.value.name]}
        self.taken = {dummy.name for dummy in dummies}
        self.computed = {value.name: value for value in method.computed}
        self.numbers = {}
        self.replaced = {}  # arrays of which there is a local copy
        self.count = next((value for value in method.values.values() if value.kind == "count"), None)

    # Names.

    def free(self, name, otherwise=""):
        """A name for a local variable."""
        return name if name not in self.taken | RESERVED else otherwise or f"{name}_c"

    @property
    def count_name(self):
        """Of how much there is, after the first of two calls."""
        return self.free("n") if self.count.name in ("count", "cap") and "n" not in self.computed else self.count.name

    def handle(self, parameter):
        if parameter == self.method.receiver:
            return "this%handle"
        dummy = self.by_parameter[parameter]
        return f"{dummy.name}{'(1)' if dummy.kind == 'splines' else ''}%handle"

    # Numbers.

    def mark(self, name, make, narrow=False):
        """Of the number that make() writes when it is first needed."""
        if name not in self.numbers:
            self.numbers[name] = Number(name, *make())
        return f"\x01{name}{',narrow' * narrow}\x02"

    def property(self, name, spline):
        several = len([value for value in self.method.values.values() if value.kind == "spline" and not value.is_output]) > 1
        local = self.free(f"{name}_{spline}" if several else name.lower() if name != "N" else "points_n", f"{name}_here")
        call = f"{PROPERTIES[name]}({self.handle(spline)})"
        kind = self.method.values[spline].kind
        if kind == "options":
            call = f"int({self.by_parameter[spline].name}%{name}, c_int64_t)"
        elif kind in ("statistics", "face"):
            call = f"{kind}_{call}"
        return self.mark(local, lambda: (call, f"int({call})"))

    def number(self, name, narrow=False):
        """One that the library takes and the caller does not give."""
        return self.mark(self.free(name), lambda: self.made(name), narrow)

    def made(self, name):
        if name in self.method.definitions:
            text = self.wide(self.method.definitions[name])
            return text, f"int({text})"
        if self.is_vague(name):
            vectors = ", ".join(self.by_parameter[value.name].name for value in self.vectors(name))
            text = f"dimension_of({self.otherwise(name)}, {vectors})"
            return text, f"int({text})"
        value, place = self.sources(name)[0]
        return self.solved(name, value, place)

    def sources(self, name):
        """(array, place) of those that the caller gives."""
        return [(value, place) for value, place in self.method.sources(name)
                if value.name in self.by_parameter and not self.by_parameter[value.name].allocated]

    def solved(self, name, value, place):
        """The number from an extent name + something."""
        extent = value.extents[place]
        rest = (0, "") if extent.op == "parameter" else self.without(name, extent)
        wide, narrow = self.extent(value, place)
        return wide + self.minus(rest, True), narrow + self.minus(rest, False)

    def without(self, name, extent):
        """What is added to the name: a number, or a term."""
        kept = [term for term in extent.arguments if name not in term.names()]
        if extent.op != "+" or len(kept) != 1:
            entry = self.method.entry
            raise TableError(f"{entry.group.name}.toml: {entry.name}: Fortran cannot tell {name} from the shape of an array "
                             f"that is given; define it: where.{name} = ...")
        return (kept[0].name, "") if kept[0].op == "number" else (0, self.wide(kept[0]))

    @staticmethod
    def minus(rest, wide):
        number, text = rest
        if text:
            return f" - {text}" if wide else f" - int({text})"
        return f" - {number}" if number else ""

    def extent(self, value, place):
        """The extent of a dummy argument that is the one in this place in C, with 64 bits and as a default integer."""
        name = self.by_parameter[value.name].name
        if value.kind == "bytes":
            return f"len({name}, c_int64_t)", f"len({name})"
        rank = len(value.extents)
        if rank == 1 and value.nullable and self.by_parameter[value.name].optional:
            return f"size_if_given({name})", f"int(size_if_given({name}))"
        if rank == 1 or value.name == self.flat:
            return f"size({name}, kind=c_int64_t)", f"size({name})"
        order = [self.words.extents(value).index(extent) + 1 for extent in value.extents]
        return f"size({name}, {order[place]}, c_int64_t)", f"size({name}, {order[place]})"

    # A dimension that vectors say of which some may be left out.

    def is_vague(self, name):
        return any(self.by_parameter[value.name].optional for value in self.vectors(name)) and name == "dim"

    def vectors(self, name):
        return [value for value, _ in self.sources(name) if len(value.extents) == 1]

    def otherwise(self, name):
        return self.method.entry.text.get("otherwise", {}).get(name, 2)

    # Terms.

    def wide(self, term):
        text, is_wide = self.text(term)
        if is_wide:
            return text
        return f"{text}_c_int64_t" if term.op == "number" else f"int({text}, c_int64_t)"

    def text(self, term):
        """Its text, and whether that has 64 bits."""
        if term.op == "number":
            return str(term.name), False
        if term.op == "parameter":
            return self.parameter(term.name)
        if term.op == "property":
            return self.property(term.name, term.of), True
        if term.op == "call":
            return self.call(term), True
        return self.operation(term)

    def parameter(self, name):
        value = self.method.values[name]
        if value.kind == "cap":
            return self.count_name, True
        if name in self.computed:
            return self.number(name), True
        if name in self.replaced:
            return self.replaced[name], True
        dummy = self.by_parameter[name]
        if dummy.optional and value.kind == "number":
            return f"given({dummy.name}, {self.words.default(self.method, dummy.argument)})", False
        return dummy.name, value.base == "int64_t" and not self.words.is_narrow(value)

    def operation(self, term):
        first, second = (self.text(argument) for argument in term.arguments)
        if not first[1] and not second[1]:
            second = self.wide(term.arguments[1]), True
        sides = [f"({text})" if term.op == "*" and argument.op in "+-" else text
                 for (text, _), argument in zip((first, second), term.arguments)]
        return f"{sides[0]} {term.op} {sides[1]}", True

    # Calls of the functions of extents.py.

    def call(self, term):
        """A local variable holds what several places need, unless a call of the library says it first."""
        text = getattr(self, f"call_{term.name}", self.called)(term)
        first = [name for argument in term.arguments for name in sorted(argument.names())]
        if term.name in ("size", "positive", "axes", "homogeneous") or self.replaced.keys() & set(first):
            return text
        return self.mark("_".join([term.name, *first[:1]]), lambda: (text, f"int({text})"))

    def called(self, term):
        """The core has a function of that name."""
        arguments = [self.given(argument) for argument in term.arguments]
        if term.name in OF_SPLINES:
            arguments.insert(0, self.handle(term.of))
        return f"{OF_SPLINES.get(term.name, term.name)}({', '.join(arguments)})"

    def given(self, term):
        """An argument: arrays and numbers of 32 bits as they are, axes from 0."""
        if term.op != "parameter" or term.name in self.computed:
            return self.wide(term)
        value = self.method.values[term.name]
        text, _ = self.text(term)
        if value.base == "int64_t" and value.kind == "number" and self.words.is_narrow(value):
            return f"int({text}, c_int64_t)"
        return f"{text} - 1" if self.words.is_index(value) else text

    def call_size(self, term):
        return f"size({self.text(term.arguments[0])[0]}, kind=c_int64_t)"

    def call_positive(self, term):
        return f"max({self.wide(term.arguments[0])}, 0_c_int64_t)"

    def call_sum(self, term):
        return f"sum({self.wide(term.arguments[0])})"

    def call_product(self, term):
        """The library judges negative numbers of control points of a spline that is to be made."""
        name = "net_size" if self.method.receiver == "out" else "product"
        return f"{name}({self.wide(term.arguments[0])})"

    def call_axes(self, term):
        return self.property("axes", term.of)

    # Conditions.

    def conditions(self):
        found = [self.condition(dummy) for dummy in self.by_parameter.values()
                 if self.is_measured(dummy) and not dummy.allocated and not self.words.is_fixed(dummy.value)]
        return [condition for condition in (*found, *self.of_flat(), *self.of_dimension()) if condition]

    @staticmethod
    def is_measured(dummy):
        """Whether its length is compared: of splines only where others tell how many there are."""
        return dummy.is_array or dummy.kind == "splines" and any(extent.op == "call" for extent in dummy.value.extents)

    def condition(self, dummy):
        value = dummy.value
        extents = self.words.extents(value)[:1] if value.name == self.flat else self.words.extents(value)
        if all(self.says(value, extent) for extent in extents):
            return ""
        rule = "as_many" if dummy.kind == "splines" else "fits"
        return f"{rule}({dummy.name}, {', '.join(self.wide(extent) for extent in extents)})"

    def says(self, value, extent):
        """Whether a number follows from this extent, so that there is nothing to compare."""
        for name in extent.names() & self.computed.keys():
            if name in self.method.definitions:
                continue
            if self.is_vague(name):
                return extent.op == "parameter" and len(value.extents) == 1
            source, place = self.sources(name)[0]
            return source is value and value.extents[place] is extent
        return False

    def of_flat(self):
        """Where an array has one rank less, what is left out has to be 1."""
        if self.flat:
            for extent in self.method.values[self.flat].extents[1:]:
                yield f"{self.wide(extent)} == 1"

    def of_dimension(self):
        if "dim" in self.computed and self.is_vague("dim"):
            yield f"{self.number('dim')} > 0"

    # Marks.

    def settle(self, texts):
        """The texts without marks, and (name, text) of the local variables that are needed, in order."""
        variables, texts = [], list(texts)
        for number in reversed(self.numbers.values()):
            everything = [*texts, *(text for _, text in variables)]
            uses = sum(match[1] == number.name for text in everything for match in MARK.finditer(text))
            local = uses > 1
            texts = [replaced(text, number, local) for text in texts]
            variables = [(name, replaced(text, number, local)) for name, text in variables]
            if local:
                variables.append((number.name, number.wide))
        return texts, [(name, text) for name, text in reversed(variables)]


def replaced(text, number, local):
    """With the name or the text of a number in place of its marks."""
    def one(match):
        if match[1] != number.name:
            return match[0]
        if local:
            return f"int({number.name})" if match[2] else number.name
        return number.narrow if match[2] else number.wide
    return MARK.sub(one, text)
