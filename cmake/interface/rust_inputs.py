# SPDX-License-Identifier: MIT
"""The first half of a Rust body: lengths that follow from arrays, checks of the others, and what the C function gets."""

import model
from extents import FUNCTIONS
from methods import KINDS
from signature import By, Struct, Take

import rust_types as types
import rust_words as words
from rust_terms import Locals, Terms


class Inputs:
    """What a body begins with, in `statements`; passed() says what stands for an input in the call."""

    def __init__(self, method, binding):
        self.method, self.entry, self.values, self.binding = method, method.entry, method.values, binding
        self.reach = types.reached(method)
        self.arguments = {name: argument for argument in method.arguments for name in self.taken_by(argument)}
        self.numbers = {}  # {parameter: (how it is written as a length, its type)}
        self.pointers = {}  # {array: Rust expressions that are passed}
        self.statements = []
        self.settled = set()  # arrays whose lengths are known to be right
        self.locals = Locals(self.taken_names())
        self.terms = Terms(self.locals, self.numbers, self.array, self.handle)
        self.note_numbers()
        self.placements()
        self.convert()
        for value in method.computed:
            self.compute(value)
        for name in self.order():
            self.check(self.values[name])
        for name in self.reach:
            if self.values[name].kind == "texts":
                self.texts(self.values[name])

    def taken_by(self, argument):
        if isinstance(argument.pattern, By):
            return types.by_names(argument.pattern)
        return [name for name, expression in self.reach.items()
                if expression.split(".")[0].split("[")[0] == words.name(argument.name)]

    def taken_names(self):
        """Of variables that have a meaning already."""
        counted = {"size"} if self.method.is_counted else set()
        return {words.name(argument.name) for argument in self.method.arguments} | set(self.values) | counted

    def note_numbers(self):
        for name, expression in self.reach.items():
            value = self.values[name]
            if value.kind == "number":
                self.numbers[name] = (expression, "usize" if types.is_size(self.method, value) else words.element(value))

    def handle(self, name):
        """The spline behind a parameter."""
        if name == self.method.receiver:
            return "self"
        return f"{self.reach[name]}[0]" if self.values[name].kind in ("splines", "handles") else self.reach[name]

    def array(self, name):
        """An array, or what an output holds, as an argument of a function."""
        value = self.values[name]
        if value.is_output:
            return f"&{name}"
        reached = self.reach[name]
        return f"&{reached}" if self.is_vector(value) else reached

    def is_vector(self, value):
        """Whether it has become a Vec, or is one of a record."""
        argument = self.arguments[value.name]
        return isinstance(argument.pattern, (By, Struct)) or types.is_size(self.method, value)

    # Placements, vectors that say the dimension, arrays that become others.

    def placements(self):
        for argument in self.method.arguments:
            if getattr(argument.pattern, "record", "") != "Placement":
                continue
            vectors = [inner.name for _, inner in argument.pattern.fields]
            self.settled.update(vectors)
            self.pointers.update((name, [name]) for name in vectors)
            listed = f"[{', '.join(vectors)}]"
            if words.fixed(self.values[vectors[0]].extents):
                self.statements.append(f"let {listed} = {argument.name}.space()?;")
            else:
                otherwise = self.entry.text.get("otherwise", {}).get("dim", 2)
                self.statements.append(f"let (dim, {listed}) = {argument.name}.place({otherwise})?;")
                self.numbers["dim"] = ("dim", "i32")

    def convert(self):
        for name, argument in self.arguments.items():
            value = self.values[name]
            if value.kind == "array" and types.is_records(self.method, argument, value):
                self.statements.append(f"let {name} = {self.reach[name]}.into();")
                self.reach[name] = name
            elif value.kind in ("splines", "handles"):
                self.handles(value, argument)
            elif value.kind == "path":
                self.statements.append(f"let {name} = path_text({self.reach[name]})?;")

    def handles(self, value, argument):
        """Arrays of handles."""
        name, reached = value.name, self.reach[value.name]
        if not words.fixed(value.extents):
            self.statements.append(f"let {reached} = {self.list_of(value)}({reached});")
            self.pointers[name] = [f"{reached}.as_ptr()"]
            if any(extent.op == "call" for extent in value.extents):  # the length is that of other arrays
                rule, size = "if_given" if value.nullable else "exactly", self.terms.product(value.extents)
                self.statements.append(f'let {reached} = {rule}(&{reached}, {size}, "{self.called(value)}")?;')
                self.pointers[name] = [reached]
        elif self.may_lack(value, argument):
            self.statements.append(f"let {name} = {reached}.map(|splines| splines.map(Spline::raw));")
            self.pointers[name] = [f"{name}.as_ref().map_or(null(), |handles| handles.as_ptr())"]
        else:
            local = name if isinstance(argument.pattern, Struct) else reached
            self.statements.append(f"let {local} = {reached}.map(Spline::raw);")
            self.pointers[name] = [f"{local}.as_ptr()"]

    def list_of(self, value):
        """The function that makes an array of handles."""
        if value.kind == "handles":
            return f"{KINDS[value.base]}_handles"
        return "some_handles" if types.may_miss(self.method, value) else "handles"

    def texts(self, value):
        n = self.terms.product(value.extents)
        self.statements.append(f'let {value.name} = Texts::new({self.reach[value.name]}, {n}, "{value.name}")?;')

    def may_lack(self, value, argument):
        """Whether it is an Option."""
        if argument.optional:
            return True
        return isinstance(argument.pattern, Struct) and value.nullable and not self.has_default(value, argument)

    def has_default(self, value, argument):
        defaults = self.binding.all_records[argument.pattern.record].defaults
        return any(inner == Take(value.name) and field in defaults for field, inner in argument.pattern.fields)

    # Numbers that the caller does not give.

    def compute(self, value):
        name = value.name
        if name in self.numbers:
            return
        self.locals.taken.discard(name)
        if name in self.method.definitions:
            term = self.method.definitions[name]
            if term.op == "-":
                self.numbers[name] = (self.terms.signed(term), "i64")
            else:
                names = ["size"] if name in FUNCTIONS else [name, "n"]
                self.numbers[name] = (self.locals.add(name, names, self.terms.text(term)), "usize")
            return
        source, place = self.source(name)
        if name == "dim":
            self.dimension()
        elif name == "axes":
            self.numbers[name] = (self.locals.add("axes", ["axes"], f"{self.length(source)}"), "usize")
        else:
            self.count(name, source, place)

    def source(self, name):
        found = [source for source in self.method.sources(name) if source[0].name in self.reach]
        return next((source for source in found if not source[0].nullable), found[0])

    def length(self, source):
        reached = self.reach[source.name]
        self.settled.add(source.name)
        return f"{reached}.len()"

    def count(self, name, source, place):
        """Of records, or of elements."""
        own, reached = self.arguments[source.name], self.reach[source.name]
        width = self.terms.product(source.extents[1:]) if len(source.extents) > 1 else "1"
        if source.kind == "array" and types.is_records(self.method, own, source):
            self.fix(name, f'{reached}.count({width}, "{self.called(source)}")?')
        elif source.kind == "array" and len(source.extents) > 1:
            self.fix(name, f'rows({reached}, {width}, "{self.called(source)}")?')
        else:
            length = f"{reached}.len()"
            extent = source.extents[place]
            if extent.op == "+":  # [pieces + 1]
                length = f"{length}.saturating_sub({extent.arguments[1].name})"
            self.numbers[name] = (self.locals.add(name, [name, "n"], length), "usize")
        self.settled.add(source.name)

    def fix(self, name, value):
        """A number that is a variable in any case, since finding it is a check."""
        self.statements.append(f"let {name} = {value};")
        self.numbers[name] = (name, "usize")
        self.locals.taken.add(name)

    def dimension(self):
        """Of the vectors that are given: all have one length."""
        vectors = [self.values[name] for name in self.reach
                   if self.values[name].kind == "array" and self.is_vector_of_dim(self.values[name])]
        self.settled.update(value.name for value in vectors)
        self.numbers["dim"] = ("dim", "i32")
        needed = [self.reach[value.name] for value in vectors if not value.nullable]
        for value in vectors:
            reached = self.reach[value.name]
            self.pointers[value.name] = [f"pointer({reached})" if value.nullable else f"{reached}.as_ptr()"]
        if len(needed) == len(vectors):
            self.statements.append(f"let dim = {needed[0]}.len() as i32;")
            needed = needed[1:]
        else:
            listed = ", ".join(self.reach[value.name] for value in vectors)
            self.statements.append(f"let dim = dimension_of(&[{listed}], 0)?;")
        self.statements.append(f"require_length(dim, &[{', '.join(needed)}])?;")

    def is_vector_of_dim(self, value):
        return len(value.extents) == 1 and value.extents[0].name == "dim" and value.extents[0].op == "parameter"

    # Checks.

    def order(self):
        """Of the C function; arrays whose lengths are the contents of others come after them."""
        arrays = {value.name for value in self.values.values() if value.kind == "array"}
        given = [name for name in self.values if name in self.reach and self.values[name].kind == "array"]
        return sorted(given, key=lambda name: any(extent.names() & arrays for extent in self.values[name].extents))

    def called(self, value):
        """What messages call an array."""
        called = self.entry.option("rust", "called", value.name)
        return called if isinstance(called, str) else called.get(value.name, value.name)

    def check(self, value):
        name, argument = value.name, self.arguments[value.name]
        if name in self.pointers:
            return
        if isinstance(argument.pattern, By):
            self.by_axis(argument)
        elif types.is_records(self.method, argument, value):
            self.records(value)
        elif name in self.settled and not types.is_size(self.method, value):
            self.pointers[name] = self.packed(f"{self.reach[name]}.as_ptr()", value)
        else:
            self.slice(value, argument)

    def packed(self, pointer, value):
        return [pointer] + ["0"] * value.strides

    def records(self, value):
        name = self.reach[value.name]
        self.pointers[value.name] = [f"{name}.pointer()"] + (
            [f"{name}.step()"] if value.strides == 1 else [f"{name}.stride()", f"{name}.component_stride()"])
        if value.name in self.settled:
            return
        n = self.terms.text(value.extents[0])
        width = self.terms.product(value.extents[1:]) if len(value.extents) > 1 else "1"
        line = f'{name}.require({n}, {width}, "{self.called(value)}")?;'
        if value.extents[0].op == "call" and "dim" in self.reach:
            self.statements.append(f"// Another dimension is left to the library to name.\nif dim > 0 {{\n{line}\n}}")
        else:
            self.statements.append(line)

    def slice(self, value, argument):
        name, reached, size = value.name, self.reach[value.name], self.terms.product(value.extents)
        sizes = words.fixed(value.extents)
        self.pointers[name] = self.packed(name, value)
        if types.is_size(self.method, value):
            self.statements.append(f'let {name} = counts_of({reached}, {size}, "{self.called(value)}")?;')
            self.pointers[name] = [f"{name}.as_ptr()"]
        elif self.may_lack(value, argument) and sizes:
            self.pointers[name] = [f"{reached}.map_or(null(), |values| values.as_ptr())"]
        elif self.may_lack(value, argument):
            self.add_check("optional", value, size)
        elif value.nullable:
            self.add_check("if_given", value, size)
        elif sizes:
            self.pointers[name] = [f"{reached}.as_ptr()"]
        else:
            self.add_check("exactly", value, size)

    def add_check(self, rule, value, size):
        reached = self.reach[value.name]
        reference = "&" if self.is_owned(value) else ""
        self.statements.append(f'let {value.name} = {rule}({reference}{reached}, {size}, "{self.called(value)}")?;')

    def is_owned(self, value):
        """Whether it is a Vec in a record that is a result too."""
        pattern = self.arguments[value.name].pattern
        return isinstance(pattern, Struct) and any(
            is_result for _, _, is_result in self.binding.all_records[pattern.record].uses["rust"])

    def by_axis(self, argument):
        """One array for each axis: their lengths, and all of them packed."""
        pattern, own = argument.pattern, argument.name
        names = types.by_names(pattern)
        axes = self.terms.text(self.values[pattern.counts].extents[0])
        listed = f"({', '.join(names)})"
        if not isinstance(pattern.item, Take):
            line = f'let {listed} = pairs_by_axis({own}, {axes}, "{own}")?;'
        elif self.values[names[1]].extents[0].op == "call":
            line = f'let {listed} = by_axis({own}, {axes}, "{own}")?;'
        else:  # knots, of which there are degree + 1 more than control points
            line = f'let {listed} = knots_by_axis({own}, degrees, "{own}")?;'
        self.statements.append(line)
        for name in names:
            self.pointers[name] = [f"{name}.as_ptr()"]
            self.reach[name] = name

    def listed_by_axis(self):
        """The first array with an element for each axis, as the caller gives it or as sizes that C takes."""
        source = self.method.sources("axes")[0][0]
        return f"&{source.name}" if types.is_size(self.method, source) else self.reach[source.name]

    # What the C function gets.

    def passed(self, value):
        name = value.name
        if value.kind in ("stride", "component_stride"):
            return []
        if value in self.method.left_out:
            return ["null()"] + ["0"] * value.strides
        if value.kind in model.HANDLES:
            return [f"{self.handle(name)}.raw()"]
        if value.kind == "options":
            return [self.struct(value)]
        if value.kind in ("path", "texts"):
            return [f"{name}.as_ptr()"]
        if value.kind == "bytes":
            return [f"{self.reach[name]}.as_ptr().cast()"]
        return [self.number(value)] if value.kind == "number" else self.pointers[name]

    def struct(self, value):
        """A pointer to it, or to nothing where it may be left out."""
        if not self.arguments[value.name].optional:
            return f"{self.reach[value.name]}.raw()"
        given, kind = self.reach[value.name], types.struct_type(value, self.binding)
        if kind == "FitOptions":  # it has arrays as long as the data say
            return f"fit_options_pointer({given}, {'self' if self.method.receiver else 'data'}.shape())"
        return {"ReadOptions": "options", "WriteOptions": "write_options", "CloudOptions": "cloud_options",
                "MeshOptions": "mesh_options"}[kind] + f"_pointer({given})"

    def number(self, value):
        text, kind = self.numbers[value.name]
        if value.name == "axes" and value in self.method.computed:
            return f"axes_of({self.listed_by_axis()})"
        return f"{text} as i64" if kind == "usize" else text
