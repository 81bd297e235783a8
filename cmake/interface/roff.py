# SPDX-License-Identifier: MIT
"""Comments of the header, in Markdown, as text for man(7)."""

import re
import textwrap

WIDTH = 100
SPECIAL = {"\\": r"\e", "^": r"\(ha", "~": r"\(ti", "'": r"\(aq", "`": r"\(ga"}


def symbols(text):
    """Characters that stand for themselves; a hyphen between letters stays one, any other is a minus."""
    text = "".join(SPECIAL.get(letter, letter) for letter in text)
    return re.sub(r"(?<![A-Za-z])-|-(?![A-Za-z])", r"\\-", text)


def inline(text):
    """Code and emphasis in bold."""
    parts = re.split(r"`([^`]*)`|\*\*([^*]+)\*\*", text)
    plain, code, strong = parts[::3], parts[1::3], parts[2::3]
    marked = [rf"\fB{symbols(a or b)}\fP" for a, b in zip(code, strong)] + [""]
    return "".join(symbols(a) + b for a, b in zip(plain, marked))


def line(text):
    """A line of text, which must not be taken for a request."""
    return r"\&" + text if text.startswith((".", "'")) else text


def heading(macro, text):
    yield f'{macro} "{symbols(text)}"'


def filled(text):
    lines = textwrap.wrap(inline(" ".join(text.split())), WIDTH, break_long_words=False, break_on_hyphens=False)
    return [line(part) for part in lines]


def literal(lines):
    """A formula or table, as it stands."""
    margin = min(len(text) - len(text.lstrip()) for text in lines if text.strip())
    return [".PP", ".in +4n", ".nf", *(line(symbols(text[margin:])) or r"\&" for text in lines), ".fi", ".in"]


def list_items(block):
    for item in re.split(r"\n(?=- )", block):
        yield r".IP \(bu 2"
        yield from filled(item.removeprefix("- "))


def indented_code(match):
    return "".join(f"\n    {part}" for part in match[1].split("\n")) + "\n"


def blocks(text):
    """Paragraphs; those that are indented and follow each other are one. Code between its marks becomes indented."""
    found = []
    text = re.sub(r"^\\code\n(.*?)\n\\endcode$", indented_code, text, flags=re.M | re.S)
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        if block.startswith("    ") and found and found[-1].startswith("    "):
            found[-1] += "\n\n" + block
        elif block.strip():
            found.append(block)
    return found


def body(text):
    """Paragraphs, lists, formulas and headings."""
    for number, block in enumerate(blocks(text)):
        first, _, rest = block.partition("\n")
        if first.startswith("# "):
            yield from heading(".SH", first[2:])
            yield from body(rest)
        elif block.startswith("- "):
            yield from list_items(block)
        elif block.startswith("    "):
            yield from literal(block.split("\n"))
        elif "\n- " in block:
            before, after = block.split("\n- ", 1)
            yield from body(before)
            yield from list_items("- " + after)
        else:
            yield from [".PP"] * (number > 0)
            yield from filled(block)
