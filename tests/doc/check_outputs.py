# SPDX-License-Identifier: MIT
"""A failing call writes to none of its outputs but handles, which become NULL, and its status is one that nurbs.h lists.

usage: check_outputs.py TOP_FOLDER libnurbs.so

Every function is called as by check_null.py, with one argument spoiled: NaN in place of real numbers, -5 in place of
integers, all bits in place of flags, in arrays everywhere or from the fourth number on.
"""

import ctypes
import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import check_null  # noqa: E402 - from the project
import header  # noqa: E402 - from the project

ANYWHERE = {"NURBS_ERROR_MEMORY", "NURBS_ERROR_INTERNAL"}
SPOILED = {"double": float("nan"), "float": float("nan"), "int32_t": -5, "int64_t": -5, "uint32_t": 0xFFFFFFFF}
FIRST = ctypes.c_void_p(1)  # what is in the places of handles before a call


def spoiled(entry, argument, first):
    """An argument without a good value, in an array from an index on."""
    if not entry.pointers:
        return type(argument)(SPOILED[entry.base])
    argument[first:64] = [SPOILED[entry.base]] * (64 - first)
    return argument


def places(function):
    """Where arguments are spoiled: (parameter, first index)."""
    for entry in function.parameters:
        if entry.direction == "in" and entry.base in SPOILED:
            yield from ((entry, first) for first in ((0, 3) if entry.pointers else (0,)))


class Calls:
    """Calls of a function, and what was wrong with them."""

    def __init__(self, border, manual, function):
        self.border, self.function = border, function
        self.call = getattr(border.library, function.name)
        self.call.restype = ctypes.c_int32
        names = {constant.value: name for name, constant in manual.constants.items() if "_ERROR_" in name}
        self.listed = ANYWHERE.union(function.statuses)
        self.names = names
        self.problems, self.failures = set(), 0

    def argument(self, entry, spline, amounts, place):
        if entry.pointers == 2 and not entry.is_const:
            return ctypes.pointer(ctypes.c_void_p(FIRST.value))
        argument = self.border.argument(entry, spline, *amounts, 64)
        return spoiled(entry, argument, place[1]) if place[0] is entry else argument

    def once(self, spline, amounts, place):
        parameters = self.function.parameters
        arguments = [self.argument(entry, spline, amounts, place) for entry in parameters]
        outputs = [(entry, argument) for entry, argument in zip(parameters, arguments) if entry.direction != "in"]
        before = [None if entry.pointers == 2 else bytes(argument) for entry, argument in outputs]
        status = self.call(*arguments)
        if status == 0:
            return
        self.failures += 1
        name = self.names.get(status, str(status))
        if name not in self.listed:
            self.problems.add(f"returns {name}, which is not listed, when {place[0].name} is spoiled")
        for (entry, argument), old in zip(outputs, before):
            if old is None and argument.contents.value:
                self.problems.add(f"fails by {name} and leaves {entry.name} as it was")
            elif old is not None and bytes(argument) != old:
                self.problems.add(f"fails by {name} and writes to {entry.name}")

    def all(self):
        for spline, amounts in itertools.product(self.border.splines, check_null.AMOUNTS):
            for place in places(self.function):
                self.once(spline, amounts, place)
        return self


def main():
    manual = header.read(sys.argv[1])
    border = check_null.Border(sys.argv[2])
    done = [Calls(border, manual, function).all() for function in manual.functions if function.result == "nurbs_status"]
    found = [f"{calls.function.name} {problem}" for calls in done for problem in sorted(calls.problems)]
    print("\n".join(found) or f"{sum(calls.failures for calls in done)} calls failed, of "
          f"{sum(calls.failures > 0 for calls in done)} functions")
    return 1 if found or not any(calls.failures for calls in done) else 0


if __name__ == "__main__":
    sys.exit(main())
