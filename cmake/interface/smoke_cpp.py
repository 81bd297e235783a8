# SPDX-License-Identifier: MIT
"""The smoke test of C++: every good call through the wrapper, see smoke.py."""

import math

import calls_model
import header
import smoke
from calls_model import Bytes, Handle, Handles, Items, Null, Number, Numbers
from cpp import parameters, words
from signature import Several, Struct, Take

PATH = f"{smoke.FOLDER}/smoke_calls.cpp"
NOTICE = f"""\
// SPDX-License-Identifier: MIT
// Generated from {calls_model.FOLDER}/*.toml, {header.PATH} and capi/bindings/table by: {header.COMMAND} - do not edit.
// clang-format off
#include "smoke_support.hpp"

namespace {{

namespace n = libnurbs;
"""


def number(value, base):
    """A literal of the type `base`."""
    if base not in ("double", "float"):
        return f"{value.value}u" if base == "uint32_t" else str(value.value)
    number = float(value.value)
    if math.isnan(number):
        return "nan_value"
    return repr(number) if math.isfinite(number) else "infinity" if number > 0 else "-infinity"


def numbers(value, base):
    return ", ".join(number(item, base) for item in value.values)


class Writer:
    """Of one step."""

    def __init__(self, step, binding, model, given="in."):
        """given: before the names of inputs that are shared."""
        self.step, self.binding, self.model, self.given = step, binding, model, given
        self.method = step.method
        self.before = []

    def spline(self, name):
        return f"{self.given}{name}" if self.model.inputs[name].shared else name

    # Arguments.

    def arguments(self):
        found = self.step.arguments()
        while found and found[-1][1] and not self.step.watched:
            found.pop()
        texts = [absent_text(argument) if absent else self.argument(argument) for argument, absent in found]
        return texts + ["watched()"] * self.step.watched

    def argument(self, argument):
        pattern = argument.pattern
        if isinstance(pattern, Struct):
            return self.record(argument.name, pattern)
        if isinstance(pattern, Several):
            base = self.method.values[pattern.items[0].name].base
            return f"{{{', '.join(number(self.step.given(item.name), base) for item in pattern.items)}}}"
        return self.value(argument, self.method.values[pattern.name])

    def record(self, name, pattern):
        self.before.append(f"n::{pattern.record} {name};")
        for field, inner in pattern.fields:
            given = self.step.given(inner.name)
            if not isinstance(given, Null):
                self.before.append(f"{name}.{field} = {self.plain(self.method.values[inner.name], given)};")
        return name

    def value(self, argument, value):
        given = self.step.given(value.name)
        if isinstance(given, Null):
            return "{}"
        if value.kind == "options":
            return self.options(argument.name, given)
        if value.kind == "path":
            return f"{given.text}_path()"
        kind = parameters.array_type(self.method, argument, value) if value.kind == "array" else ""
        if "std::array" in kind:
            exact = words.array_of(words.SCALARS[value.base], words.fixed(value.extents))
            return f"{exact}{{{numbers(given, value.base)}}}"
        return self.plain(value, given)

    def options(self, name, given):
        record = next(record for record in self.binding.all_records.values() if record.struct == given.type)
        self.before.append(f"n::{record.key} {name};")
        for field, of in smoke.fields_of(given, self.binding.manual):
            if isinstance(of, Numbers):
                array = f"{name}_{field.name}"
                self.before.append(f"static constexpr {words.SCALARS[field.base]} {array}[] = {{{numbers(of, field.base)}}};")
                self.before.append(f"{name}.{field.name} = {array};")
            else:
                self.before.append(f"{name}.{field.name} = {number(of, field.base)};")
        return name

    def plain(self, value, given):
        match given:
            case Number():
                return number(given, value.base)
            case Numbers():
                return f"{{{numbers(given, value.base)}}}"
            case Handle():
                return self.spline(given.name)
            case Handles():
                return self.splines(value, [self.spline(name) for name in given.names])
            case Items():
                return self.splines(value, [f"{self.spline(given.list)}[{i}]" for i in range(given.count)])
            case Bytes():
                return f"std::as_bytes(std::span({given.text}))"

    def splines(self, value, texts):
        kind = "std::array" if words.fixed(value.extents) else f"std::vector<n::{smoke.class_of(value.base)}>"
        size = f"<n::Spline, {len(texts)}>" if kind == "std::array" else ""
        return f"{kind}{size}{{{', '.join(texts)}}}"

    # The call.

    def call(self):
        name, receiver = self.method.name, self.method.receiver
        given = ", ".join(self.arguments())
        if receiver in self.method.values and not self.method.values[receiver].is_output:
            return f"{self.spline(self.step.given(receiver).name)}.{name}({given})"
        owner = {"out": "n::Spline::"}.get(receiver, f"n::{receiver}::" if receiver else "n::")
        return f"{owner}{name}({given})"

    def shown(self):
        """(expression, parameter) of what comes back."""
        yield from shown("found", self.method.result)

    def lines(self):
        call = self.call()
        yield from self.before
        if self.method.result is None:
            yield f"{call};"
            return
        yield f"const auto found = {call};"
        for expression, parameter in self.shown():
            if self.method.values[parameter].kind == "options":
                continue
            yield f'show("{parameter}", {expression});'


