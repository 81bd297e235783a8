#!/usr/bin/env python3
"""Every function of nurbs.h is called by a fuzz target, and functions.txt says which.

usage: check_functions.py [nurbs.h [folder of the fuzz targets]]
"""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.S)


def declared(path):
    """Names of the functions, in the header's order."""
    return [function.name for function in header.parse(path.read_text(encoding="utf-8")).functions]


def table(path):
    """Pairs (function, target) of functions.txt."""
    lines = (line.split("#")[0].split() for line in path.read_text().splitlines())
    return [tuple(words) for words in lines if words]


def called(target):
    """Names that a target's source calls; what the shared header calls for it counts too."""
    text = without_comments(target.read_text()) + without_comments((target.parent / "harness.h").read_text())
    return set(re.findall(r"\b(nurbs_\w+)\s*\(", text))


def problems(path, folder):
    functions, rows = declared(path), table(folder / "functions.txt")
    if not functions:
        yield f"{path}: no functions found"
    for row in rows:
        if len(row) != 2:
            yield f"functions.txt: a line is not 'function target': {' '.join(row)}"
            return
    names = [name for name, _ in rows]
    for name in functions:
        if names.count(name) != 1:
            yield f"functions.txt: {name} is listed {names.count(name)} times"
    for name, target in rows:
        source = folder / f"{target}.cpp"
        if name not in functions:
            yield f"functions.txt: {name} is not in the header"
        if not source.exists():
            yield f"functions.txt: {name}: there is no {source.name}"
        elif name not in called(source):
            yield f"{source.name} does not call {name}"


def main(arguments):
    path = Path(arguments[0]) if arguments else HERE.parents[1] / header.PATH
    folder = Path(arguments[1]) if len(arguments) > 1 else HERE
    found = list(problems(path, folder))
    for problem in found:
        print(problem)
    print(f"{len(declared(path))} functions, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
