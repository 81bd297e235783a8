#!/usr/bin/env python3
"""Every function of nurbs.h is called by a fuzz target; prints which.

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


def calls_of(source):
    """Names that a target's source calls; what the shared header calls for it counts too."""
    text = without_comments(source.read_text()) + without_comments((source.parent / "harness.h").read_text())
    return set(re.findall(r"\b(nurbs_\w+)\s*\(", text))


def targets(path, folder):
    """{function: the targets that call it}"""
    calls = {source.stem: calls_of(source) for source in sorted(folder.glob("fuzz_*.cpp"))}
    return {name: [target for target, names in calls.items() if name in names] for name in declared(path)}


def main(arguments):
    path = Path(arguments[0]) if arguments else HERE.parents[1] / header.PATH
    folder = Path(arguments[1]) if len(arguments) > 1 else HERE
    found = targets(path, folder)
    for name, of in found.items():
        print(name, " ".join(of) or "is called by no target")
    missing = sum(not of for of in found.values())
    print(f"{len(found)} functions, {missing} without a target")
    return 1 if missing or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
