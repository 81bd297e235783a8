# SPDX-License-Identifier: MIT
"""Arrays of doubles may be parts of one table: every function that takes strides for inputs and outputs, or for several
outputs, takes them with the row of the table as their stride.

usage: check_tables.py TOP_FOLDER libnurbs.so
"""

import ctypes
import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import check_null  # noqa: E402 - from the project
import header  # noqa: E402 - from the project

WIDTH, ROWS = 32, 64  # room for each array in a row


def strided(function):
    """The places of the arrays of doubles that have strides."""
    parameters = function.parameters
    return [place for place, (entry, after) in enumerate(zip(parameters, parameters[1:]))
            if entry.base == "double" and entry.pointers and after.name.endswith("_stride")]


def status_in_table(border, function, places, spline, amounts):
    """The status of a call with all these arrays in one table, or None if it fails with packed ones."""
    call = getattr(border.library, function.name)
    call.restype = ctypes.c_int32
    arguments = [border.argument(entry, spline, *amounts, 64) for entry in function.parameters]
    if call(*arguments):
        return None
    row = WIDTH * len(places)
    table = (ctypes.c_double * (row * ROWS))(*[0.25 + i / 1e5 for i in range(row * ROWS)])
    for column, place in enumerate(places):
        arguments[place] = ctypes.byref(table, 8 * WIDTH * column)
        arguments[place + 1] = ctypes.c_int64(row)
    return call(*arguments)


def main():
    border = check_null.Border(sys.argv[2])
    problems, tried = [], 0
    for function in header.read(sys.argv[1]).functions:
        places = strided(function)
        if len(places) < 2 or all(function.parameters[place].direction == "in" for place in places):
            continue
        found = {status_in_table(border, function, places, spline, amounts)
                 for spline, amounts in itertools.product(border.splines, check_null.AMOUNTS)}
        tried += 0 in found
        problems += [f"{function.name} fails by {status}: {border.message()}" for status in found - {0, None}]
    print("\n".join(problems) or f"{tried} functions take tables")
    return 1 if problems or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
