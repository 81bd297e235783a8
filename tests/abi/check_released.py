#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What was released stays as it was: functions, their parameters with names and order, constants, macros, and fields.

usage: check_released.py TOP [--write]     --write adds the file of a minor version that has none yet

tests/abi/released holds the promises of each minor version, a line for each, and their binary interfaces. What is new
belongs to the version to come: while the header has a version with a file, it promises what is in that file, no more.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project


def interface(manual):
    """Lines, each of which is a promise."""
    for function in manual.functions:
        parameters = ", ".join(f"{entry.c_type}{entry.name}" if entry.c_type.endswith("*") else
                               f"{entry.c_type} {entry.name}" for entry in function.parameters)
        yield f"{function.since} {function.result} {function.name}({parameters})"
    for constant in manual.constants.values():
        if not constant.name.startswith("NURBS_VERSION"):
            yield f"{constant.name} = {constant.value}"
    for macro in manual.macros:
        yield f"{macro.name}({', '.join(macro.parameters)}) {macro.body}"
    for struct in manual.structs:
        for place, entry in enumerate(struct.fields):
            yield f"{struct.name}[{place}] {entry.c_type} {entry.name}"


def missing_files(folder, version):
    """Each minor version has its files from its release on, which the first patch follows."""
    major, minor, patch = (int(part) for part in version.split("."))
    for released in range(minor + (patch > 0)):
        for path in (folder / f"{major}.{released}.txt", folder / f"{major}.{released}.abi"):
            if not path.exists():
                yield f"{path} is missing"


def problems(manual, now, folder):
    major, minor, _ = manual.version.split(".")
    yield from missing_files(folder, manual.version)
    for path in sorted(folder.glob(f"{major}.*.txt")):
        version, before = path.stem, path.read_text(encoding="utf-8").splitlines()
        yield from (f"{version} had: {line}" for line in before if line not in now)
        yield from (f"new, but {version} is released: {line}" for line in now
                    if line not in before and (version == f"{major}.{minor}" or line.startswith(f"{version} ")))


def write(path, now):
    if path.exists():
        print(f"{path} exists: what was released stays")
        return 1
    path.write_text("\n".join(now) + "\n", encoding="utf-8")
    return 0


def main(arguments):
    top = Path(arguments[0])
    manual = header.read(top)
    folder = top / "tests/abi/released"
    major, minor, _ = manual.version.split(".")
    now = list(interface(manual))
    if arguments[1:] == ["--write"]:
        return write(folder / f"{major}.{minor}.txt", now)
    found = list(problems(manual, now, folder))
    print("\n".join(found) or f"{len(now)} promises are kept")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
