# SPDX-License-Identifier: MIT
"""A failing call writes to none of its outputs but handles, which become NULL, and its status is one that nurbs.h lists.

usage: check_outputs.py TOP_FOLDER libnurbs.so

Every function is called with arguments that are made up, one of which is spoiled: NaN in place of real numbers, -5 in place
of integers, all bits in place of flags, in arrays everywhere or from the fourth number on; a byte beyond the fields of a
struct; and the least limit of work.
"""

import ctypes
import sys

import made_calls
import slots

ANYWHERE = {"NURBS_ERROR_MEMORY", "NURBS_ERROR_INTERNAL"}
SPOILED = {"double": float("nan"), "float": float("nan"), "int32_t": -5, "int64_t": -5, "uint32_t": 0xFFFFFFFF}
FIRST = ctypes.c_void_p(1)  # what is in the places of handles before a call


def spoil_array(array, first, value):
    array[first:64] = [value] * (64 - first)


def add_unknown_field(struct, size):
    size.value = ctypes.sizeof(struct)
    struct.beyond[0] = 1


def mistakes(found):
    """What may be wrong with a call: (key of a slot, what changes its value)."""
    for slot in found:
        if slot.direction != "in":
            continue
        if slot.entry.base in SPOILED:
            bad = SPOILED[slot.entry.base]
            if slot.entry.pointers:
                yield from ((slot, lambda values, key=slot.key, first=first, bad=bad: spoil_array(values[key], first, bad))
                            for first in (0, 3) if slot.used)
            else:
                yield slot, lambda values, key=slot.key, bad=bad: values.update({key: type(values[key])(bad)})
        if slot.key == "call.work":
            yield slot, lambda values: values.update({"call.work": ctypes.c_int64(1)})
        if slot.holder and slot.entry.name == "struct_size":
            yield slot, lambda values, slot=slot: add_unknown_field(values[slot.holder.name], values[slot.key])


def is_handle(slot):
    return slot.entry.pointers == 2


class Calls:
    """Calls of a function, and what was wrong with them."""

    def __init__(self, border, function):
        self.border, self.function = border, function
        self.slots = border.slots(function)
        self.outputs = [slot for slot in self.slots if slot.direction != "in" and slot.is_pointer and slot.used]
        self.names = {constant.value: name for name, constant in border.manual.constants.items() if "_ERROR_" in name}
        self.listed = ANYWHERE.union(function.statuses)
        self.problems, self.statuses = set(), []

    def values(self, kind):
        values = self.border.values(self.slots, *kind)
        values.update({slot.key: made_calls.new_handles(FIRST.value) for slot in self.outputs if is_handle(slot)})
        return values

    def once(self, kind, slot, spoil):
        values = self.values(kind)
        spoil(values)
        slots.passed(self.slots, values)  # fills the structs, so that they are seen to stay
        before = {output.key: bytes(values[output.key]) for output in self.outputs if not is_handle(output)}
        status = self.border.call(self.function, self.slots, values)
        self.statuses.append(status)
        if status:
            self.judge(self.names.get(status, str(status)), slot, values, before)

    def judge(self, name, slot, values, before):
        if name not in self.listed:
            self.problems.add(f"returns {name}, which is not listed, when {slot.key} is spoiled")
        for output in self.outputs:
            if is_handle(output):
                if values[output.key].contents.value and not (output.entry.shape and slot.key == "count"):
                    self.problems.add(f"fails by {name} and leaves {output.key} as it was")
            elif bytes(values[output.key]) != before[output.key]:
                self.problems.add(f"fails by {name} and writes to {output.key}")

    def all(self):
        for kind in self.border.kinds():
            for slot, spoil in mistakes(self.slots):
                self.once(kind, slot, spoil)
        return self


def main():
    border = made_calls.Border(*sys.argv[1:3])
    done = [Calls(border, function).all() for function in border.functions()]
    found = [f"{calls.function.name} {problem}" for calls in done for problem in sorted(calls.problems)]
    failures = [sum(status != 0 for status in calls.statuses) for calls in done]
    print("\n".join(found) or f"{sum(failures)} calls failed, of {sum(count > 0 for count in failures)} functions")
    return 1 if found or not any(failures) else 0


if __name__ == "__main__":
    sys.exit(main())
