# SPDX-License-Identifier: MIT
"""The smoke test of Rust: every good call through the crate, see smoke.py."""

import math

import calls_model
import header
import rust_types as types
import rust_words as words
import smoke
from calls_model import Bytes, Handle, Handles, Items, Null, Number, Numbers
from rust_records import is_input
from signature import By, Each, Several, Struct, Take

PATH = f"{smoke.FOLDER}/smoke_calls.rs"
NOTICE = f"""\
// SPDX-License-Identifier: MIT
// Generated from {calls_model.FOLDER}/*.toml, {header.PATH} and capi/bindings/table by: {header.COMMAND} - do not edit.
//! Every good call, see smoke_reference.cpp.

#[path = "../smoke_support.rs"]
mod smoke_support;

use nurbs::{{Call, Face, List, Meet, Mesh, Model, Spline, Statistics}};
use smoke_support::{{begin, by_hand, show, written}};
"""


def number(value, base):
    if base not in ("double", "float"):
        return str(value.value)
    number = float(value.value)
    if math.isnan(number):
        return "f64::NAN"
    return repr(number) if math.isfinite(number) else f"f64::{'' if number > 0 else 'NEG_'}INFINITY"


def listed(items, base):
    return f"[{', '.join(number(item, base) for item in items)}]"


def own(name):
    """The name of an input, of which some are words of Rust."""
    return f"r#{name}" if name == "loop" else name


def nested(items, sizes):
    """Texts in arrays of the sizes."""
    for size in reversed(sizes[1:]):
        items = [f"[{', '.join(items[i:i + size])}]" for i in range(0, len(items), size)]
    return f"[{', '.join(items)}]"


class Writer:
    """Of one step."""

    def __init__(self, step, binding, model, given="given."):
        """given: before the names of inputs that are shared."""
        self.step, self.binding, self.model, self.given = step, binding, model, given
        self.method = step.method

    def spline(self, name):
        return f"{self.given}{own(name)}" if self.model.inputs[name].shared else own(name)

    # Arguments.

    def arguments(self):
        texts = [self.argument(argument) for argument in self.method.arguments]
        return texts + ["&mut Call::new().progress(|_| true)"] * self.step.watched

    def argument(self, argument):
        pattern = argument.pattern
        if isinstance(pattern, By):
            return self.by_axis(pattern)
        if isinstance(pattern, Several):
            return self.several(pattern)
        if isinstance(pattern, Struct):
            return self.record(pattern)
        value = self.method.values[pattern.name]
        given = self.step.given(pattern.name)
        if isinstance(given, Null):
            return "None" if argument.optional else "&[]"
        text = self.value(value, given)
        return f"Some({text})" if argument.optional else text

    def by_axis(self, pattern):
        names = types.by_names(pattern)[1:]
        rows, rests = [], {name: list(self.step.given(name).values) for name in names}
        for length in self.lengths(pattern, names):
            parts = [f"&{self.part(name, rests[name], length)}" for name in names]
            rows.append(parts[0] if isinstance(pattern.item, Take) else f"({', '.join(parts)})")
        return f"&[{', '.join(rows)}]"

    def lengths(self, pattern, names):
        """Of the arrays of the axes; those of knots follow from the control points."""
        counts = [count.value for count in self.step.given(pattern.counts).values]
        if names != ["knots"]:
            return counts
        return [count + degree.value + 1 for count, degree in zip(counts, self.step.given("degrees").values)]

    def part(self, name, rest, count):
        first, rest[:count] = rest[:count], []
        return listed(first, self.method.values[name].base)

    def several(self, pattern):
        texts = [self.value(self.method.values[item.name], self.step.given(item.name)) for item in pattern.items]
        brackets = "()" if pattern.bracket == "(" else "[]"
        return f"{brackets[0]}{', '.join(texts)}{brackets[1]}"

    def record(self, pattern):
        record = self.binding.all_records[pattern.record]
        texts = [text for field, inner in pattern.fields for text in self.field(record, field, inner)]
        rest = [] if len(texts) == len(record.uses["rust"][0][1].fields) else ["..Default::default()"]
        by_reference = any(is_result for _, _, is_result in record.uses["rust"])
        return f"{'&' * by_reference}nurbs::{record.name('rust')} {{ {', '.join(texts + rest)} }}"

    def field(self, record, field, inner):
        """field: value; none where it has a default."""
        given, value = self.step.given(inner.name), self.method.values[inner.name]
        made = not is_input(record) and value.kind != "number"
        optional = (is_input(record) and not record.by_hand and value.kind != "number" and value.nullable
                    and field not in record.defaults)
        if not isinstance(given, Null):
            text = f"vec!{self.array(value, given)}" if made else self.value(value, given)
            yield f"{field}: Some({text})" if optional else f"{field}: {text}"
        elif optional:
            yield f"{field}: None"

    def value(self, value, given):
        match given:
            case Number():
                return number(given, value.base)
            case Numbers():
                return f"&{self.array(value, given)}"
            case Handle():
                return f"&{self.spline(given.name)}"
            case Handles():
                some = "Some({})" if types.may_miss(self.method, value) else "{}"
                return self.splines(value, [some.format(f"&{self.spline(name)}") for name in given.names])
            case Items():
                return self.splines(value, [f"&{self.spline(given.list)}.get({i})?" for i in range(given.count)])
            case Bytes():
                text = self.model.texts[given.text]
                return f"{given.text.upper()}{'.as_bytes()' * isinstance(text, str)}"
            case calls_model.Path():
                return f'written("smoke_calls_rust.{given.text}", {given.text.upper()})'
            case _:
                return getattr(self, given.type)({field.name: (field, of) for field, of
                                                  in smoke.fields_of(given, self.binding.manual)})

    # Structs, of which the crate has types of its own.

    def nurbs_read_options(self, fields):
        return "&nurbs::ReadOptions::new()?" + "".join(f".{name}({number(of, field.base)})"
                                                      for name, (field, of) in fields.items())

    def nurbs_write_options(self, fields):
        return "&nurbs::WriteOptions::new()?" + "".join(f".{name}({number(of, field.base)})"
                                                       for name, (field, of) in fields.items())

    def nurbs_fit_options(self, fields):
        rule = fields["smoothing"][1].value
        factor = fields.get("lambda", fields.get("target", (None, Number(0.0))))[1]
        order = f".penalty_order({fields['penalty_order'][1].value})" if "penalty_order" in fields else ""
        return f"&nurbs::FitOptions::new()?.smoothing({rule}, {number(factor, 'double')}){order}"

    def nurbs_cloud_options(self, fields):
        return "&nurbs::CloudOptions::new()?" + "".join(f".{name}({number(of, field.base)})"
                                                        for name, (field, of) in fields.items())

    def nurbs_mesh_options(self, fields):
        return "&nurbs::MeshOptions::new()?" + "".join(f".{name}({number(of, field.base)})"
                                                       for name, (field, of) in fields.items())

    def nurbs_data(self, fields):
        arrays = {name: f"&{listed(of.values, field.base)}" for name, (field, of) in fields.items() if isinstance(of, Numbers)}
        weights = f".weights({arrays['weights']})?" if "weights" in arrays else ""
        sizes = f"{fields['axes'][1].value}, {fields['dim'][1].value}"
        return f"&nurbs::Data::new({sizes}, {arrays['params']}, {arrays['values']})?{weights}"

    def array(self, value, given):
        texts = [number(item, value.base) for item in given.values]
        sizes = words.fixed(value.extents)
        exact = sizes and not (value.nullable and not self.is_option(value)) and not value.strides
        return nested(texts, sizes) if exact else f"[{', '.join(texts)}]"

    def is_option(self, value):
        return any(argument.optional for argument in self.method.arguments
                   if getattr(argument.pattern, "name", "") == value.name)

    def splines(self, value, texts):
        return f"{'' if words.fixed(value.extents) else '&'}[{', '.join(texts)}]"

    # The call.

    def call(self):
        name = self.method.name + "_with" * self.step.watched
        receiver, given = self.method.receiver, ", ".join(self.arguments())
        if receiver in self.method.values and not self.method.values[receiver].is_output:
            return f"{self.spline(self.step.given(receiver).name)}.{name}({given})?"
        return f"{receiver or 'nurbs'}::{name}({given})?"

    def lines(self):
        call = self.call()
        if self.method.result is None:
            yield f"{call};"
        else:
            yield f"let found = {call};"
            yield from shown("found", self.method.result, self.binding, self.method)


