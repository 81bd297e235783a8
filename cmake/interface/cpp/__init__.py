# SPDX-License-Identifier: MIT
"""C++: the headers above the small core of include/nurbs/cpp that is written by hand."""

from .files import files  # noqa: F401 - what generate.py calls
