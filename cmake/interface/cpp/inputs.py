# SPDX-License-Identifier: MIT
"""The first half of a C++ body: lengths that follow from arrays, and the checks that arrays are as long as the library
will read."""

import re

import model

from . import parameters, words
from .terms import Locals, Terms


class Inputs:
    """What a body begins with, in `statements`; `names` says how numbers and arrays are written in lengths."""

    def __init__(self, method, binding):
        self.method, self.entry, self.values = method, method.entry, method.values
        self.reach = parameters.reached(method)
        self.optional = parameters.optional_arrays(method)
        self.lacking = {name for name in parameters.may_lack(method, binding.all_records)
                        if method.values[name].nullable}
        self.locals, self.names, self.statements = Locals(), {}, []
        self.terms = Terms(method, self.locals, self.names, self.handle)
        self.places = {}  # parameters of a placement: "place.origin"
        self.sources = {}  # number that is not given: the array that it is the length of
        self.settled = set()  # vectors that the dimension is of
        self.note_places()
        self.note_names()
        for value in method.computed:
            self.compute(value)
        self.check_all()

    def note_names(self):
        self.names.update((name, expression) for name, expression in self.reach.items()
                          if self.values[name].kind in ("number", "array"))
        for value in self.values.values():
            if value.kind == "cap":
                self.names["cap"] = self.count_name()
            elif value.is_output and value.kind == "array":
                self.names.setdefault(value.name, f"found.{value.name}")

    def handle(self, name):
        if name == self.method.receiver:
            return "get()"
        reached = self.reach[name]
        if self.values[name].kind == "options":
            return reached
        return f"{reached}[0].get()" if self.values[name].kind in ("splines", "handles") else f"{reached}.get()"

    def count_name(self):
        return next((value.name for value in self.values.values() if value.kind == "count"), "")

    # Placements, which say the dimension themselves.

    def note_places(self):
        for argument in self.method.arguments:
            if getattr(argument.pattern, "record", "") != "Placement":
                continue
            fields = dict((field, inner.name) for field, inner in argument.pattern.fields)
            self.places = {name: f"place.{field}" for field, name in fields.items()}
            extents = self.values[fields["origin"]].extents
            if words.fixed(extents):
                self.statements.append(f"const detail::Space place({argument.name});")
            else:
                otherwise = self.entry.text.get("otherwise", {}).get("dim")
                more = f", {otherwise}" if otherwise else ""
                self.statements.append(f"const detail::Place place({argument.name}{more});")
                self.names["dim"] = "place.dim"

    # Numbers that the caller does not give.

    def compute(self, value):
        name = value.name
        if name in self.names:
            return
        if name in self.method.definitions:
            definition = self.terms.text(self.method.definitions[name])
            known = re.fullmatch(r"@\w+@", definition)
            self.names[name] = definition if known else self.locals.add(name, name, definition)
            return
        source, place = self.source(name)
        if value.base == "int32_t" and name == "dim":
            self.dimension()
        elif source.kind == "array" and (parameters.is_records(self.method, source) or len(source.extents) > 1):
            width = self.terms.product(source.extents[1:]) if len(source.extents) > 1 else "1"
            words_ = f'detail::records({self.reach[source.name]}, {width}, "{source.name}")'
            self.names[name] = self.locals.add(name, name, words_, kept=True)
            self.sources[name] = source.name
        else:
            self.names[name] = self.locals.add(name, name, self.length(source, source.extents[place]))
            self.sources[name] = source.name

    def source(self, name):
        """The first array that has to be given, or the first one at all."""
        found = [source for source in self.method.sources(name) if source[0].name in self.reach]
        needed = [source for source in found if not source[0].nullable]
        return (needed or found)[0]

    def length(self, source, extent):
        """Of [pieces + 1], which is the size of the array, the pieces."""
        size = f"detail::length({self.reach[source.name]})"
        return f"{size} - {extent.arguments[1].name}" if extent.op == "+" else size

    def dimension(self):
        """Of the vectors that are given: that of the first one; where some may be left out, of those that are not."""
        vectors = [value for value in (self.values[name] for name in self.reach)
                   if value.kind == "array" and value.extents and value.extents[-1].name == "dim"
                   and len(value.extents) == 1]
        needed = [self.reach[value.name] for value in vectors if not value.nullable]
        given = [self.reach[value.name] for value in vectors if value.nullable]
        self.names["dim"] = "dim"
        self.settled = {value.name for value in vectors}
        if not given:
            self.statements.append(f"const auto dim = static_cast<std::int32_t>({needed[0]}.size());")
            self.statements.append(f"detail::require_length(dim, {{{', '.join(needed[1:])}}});")
            return
        first = self.entry.option("cpp", "dim_of") or [needed[0], *given]
        self.statements.append(f"const std::int32_t dim = detail::dimension_of({{{', '.join(first)}}}, 0);")
        rest = [name for name in needed if name not in first]
        if rest:
            self.statements.append(f"detail::require_length(dim, {{{', '.join(rest)}}});")

    # Checks.

    def check_all(self):
        counted = {source: name for name, source in self.sources.items()}
        together = []
        for value in sorted((self.values[name] for name in self.reach), key=self.depends):
            name = value.name
            if value.kind == "path":
                self.check_path(value)
            if value.kind == "texts":
                n = self.terms.product(value.extents)
                self.statements.append(f'detail::require_texts({self.reach[name]}, {n}, "{name}");')
            if name in counted:
                self.statements.append(self.names[counted[name]])
            if not self.has_length(value) or name in counted:
                continue
            if name in self.lacking and self.entry.text.get("called") and words.fixed(value.extents):
                together.append(self.reach[name])
                continue
            self.statements.append(self.check(value))
        if together:
            self.statements.append(f"detail::require_space({{{', '.join(together)}}}, \"{self.entry.text['called']}\");")

    def has_length(self, value):
        """Whether it is an array of a length that is to be checked."""
        if value.kind == "splines":  # of which others tell how many there are
            return any(extent.op == "call" for extent in value.extents)
        return (value.kind == "array" and value.extents and value.name not in self.places
                and value.name not in self.settled | self.optional and not self.is_exact_array(value))

    def depends(self, value):
        """Arrays whose lengths are the contents of others come after them."""
        arrays = {other.name for other in self.values.values() if other.kind == "array"}
        return any(extent.names() & arrays for extent in value.extents)

    def check_path(self, value):
        self.statements += [f"if ({value.name}.find('\\0') != std::string::npos) {{",
                            f"detail::fail(Status::file, \"{value.name} contains a zero byte\");", "}"]

    def is_exact_array(self, value):
        """A std::array or single elements of one."""
        taken = [argument for argument in self.method.arguments if getattr(argument.pattern, "name", "") == value.name]
        return bool(taken) and parameters.array_type(self.method, taken[0], value).startswith("const std::array")

    def check(self, value):
        reached = self.reach[value.name]
        what = self.entry.text["called"] if value.name in self.called() else value.name
        if parameters.is_records(self.method, value):
            n = self.terms.text(value.extents[0])
            width = self.terms.product(value.extents[1:]) if len(value.extents) > 1 else "1"
            if value.name in self.lacking:
                return f'detail::require_wanted({reached}, {n}, {width}, "{what}");'
            return f'{reached}.require({n}, {width}, "{what}");'
        if len(value.extents) == 2 and value.extents[0].names() & self.given_numbers():
            rows, columns = (self.terms.text(extent) for extent in value.extents)
            return f"detail::require_matrix({reached}, {rows}, {columns});"
        return f'detail::{self.rule(value)}({reached}, {self.terms.product(value.extents)}, "{what}");'

    def called(self):
        """Arrays that messages do not call by their names."""
        if "called" not in self.entry.text:
            return set()
        return {value.name for value in self.values.values() if value.kind == "array"}

    def given_numbers(self):
        return {name for name in self.reach if self.values[name].kind == "number" and name != "dim"}

    def rule(self, value):
        if value.name in self.entry.text.get("lenient", ()):
            return "require_unless_negative"
        return "require_given" if value.name in self.lacking else "require"

    # What the C function gets.

    def passed(self, value):
        """C++ expressions of an input; those of its strides come with it."""
        name = value.name
        if value.kind in ("stride", "component_stride"):
            return []
        if value in self.method.left_out:
            return ["nullptr"] + ["0"] * value.strides
        if value.kind in model.HANDLES:
            return [self.handle(name)]
        if value.kind in ("splines", "handles"):
            handles = f"detail::handle_list({self.reach[name]})"
            return [f"detail::pointer({handles})" if name in self.lacking else f"{handles}.data()"]
        if value.kind == "options":
            return [f"&{self.reach[name]}"]
        if value.kind == "path":
            return [f"{self.reach[name]}.c_str()"]
        if value.kind == "texts":
            return [f"detail::pointer(detail::text_list({self.reach[name]}))"]
        if value.kind == "number":
            return [self.number(value)]
        if name in self.places:
            return [self.places[name]]
        return self.array(value)

    def number(self, value):
        if value.name == "axes" and value in self.method.computed:
            return f"detail::axes_of({self.reach[self.sources['axes']]})"
        return self.names[value.name]

    def array(self, value):
        reached = self.reach[value.name]
        if value.name in self.optional:
            return [f"{reached} ? {reached}->data() : nullptr"]
        pointer = f"detail::pointer({reached})" if value.name in self.lacking else f"{reached}.data()"
        if not value.strides:
            return [pointer]
        if not parameters.is_records(self.method, value):
            return [pointer] + ["0"] * value.strides
        return [pointer, *strides(reached, value)]


def strides(reached, value):
    """Of one component there is only one."""
    return [f"{reached}.step()"] if value.strides == 1 else [f"{reached}.stride()", f"{reached}.component_stride()"]