def shown(expression, pattern, binding, method):
    if isinstance(pattern, Take):
        if method.values[pattern.name].kind != "options":
            yield f'show("{pattern.name}", &{expression});'
    elif isinstance(pattern, Each):
        yield f"for row in &{expression} {{"
        yield from ("    " + line for line in shown("row", pattern.item, binding, method))
        yield "}"
    else:
        for member, inner in members(pattern, binding):
            yield from shown(expression + member, inner, binding, method)


def members(pattern, binding):
    if isinstance(pattern, Struct):
        record = binding.all_records[pattern.record]
        return [(f".{record.renamed('rust', field)}", inner) for field, inner in pattern.fields]
    index = "[{}]" if pattern.bracket == "[" else ".{}"
    return [(index.format(i), inner) for i, inner in enumerate(pattern.items)]


def block(step, binding, model):
    yield f'begin("{step.call.name}");'
    yield "{"
    for name in step.call.made:
        inner = smoke.Planner(binding, "rust").step(model.inputs[name].call)
        yield f"    let {own(name)} = {Writer(inner, binding, model).call()};"
    yield from ("    " + line for line in Writer(step, binding, model).lines())
    yield "}"


def inputs(plan, binding, model):
    shared = [(step, entry) for step, entry in zip(plan.inputs, model.inputs.values()) if entry.shared]
    yield "struct Given {"
    for _, entry in shared:
        yield f"    {own(entry.name)}: {smoke.class_of(entry.kind)},"
    yield "}"
    yield ""
    yield "fn given() -> nurbs::Result<Given> {"
    yield from (f"    let {own(entry.name)} = {Writer(step, binding, model, '').call()};" for step, entry in shared)
    yield "    Ok(Given {"
    yield from (f"        {own(entry.name)}," for _, entry in shared)
    yield "    })"
    yield "}"


def files(binding, model):
    plan = smoke.plan(binding, model, "rust")
    lines = [NOTICE]
    lines += [f"const {name.upper()}: &str = r#\"{text}\"#;\n" if isinstance(text, str) else
              f"const {name.upper()}: &[u8] = &[{', '.join(map(str, text))}];\n" for name, text in model.texts.items()]
    lines += [*inputs(plan, binding, model), ""]
    for name, steps in plan.groups.items():
        lines.append(f"fn {name}(given: &Given) -> nurbs::Result<()> {{")
        for step in steps:
            written = [f'by_hand("{step}");'] if isinstance(step, str) else block(step, binding, model)
            lines += ["    " + line for line in written]
        lines += ["    Ok(())", "}", ""]
    lines += ["fn main() -> nurbs::Result<()> {", "    let given = given()?;"]
    lines += [f"    {name}(&given)?;" for name in plan.groups]
    lines += ["    Ok(())", "}", ""]
    return {PATH: "\n".join(lines)}
