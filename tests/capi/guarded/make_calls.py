# SPDX-License-Identifier: MIT
"""Writes a header with every function of nurbs.h again, each with its arrays replaced.

usage: make_calls.py TOP_FOLDER MEANS OUTPUT

The header replaces the functions of nurbs.h by macros, so that a file that is compiled with it (-include) calls others in
their place. MEANS is a header of this folder's parent, such as guarded/pages.h, which says how: in a namespace with the
name of its folder it has the classes Function and Argument, of which there is one for each function and for each array,
Running, which lives as long as a call, and Array, which gives the function the place of an array with as many elements as
the shapes of the comments in nurbs.h ask for.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "cmake/interface"))

import header  # noqa: E402 - from the project
from shapes import Shapes  # noqa: E402 - from the project

HEAD = f'''\
/* SPDX-License-Identifier: MIT */
/* Generated from {header.PATH} by tests/capi/guarded/make_calls.py - do not edit. */
#pragma once

#include "guarded/shape_terms.h"
'''


def is_handle(entry):
    return (entry.base in ("nurbs", "nurbs_list", "nurbs_statistics", "nurbs_face", "nurbs_model", "nurbs_meet",
                           "nurbs_mesh")
            and entry.pointers == 1)


def moved(entry):
    """Whether an argument is memory of the caller's, and not a handle."""
    return entry.pointers > 0 and not is_handle(entry)


def size_of(function, shapes, index):
    entry = function.parameters[index]
    if entry.c_type == "const char *":
        return "text(" + entry.name + ")"
    return shapes.extent(index) if entry.shape else "1"


def result_of(function, call):
    """The end of a replacement."""
    if function.result == "void":
        return f"    {call};"
    return f"    return here.{'status' if function.result == 'nurbs_status' else 'other'}({call});"


def wrapper(space, function, number, first):
    """The function's replacement; `first` is the number of its first array."""
    shapes = Shapes(function)
    parameters = ", ".join(f"{entry.c_type} {entry.name}" for entry in function.parameters)
    yield f"inline {function.result} {space}_{function.name}({parameters}) {{"
    yield f"    using namespace {space};"
    yield "    using namespace shape_terms;"
    yield f"    [[maybe_unused]] Running here(functions[{number}]);"
    names = []
    for index, entry in enumerate(function.parameters):
        if moved(entry):
            yield f"    const Array {entry.name}_(arrays[{first}], {entry.name}, {size_of(function, shapes, index)});"
            first += 1
        names.append(entry.name + "_.place()" * moved(entry))
    yield result_of(function, f"{function.name}({', '.join(names)})")
    yield "}"


def tables(space, functions):
    """The classes' objects."""
    yield f"namespace {space} {{"
    yield "inline Function functions[] = {"
    yield from (f'    {{"{function.name}"}},' for function in functions)
    yield "};"
    yield "inline Argument arrays[] = {"
    for function in functions:
        for entry in filter(moved, function.parameters):
            yield f'    {{"{function.name}", "{entry.name}", {"true" if "in" in entry.direction.split(",") else "false"}}},'
    yield "};"
    yield f"}} // namespace {space}"


def contents(manual, means):
    space = means.split("/")[0]
    yield HEAD + f'#include "{means}"\n'
    yield from tables(space, manual.functions)
    first = 0
    for number, function in enumerate(manual.functions):
        yield from wrapper(space, function, number, first)
        first += sum(moved(entry) for entry in function.parameters)
    yield from (f"#define {function.name} {space}_{function.name}" for function in manual.functions)


def main(arguments):
    top, means, output = arguments
    Path(output).write_text("\n".join(contents(header.read(top), means)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
