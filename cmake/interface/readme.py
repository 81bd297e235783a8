# SPDX-License-Identifier: MIT
"""README's table of all functions: a row for each chapter of the header."""

import re
from pathlib import Path

PATH = "README.md"
TOP = Path(__file__).resolve().parents[2]
HEAD = "| Chapter | Functions |\n|---|---|\n"


def row(module, manual):
    """The forms of functions that can be watched stand in one row, that of long calls."""
    plain = [function for function in module.functions if manual.plain(function) is None]
    text = names(plain)
    if module.name == "call":
        watched = [manual.plain(function) for function in manual.functions if manual.plain(function)]
        text += f"; `nurbs_X_with` for {names(watched)}"
    return f"| {module.title} | {text} |\n"


def names(functions):
    return ", ".join(f"`{function.name}`" for function in functions)


def contents(manual):
    """The whole file with the table as it should be."""
    table = HEAD + "".join(row(module, manual) for module in manual.modules if module.functions)
    text = (TOP / PATH).read_text(encoding="utf-8")
    return re.sub(re.escape(HEAD) + r"(\|.*\n)+", lambda _: table, text, count=1)


FILES = {PATH: contents}
