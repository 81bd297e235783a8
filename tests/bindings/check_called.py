#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether the programs of a language, which ran before, called every function that the library exports.

usage: check_called.py MAP FOLDER...    each FOLDER with what one program called; exits with 77 if nothing is there
"""

import pathlib
import re
import sys

# A line of the dynamic linker (LD_DEBUG=bindings) about a program, not about what the library binds itself; or the name
# alone.
CALL = re.compile(r"^(?:.*binding file (?!\S*libnurbs\.so)\S+ .*: normal symbol `)?(nurbs_\w+)(?:'.*)?$", re.M)


def exported(version_script):
    return set(re.findall(r"\b(nurbs_\w+);", version_script))


def called(folders):
    files = [file for folder in folders for file in sorted(pathlib.Path(folder).glob("*"))]
    names = {name for file in files for name in CALL.findall(file.read_text(errors="replace"))}
    return names | {name.removesuffix("_with") for name in names}  # the same function, which may be watched


def main():
    wanted = exported(pathlib.Path(sys.argv[1]).read_text())
    found = called(sys.argv[2:]) & wanted
    if not found:
        print("SKIPPED: there is no record of calls; the language or glibc's linker is missing")
        return 77
    missing = sorted(wanted - found)
    print(f"{len(found)} of {len(wanted)} functions are called; not called:", *(missing or ["none"]))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
