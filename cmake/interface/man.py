#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the manual pages of section 3: one for each function, and nurbs(3), which holds the rest of the header.

    man.py TOP OUTPUT_FOLDER       TOP is the folder of the project

The same header gives the same bytes: pages carry the version, and no date.
"""

import re
import sys
import textwrap
from pathlib import Path

import header
import roff

SYNOPSIS_WIDTH = 76
LONG_NAME = 80
PROPER_NAMES = ("Bernstein", "Bezier", "Frenet", "Greville")


def title(manual, name):
    """Without hyphenation and justification, which do not suit names and formulas."""
    head = f'.TH {name.upper()} 3 "" "libnurbs {manual.version}" "libnurbs"'
    return head + "\n.nh\n.ad l"


def name_line(name, text):
    """One line, as whatis(1) shows it, with a small first letter where that is no name or symbol."""
    text = text.rstrip(".")
    if len(text) > LONG_NAME:
        text = re.split(r"[:;] ", text)[0]
    if re.match(r"[A-Z][a-z]*(?=[ ,])", text) and not text.startswith(PROPER_NAMES):
        text = text[0].lower() + text[1:]
    return f"{name} \\- {roff.inline(text)}"


# A function.


def synopsis(function):
    """The declaration, with the names of parameters in italics."""
    space = "" if function.result.endswith("*") else " "
    head = f"{function.result}{space}{function.name}("
    words = [f"{kind}{'' if kind.endswith('*') else ' '}@{name}@" for kind, name in
             ((entry.c_type, entry.name) for entry in function.parameters)] or ["void"]
    text = ", ".join(word.replace(" ", "\0") for word in words) + ");"
    indent = " " * min(len(head), 24)
    lines = textwrap.wrap(text, SYNOPSIS_WIDTH - len(indent), break_long_words=False, break_on_hyphens=False)
    lines = [(indent if number else head) + line.replace("\0", " ") for number, line in enumerate(lines)]
    yield ".nf"
    yield roff.line(r"\fB#include <nurbs/nurbs.h>\fP")
    yield ".PP"
    for line in lines:
        yield r"\fB" + re.sub(r"@(\w+)@", r"\\fI\1\\fB", line) + r"\fP"
    yield ".fi"
    yield ".PP"
    yield r"Link with \fI\-lnurbs\fP."


def parameters(function):
    """Those that share their description share an entry."""
    entries = list(function.parameters)
    while entries:
        first = entries[0]
        same = [entry for entry in entries if function.described[entry.name] == function.described[first.name]]
        entries = [entry for entry in entries if entry not in same]
        shape = f" {roff.symbols(first.shape)}" if first.shape else ""
        null = ", may be NULL" if first.nullable else ""
        text = f"{first.text.rstrip('.')}; or NULL{first.null}.".lstrip("; ") if first.null else first.text
        yield ".TP"
        yield rf"\fI{', '.join(entry.name for entry in same)}\fR{shape} ({first.direction}{null})"
        yield from roff.filled(text) or [r"\&"]


def returned(function):
    """With the statuses that stand in the text of another function."""
    text = header.full_statuses(function.returns)
    yield from roff.filled(text[0].upper() + text[1:])
    if function.result == "nurbs_status" and text.startswith("as for"):
        yield ".PP"
        yield from roff.filled("These are: " + ", ".join(function.statuses) + ".")


def related(function):
    """Functions that the comment names."""
    words = re.findall(r"(nurbs_\w+)\(\)", function.text + function.returns
                       + " ".join(text for _, text in function.described.values()))
    return sorted(set(words) - {function.name})


def function_page(manual, function):
    yield title(manual, function.name)
    yield ".SH NAME"
    yield name_line(function.name, function.brief)
    yield ".SH SYNOPSIS"
    yield from synopsis(function)
    yield ".SH DESCRIPTION"
    yield from roff.body(function.text)
    if function.parameters:
        yield ".SH PARAMETERS"
        yield from parameters(function)
    if function.returns:
        yield ".SH RETURN VALUE"
        yield from returned(function)
    yield ".SH HISTORY"
    yield f"Since version {function.since}."
    yield ".SH SEE ALSO"
    names = [f"`{name}`(3)" for name in related(function)]
    yield from roff.filled(", ".join([f'`nurbs`(3), chapter "{function.module.title}"', *names]))


# The overview.


def constant(entry):
    yield ".TP"
    yield rf"\fB{entry.name}\fP = {roff.symbols(entry.literal)}"
    yield from roff.filled(entry.text)


def chapter(module):
    yield from roff.heading(".SH", f"{module.title}")
    yield from roff.body(module.text)
    for function in module.functions:
        yield ".TP"
        yield rf"\fB{function.name}\fP(3)"
        yield from roff.filled(function.brief)


def constants(manual):
    yield ".SH CONSTANTS"
    for group in manual.groups:
        yield from roff.heading(".SS", group.title)
        yield from roff.body(group.text)
        for entry in group.constants:
            yield from constant(entry)
    yield ".SS Macros"
    for macro in manual.macros:
        yield ".TP"
        yield rf"\fB{macro.name}\fP({', '.join(macro.parameters)})"
        yield from roff.filled(macro.text)


def prototype(entry):
    """A callback as C declares it."""
    told = ", ".join(f"{word.c_type}{'' if word.pointers else ' '}{word.name}" for word in entry.parameters)
    return f"{entry.result} (*{entry.name})({told})"


def types(manual):
    yield ".SH TYPES"
    named = {**manual.handles, **{name: text for name, (_, text) in manual.aliases.items()},
             **{prototype(entry): entry.text for entry in manual.callbacks.values()}}
    for name, text in named.items():
        yield ".TP"
        yield rf"\fB{name}\fP"
        yield from roff.filled(text)
    for struct in manual.structs:
        yield ".TP"
        yield rf"\fBstruct {struct.name}\fP"
        yield from roff.filled(struct.text)
        for entry in struct.fields:
            space = "" if entry.pointers else " "
            yield ".IP"
            yield from roff.filled(f"`{entry.c_type}{space}{entry.name}`: {entry.described}.")


def overview(manual):
    first, _, rest = manual.preamble.partition("\n")
    yield title(manual, "nurbs")
    yield ".SH NAME"
    yield name_line("nurbs", first)
    yield ".SH SYNOPSIS"
    yield ".nf"
    yield r"\fB#include <nurbs/nurbs.h>\fP"
    yield ".fi"
    yield ".PP"
    yield r"cc program.c \fI\-lnurbs\fP"
    yield from roff.body(rest)
    for module in manual.modules:
        yield from chapter(module)
    yield from constants(manual)
    yield from types(manual)


def pages(manual):
    """{file name: text}"""
    found = {"nurbs.3": overview(manual)}
    found |= {f"{function.name}.3": function_page(manual, function) for function in manual.functions}
    notice = f'.\\" Generated from {header.PATH} by cmake/interface/man.py\n'
    return {name: notice + "\n".join(lines) + "\n" for name, lines in found.items()}


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = Path(arguments[1])
    folder.mkdir(parents=True, exist_ok=True)
    written = pages(header.read(arguments[0]))
    for name, text in written.items():
        (folder / name).write_text(text, encoding="utf-8")
    print(f"{len(written)} manual pages in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
