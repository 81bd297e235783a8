# SPDX-License-Identifier: MIT
"""Counts and strides beyond what any array can have: every function refuses them and ends no program. Functions and
their arrays are found by reading the header, those in structs too. An array of handles is not even looked at: its address
cannot be read.

usage: check_counts.py FOLDER_OF_THE_PROJECT libnurbs.so
"""

import ctypes
import json
import os
import re
import resource
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "doc"))

import header  # noqa: E402 - from the project
import slots  # noqa: E402 - from the project

TOO_MANY = (2**53, 2**60 - 1, 2**61, 2**63 - 1)
UNREADABLE = ctypes.c_void_p(8)
ROOM = 256
OVERFLOW = "NURBS_ERROR_OVERFLOW"

NUMBERS = {"int64_t": ctypes.c_int64, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32, "double": ctypes.c_double}
ELEMENTS = {**slots.NUMBERS, "char": ctypes.c_char, "void": ctypes.c_char}
# A cubic on one span, and two of whatever is counted else.
VALUES = {"axes": 1, "dim": 2, "degree": 3, "count": 4, "knot_count": 8, "cap": 0, "n": 2, "parts": 2, "pieces": 2,
          "double": 0.25}
KNOTS = [0, 0, 0, 0, 1, 1, 1, 1]


def array(element, values):
    return (element * ROOM)(*values)


def handles(library):
    """A curve in the plane and a surface in space; they are never freed."""
    made = [ctypes.c_void_p(), ctypes.c_void_p()]
    points = array(ctypes.c_double, [0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1])
    packed = ctypes.c_int64(0)
    if (library.nurbs_curve_line(2, points, ctypes.byref(points, 32), ctypes.byref(made[0])) != 0
            or library.nurbs_surface_bilinear(3, points, packed, packed, ctypes.byref(made[1])) != 0):
        sys.exit("the splines for the calls cannot be made")
    return made


def filling(parameter, element):
    """Values of an array: rising ones, and what makes the cubic."""
    if parameter.name == "knots":
        return KNOTS
    if element is ctypes.c_double:
        return (i / ROOM for i in range(ROOM))
    return ({"degrees": 3, "counts": 4}.get(parameter.name, 1) for _ in range(ROOM)) if parameter.is_const else []


def argument(parameter, handle):
    if parameter.pointers == 2:  # handles in, or one out
        return UNREADABLE if parameter.is_const else (ctypes.c_void_p * 1)()
    if parameter.base == "nurbs":
        return handle
    if parameter.pointers == 1 and parameter.base in ELEMENTS:
        element = ELEMENTS[parameter.base]
        values = filling(parameter, element) if element is not ctypes.c_char else []
        return array(element, values)
    if parameter.pointers == 0 and parameter.base in NUMBERS:
        value = VALUES.get("double") if parameter.base == "double" else VALUES.get(parameter.name, 0)
        return NUMBERS[parameter.base](value)
    return None


class Arguments:
    """Those of a function, in its structs too."""

    def __init__(self, manual, function):
        self.slots = list(slots.slots(manual, function))
        self.structs = {struct.name: slots.struct_class(manual, struct) for struct in manual.structs}

    def value(self, slot, handle):
        """Fields that are for other functions, and callbacks, are not set."""
        if slot.entry.base in self.structs and slot.entry.pointers:
            return self.structs[slot.entry.base]()
        if slot.holder and slot.entry.name == "struct_size":
            return ctypes.c_int64(slots.known_size(self.structs[slot.holder.base]))
        if not slot.used or slot.is_callback:
            return None if slot.is_pointer else NUMBERS[slot.entry.base](0)
        return argument(slot.entry, handle)

    def passed(self, handle, replaced):
        values = {slot.key: replaced.get(slot.key) or self.value(slot, handle) for slot in self.slots}
        return slots.passed(self.slots, values)

    def is_length(self, slot):
        """Whether a number is the length of an array, not only a room that may be too large."""
        name = slot.entry.name
        return name != "cap" and any(re.search(rf"\b{name}\b", other.entry.shape) for other in self.slots if other.used)

    def lengths(self):
        """Keys of the counts and strides."""
        return [slot.key for slot in self.slots if slot.used and slot.entry.c_type == "int64_t"
                and (slot.entry.name.endswith("stride") or self.is_length(slot))]

    def handle_counts(self):
        """The lengths of its arrays of handles."""
        return {name for slot in self.slots if slot.entry.pointers == 2 and slot.entry.is_const
                for name in re.findall(r"\w+", slot.entry.shape)}


def call(library, function, arguments, handle, replaced):
    entry = getattr(library, function.name)
    entry.restype = ctypes.c_int32
    return entry(*arguments.passed(handle, replaced))


def findings(library, function, arguments, statuses, found):
    """Adds [what, value, status] of all calls, the present one first of all, so that a crash shows which it was."""
    for handle in handles(library):
        for name in arguments.lengths():
            for value in TOO_MANY:
                found.append([name, value, "ended the program"])
                yield
                status = call(library, function, arguments, handle, {name: ctypes.c_int64(value)})
                found[-1][2] = statuses.get(status, str(status))


def in_a_child(library, function, arguments, statuses):
    """What findings() finds, in a process of its own with little memory."""
    source, sink = os.pipe()
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (2**32, 2**32))
        found = []
        with os.fdopen(sink, "w") as pipe:
            for _ in findings(library, function, arguments, statuses, found):
                pipe.write(json.dumps(found[-2:]) + "\n")
                pipe.flush()
            pipe.write(json.dumps(found) + "\n")
        os._exit(0)
    os.close(sink)
    with os.fdopen(source) as pipe:
        last = json.loads(pipe.read().splitlines()[-1])
    os.waitpid(child, 0)
    return last


def mistakes(function, arguments, found):
    for name, value, status in found:
        if name in arguments.handle_counts() and status != OVERFLOW:
            yield f"{function.name}(): {name} = {value}: {status}, expected {OVERFLOW}"
        elif status in ("ended the program", "NURBS_ERROR_INTERNAL"):
            yield f"{function.name}(): {name} = {value}: {status}"


def main(top, library_path):
    declared, library = header.read(top), ctypes.CDLL(library_path)
    statuses = {constant.value: constant.name for group in declared.groups if group.is_status
                for constant in group.constants}
    every = [(function, Arguments(declared, function)) for function in declared.functions if function.statuses]
    chosen = [(function, arguments) for function, arguments in every if arguments.lengths()]
    handle_arrays = sum(bool(arguments.handle_counts() & set(arguments.lengths())) for _, arguments in chosen)
    in_structs = sum("." in name for _, arguments in chosen for name in arguments.lengths())
    bad, seen = [], {}
    for function, arguments in chosen:
        found = in_a_child(library, function, arguments, statuses)
        bad += mistakes(function, arguments, found)
        for *_, status in found:
            seen[status] = seen.get(status, 0) + 1
    print(f"{len(chosen)} functions, {handle_arrays} with arrays of handles, {in_structs} numbers in structs; {seen}")
    # So that an error in the reading of the header does not leave the test without calls.
    if handle_arrays < 4 or in_structs < 30 or seen.get(OVERFLOW, 0) < 500:
        bad.append("too few calls were refused for their sizes")
    print(*bad, sep="\n")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
