# SPDX-License-Identifier: MIT
"""Structs, callbacks, and functions nurbs_X_with are described in the uniform way that generators of bindings read.

usage: check_structs.py TOP_FOLDER

Structs begin with their size, have no holes, and describe their fields as parameters are described. nurbs_X_with takes what
nurbs_X takes, and `call`; arguments that are not its own are fields of its structs, with the name, type and shape that they
have in nurbs_X.
"""

import ctypes
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project
import slots  # noqa: E402 - from the project

MOST_PARAMETERS = 12
ENDED = ("NURBS_ERROR_OPTIONS", "NURBS_ERROR_CANCELLED", "NURBS_ERROR_WORK")
OPTIONS = "const nurbs_call_options *"


# Structs.


def field_problem(manual, entry):
    """What is wrong with a field for itself."""
    array = entry.pointers == 1 and entry.base in slots.NUMBERS
    if entry.base not in (*slots.NUMBERS, *manual.callbacks, *["void"] * entry.pointers) or entry.pointers > 1:
        return f"{entry.c_type} is no type of a field"
    if array != bool(entry.shape):
        return "no shape in brackets" if array else "a shape for what is no array"
    if entry.nullable and not entry.pointers and entry.base not in manual.callbacks:
        return "is no pointer, and cannot be NULL"
    if re.search(r"\bNULL\b", entry.text):
        return "speaks of NULL out of its place"
    return None if entry.text or entry.nullable else "says nothing"


def has_holes(manual, struct):
    known = slots.struct_class(manual, struct, beyond=0)
    return sum(getattr(known, entry.name).size for entry in struct.fields) != ctypes.sizeof(known)


def struct_problems(manual, struct):
    first = struct.fields[0]
    if (first.c_type, first.name) != ("int64_t", "struct_size"):
        yield "does not begin with int64_t struct_size"
    if has_holes(manual, struct):
        yield "has holes between fields, or behind them"
    if not struct.text:
        yield "has no text"
    for entry in struct.fields:
        problem = field_problem(manual, entry)
        if problem:
            yield f"{entry.name}: {problem}"


def callback_problems(entry):
    kinds = {told.c_type for told in entry.parameters}
    if entry.result != "int32_t" or not kinds <= {"double", "int32_t", "int64_t", "void *"}:
        yield "has a type that bindings do not expect"
    if entry.parameters[-1].c_type != "void *":
        yield "does not pass what belongs to the caller, last"
    if not entry.text:
        yield "has no text"


# Functions nurbs_X_with.


def place_of_call(function):
    """Where `call` has to stand: last, or before a new handle."""
    makes = any(entry.pointers == 2 and not entry.is_const for entry in function.parameters)
    return len(function.parameters) - 1 - makes


def own_problems(function, plain):
    """Of the parameters that both have."""
    names = [entry.name for entry in plain.parameters]
    both = [entry for entry in function.parameters if entry.name in names]
    if [names.index(entry.name) for entry in both] != sorted(names.index(entry.name) for entry in both):
        yield "the order of parameters differs"
    for entry in both:
        other = next(twin for twin in plain.parameters if twin.name == entry.name)
        if (entry.c_type, entry.direction, entry.shape, entry.nullable) != \
                (other.c_type, other.direction, other.shape, other.nullable):
            yield f"{entry.name} differs"
        if entry.name != "out" and entry.text.rstrip(".") != f"as for {plain.name}()":
            yield f"{entry.name} is not described as for {plain.name}()"


def same_shape(field, twin):
    """A curve has one axis, and a plane two coordinates: where the plain form says so, the struct may be more general."""
    special = re.escape(field.shape).replace(r"\[axes\]", r"(\[axes\])?").replace(r"\[dim\]", r"\[(dim|2)\]")
    return re.fullmatch(special, twin.shape) is not None


def field_problems(found, plain):
    """Of the arguments that are fields."""
    own = {slot.entry.name for slot in found if not slot.holder}
    twins = {slot.entry.name: slot for slot in found if slot.twin}
    for entry in plain.parameters:
        slot = twins.get(entry.name)
        if (entry.name in own) == (slot is not None):
            yield f"{entry.name} is passed twice" if slot else f"{entry.name} cannot be passed"
        elif slot:
            returned = slot.holder.direction != "in" and not slot.is_pointer
            if slot.entry.c_type != (re.sub(r" \*$", "", entry.c_type) if returned else entry.c_type):
                yield f"{slot.key} has another type than {entry.name} of {plain.name}"
            if not same_shape(slot.entry, entry):
                yield f"{slot.key} has another shape than {entry.name} of {plain.name}"
            if entry.nullable and not slot.entry.nullable and not returned:
                yield f"{slot.key} may be NULL in {plain.name}"


def with_problems(manual, function):
    plain = manual.plain(function)
    if plain is None:
        yield "has no plain form"
        return
    call = function.parameters[place_of_call(function)]
    if (call.name, call.c_type, call.nullable) != ("call", OPTIONS, True):
        yield "`call` does not stand in its place, or may not be NULL"
    if len(function.parameters) > MOST_PARAMETERS:
        yield f"has more than {MOST_PARAMETERS} parameters"
    yield from (f"{status} is missing" for status in (*plain.statuses, *ENDED) if status not in function.statuses)
    yield from own_problems(function, plain)
    yield from field_problems(list(slots.slots(manual, function)), plain)


def unasked_fields(manual):
    """Fields that may be NULL in the struct, but in no function that has it."""
    found = [(slot, slot.holder.base) for function in manual.functions for slot in slots.slots(manual, function)
             if slot.holder and slot.is_pointer]
    needless = {(base, slot.entry.name) for slot, base in found if slot.entry.nullable}
    return needless - {(base, slot.entry.name) for slot, base in found if slot.nullable or not slot.used}


def problems(manual):
    for struct in manual.structs:
        yield from (f"{struct.name}: {problem}" for problem in struct_problems(manual, struct))
    for entry in manual.callbacks.values():
        yield from (f"{entry.name}: {problem}" for problem in callback_problems(entry))
    for function in manual.functions:
        if function.name.endswith("_with"):
            yield from (f"{function.name}: {problem}" for problem in with_problems(manual, function))
        elif any(entry.c_type == OPTIONS for entry in function.parameters):
            yield f"{function.name}: takes `call`, and is not named nurbs_X_with"
    yield from (f"{base}.{name} may be NULL in no function" for base, name in sorted(unasked_fields(manual)))


def main():
    manual = header.read(sys.argv[1])
    found = list(problems(manual))
    long_calls = sum(function.name.endswith("_with") for function in manual.functions)
    print("\n".join(found) or f"{len(manual.structs)} structs, {len(manual.callbacks)} callbacks and {long_calls} long calls "
          "are described")
    return 1 if found or not manual.structs or not long_calls else 0


if __name__ == "__main__":
    sys.exit(main())
