# SPDX-License-Identifier: MIT
"""Fortran: the modules above the core that is written by hand, nurbs_support and nurbs_handles.

    files(binding)      what generate.py calls: {path: text}

modules.py makes modules of groups, procedures.py a procedure of a method: dummies.py its arguments, sizes.py what the shapes
of arrays say, passing.py the arguments of the C function, and statements.py breaks lines.
"""

from .modules import files  # noqa: F401 - what generate.py calls
