# SPDX-License-Identifier: MIT
"""Python: the constants, and what ctypes has to know of every function."""

import re

import header
import layout

FOLDER = "capi/bindings/python/nurbs"
WIDTH = 120
LETTERS = {"int32_t": "i", "nurbs_status": "i", "int64_t": "l", "uint32_t": "u", "double": "d", "void": "v"}

CONSTANTS_HEAD = f'''\
# SPDX-License-Identifier: MIT
# {header.NOTICE}
"""The constants of nurbs.h, with its names and values, and its macros for flags."""
'''

PROTOTYPES_HEAD = f'''\
# SPDX-License-Identifier: MIT
# {header.NOTICE}
"""The functions of nurbs.h: the type of the result, then one letter for each argument.

i, l: integers of 32 and 64 bits; u: unsigned of 32 bits; d: double; p: any pointer; s: text; v: nothing.
"""
'''


def translated(expression):
    """A C expression of constants, as Python has it."""
    expression = re.sub(r"\b(0x[0-9a-fA-F]+|\d+)u\b", r"\1", expression.replace("(uint32_t)", ""))
    expression = re.sub(r"\((\w+)\)", r"\1", expression)
    whole = re.fullmatch(r"\((.*)\)", expression)
    return whole[1] if whole else expression


def constant_group(group):
    yield from layout.comment("# --- ", group.title, WIDTH)
    for constant in group.constants:
        yield from layout.with_comment(f"{constant.name} = {translated(constant.literal)}", "#", constant.text, WIDTH)
    yield ""


def macro(entry):
    """NURBS_ON_AXIS becomes the function on_axis."""
    yield ""
    parameters = ", ".join(f"{name}: int" for name in entry.parameters)
    yield f"def {entry.name.removeprefix('NURBS_').lower()}({parameters}) -> int:"
    yield f'    """{entry.text.rstrip(".")}: the macro {entry.name}."""'
    yield f"    return {translated(entry.body)}"
    yield ""


def constants(manual):
    lines = [CONSTANTS_HEAD]
    lines += [line for group in manual.groups for line in constant_group(group)]
    lines += [line for entry in manual.macros for line in macro(entry)]
    return "\n".join(lines)


def result_letter(function):
    return "s" if "*" in function.result else LETTERS[function.result]


def prototypes(manual):
    lines = [PROTOTYPES_HEAD, "PROTOTYPES = {"]
    for function in manual.functions:
        letters = "".join("p" if entry.pointers else LETTERS[entry.base] for entry in function.parameters)
        lines.append(f'    "{function.name}": "{result_letter(function)} {letters}",')
    return "\n".join(lines) + "\n}\n"


FILES = {f"{FOLDER}/constants.py": constants, f"{FOLDER}/_prototypes.py": prototypes}
