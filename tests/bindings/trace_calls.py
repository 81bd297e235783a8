# SPDX-License-Identifier: MIT
"""Runs a program and writes the functions of shared libraries that it really calls through ctypes, one in each line.

usage: trace_calls.py FILE PROGRAM [ARGUMENT...]
"""

import atexit
import ctypes
import os
import pathlib
import runpy
import sys

calls = set()


class RecordingLibrary(ctypes.CDLL):
    """A library whose functions write down their names when they are called, and not when they are looked up."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)

        class Function(self._FuncPtr):
            _flags_ = self._FuncPtr._flags_
            _restype_ = self._FuncPtr._restype_

            def __call__(self, *values):
                calls.add(self.__name__)
                return super().__call__(*values)

        self._FuncPtr = Function


def main():
    file = pathlib.Path(sys.argv[1])
    sys.argv = sys.argv[2:]
    sys.path[0] = os.path.dirname(os.path.abspath(sys.argv[0]))
    atexit.register(lambda: file.write_text("".join(f"{name}\n" for name in sorted(calls))))
    ctypes.CDLL = RecordingLibrary
    runpy.run_path(sys.argv[0], run_name="__main__")


if __name__ == "__main__":
    main()
