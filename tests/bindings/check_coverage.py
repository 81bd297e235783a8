#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function, constant and macro of nurbs.h can be reached from the layers above the declarations, and every function
is called by a test in C, and by those of memory and threads.

    check_coverage.py TOP     TOP is the folder of the project

Declarations and constants are generated from the header, and bindings.generated compares them; here it is seen that the
layers above use them all, those that are generated from the table and those that are written by hand.
"""

import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
BINDINGS = TOP / "capi/bindings"
sys.path.insert(0, str(TOP / "cmake/interface"))

import header  # noqa: E402 - from the project
from generate import declarations  # noqa: E402 - from the project

COMMENT = r"/\*.*?\*/|//[^\n]*"
COMMENTS = {".c": COMMENT, ".cpp": COMMENT, ".h": COMMENT, ".hpp": COMMENT, ".rs": COMMENT,
            ".f90": r"![^\n]*", ".py": r"(?<!.)#[^\n]*"}


def sources(manual, *patterns):
    """Text of the files but the declarations, without comments."""
    generated = {TOP / path for path in declarations(manual)}
    paths = sorted(path for pattern in patterns for path in TOP.glob(pattern) if path not in generated)
    return "\n".join(re.sub(COMMENTS[path.suffix], " ", path.read_text(), flags=re.S) for path in paths)


def lacking(language, text, pattern, names):
    """Names that do not occur; {} in the pattern stands for the name."""
    return [f"{language} does not use {name}" for name in names if not re.search(pattern.format(name), text)]


def fortran_functions(manual):
    """Those that the layer has to use: functions without handles are called by their own names if it shows them."""
    lines = [line.split("!")[0].strip() for line in (BINDINGS / "fortran/nurbs.f90").read_text().splitlines()]
    return [function.name for function in manual.functions
            if "use nurbs_c" not in lines
            or any(parameter.base in manual.handles for parameter in function.parameters)]


def problems(manual):
    functions = [function.name for function in manual.functions]
    macros = [macro.name for macro in manual.macros]
    cpp = sources(manual, "include/nurbs/nurbs.hpp", "include/nurbs/cpp/*.hpp")
    fortran = sources(manual, "capi/bindings/fortran/*.f90").lower()
    python = sources(manual, "capi/bindings/python/nurbs/*.py")
    rust = sources(manual, "capi/bindings/rust/src/*.rs")
    tests = sources(manual, "tests/capi/*.c", "tests/capi/*.h")
    calls = sources(manual, "tests/capi/calls/*", "tests/capi/shapes.h")
    yield from lacking("tests/capi", tests, r"\b{}\(", functions)
    yield from lacking("tests/capi/calls", calls, r"\b{}\(", functions)
    yield from lacking("tests/capi/calls/calls.h", sources(manual, "tests/capi/calls/calls.h"), r"[ {{]{}\(\)[,}}]",
                       set(re.findall(r"(\w+_calls)\(\) {", calls)) - {"scalar_calls"})
    yield from lacking("C++", cpp, r"\b{}\b", [*functions, *manual.constants, *macros])
    yield from lacking("Fortran", fortran, r"\b{}\b", fortran_functions(manual))
    yield from lacking("Fortran", fortran, r"function {}\(", [name.lower() for name in macros])
    yield from lacking("Python", python, r"\blib\.{}\b", functions)
    yield from lacking("Rust", rust, r"\bsys::{}\b", functions)
    yield from lacking("Rust", rust, r"fn {}\(", [name.removeprefix("NURBS_").lower() for name in macros])


def main():
    manual = header.read(TOP)
    found = list(problems(manual))
    print("\n".join(found) or f"{len(manual.functions)} functions can be reached from every layer")
    return 1 if found or not manual.functions else 0


if __name__ == "__main__":
    sys.exit(main())
