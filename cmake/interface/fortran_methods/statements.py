# SPDX-License-Identifier: MIT
"""Lines of Fortran: statements that are broken where they are too long, declarations and comments."""

import layout

WIDTH = 120
STEP = "    "


def comment(text, indent, mark="!> "):
    return layout.comment(STEP * indent + mark, text, WIDTH)


def statement(text, indent, deeper=1):
    """Lines of a statement; those that go on stand deeper."""
    lines, line, start = [], STEP * indent + text, STEP * (indent + deeper)
    while len(line) > WIDTH:
        cut = cut_of(line)
        lines.append(line[:cut] + " &")
        line = start + line[cut + 1:]
    return [*lines, line]


def cut_of(line):
    """The last space in the fewest brackets, if it leaves a line that is more than half full, else the last space."""
    found = [(depth, place) for depth, place in spaces(line) if place < WIDTH - 1]
    good = [(depth, -place) for depth, place in found if place > WIDTH // 2]
    return -min(good)[1] if good else found[-1][1]


def spaces(line):
    """(how many brackets are open, place) of each space after the first word, arrays in one bracket with their call."""
    depth = 0
    for place, letter in enumerate(line):
        depth += (letter == "(") - (letter == ")")
        if letter == " " and line[:place].strip():
            yield depth, place


def listed(head, names, indent):
    """head a, b, c: as many statements as are needed."""
    lines, line = [], ""
    for name in names:
        longer = f"{line}, {name}" if line else f"{STEP * indent}{head} {name}"
        if line and len(longer) > WIDTH:
            lines.append(line)
            longer = f"{STEP * indent}{head} {name}"
        line = longer
    return [*lines, line] if line else lines


def declarations(declared, indent):
    """Of (attributes, name) in their order, one statement for each kind of attributes."""
    found = {}
    for attributes, name in declared:
        found.setdefault(attributes, []).append(name)
    for attributes, names in found.items():
        yield from listed(f"{attributes} ::", names, indent)


def block(condition, statements):
    """if (condition): one statement, or a block."""
    statements = list(statements)
    if len(statements) == 1 and not statements[0].startswith("if "):
        return [f"if ({condition}) {statements[0]}"]
    return [f"if ({condition}) then", *statements, "end if"] if statements else []


def indented(statements, indent):
    """Lines of statements, those of blocks deeper."""
    for text in statements:
        indent -= text in ("else", "end if")
        yield from statement(text, indent)
        indent += text == "else" or text.startswith("if ") and text.endswith(" then")
