"""Every function of nurbs.h is documented in the uniform way that generators of bindings read.

usage: check_header.py TOP_FOLDER

The rules are those of the header's section "Bindings". A function has \\brief, \\since, \\return unless it is void,
and a \\param with its direction for every parameter and for no other; arrays have a shape in brackets, and pointers
that may be NULL the words "or NULL" in their one place. Statuses that are listed exist. check_structs.py sees to structs
and to what stands for other functions.
"""

import re
import sys
from pathlib import Path

TOP = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
sys.path.insert(0, str(TOP / "cmake/interface"))

import header  # noqa: E402 - from the project

# Pointers to one value that is written; arrays have names in the plural.
SINGLE_RESULTS = ("against", "angle", "area", "at_least", "at_most", "axes", "bound", "branches", "cells", "complete", "content",
                  "convexity", "count", "curvature_gap", "degree", "deviation", "dim", "distance", "edge_points", "edges",
                  "entity_type", "entries", "error", "faces", "factor", "form", "from_mesh", "from_shape", "gap", "geometric", "homogeneous",
                  "in_void", "index", "key", "kind", "knot", "length", "line", "major", "metres", "minor", "moved", "nodes", "openness",
                  "optimality", "order", "parent", "part", "parts", "periodic", "points", "position_gap", "proven", "rank",
                  "ratio", "rational", "reached", "reason", "removed", "residual", "result", "shape", "size", "slots", "solid", "status",
                  "tolerance", "triangles", "type", "uses", "value", "vertices", "volume", "weight")
ORDER = ["brief", "param", "return", "since"]


def is_number(parameter):
    return parameter.base in ("double", "float", "int32_t", "int64_t", "uint32_t", "nurbs_status", "char")


def shape_problem(parameter):
    if parameter.pointers == 0 or parameter.name == "path":
        return "a shape for what is no array" if parameter.shape else None
    if parameter.base in manual.handles and not parameter.is_const and parameter.pointers == 2:
        return None  # a new one, or with a shape an array of these
    if parameter.base in manual.handles and parameter.pointers < 2:
        return "a shape for a handle" if parameter.shape else None
    if parameter.base in structs and parameter.pointers == 1:
        return "a shape for a struct" if parameter.shape else None
    if parameter.shape:
        return None
    single = is_number(parameter) and not parameter.is_const and parameter.name in SINGLE_RESULTS
    return None if single else "no shape in brackets"


def null_problem(parameter, text):
    """`text` is the description as it is written, the mark included."""
    if parameter.nullable and parameter.pointers == 0:
        return "is no pointer, and cannot be NULL"
    if parameter.nullable and parameter.pointers == 2 and not parameter.is_const:
        return "a handle that is returned needs its place"
    if "NULL" in text and not parameter.nullable:
        return "speaks of NULL without the mark 'or NULL' in its place"
    if re.search(r"(or|may be) NULL", parameter.text):
        return "has the mark 'or NULL' twice"
    return None


def parameter_problems(function):
    names = [parameter.name for parameter in function.parameters]
    for name in function.described:
        if name not in names:
            yield f"\\param {name} is not a parameter"
    for parameter in function.parameters:
        if parameter.name not in function.described:
            yield f"no \\param for {parameter.name}"
            continue
        text = function.described[parameter.name][1]
        freed = parameter.base in manual.handles and parameter.pointers == 1
        written = parameter.pointers > 0 and not parameter.is_const and not freed
        if written != (parameter.direction != "in"):
            yield f"\\param {parameter.name} is marked {parameter.direction}"
        if not text:
            yield f"\\param {parameter.name} says nothing"
        for problem in (shape_problem(parameter), null_problem(parameter, text)):
            if problem:
                yield f"\\param {parameter.name}: {problem}"


def status_problems(function):
    if function.result != "nurbs_status":
        return
    if not function.statuses or function.statuses[0] != "NURBS_OK":
        yield "\\return does not list NURBS_OK first"
    for status in function.statuses:
        if status not in manual.constants:
            yield f"there is no {status}"
    required = any(parameter.pointers and not parameter.nullable for parameter in function.parameters)
    if required != ("NURBS_ERROR_NULL" in function.statuses):
        yield "NURBS_ERROR_NULL is " + ("missing" if required else "listed, but no pointer is required")


def problems(function):
    if not function.brief:
        yield "no \\brief"
    if not function.returns and function.result != "void":
        yield "no \\return"
    if list(function.tags) != sorted(function.tags, key=ORDER.index):
        yield "the order of tags is not \\" + ", \\".join(ORDER)
    if not re.fullmatch(r"\d+\.\d+", function.since):
        yield f"\\since {function.since} is not a version"
    yield from parameter_problems(function)
    yield from status_problems(function)


def main():
    messages = [f"{function.name}: {problem}" for function in manual.functions for problem in problems(function)]
    if not manual.functions:
        messages.append("no functions")
    messages += [f"{constant.name} has no text" for constant in manual.constants.values() if not constant.text]
    print("\n".join(messages) or f"{len(manual.functions)} functions are documented")
    return 1 if messages else 0


manual = header.read(TOP)
structs = {struct.name for struct in manual.structs}
if __name__ == "__main__":
    sys.exit(main())
