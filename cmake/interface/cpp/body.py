# SPDX-License-Identifier: MIT
"""The second half of a C++ body: room for the results, the call, and what is returned."""

import model
from signature import Several, Struct, Take

from . import parameters, words
from .inputs import Inputs, strides


class Body:
    """Of one method, or of the watched form of it. Each form gives the lines between the braces."""

    def __init__(self, method, binding, watched=False):
        self.method, self.binding, self.watched = method, binding, watched
        self.entry, self.values = method.entry, method.values
        self.function = self.entry.watched.name if watched else self.entry.name
        if watched and self.entry.packed:
            self.function = f"detail::{self.function}"
        self.inputs = Inputs(method, binding)
        self.terms = self.inputs.terms
        self.targets = {}  # output: C++ expressions that are passed for it
        self.before = ["const detail::Watch watch(call);"] if watched else []
        self.after = []

    # Forms.

    def returning(self):
        result = self.method.result
        if result is None:
            lines = [*self.before, f"return detail::call({self.call()});"]
            self.before = []
        elif isinstance(result, Struct):
            lines = self.record(result)
        elif isinstance(result, Several):
            lines = self.pair(result)
        else:
            lines = self.single(self.values[result.name])
        return self.inputs.locals.resolved([*self.inputs.statements, *self.before, *lines])

    def filling(self):
        """Writes to arrays of the caller."""
        for field, name, reached in self.caller_arrays():
            value = self.values[name]
            self.before.append(self.output_check(value, reached, field))
            pointer = f"detail::pointer({reached})" if value.nullable else f"{reached}.data()"
            self.targets[name] = [pointer] + (strides(reached, value) if value.strides else [])
        lines = [f"return detail::call({self.call()});"]
        return self.inputs.locals.resolved([*self.inputs.statements, *self.before, *lines])

    def filled(self):
        """Returns what the other form writes."""
        result = self.method.result
        name = self.method.name
        if isinstance(result, Take):
            value = self.values[result.name]
            lines = [f"std::vector<{words.element(value)}> values = {self.room(value)};",
                     self.run(name, ["values"]), "return values;"]
        else:
            lines = self.filled_record(result, name)
        return self.inputs.locals.resolved([*self.inputs.statements, *lines])

    def filled_record(self, result, name):
        fields = [f"found.{field}" for field, _ in result.fields]
        record = self.binding.all_records[result.record]
        arrays = [f"{{{', '.join(fields)}}}"] if record.outputs("cpp") else fields
        rooms = ", ".join(self.room(self.values[inner.name]) for _, inner in result.fields)
        return [f"{result.record} found{{{rooms}}};", self.run(name, arrays), "return found;"]

    def run(self, name, arrays):
        more = ", call" if self.watched else ""
        return f"detail::run([&] {{ return {name}({parameters.passed_on(self.method, arrays)}{more}); }});"

    # Arrays of the caller.

    def caller_arrays(self):
        """(name in messages, parameter, C++ expression)"""
        result = self.method.result
        if isinstance(result, Take):
            return [(result.name, result.name, result.name)]
        if self.binding.all_records[result.record].outputs("cpp"):
            return [(field, inner.name, f"out.{field}") for field, inner in result.fields]
        return [(inner.name, inner.name, inner.name) for _, inner in result.fields]

    def output_check(self, value, reached, what):
        n = self.terms.text(value.extents[0])
        if not value.strides:
            return f'detail::require_given({reached}, {self.terms.product(value.extents)}, "{what}");'
        width = self.terms.product(value.extents[1:])
        if value.nullable:
            return f'detail::require_wanted({reached}, {n}, {width}, "{what}");'
        return f'{reached}.require({n}, {width}, "{what}");'

    # One result.

    def single(self, value):
        if value in self.method.made:
            return [f"return {self.making(value)};"]
        if value.kind == "text":
            return self.text("return ", value)
        if value.kind == "number":
            return self.number(value)
        if words.fixed(value.extents) and not value.strides:
            self.targets[value.name] = ["v->data()"]
            return [f"return detail::result_of<{words.owned(value)}>([&](auto *v) {{ return {self.plain_call()}; }});"]
        self.targets[value.name] = ["values.data()"] + ["0"] * value.strides
        if self.method.is_counted:
            return [f"std::vector<{words.element(value)}> values;", *self.counted(), "return values;"]
        return [f"std::vector<{words.element(value)}> values = {self.room(value)};",
                f"detail::call({self.call()});", "return values;"]

    def number(self, value):
        self.targets[value.name] = ["v"]
        kind = words.SCALARS[value.base]
        result = f"detail::result_of<{kind}>([&](auto *v) {{ return {self.plain_call()}; }})"
        return [f"return {result}{' != 0' if value.truth else ''};"]

    def text(self, start, value):
        self.targets[value.name] = ["buf"]
        return [f"{start}detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {{ "
                f"return {self.plain_call()}; }});"]

    def pair(self, result):
        names = [item.name for item in result.items]
        for name in names:
            self.targets[name] = [f"&{name}"]
        handles = ", ".join(f"*{name} = nullptr" for name in names)
        return [f"nurbs {handles};", f"detail::call({self.call()});",
                f"return std::pair({', '.join(f'Spline({name})' for name in names)});"]

    # A record.

    def record(self, result):
        record = self.binding.all_records[result.record]
        kept = {name: words.owned(value) for name, _, value, _ in record.members("cpp")
                if value and value.kind == "array"}
        variable = self.variable()
        starts = [self.start(variable, field, inner, kept) for field, inner in result.fields]
        plain = all(start in ("{}", "0", "false") for start in starts)
        lines = [f"{result.record} {variable}{{{'' if plain else ', '.join(starts)}}};"]
        return [*lines, *self.before_call(), *self.calls(variable), *self.after, f"return {variable};"]

    def variable(self):
        taken = {argument.name for argument in self.method.arguments}
        return next(name for name in (("made", "result") if self.method.made else ("found", "result"))
                    if name not in taken)

    def before_call(self):
        lines, self.before = self.before, []
        return lines

    def start(self, variable, field, pattern, kept):
        """The first value of a field; notes where the library writes it."""
        value, target = self.values[pattern.name], f"{variable}.{field}"
        if not value.is_output:
            return self.inputs.names[value.name]
        if value in self.method.made:
            self.targets[value.name] = []
            return "{}"
        if value.kind == "text":
            return "{}"
        if value.kind == "options":
            self.targets[value.name] = [f"&{target}"]
            return "{}"
        if value.kind == "array":
            return self.start_array(variable, field, pattern, kept)
        return self.start_number(value, field, target)

    def start_number(self, value, field, target):
        self.targets[value.name] = [f"&{field}"]
        if value.truth:
            self.before.append(f"std::int32_t {field} = 0;")
            self.after.append(f"{target} = {field} != 0;")
            return "false"
        if value.base == "nurbs_status":
            self.before.append(f"nurbs_status {field} = NURBS_OK;")
            self.after.append(f"{target} = static_cast<Status>({field});")
            return "{}"
        self.targets[value.name] = [f"&{target}"]
        return "0"

    def start_array(self, variable, field, pattern, kept):
        value, target = self.values[pattern.name], f"{variable}.{field}"
        if pattern.last:
            return self.start_part(value, target, pattern)
        if value.unsigned:
            return self.start_unsigned(value, field, target)
        nested = kept.get(field, "").count("std::array") > 1
        pointer = f"detail::flat({target})" if nested else f"{target}.data()"
        self.targets[value.name] = [pointer] + ["0"] * value.strides
        if "std::vector" not in kept.get(field, "") or self.is_deferred(value):
            return "{}"
        return self.room(value)

    def start_part(self, value, target, pattern):
        local = value.name
        if value.name not in self.targets:
            self.targets[value.name] = [f"{local}.data()"]
            self.before.append(f"{words.array_of('double', [e.name for e in value.extents])} {local}{{}};")
        offset = f" + {pattern.first}" if pattern.first else ""
        self.after.append(f"std::copy_n({local}.begin(){offset}, {pattern.last - pattern.first}, {target}.begin());")
        return "{}"

    def start_unsigned(self, value, field, target):
        bits = f"{field}_bits"
        self.before.append(f"std::vector<{words.SCALARS[value.base]}> {bits};")
        self.targets[value.name] = [f"{bits}.data()"]
        self.after.append(f"{target}.assign({bits}.begin(), {bits}.end());")
        return "{}"

    # The call.

    def calls(self, variable):
        if self.entry.text.get("through"):
            return self.call_through()
        text = [value for value in self.values.values() if value.kind == "text"]
        if text:
            field = next(field for field, inner in self.method.result.fields if inner.name == text[0].name)
            return self.text(f"{variable}.{field} = ", text[0])
        if self.method.is_counted:
            return self.counted()
        made = self.method.made
        if made:
            field = next(field for field, inner in self.method.result.fields if inner.name == made[0].name)
            return [f"{variable}.{field} = {self.making(made[0])};"]
        return [f"detail::call({self.call()});"]

    def call_through(self):
        """centroid and inertia as arguments of a function that may leave them out."""
        arrays = [value for value in self.values.values() if value.is_output and value.kind == "array"]
        pointers = [self.targets[value.name][0] for value in arrays]
        spans = [pointer.removesuffix(".data()") if "flat" not in pointer else self.flat_span(value, pointer)
                 for value, pointer in zip(arrays, pointers)]
        for value in arrays:
            self.targets[value.name] = [value.name]
        names = ", ".join(f"double *{value.name}" for value in arrays)
        return [f"detail::call_{self.entry.text['through']}([&]({names}) {{ return {self.plain_call()}; }}, "
                f"{', '.join(spans)});"]

    def flat_span(self, value, pointer):
        return f"{{{pointer}, {self.terms.product(value.extents)}}}"

    def counted(self):
        """Asked for the number first, with cap = 0."""
        count = self.inputs.count_name()
        base = words.SCALARS[self.values[count].base]
        self.targets[count] = [f"&{count}"]
        call = self.call()
        rooms = [f"{self.targets[name][0].removesuffix('.data()')} = {self.room(self.values[name])};"
                 for name in self.method.returned if self.is_deferred(self.values[name])]
        return [f"{base} {count} = 0;", f"const auto ask = [&](std::int64_t cap) {{ detail::call({call}); }};",
                "ask(0);", *rooms, f"ask({count});"]

    def is_deferred(self, value):
        """Whether an array gets its room after a first call: all of them but those that lengths depend on."""
        if not self.method.is_counted or value.kind != "array" or not value.is_output:
            return False
        return not any(value.name in extent.names() for other in self.values.values() for extent in other.extents)

    def room(self, value):
        kind = words.SCALARS[value.base]
        extents = ", ".join(self.terms.text(extent) for extent in value.extents)
        if value.name in self.entry.text.get("space_only", ()):
            dim = self.terms.text(self.space_dimension())
            first, *others = (self.terms.text(extent) for extent in value.extents)
            extents = ", ".join([f"{dim} == 3 ? {first} : 0", *others])
        return f"detail::room{'' if kind == 'double' else f'<{kind}>'}({extents})"

    def space_dimension(self):
        return next(extent for value in self.values.values() for extent in value.extents if extent.name == "dim")

    def making(self, value):
        """The expression of a new Spline or List; the handle is the last argument."""
        return f"detail::made<{model.HANDLES[value.kind]}>({self.call(without=value)})"

    def call(self, without=None):
        """nurbs_x, argument, ..."""
        return ", ".join([self.function, *self.arguments(without)])

    def plain_call(self):
        return f"{self.function}({', '.join(self.arguments(None))})"

    def arguments(self, without):
        waiting = self.watched
        for value in self.values.values():
            if waiting and value.name == "out":
                yield "watch.get()"
                waiting = False
            if value is without:
                continue
            if value.kind in ("cap", "count") and value.name not in self.targets:
                yield value.name
            elif not value.is_output or value.parameter.direction == "in,out" and value.name not in self.targets:
                yield from self.inputs.passed(value)
            else:
                yield from self.targets.get(value.name, ["nullptr"])
        if waiting:
            yield "watch.get()"
