# SPDX-License-Identifier: MIT
"""What the smoke tests of Python share: the table of good calls, and how results are printed; see smoke_reference.cpp."""

import ctypes
import struct
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cmake/interface"))

import calls_reader  # noqa: E402 - from the project
import header  # noqa: E402 - from the project

TYPES = {"double": ctypes.c_double, "float": ctypes.c_float, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32,
         "int64_t": ctypes.c_int64, "nurbs_status": ctypes.c_int32, "char": ctypes.c_char}
BITS = {ctypes.c_double: "<d", ctypes.c_float: "<f"}

manual = header.read(TOP)
model = calls_reader.read(manual, TOP)


def text_of(number, ctype):
    """As smoke_reference.cpp prints it."""
    form = BITS.get(ctype)
    return struct.pack(form, number)[::-1].hex() if form else str(int(number))


def show(call, parameter, texts):
    print(f"{call}|{parameter}|{' '.join(texts)}")


def file(text):
    """The path of a file that holds a text of the table."""
    path = Path(f"smoke_python.{text}")
    path.write_text(model.texts[text], encoding="utf-8")
    return str(path)
