# SPDX-License-Identifier: MIT
"""The smoke test of Fortran: every good call through the modules, see smoke.py."""

import math
import re

import calls_model
import header
import smoke
from calls_model import Bytes, Handle, Handles, Items, Null, Number, Numbers
from calls_terms import Sizes
from fortran_methods.dummies import dummies
from fortran_methods.statements import statement
from fortran_methods.words import Words
from methods import KINDS
from model import HANDLES
from signature import Each, Several, Struct, Take

PATH = f"{smoke.FOLDER}/smoke_calls.f90"
NOTICE = f"""\
! SPDX-License-Identifier: MIT
! Generated from {calls_model.FOLDER}/*.toml, {header.PATH} and capi/bindings/table by: {header.COMMAND} - do not edit.
"""
ORDERS = {2: "[2, 1]", 3: "[2, 3, 1]"}


def real(value, kind):
    number = float(value.value)
    if math.isnan(number):
        return "ieee_value(0d0, ieee_quiet_nan)"
    if math.isinf(number):
        return f"ieee_value(0d0, ieee_{'positive' if number > 0 else 'negative'}_inf)"
    text = repr(number).replace("e", "d")
    return text if "d" in text else f"{text}d0"


class Writer:
    """Of one step: declarations and statements."""

    def __init__(self, step, words, model):
        self.step, self.words, self.model = step, words, model
        self.method, self.values = step.method, step.method.values
        self.sizes = Sizes(step.given, model.inputs)
        self.declared, self.before, self.after = [], [], []

    # Inputs.

    def number(self, value, item):
        if value.base in ("double", "float"):
            return real(item, value.base)
        number = item.value + self.words.is_index(value)
        if value.base == "uint32_t" and number >= 1 << 31:
            return f"int(z'{number:x}', c_int32_t)"
        wide = self.words.type_of(value) == "integer(c_int64_t)"
        text = f"{number}_c_int64_t" if wide else str(number)
        return f"({text})" if number < 0 else text

    def array(self, value, given):
        if not given.values:
            return f"[{self.words.type_of(value)} ::]"
        text = f"[{', '.join(self.number(value, item) for item in given.values)}]"
        rank = len(value.extents)
        if rank < 2:
            return text
        extents = self.extents(value, len(given.values))
        order = "" if value.name in self.words.stored else f", order={ORDERS[rank]}"
        return f"reshape({text}, [{', '.join(map(str, extents))}]{order})"

    def extents(self, value, length=None):
        """In Fortran's order, as numbers."""
        own = self.sizes.of(value.extents)
        if length is not None and math.prod(own) != length:
            own[0] = length // math.prod(own[1:])
        return own[::-1] if value.name in self.words.stored else own[:1] + own[:0:-1]

    def given(self, name, value, given):
        match given:
            case Number():
                return self.number(value, given)
            case Numbers():
                return self.array(value, given)
            case Handle():
                return given.name
            case Handles():
                return self.splines(name, list(given.names), value.base)
            case Items():
                return self.items(name, given)
            case Bytes():
                return f"{given.text}_text"
            case calls_model.Path():
                return f"written('smoke_calls_fortran.{given.text}', {given.text}_text)"
            case _:
                return self.options(name, given)

    def splines(self, name, names, base):
        self.declared.append(f"type(nurbs_{KINDS[base]}) :: {name}_given({len(names)})")
        self.before += [f"{name}_given({i + 1}) = {other}" for i, other in enumerate(names)]
        return f"{name}_given"

    def items(self, name, given):
        self.declared.append(f"type(nurbs_spline) :: {name}_given({given.count})")
        self.before += [f"call {given.list}%get({i + 1}, {name}_given({i + 1}))" for i in range(given.count)]
        return f"{name}_given"

    def options(self, name, given):
        self.declared.append(f"type({given.type}) :: {name}_given")
        fields = {field.name: (field, of) for field, of in smoke.fields_of(given, self.words.binding.manual)}
        if given.type == "nurbs_data":
            return self.data(name, fields)
        self.before.append(f"call default_{given.type.removeprefix('nurbs_')}({name}_given)")
        self.before += [f"{name}_given%{field.name} = {real(of, 'double') if field.base == 'double' else of.value}"
                        for field, of in fields.values()]
        return f"{name}_given"

    def data(self, name, fields):
        """Arrays of data have to stay as long as the struct."""
        n = fields["n"][1].value
        arguments = [f"{name}_given"]
        for field, of in fields.values():
            if not isinstance(of, Numbers):
                continue
            width, own = len(of.values) // n, f"{name}_{field.name}"
            shape = f"({n}, {width})" if field.name != "weights" else f"({n})"
            text = f"[{', '.join(real(item, 'double') for item in of.values)}]"
            rows = f"reshape({text}, [{n}, {width}], order=[2, 1])" if field.name != "weights" else text
            self.declared.append(f"real(c_double), target :: {own}{shape}")
            self.before.append(f"{own} = {rows}")
            arguments.append(f"{field.name}={own}")
        self.before.append(f"call data_for_fits({', '.join(arguments)})")
        return f"{name}_given"

    def several(self, dummy):
        items = dummy.argument.pattern.items
        return f"[{', '.join(self.number(self.values[item.name], self.step.given(item.name)) for item in items)}]"

    # Outputs.

    def output(self, dummy):
        """A variable, and how it is shown."""
        value, own = dummy.value, f"{dummy.name}_found"
        if dummy.kind in HANDLES:
            self.declared.append(f"type(nurbs_{dummy.kind}) :: {own}")
        elif dummy.kind == "options":
            self.declared.append(f"type({value.base}) :: {own}")
            return own
        elif dummy.kind == "text":
            self.declared.append(f"character(len=:), allocatable :: {own}")
        elif dummy.is_array:
            self.array_output(dummy, own)
        else:
            self.declared.append(f"{self.words.type_of(value)} :: {own}")
        self.show(own, value)
        return own

    def array_output(self, dummy, own):
        value = dummy.value
        rank = len(value.extents)
        self.declared.append(f"{self.words.type_of(value)}, allocatable :: {own}({', '.join(':' * rank)})")
        if not dummy.allocated:
            self.before.append(f"allocate ({own}({', '.join(map(str, self.extents(value)))}))")
        if value.parameter.direction == "in,out":
            self.before.append(f"{own} = 0")

    def show(self, text, value):
        rank = len(value.extents) if value.kind == "array" else 0
        one = " - 1" if self.words.is_index(value) else ""
        if rank > 1 and value.name not in self.words.stored:
            sizes = [f"size({text}, {k + 1})" for k in range(rank)]
            order = {2: "[2, 1]", 3: "[3, 1, 2]"}[rank]
            text = f"reshape({text}, [{', '.join([*sizes[1:], sizes[0]])}], order={order})"
        if rank > 1:
            text = f"flat({text})"
        self.after.append(f"call show('{value.name}', {text}{one})")

    def record(self, dummy):
        pattern, own = dummy.argument.pattern, f"{dummy.name}_found"
        several = isinstance(pattern, Each)
        inner = pattern.item if several else pattern
        kind = self.words.records[inner.record].name("fortran")
        self.declared.append(f"type({kind}){', allocatable' * several} :: {own}{'(:)' * several}")
        for name, part in inner.fields:
            self.after.append(f"call show('{part.name}', {own}%{name})")
        return own

    # The call.

    def arguments(self):
        for dummy, (_, absent) in zip(dummies(self.method), self.step.arguments()):
            if dummy.kind in ("record", "records"):
                yield dummy.name, self.record(dummy)
            elif dummy.kind == "several":
                if not absent:
                    yield dummy.name, self.several(dummy)
            elif dummy.value.is_output:
                if not (dummy.optional and isinstance(self.step.given(dummy.value.name), Null)):
                    yield dummy.name, self.output(dummy)
            else:
                given = self.step.given(dummy.value.name)
                if not isinstance(given, Null):
                    yield dummy.name, self.given(dummy.name, dummy.value, given)

    def statements(self, target=""):
        """target: the input that a step makes."""
        receiver = self.method.receiver
        texts = [f"{name}={text}" for name, text in self.arguments()]
        if self.step.watched:
            self.declared.append("type(nurbs_call) :: watching")
            texts.append("call=watching")
        owner = ""
        if receiver in self.values and not self.values[receiver].is_output:
            owner = f"{self.step.given(receiver).name}%"
        elif receiver:
            owner = f"{target or 'found'}%"
        return owner, f"{owner}{self.method.name}({', '.join(texts)})"

    def lines(self):
        owner, text = self.statements()
        if owner == "found%":
            self.declared.append(f"type(nurbs_{self.method.values['out'].kind}) :: found")
            self.after.append("call show('out', found)")
        if self.method.result is None:
            call = [f"call {text}"]
        else:
            self.show_result(text)
            call = []
        return self.declared, [*self.before, *call, *self.after]

    def show_result(self, text):
        value = self.values[self.method.result.name]
        one = " - 1" if self.words.is_index(value) else ""
        self.after.append(f"call show('{value.name}', {text}{one})")


