# SPDX-License-Identifier: MIT
"""The parameter list of a C++ function, and how its body reaches what the caller gave."""

import model
from methods import KINDS
from signature import Several, Struct, Take

from . import words


def is_records(method, value):
    """Whether it is taken with strides."""
    return value.strides > 0 and value.name not in method.entry.text.get("packed", ())


def taken_type(method, argument, value, binding):
    """Type of an argument that is one parameter of the C function."""
    if value.kind in model.HANDLES:
        return f"const {model.HANDLES[value.kind]} &"
    if value.kind == "handles":
        return f"std::span<const {model.HANDLES[KINDS[value.base]]}> "
    if value.kind == "splines":
        return several_splines(argument, value, binding)
    if value.kind == "path":
        return "const std::string &"
    if value.kind == "texts":
        return "std::span<const std::string> "
    if value.kind == "bytes":
        return "std::span<const std::byte> "
    if value.kind == "options":
        return f"const {words.struct_type(value, binding)} &"
    if value.kind == "number":
        return words.SCALARS[value.base] + " "
    return array_type(method, argument, value)


def several_splines(argument, value, binding):
    sizes = words.fixed(value.extents)
    if not sizes:
        return "std::span<const Spline> "
    alias = next(record.key for record in binding.all_records.values() if record.splines == sizes[0])
    return f"const std::optional<{alias}> &" if argument.optional else f"const {alias} &"


def array_type(method, argument, value):
    if is_records(method, value):
        return words.RECORDS[value.base][0] + " "
    sizes = words.fixed(value.extents)
    if sizes and value.base == "double" and (argument.optional or not value.nullable):
        kind = words.array_of(words.SCALARS[value.base], sizes)
        return f"const std::optional<{kind}> &" if argument.optional else f"const {kind} &"
    return f"View<{words.SCALARS[value.base]}> "


def declared(method, argument, binding, with_default):
    """double relative_tolerance = 0"""
    pattern = argument.pattern
    if isinstance(pattern, Struct):
        kind = f"{pattern.record} " if is_small(method, pattern) else f"const {pattern.record} &"
    elif isinstance(pattern, Several):
        first = method.values[pattern.items[0].name]
        kind = f"const {words.array_of(words.SCALARS[first.base], [len(pattern.items)])} &"
    else:
        kind = taken_type(method, argument, method.values[pattern.name], binding)
    text = f"{kind}{argument.name}"
    return f"{text} = {words.default(argument.default)}" if with_default and argument.default is not None else text


def is_small(method, pattern):
    """A record of two numbers is passed by its value."""
    values = [method.values[inner.name] for _, inner in pattern.fields]
    return len(values) <= 2 and all(value.kind == "number" for value in values)


def outputs(method, binding):
    """What the form that writes to arrays of the caller takes besides: [(type, name)]."""
    if isinstance(method.result, Struct):
        record = binding.all_records[method.result.record]
        if record.outputs("cpp"):
            return [(f"const {record.outputs('cpp')} &", "out")]
    return [(words.RECORDS[method.values[name].base][1] + " ", name) for name in method.returned]


def listed(method, binding, fills, with_defaults=True):
    """The declarations of all parameters; arrays to be filled come before the first default."""
    texts = [declared(method, argument, binding, with_defaults) for argument in method.arguments]
    if fills:
        place = next((i for i, argument in enumerate(method.arguments) if argument.default is not None), len(texts))
        texts[place:place] = [kind + name for kind, name in outputs(method, binding)]
    return texts


def passed_on(method, fills_with):
    """The arguments of a call of the other form: those of this one, and the arrays that are filled."""
    names = [argument.name for argument in method.arguments]
    place = next((i for i, argument in enumerate(method.arguments) if argument.default is not None), len(names))
    return ", ".join(names[:place] + fills_with + names[place:])


def reached(method):
    """{parameter of the C function: C++ expression} of all that the caller gives, other than shapes' places."""
    found = {}
    for argument in method.arguments:
        pattern = argument.pattern
        if isinstance(pattern, Take):
            found[pattern.name] = argument.name
        elif isinstance(pattern, Several):
            found.update((item.name, f"{argument.name}[{i}]") for i, item in enumerate(pattern.items))
        else:
            found.update((inner.name, f"{argument.name}.{field}") for field, inner in pattern.fields)
    return found


def may_lack(method, records):
    """Names of the parameters that may be left out: NULL is allowed, and the argument or the field has a default."""
    for argument in method.arguments:
        pattern = argument.pattern
        if isinstance(pattern, Take) and (argument.optional or argument.default is not None):
            yield pattern.name
        elif isinstance(pattern, Struct):
            defaults = records[pattern.record].defaults
            yield from (inner.name for field, inner in pattern.fields if field in defaults)


def optional_arrays(method):
    """Names of the parameters that come as std::optional of an array."""
    return {argument.pattern.name for argument in method.arguments
            if argument.optional and isinstance(argument.pattern, Take)
            and words.fixed(method.values[argument.pattern.name].extents)
            and method.values[argument.pattern.name].kind == "array"
            and not is_records(method, method.values[argument.pattern.name])}
