# SPDX-License-Identifier: MIT
"""Which outputs of the good calls are in which places of the struct Output, for the program that prints what C returns."""

import calls
import header
from calls_model import FOLDER as CALLS
from calls_model import NewHandle, Slot
from smoke import FOLDER, values_of

PATH = f"{FOLDER}/smoke_slots.h"
NOTICE = f"""\
/* SPDX-License-Identifier: MIT */
// Generated from {CALLS}/*.toml and {header.PATH} by: {header.COMMAND} - do not edit.
// clang-format off
#ifndef NURBS_TESTS_BINDINGS_SMOKE_SLOTS_H
#define NURBS_TESTS_BINDINGS_SMOKE_SLOTS_H

// A place of Output: elements of an array, or a new handle.
struct Slot {{
    const char *call, *parameter, *place;
    int first, length;
}};

inline constexpr Slot slots[] = {{
"""


def places(call):
    """(parameter, value) of all outputs."""
    found = [(name, value) for name, value in values_of(call).items()
             if isinstance(value, NewHandle) or isinstance(value, Slot) and value.length > 0]
    return found + ([("return", call.result)] if call.result else [])


def line(call, parameter, value):
    where = f'"{value.array}", {value.first}, {value.length}' if isinstance(value, Slot) else f'"{value.place}", 0, 1'
    return f'    {{"{call.name}", "{parameter}", {where}}},'


def contents(manual):
    model = calls.read(manual)
    lines = [line(call, *place) for call in model.calls() for place in places(call)]
    return NOTICE + "\n".join(lines) + "\n};\n\n#endif\n"


FILES = {PATH: contents}