def maker(step, entry, words, model):
    """Statements that make an input."""
    writer = Writer(step, words, model)
    owner, text = writer.statements(entry.name)
    if not owner.startswith(f"{entry.name}%"):
        text = re.sub(r"(\w+)=\1_found", rf"\1={entry.name}", text)
        writer.declared = [line for line in writer.declared if not line.endswith("_found")]
    return writer.declared, [*writer.before, f"call {text}"]


def block(step, planner, words, model):
    declared, statements = [], []
    for name in step.call.made:
        entry = model.inputs[name]
        declared.append(f"type(nurbs_{KINDS[entry.kind]}) :: {name}")
        inner = planner.step(entry.call)
        if inner is None:  # nurbs_clone() is assignment
            statements.append(f"{name} = {entry.call.value('g').name}")
            continue
        own, made = maker(inner, entry, words, model)
        declared += own
        statements += made
    own, rest = Writer(step, words, model).lines()
    yield f"call begin('{step.call.name}')"
    yield "block"
    yield from (f"    {line}" for line in [*declared, *own, *statements, *rest])
    yield "end block"


def literal(name, text):
    lines = [f"'{line.replace(chr(39), chr(39) * 2)}'//new_line('a')" for line in text.splitlines()]
    yield f"    character(len=*), parameter :: {name}_text = &"
    yield from (f"        {line}//&" for line in lines[:-1])
    yield f"        {lines[-1]}"


