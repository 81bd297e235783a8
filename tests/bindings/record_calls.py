#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program that uses the Python package, and writes down which functions of the library it calls.

    record_calls.py OUTPUT PROGRAM
"""

import atexit
import runpy
import sys
from pathlib import Path

from nurbs import _library

called = set()


def recording(name, function):
    def call(*arguments):
        called.add(name)
        return function(*arguments)
    return call


output, program = Path(sys.argv[1]), sys.argv[2]
for name in _library.PROTOTYPES:
    setattr(_library.lib, name, recording(name, getattr(_library.lib, name)))
atexit.register(lambda: output.write_text("\n".join(sorted(called))))
sys.argv = [program]
sys.path.insert(0, str(Path(program).parent))
runpy.run_path(program, run_name="__main__")