def absent_text(argument):
    if argument.default is None:
        return "{}"
    text = words.default(argument.default)
    return f"n::{text}" if text.isidentifier() else text


def shown(expression, pattern):
    if isinstance(pattern, Take):
        yield expression, pattern.name
    elif isinstance(pattern, Struct):
        for field, inner in pattern.fields:
            yield from shown(f"{expression}.{field}", inner)
    else:
        for member, inner in zip(("first", "second"), pattern.items):
            yield from shown(f"{expression}.{member}", inner)


def made(step, binding, model, given="in."):
    """Expression of an input, and what stands before it."""
    writer = Writer(step, binding, model, given)
    call = writer.call()
    return writer.before, call


def block(step, binding, model):
    yield "{"
    yield f'    begin("{step.call.name}");'
    for name in step.call.made:
        inner = next(entry for entry in model.inputs.values() if entry.name == name)
        before, call = made(smoke.Planner(binding, "cpp").step(inner.call), binding, model)
        yield from ("    " + line for line in before)
        yield f"    const n::{smoke.class_of(inner.kind)} {name} = {call};"
    yield from ("    " + line for line in Writer(step, binding, model).lines())
    yield "}"


def inputs(plan, binding, model):
    yield "struct Inputs {"
    for step, entry in zip(plan.inputs, model.inputs.values()):
        if entry.shared:
            before, call = made(step, binding, model, "")
            if before:
                call = f"[&] {{ {' '.join(before)} return {call}; }}()"
            yield f"    n::{smoke.class_of(entry.kind)} {entry.name} = {call};"
    yield "};"


def texts(model, calls):
    """Contents of files, and the files of those that calls name by a path."""
    for name, text in model.texts.items():
        if isinstance(text, bytes):
            yield from (f"constexpr unsigned char {name}[] = {{{', '.join(map(str, text))}}};", "")
            continue
        yield from (f"const std::string {name} = R\"({text})\";", "")
        if f"{name}_path()" in calls:
            yield from (f"std::string {name}_path() {{", f"    return written(\"smoke_calls_cpp.{name}\", {name});", "}", "")


def files(binding, model):
    plan = smoke.plan(binding, model, "cpp")
    lines = [*inputs(plan, binding, model), ""]
    for name, steps in plan.groups.items():
        lines.append(f"void {name}(const Inputs &in) {{")
        for step in steps:
            if isinstance(step, str):
                lines.append(f'    by_hand("{step}");')
            else:
                lines += ["    " + line for line in block(step, binding, model)]
        lines += ["}", ""]
    lines += ["} // namespace", "", "int main() {", "    const Inputs in;"]
    lines += [f"    {name}(in);" for name in plan.groups]
    lines += ["    return 0;", "}", ""]
    calls = "\n".join(lines)
    return {PATH: "\n".join([NOTICE, *texts(model, calls), calls])}