def data_literal(name, data):
    """In parts, since a statement may have no more than 255 lines."""
    parts = []
    for first in range(0, len(data), 1600):
        part = data[first:first + 1600]
        rows = ["//".join(f"char({byte})" for byte in part[i:i + 8]) for i in range(0, len(part), 8)]
        parts.append(f"{name}_part_{len(parts) + 1}")
        yield f"    character(len=*), parameter :: {parts[-1]} = &"
        yield from (f"        {row}//&" for row in rows[:-1])
        yield f"        {rows[-1]}"
    yield f"    character(len=*), parameter :: {name}_text = {'//'.join(parts)}"


def files(binding, model):
    words, planner = Words(binding), smoke.Planner(binding, "fortran")
    plan = smoke.plan(binding, model, "fortran")
    shared = [(step, entry) for step, entry in zip(plan.inputs, model.inputs.values()) if entry.shared]
    lines = [NOTICE + "program smoke_calls", "    use, intrinsic :: iso_c_binding", "    use, intrinsic :: ieee_arithmetic",
             "    use nurbs", "    use smoke_support", "    implicit none"]
    for name, text in model.texts.items():
        lines += literal(name, text) if isinstance(text, str) else data_literal(name, text)
    lines += [f"    type(nurbs_{KINDS[entry.kind]}) :: {entry.name}" for _, entry in shared]
    made = [maker(step, entry, words, model) for step, entry in shared]
    # Several handles may be made with options of one kind.
    lines += [f"    {line}" for line in dict.fromkeys(line for declared, _ in made for line in declared)]
    lines.append("")
    for _, statements in made:
        for text in statements:
            lines += statement(text, 1)
    lines += [f"    call calls_of_{name}()" for name in plan.groups]
    lines += ["", "contains"]
    for name, steps in plan.groups.items():
        lines += ["", f"    subroutine calls_of_{name}()"]
        for step in steps:
            texts = [f"call by_hand('{step}')"] if isinstance(step, str) else block(step, planner, words, model)
            for text in texts:
                lines += statement(text, 2, 2)
        lines.append(f"    end subroutine calls_of_{name}")
    return {PATH: "\n".join([*lines, "", "end program smoke_calls", ""])}
