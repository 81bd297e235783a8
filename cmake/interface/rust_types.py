# SPDX-License-Identifier: MIT
"""The signature of a Rust method, and how its body reaches what the caller gave."""

from dataclasses import dataclass, field

import model
from methods import KINDS
from signature import By, Each, Several, Struct, Take

import rust_words as words

LIFETIMES = "abcdef"


@dataclass
class Signature:
    """Of one form of a method: parameters as they are declared, and the lifetimes of arrays with strides."""

    method: object
    binding: object
    inputs: int = 0
    outputs: list = field(default_factory=list)
    lifetimes: list = field(default_factory=list)

    def text(self, suffix="", fills=False, watched=False):
        result = "()" if fills else result_type(self.method, self.binding)
        declared = self.parameters(fills) + (["call: &mut Call"] if watched else [])
        receiver = [] if self.method.receiver in ("", *model.HANDLES.values()) else ["&self"]
        generics = f"<{', '.join(self.lifetimes)}>" if self.lifetimes else ""
        listed = ", ".join(receiver + declared)
        return f"pub fn {self.method.name}{suffix}{generics}({listed}) -> Result<{result}> {{"

    def parameters(self, fills):
        """What is filled comes after the last array that is given."""
        declared = [f"{words.name(argument.name)}: {self.kind(argument)}" for argument in self.method.arguments]
        if fills:
            place = last_array(self.method) + 1
            declared[place:place] = self.filled()
        return declared

    def kind(self, argument):
        pattern = argument.pattern
        if isinstance(pattern, Take) and is_records(self.method, argument, self.method.values[pattern.name]):
            self.inputs += 1
            return f"impl Into<Records<{self.lifetime(self.inputs - 1)}>>"
        return argument_type(self.method, argument, self.binding)

    def lifetime(self, place):
        self.lifetimes.append(f"'{LIFETIMES[place]}")
        return self.lifetimes[-1]

    def filled(self):
        outputs = output_record(self.method, self.binding)
        if outputs:
            return [f"mut out: {outputs}"]
        value = self.method.values[self.method.result.name]
        more = ", f32" if value.base == "float" else ""
        return [f"{value.name}: impl Into<RecordsMut<{self.lifetime(max(self.inputs, 1))}{more}>>"]


def output_record(method, binding):
    """The struct of arrays of the caller, or ""."""
    return binding.all_records[method.result.record].outputs("rust") if isinstance(method.result, Struct) else ""


def last_array(method):
    """The place of the last argument that is an array with strides, or one for each axis."""
    return max(place for place, argument in enumerate(method.arguments)
               if isinstance(argument.pattern, By)
               or isinstance(argument.pattern, Take)
               and is_records(method, argument, method.values[argument.pattern.name]))


def is_records(method, argument, value):
    """Whether it is taken with strides."""
    return (value.kind == "array" and value.strides > 0 and not argument.optional
            and value.name not in method.entry.text.get("packed", ()))


def may_miss(method, value):
    """Whether elements of an array of splines may be missing."""
    return value.name in method.entry.text.get("missing", ())


def is_size(method, value):
    return value.name in method.entry.option("rust", "sizes", ())


# What the caller gives.


def argument_type(method, argument, binding):
    pattern = argument.pattern
    if isinstance(pattern, Take):
        kind = taken_type(method, argument, method.values[pattern.name], binding)
        return f"Option<{kind}>" if argument.optional else kind
    if isinstance(pattern, By):
        return by_axis(method, pattern)
    if isinstance(pattern, Several):
        return several(method, pattern)
    record = binding.all_records[pattern.record]
    is_made_too = any(is_result for _, _, is_result in record.uses["rust"])
    return f"&{record.name('rust')}" if is_made_too else record.name("rust")


def by_axis(method, pattern):
    if isinstance(pattern.item, Take):
        return f"&[&[{words.element(method.values[pattern.item.name])}]]"
    items = ", ".join(f"&[{words.element(method.values[item.name])}]" for item in pattern.item.items)
    return f"&[({items})]"


def several(method, pattern):
    kinds = [single_type(method.values[item.name]) for item in pattern.items]
    return f"({', '.join(kinds)})" if pattern.bracket == "(" else f"[{kinds[0]}; {len(kinds)}]"


def single_type(value):
    return f"&{model.HANDLES[value.kind]}" if value.kind in model.HANDLES else words.SCALARS[value.base]


def taken_type(method, argument, value, binding):
    sizes = words.fixed(value.extents)
    if value.kind == "splines":
        one = "Option<&Spline>" if may_miss(method, value) else "&Spline"
        return f"[{one}; {sizes[0]}]" if sizes else f"&[{one}]"
    if value.kind == "handles":
        return f"&[&{model.HANDLES[KINDS[value.base]]}]"
    if value.kind == "path":
        return "impl AsRef<Path>"
    if value.kind == "texts":
        return "&[&str]"
    if value.kind == "bytes":
        return "&[u8]"
    if value.kind == "options":
        return f"&{struct_type(value, binding)}"
    if value.kind == "array":
        if sizes and (argument.optional or not value.nullable):
            return f"&{words.nested(words.element(value), sizes)}"
        return f"&[{'usize' if is_size(method, value) else words.element(value)}]"
    return "usize" if is_size(method, value) else single_type(value)


def struct_type(value, binding):
    return next(record.key for record in binding.all_records.values() if record.struct == value.base)


# What comes back.


def result_type(method, binding):
    return "()" if method.result is None else pattern_type(method, method.result, binding)


def pattern_type(method, pattern, binding, in_rows=False):
    if isinstance(pattern, Struct):
        return binding.all_records[pattern.record].name("rust")
    if isinstance(pattern, Each):
        return f"Vec<{pattern_type(method, pattern.item, binding, True)}>"
    if isinstance(pattern, Several):
        kinds = [pattern_type(method, item, binding, in_rows) for item in pattern.items]
        return f"({', '.join(kinds)})" if pattern.bracket == "(" else f"[{kinds[0]}; {len(kinds)}]"
    value = method.values[pattern.name]
    if pattern.last:
        return words.nested(words.element(value), [pattern.last - pattern.first])
    if value.kind in model.HANDLES:
        return model.HANDLES[value.kind]
    if value.kind == "options":
        return struct_type(value, binding)
    if value.kind == "text":
        return "String"
    if value.kind == "array":
        return words.element(value) if in_rows else words.owned(value)
    return words.number(value, is_size(method, value))


def reached(method):
    """{parameter of the C function: Rust expression} of all that the caller gives."""
    found = {}
    for argument in method.arguments:
        pattern, own = argument.pattern, words.name(argument.name)
        if isinstance(pattern, Take):
            found[pattern.name] = own
        elif isinstance(pattern, Several):
            index = "{}[{}]" if pattern.bracket == "[" else "{}.{}"
            found.update((item.name, index.format(own, place)) for place, item in enumerate(pattern.items))
        elif isinstance(pattern, Struct):
            found.update((inner.name, f"{own}.{name}") for name, inner in pattern.fields)
        else:
            found.update((name, own) for name in by_names(pattern))
    return found


def by_names(pattern):
    """Of arrays in parts: the lengths and the arrays."""
    items = [pattern.item] if isinstance(pattern.item, Take) else pattern.item.items
    return [pattern.counts, *(item.name for item in items)]
