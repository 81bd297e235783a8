# SPDX-License-Identifier: MIT
"""Rust structs: results, settings, and arrays of the caller that are filled."""

import re

from signature import By, Each, Several, Struct, Take

import rust_types as types
import rust_words as words

VALUES = {"infinity": "f64::INFINITY", "-infinity": "f64::NEG_INFINITY", "{}": "&[]"}


def lines(record, binding):
    yield from struct(record, binding)
    if record.outputs("rust"):
        yield ""
        yield from outputs(record)


def is_input(record):
    return not any(is_result for _, _, is_result in record.uses["rust"])


def struct(record, binding):
    members = [(name, text, kind(record, field, value, pattern, binding))
               for field, (name, text, value, pattern) in zip(fields_of(record), record.members("rust"))]
    kinds = [kind_ for _, _, kind_ in members]
    has_default = is_input(record) and set(record.defaults.values()) - {0, "{}"}
    yield from words.comment(record.options.get("rust", {}).get("doc", record.doc))
    yield f"#[derive({', '.join(derived(kinds, binding, bool(has_default)))})]"
    if all(is_result for _, _, is_result in record.uses["rust"]):
        yield "#[non_exhaustive]"
    yield f"pub struct {record.name('rust')}{lifetime(kinds)} {{"
    for name, text, kind_ in members:
        yield from words.comment(text, "    ")
        yield f"    pub {name}: {kind_},"
    yield "}"
    if has_default:
        yield ""
        yield from default(record, members)


def fields_of(record):
    return [name for name, _ in record.uses["rust"][0][1].fields]


def lifetime(kinds):
    return "<'a>" if any("'a" in kind_ for kind_ in kinds) else ""


def derived(kinds, binding, has_default):
    """What all fields can: nothing that holds a Vec is copied, nothing that holds a spline has a default."""
    text = " ".join(kinds)
    handles = re.search(r"\b(Spline|List|Statistics|Face)\b", text)
    if "List" in text:
        return ["Debug"]
    yes = ["Clone"]
    if "Face" in text:
        return [*yes, "Debug"]
    if not re.search(r"Vec|String|(?<!&'a )\bSpline", text):
        yes.append("Copy")
    yes.append("Debug")
    if not handles and not has_default:
        yes.append("Default")
    if not re.search("f32|f64", text) and not handles and not any(is_record(word, binding) for word in re.findall(r"\w+", text)):
        yes.append("Eq")
    return [*yes, "PartialEq"]


def is_record(word, binding):
    return any(record.name("rust") == word for record in binding.all_records.values())


def default(record, members):
    """Where the derived one would not do."""
    yield f"impl Default for {record.name('rust')}{lifetime([kind_ for _, _, kind_ in members]).replace('a', '_')} {{"
    yield "fn default() -> Self {"
    starts = [f"{name}: {initial(record.defaults.get(name), kind_)}" for name, _, kind_ in members]
    yield f"{record.name('rust')} {{ {', '.join(starts)} }}"
    yield "}"
    yield "}"


def initial(value, kind_):
    if value is None:
        value = "{}" if kind_.startswith("&") else 0
    value = VALUES.get(str(value), str(value))
    return f"{value}.0" if kind_ == "f64" and re.fullmatch(r"-?\d+", value) else value


def kind(record, field, value, pattern, binding):
    method, use, _ = record.uses["rust"][0]
    if is_input(record):
        return input_kind(record, field, value)
    return types.pattern_type(method, pattern, binding, is_row(method.result, use))


def is_row(pattern, wanted, inside=False):
    """Whether it is made of the elements of arrays."""
    if pattern is wanted:
        return inside
    if isinstance(pattern, Each):
        return is_row(pattern.item, wanted, True)
    if isinstance(pattern, Struct):
        return any(is_row(inner, wanted, inside) for _, inner in pattern.fields)
    if isinstance(pattern, Several):
        return any(is_row(inner, wanted, inside) for inner in pattern.items)
    return not isinstance(pattern, (Take, By)) and inside


def input_kind(record, field, value):
    if value.kind == "number":
        return words.SCALARS[value.base]
    size = words.fixed(value.extents)
    kind_ = f"[&'a Spline; {size[0]}]" if value.kind == "splines" else f"&'a [{words.element(value)}]"
    return f"Option<{kind_}>" if value.nullable and field not in record.defaults else kind_


def outputs(record):
    """Arrays of the caller."""
    yield "/// Where they are written; those that are `None` are not wanted."
    yield "#[derive(Debug, Default)]"
    yield f"pub struct {record.outputs('rust')}<'a> {{"
    for name, text, value, _ in record.members("rust"):
        yield from words.comment(text, "    ")
        array = "RecordsMut<'a>" if value.strides else f"&'a mut [{words.element(value)}]"
        yield f"    pub {name}: Option<{array}>,"
    yield "}"
