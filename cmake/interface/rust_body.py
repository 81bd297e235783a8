# SPDX-License-Identifier: MIT
"""The second half of a Rust body: room for the results, the call, and what is returned."""

from methods import MethodError
import model
from signature import Each, Several, Struct, Take

import rust_types as types
import rust_words as words
from rust_inputs import Inputs

# Names that variables with lengths may have.
LENGTHS = {"axes", "count", "dim", "n", "rational", "size"}

# Names of variables and of arguments of closures.
OWN = {"buf", "call", "cap", "fill", "length", "out"}


class Body:
    """Of one method, or of the watched form of it. Each form gives the statements between the braces."""

    def __init__(self, method, binding, watched=False):
        self.method, self.binding, self.watched = method, binding, watched
        self.entry, self.values = method.entry, method.values
        self.function = self.entry.watched if watched else self.entry.function
        self.inputs = Inputs(method, binding)
        self.targets = {}  # output: Rust expressions that are passed for it
        self.count = self.size = ""  # the variables that hold the number of results, where that is asked for first
        self.check_names()
        self.names = {}  # output: the variable that holds it
        self.counted = [value for value in self.values.values() if value.is_counted and value.kind == "array"]
        for name in method.returned:
            self.names.setdefault(name, self.variable(name))

    def check_names(self):
        """A pointer that hides a number would be taken for it."""
        clashes = OWN & {words.name(argument.name) for argument in self.method.arguments}
        if clashes:
            raise MethodError(f"{self.entry.name}: rust.call has to rename {', '.join(clashes)}, which the body needs")

    def variable(self, name):
        """Of the field that it becomes, if nothing else has that name."""
        value = self.values[name]
        if value.kind in model.HANDLES:
            return value.kind if name == "out" else name
        result = self.method.result
        fields = {inner.name: field for field, inner in self.fields(result) if isinstance(inner, Take) and not inner.last}
        taken = {words.name(argument.name) for argument in self.method.arguments} | LENGTHS
        field = fields.get(name, name)
        return words.name(name if field in taken else field)

    def fields(self, result):
        if not isinstance(result, Struct):
            return []
        record = self.binding.all_records[result.record]
        return [(record.renamed("rust", field), inner) for field, inner in result.fields]

    # Forms.

    def returning(self):
        result = self.method.result
        if result is None:
            return self.inputs.locals.resolved([*self.inputs.statements, self.checked(self.call(), "")])
        if self.counted:
            self.in_two_calls()
            lines = self.rows()
        elif self.is_value():
            lines = self.value()
        else:
            lines = self.in_one_call()
        if not self.is_tail():
            lines.append(f"Ok({self.expression(result)})")
        return self.inputs.locals.resolved([*self.inputs.statements, *lines])

    def filling(self):
        """Writes to arrays of the caller."""
        if types.output_record(self.method, self.binding):
            lines = [self.layout(field, inner.name) for field, inner in self.method.result.fields]
        else:
            lines = self.one_array(self.method.result.name)
        return self.inputs.locals.resolved([*self.inputs.statements, *lines, self.checked(self.call(), "")])

    def one_array(self, name):
        n, width = self.shape(self.values[name])
        self.targets[name] = [f"{name}.pointer()", f"{name}.stride()", f"{name}.component_stride()"]
        return [f"let mut {name} = {name}.into();", f'{name}.require({n}, {width}, "{name}")?;']

    def layout(self, field, name):
        value = self.values[name]
        n, width = self.shape(value)
        what = self.inputs.called(value)
        if not value.strides:
            self.targets[name] = [name]
            return f'let {name} = exactly_mut(&mut out.{field}, {n}, "{what}")?;'
        self.targets[name] = [f"{name}.{place}" for place in range(value.strides + 1)]
        return f'let {name} = layout(&mut out.{field}, {n}, {width}, "{what}")?;'

    def shape(self, value):
        terms = self.inputs.terms
        return terms.text(value.extents[0]), terms.product(value.extents[1:]) if len(value.extents) > 1 else "1"

    # One number or one handle.

    def is_value(self):
        """Whether what the library writes is what is returned."""
        value = self.single()
        return value is not None and value.kind == "number" and self.converted(value, "x") == "x"

    def is_tail(self):
        """Whether the call is the last expression."""
        value = self.single()
        return value is not None and (value in self.method.made or value.kind == "text" or self.is_value())

    def single(self):
        """What is returned, if that is one parameter."""
        return self.values[self.method.result.name] if isinstance(self.method.result, Take) else None

    def is_text(self):
        return any(value.kind == "text" for value in self.values.values())

    def value(self):
        name = self.names[self.method.result.name]
        self.targets[self.method.result.name] = [name]
        return [f"value(|{name}| unsafe {{ {self.call()} }})"]

    # One call.

    def in_one_call(self):
        lines = [line for name in self.outputs() for line in self.room(self.values[name])]
        made = self.method.made
        if not made:
            return [*lines, *self.plain_call()]
        last = made[-1]
        self.targets[last.name] = ["out"]
        call = f"{model.HANDLES[last.kind]}::made(|out| unsafe {{ {self.call()} }})"
        return [*lines, call if self.is_tail() else f"let {self.names[last.name]} = {call}?;"]

    def outputs(self):
        """Those that are given room here: not the last handle, nor texts."""
        last = self.method.made[-1:]
        return [name for name in self.values if name in self.names and self.values[name].is_output
                and self.values[name] not in last and self.values[name].kind != "text"]

    def plain_call(self):
        if self.is_text():
            return [self.text()]
        if self.entry.text.get("through") == "moments":
            return [self.moments()]
        return [self.checked(self.call())]

    def text(self):
        text = next(value for value in self.values.values() if value.kind == "text")
        self.targets[text.name] = ["buf"]
        call = f"written(|buf, cap, length| unsafe {{ {self.call()} }})"
        return call if self.is_tail() else f"let {self.names[text.name]} = {call}?;"

    def moments(self):
        """The library is asked for less where it cannot give all."""
        names = [self.names[name] for name in ("centroid", "inertia")]
        arrays = [f"flat(&mut {self.names[name]})" if len(words.fixed(self.values[name].extents) or ()) > 1
                  else f"&mut {self.names[name]}" for name in ("centroid", "inertia")]
        for name in ("centroid", "inertia"):
            self.targets[name] = [name]
        return f"moments_of({', '.join(arrays)}, |{', '.join(names)}| unsafe {{ {self.call()} }})?;"

    def checked(self, call, end="?;"):
        return f"check(unsafe {{ {call} }}){end}"

    # Room.

    def room(self, value):
        """The declaration of a variable; notes what the library gets for it."""
        name = self.names[value.name]
        if value in self.method.made:
            self.targets[value.name] = [f"&mut {name}"]
            return [f"let mut {name} = null_mut();"]
        if value.kind == "number":
            self.targets[value.name] = [f"&mut {name}"]
            return [f"let mut {name} = {words.zero(value)};"]
        if value.kind == "options":
            self.targets[value.name] = [f"{name}.raw_mut()"]
            return [f"let mut {name} = {types.struct_type(value, self.binding)}::empty();"]
        sizes = self.sizes(value)
        many = sizes and len(sizes) > 1 or not sizes and words.row(value)
        pointer = f"{name}.as_mut_ptr(){'.cast()' if many else ''}"
        if value.name in self.entry.text.get("space_only", ()):
            pointer = f"pointer_mut(&mut {name})"
        self.targets[value.name] = [pointer] + ["0"] * value.strides
        return [f"let mut {name} = {self.start(value, sizes)};"]

    def sizes(self, value):
        """Of an array whose size is known; [9] in three parts is [3][3]."""
        sizes = words.fixed(value.extents) if not value.strides and not self.is_vector(value) else None
        parts = [inner for _, inner in self.fields(self.method.result)
                 if isinstance(inner, Take) and inner.last and inner.name == value.name]
        return [len(parts), parts[0].last - parts[0].first] if parts else sizes

    def is_vector(self, value):
        """Whether the field is of another length in another method."""
        if not isinstance(self.method.result, Struct):
            return False
        record = self.binding.all_records[self.method.result.record]
        return any(first is not None and first.extents and not words.fixed(first.extents)
                   for (_, inner), (_, _, first, _) in zip(self.method.result.fields, record.members("rust"))
                   if inner == Take(value.name))

    def start(self, value, sizes):
        if sizes:
            return words.nested(words.zero(value), sizes)
        per_row = words.row(value)
        element = words.nested(words.zero(value), [per_row] if per_row else [])
        size = self.inputs.terms.product(value.extents, per_row or 1)
        if value.name in self.entry.text.get("space_only", ()):
            size = f"if {self.inputs.terms.property('dim', self.method.receiver)} == 3 {{ {size} }} else {{ 0 }}"
        return f"vec![{element}; {size}]"

    # Two calls: how many there are, then all of them.

    def in_two_calls(self):
        self.count = next(value.name for value in self.values.values() if value.kind == "count")
        locals_ = self.inputs.locals
        self.size = "size" if "n" in self.inputs.numbers or "n" in locals_.names.values() else "n"
        locals_.taken.add(self.size)
        self.inputs.numbers["cap"] = (self.size, "usize")
        self.targets[self.count] = [self.count]
        for value in self.late():
            self.targets[value.name] = [self.names[value.name]]

    def late(self):
        """Arrays that get room after the first call."""
        arrays = {value.name for value in self.values.values() if value.is_output and value.kind == "array"}
        return [value for value in self.values.values() if value.name in self.names and value.kind == "array"
                and (value in self.counted or any(extent.names() & arrays for extent in value.extents))]

    def rows(self):
        late = self.late()
        lines = [line for name in self.outputs() if self.values[name] not in late for line in self.early(name, late)]
        names = [self.names[value.name] for value in late]
        closure = f"let {self.mutable(late)}fill = |{', '.join(['cap', *names, self.count])}| unsafe {{ {self.call()} }};"
        lines += [closure, f"let mut {self.count} = 0;",
                  self.checked_fill("0", ["null_mut()"] * len(late)), f"let {self.size} = {self.count} as usize;"]
        pointers = []
        for value in late:
            lines += self.room(value)
            pointers += self.targets[value.name]
        return [*lines, self.checked_fill(self.count, pointers)]

    def early(self, name, late):
        """Outputs of both calls; of one that others take their lengths from only the pointer is kept."""
        lines = self.room(self.values[name])
        if any(name in extent.names() for value in late for extent in value.extents):
            lines.append(f"let {name}_pointer = {self.targets[name][0]};")
            self.targets[name] = [f"{name}_pointer"]
        return lines

    def mutable(self, late):
        """A closure that writes to variables."""
        return "mut " if self.watched or any(target.startswith("&mut") or target.endswith("as_mut_ptr()")
                             for name in self.outputs() if self.values[name] not in late
                             for target in self.targets[name]) else ""

    def checked_fill(self, cap, pointers):
        return f"check(fill({', '.join([cap, *pointers, f'&mut {self.count}'])}))?;"

    # The call.

    def call(self):
        if self.watched and self.entry.packed:
            return f"crate::call::{self.function.name}({', '.join(self.unpacked())})"
        passed = [text for parameter in self.function.parameters for text in self.passed(parameter)]
        return f"sys::{self.function.name}({', '.join(passed)})"

    def unpacked(self):
        """The arguments of the plain function, and the options last or before a new spline."""
        parameters = self.entry.function.parameters
        passed = [text for parameter in parameters for text in self.passed(parameter)]
        passed.insert(len(passed) - (parameters[-1].name == "out"), "call.options()")
        return passed

    def passed(self, parameter):
        if parameter.name == "call" and self.watched:
            return ["call.options()"]
        value = self.values[parameter.name]
        if value.kind == "cap":
            return ["cap"]
        if value.kind == "count" and value.name not in self.targets:
            return ["length"]
        if value.kind in ("stride", "component_stride"):
            return []  # beside the array
        if value.name in self.entry.text.get("unreturned", ()):
            return ["null_mut()"]
        return self.targets[value.name] if value.is_output else self.inputs.passed(value)

    # What is returned.

    def expression(self, pattern, index=""):
        if isinstance(pattern, Struct):
            return self.record(pattern, index)
        if isinstance(pattern, Each):
            row = self.expression(pattern.item, "[i]")
            n = self.size if self.counted else self.inputs.terms.text(self.first_of(pattern).extents[0])
            return f"(0..{n}).map(|i| {row}).collect()"
        if isinstance(pattern, Several):
            items = [self.expression(item, index) for item in pattern.items]
            return f"({', '.join(items)})" if pattern.bracket == "(" else f"[{', '.join(items)}]"
        return self.taken(pattern, index)

    def first_of(self, pattern):
        while not isinstance(pattern, Take):
            pattern = pattern.item if isinstance(pattern, Each) else (
                pattern.fields[0][1] if isinstance(pattern, Struct) else pattern.items[0])
        return self.values[pattern.name]

    def record(self, pattern, index):
        record = self.binding.all_records[pattern.record]
        fields = []
        for field, inner in pattern.fields:
            name, text = record.renamed("rust", field), self.expression(inner, index)
            fields.append(name if name == text else f"{name}: {text}")
        return f"{record.name('rust')} {{ {', '.join(fields)} }}"

    def taken(self, pattern, index):
        value = self.values[pattern.name]
        if not value.is_output:
            return self.inputs.reach[pattern.name]
        name = self.names[pattern.name]
        if pattern.last:
            return f"{name}[{pattern.first // (pattern.last - pattern.first)}]"
        if value in self.method.made[:-1]:
            return f"unsafe {{ Spline::owned({name}) }}"
        return self.converted(value, name + index)

    def converted(self, value, text):
        if value.kind == "array" and value.truth:
            return f"truths({text})"
        if value.unsigned:
            return f"bits({text})" if value.kind == "array" and not text.endswith("]") else f"{text} as u32"
        if value.truth:
            return f"{text} != 0"
        if value.kind == "number" and types.is_size(self.method, value):
            return f"{text} as usize"
        return text
