# SPDX-License-Identifier: MIT
"""The good calls of tests/capi/calls as calls of the methods of a language, for smoke tests that are generated.

    plan = smoke.plan(binding, model, language)
    plan.inputs           [Step, ...], what the calls are given; step.call.name is the name of the input
    plan.groups           {name: [Step or str, ...]}, a str being the name of a call that has no method: by hand

    step.method           model.Method
    step.watched          whether its form with options of long calls is meant
    step.given(name)      the value of a parameter of the C function, see calls_model.py
    step.arguments()      [(signature.Argument, whether it is left out), ...]

Every program prints what its calls return, as tests/bindings/compare_smoke.py describes it.
"""

from dataclasses import dataclass

from calls_model import NewHandle, Null, Number, Packed, Slot
from methods import KINDS
from model import HANDLES
import signature

FOLDER = "tests/bindings/generated"


class SmokeError(Exception):
    """A call cannot be made in a language."""


@dataclass
class Step:
    call: object
    method: object
    watched: bool
    values: dict

    def given(self, name):
        """A struct that packs arguments has no numbers that are 0."""
        absent = Number(0) if name in self.method.values and self.method.values[name].kind == "number" else Null()
        return self.values.get(name, absent)

    def lacks(self, pattern):
        """Whether nothing is given for any parameter of a pattern."""
        return all(isinstance(self.given(name), Null) for name in signature.taken(pattern))

    def arguments(self):
        return [(argument, (argument.optional or argument.default is not None) and self.lacks(argument.pattern))
                for argument in self.method.arguments]


@dataclass
class Plan:
    inputs: list
    groups: dict

    def steps(self):
        yield from self.inputs
        yield from (step for steps in self.groups.values() for step in steps if isinstance(step, Step))


class Planner:
    def __init__(self, binding, language):
        self.language = language
        self.plain = {entry.name: entry for entry in binding.entries}
        self.watched = {entry.watched.name: entry for entry in binding.entries if entry.watched}

    def step(self, call):
        """None where the language has no method."""
        name = call.function.name
        watched = name in self.watched
        entry = self.watched[name] if watched else self.plain[name]
        methods = entry.methods.get(self.language)
        if not methods:
            return None
        values = values_of(call, {value.name for value in methods[0].values.values()})
        for method in methods:
            if suits(method, values):
                return Step(call, method, watched, values)
        raise SmokeError(f"{call.name}: no form of {name} takes these arguments in {self.language}")


def values_of(call, own=()):
    """{parameter: value}; those of a struct that only packs arguments, of other names than `own`, are arguments."""
    values = {}
    for entry, value in call.arguments:
        if isinstance(value, Packed) and entry.name not in own:
            values.update((field.name, of) for field, of in value.fields)
        else:
            values[entry.name] = value
    return values


def suits(method, values):
    """Whether a method takes all that is given, and is given all that it needs."""
    own = {method.receiver, *method.given}
    for name, value in method.values.items():
        given = values.get(name, Null())
        absent = isinstance(given, (Null, Slot, NewHandle))
        if value.is_output or value.kind not in ("array", "splines", "handles", "path", "texts", "bytes", "options", *HANDLES):
            continue
        if not absent and name not in own or absent and name in own and not value.nullable:
            return False
    return True


def fields_of(given, manual):
    """(header.Field, value) of a struct that is given, without its size."""
    fields = {field.name: field for struct in manual.structs if struct.name == given.type for field in struct.fields}
    pairs = [(field, of) if isinstance(given, Packed) else (fields[field], of) for field, of in given.fields]
    return [(field, of) for field, of in pairs if field.name != "struct_size"]


def class_of(kind):
    """The type that owns a handle of nurbs.h."""
    return HANDLES[KINDS[kind]]


def plan(binding, model, language):
    planner = Planner(binding, language)
    inputs = [planner.step(entry.call) for entry in model.inputs.values()]
    groups = {name: [planner.step(call) or call.name for call in calls] for name, calls in model.groups.items()}
    return Plan(inputs, groups)
