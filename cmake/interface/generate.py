#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the files that follow from nurbs.h and the table of the bindings.

    generate.py [--check] TOP       TOP is the folder of the project

With --check nothing is written: the exit code is 1 if a file is not what would be written, and the files are named.
"""

import sys
from pathlib import Path

import calls
import cpp
import exports
import formatting
import fortran
import fortran_methods
import header
import python
import readme
import rust
import rust_methods
import smoke_cpp
import smoke_fortran
import smoke_reference
import smoke_rust
import table

DECLARATIONS = (fortran, python, rust, exports, calls, smoke_reference, readme)  # FILES: {path: what makes the text of the header}
WRAPPERS = (cpp, fortran_methods, rust_methods)  # files(binding): {path: text}, of the header and the table
SMOKE_TESTS = (smoke_cpp, smoke_fortran, smoke_rust)  # files(binding, model): the same of the good calls, too


def declarations(manual):
    """{path from the top folder: text} of what the header alone says."""
    return {path: make(manual) for backend in DECLARATIONS for path, make in backend.FILES.items()}


def contents(top):
    """The same of all files."""
    manual = header.read(top)
    binding = table.read(manual, top)
    texts = declarations(manual)
    for backend in WRAPPERS:
        texts.update(backend.files(binding))
    model = calls.read(manual)
    for backend in SMOKE_TESTS:
        texts.update(backend.files(binding, model))
    return texts


def stale(top, wanted):
    for path, text in wanted.items():
        file = top / path
        if not file.exists() or not formatting.same(path, file.read_text(encoding="utf-8"), text):
            yield path


def main(arguments):
    check = arguments[:1] == ["--check"]
    if len(arguments) != 1 + check:
        print(__doc__, file=sys.stderr)
        return 2
    top = Path(arguments[-1])
    try:
        wanted = contents(top)
    except table.TableError as error:
        print(error, file=sys.stderr)
        return 1
    changed = list(stale(top, wanted))
    for path in changed:
        if not check:
            (top / path).parent.mkdir(parents=True, exist_ok=True)
            (top / path).write_text(formatting.formatted(top / path, wanted[path]), encoding="utf-8")
        print(f"{path} " + (f"does not follow {header.PATH} and {table.FOLDER}" if check else "written"))
    if check and changed:
        print(f"To refresh: {header.COMMAND}")
    print(f"{len(wanted)} files, {len(changed)} " + ("stale" if check else "changed"))
    return 1 if check and changed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
