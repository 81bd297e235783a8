# SPDX-License-Identifier: MIT
"""Arrays of doubles may be parts of one table: every function that takes strides for inputs and outputs, or for several
outputs, takes them with the row of the table as their stride. So do structs that hold such arrays.

usage: check_tables.py TOP_FOLDER libnurbs.so
"""

import ctypes
import sys

import made_calls

WIDTH, ROWS = 96, 64  # room for each array in a row


def strided(found):
    """Pairs of slots: the arrays of doubles that have strides, and these."""
    return [(slot, after) for slot, after in zip(found, found[1:])
            if slot.entry.base == "double" and slot.is_pointer and slot.used and after.entry.name.endswith("_stride")]


def status_in_table(border, function, found, pairs, kind):
    """The status of a call with all these arrays in one table, or None if it fails with packed ones."""
    values = border.values(found, *kind)
    if border.call(function, found, values):
        return None
    row = WIDTH * len(pairs)
    table = (ctypes.c_double * (row * ROWS))(*[0.25 + i / 1e5 for i in range(row * ROWS)])
    for column, (array, stride) in enumerate(pairs):
        values[array.key] = (ctypes.c_double * WIDTH).from_buffer(table, 8 * WIDTH * column)
        values[stride.key] = ctypes.c_int64(row)
    return border.call(function, found, values)


def main():
    border = made_calls.Border(*sys.argv[1:3])
    problems, tried = [], 0
    for function in border.functions():
        found = border.slots(function)
        pairs = strided(found)
        if len(pairs) < 2 or all(array.direction == "in" for array, _ in pairs):
            continue
        statuses = {status_in_table(border, function, found, pairs, kind) for kind in border.kinds()}
        tried += 0 in statuses
        problems += [f"{function.name} fails by {status}: {border.message()}" for status in statuses - {0, None}]
    print("\n".join(problems) or f"{tried} functions take tables")
    return 1 if problems or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
