#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function of nurbs.h is called by the tests of a binding, directly or through its layers.

    check_calls.py python|LANGUAGE TOP LIBRARY_FOLDER PROGRAM...

The programs are run. Of compiled ones the dynamic linker says which functions it binds: where binding is lazy, as g++ and
gfortran leave it, those that are called; where it is not, as in Rust, those that the linker found a way to from main().
Of Python programs the calls are recorded by record_calls.py. Exits with 77 if a program was not made, for want of its
language.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else HERE.parents[1]
sys.path.insert(0, str(TOP / "cmake/interface"))

import header  # noqa: E402 - from the project

BINDING = re.compile(r"binding file (\S+) \[0\] to \S*libnurbs\.so\S* \[0\]: normal symbol `(nurbs_\w+)'")


def run(command, **variables):
    result = subprocess.run(command, env={**os.environ, **variables}, capture_output=True, text=True, timeout=120)
    if result.returncode == 77:
        print(result.stdout)
        sys.exit(77)
    if result.returncode != 0:
        sys.exit(f"{command[-1]} fails:\n{result.stdout}{result.stderr}")


def compiled_calls(program, library, folder):
    run([program], LD_DEBUG="bindings", LD_DEBUG_OUTPUT=str(folder / "bindings"),
        LD_LIBRARY_PATH=f"{library}:{os.environ.get('LD_LIBRARY_PATH', '')}")
    text = "".join(path.read_text() for path in folder.glob("bindings*"))
    return {name for file, name in BINDING.findall(text) if "libnurbs.so" not in file}


def python_calls(program, library, folder):
    recorded = folder / "calls"
    run([sys.executable, "-W", "error", HERE / "record_calls.py", recorded, program],
        NURBS_LIBRARY=f"{library}/libnurbs.so", PYTHONPATH=f"{TOP}/capi/bindings/python", PYTHONDONTWRITEBYTECODE="1")
    return set(recorded.read_text().split())


def called(language, library, programs):
    found = set()
    for program in programs:
        if not Path(program).exists():
            print(f"SKIPPED: there is no {program}")
            sys.exit(77)
        with tempfile.TemporaryDirectory() as folder:
            calls = python_calls if language == "python" else compiled_calls
            found |= calls(program, library, Path(folder))
    return found


def main():
    language, _, library, *programs = sys.argv[1:]
    wanted = [function.name for function in header.read(TOP).functions]
    found = called(language, library, programs)
    missing = [name for name in wanted if name not in found]
    for name in missing:
        print(f"{language}: no test calls {name}")
    print(f"{language}: {len(wanted) - len(missing)} of {len(wanted)} functions are called")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
