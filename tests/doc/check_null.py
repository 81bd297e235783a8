# SPDX-License-Identifier: MIT
"""The library refuses NULL where nurbs.h does not mark a pointer with "or NULL", and nowhere else.

usage: check_null.py TOP_FOLDER libnurbs.so

Every function is called with one pointer NULL, be it a parameter or a field of a struct, and arguments that are made up. A
required pointer has to be refused by NURBS_ERROR_NULL with its name in some of these calls, and none may succeed; one that
may be NULL is refused in none. A pointer in a struct that a function does not use is refused by NURBS_ERROR_OPTIONS.
"""

import ctypes
import sys

import made_calls

ERROR_NULL, ERROR_OPTIONS = 1, 27


def statuses(border, function, slot):
    """(status, message) of the calls in which one pointer is NULL."""
    found = border.slots(function)
    cap = 0 if slot.entry.null == " when cap is 0" else 64
    for kind in border.kinds():
        values = border.values(found, *kind, cap)
        values[slot.key] = None
        status = border.call(function, found, values)
        yield status, border.message() if status else ""


def outcome(border, function, slot):
    """What is wrong, or None; and whether a call without the pointer succeeds."""
    found = list(statuses(border, function, slot))
    refused = any(status == ERROR_NULL and message.startswith(f"{slot.entry.name} is NULL") for status, message in found)
    succeeded = any(status == 0 for status, _ in found)
    if slot.nullable and refused:
        return "is marked with 'or NULL', and refused", succeeded
    if not slot.nullable and succeeded:
        return "may be NULL, and is not marked", succeeded
    return None if slot.nullable or refused else "is required, and never refused here", succeeded


def unused_outcome(border, function, slot):
    found = border.slots(function)
    values = border.values(found, *next(border.kinds()))
    values[slot.key] = (ctypes.c_double * made_calls.ROOM)()
    refused = border.call(function, found, values) == ERROR_OPTIONS and border.message().startswith(slot.key)
    return None if refused else "is not used, and accepted"


def main():
    border = made_calls.Border(*sys.argv[1:3])
    pointers = [(function, slot) for function in border.functions() for slot in border.slots(function) if slot.is_pointer]
    used = [(function, slot) for function, slot in pointers if slot.used]
    found, accepted = [], 0
    for function, slot in used:
        text, succeeded = outcome(border, function, slot)
        accepted += succeeded
        found += [f"{function.name}: {slot.key} {text}"] if text else []
    for function, slot in (entry for entry in pointers if not entry[1].used):
        text = unused_outcome(border, function, slot)
        found += [f"{function.name}: {slot.key} {text}"] if text else []
    nullable = sum(slot.nullable for _, slot in used)
    print("\n".join(found) or f"{len(used) - nullable} pointers are required, {nullable} may be NULL, "
          f"{accepted} of them in calls that succeed; {len(pointers) - len(used)} fields are for other functions")
    return 1 if found or not used else 0


if __name__ == "__main__":
    sys.exit(main())
