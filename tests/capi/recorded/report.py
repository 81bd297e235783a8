# SPDX-License-Identifier: MIT
"""Records all outputs with two builds of the library, and prints what differs.

usage: report.py FOLDER [OPTION...]

FOLDER has the program record_outputs, which gets the options, and the libraries in its folders before and after.
"""

import itertools
import math
import os
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

SIDES = ("before", "after")


class Builds:
    """The program, with either library."""

    def __init__(self, folder, options):
        self.folder = folder
        self.options = options

    def start(self, side, hidden, *arguments):
        environment = {**os.environ, "LD_LIBRARY_PATH": str(self.folder / side)}
        if hidden:
            environment["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=" + ",".join(f"-{name}" for name in hidden)
        command = [self.folder / "record_outputs", *self.options, *arguments]
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)

    def both(self, hidden, *arguments):
        """The lines of every section, with one library and with the other."""
        programs = [self.start(side, hidden, *arguments) for side in SIDES]
        groups = (itertools.groupby(program.stdout, section_of) for program in programs)
        for (name, left), (other, right) in itertools.zip_longest(*groups, fillvalue=("", ())):
            if name != other:
                break
            yield list(left), list(right)
        for side, program in zip(SIDES, programs):
            program.stdout.close()
            if program.wait() != 0:
                sys.exit(f"record_outputs ends with {program.returncode} with the library {side}")


def section_of(line):
    return line.split(" ", 1)[0]


@dataclass
class Difference:
    """What differs in one output of a function."""

    sections: list = field(default_factory=list)
    absolute: float = 0.0
    relative: float = 0.0  # to the largest value of the array
    words: dict = field(default_factory=dict)  # in their order; what cannot be told in numbers

    def compare(self, before, after):
        """The values of one call."""
        if len(before) != len(after):
            self.words[f"{len(before)} -> {len(after)} values"] = True
            return
        largest = max((abs(x) for x in itertools.chain(before, after) if math.isfinite(x)), default=0)
        for x, y in zip(before, after):
            difference = 0 if x == y or (math.isnan(x) and math.isnan(y)) else abs(x - y)
            difference = math.inf if math.isnan(difference) else difference
            self.absolute = max(self.absolute, difference)
            self.relative = max(self.relative, difference / largest if difference else 0)

    def status(self, before, after):
        self.words[f"{before} -> {after}"] = True

    def told(self):
        numbers = [f"{self.absolute:.3g}", f"{self.relative:.3g}"] if self.absolute else ["", ""]
        words = list(self.words)
        return [*numbers, ", ".join(words[:3]) + (", ..." if len(words) > 3 else "")]


def keyed(lines, width):
    """The rest of each line by its first words, several of the same ones in a list."""
    found = {}
    for line in lines:
        *key, rest = line.rstrip("\n").split(" ", width)
        found.setdefault(tuple(key), []).append(rest)
    return found


def differing(builds, hidden):
    """Difference by function and output, and the number of all outputs."""
    found, total = {}, 0
    for before, after in builds.both(hidden, "/dev/stdout"):
        total += len(after)
        if before == after:
            continue
        left, right = keyed(before, 3), keyed(after, 3)
        for key in {**left, **right}:
            if left.get(key) != right.get(key):
                found.setdefault(key[1:], Difference()).sections.append(key[0])
    return found, total


def numbers(text):
    return [float.fromhex(word) for word in text.removeprefix("=").split()]


def compare_call(difference, output, before, after):
    if output == "return":
        difference.status(*(text.removeprefix("= ") for text in (before, after)))
    elif output != "message":
        difference.compare(numbers(before), numbers(after))


def is_values(line):
    return " = " in line or line.endswith(" =\n")


def one_of(names):
    """A regular expression."""
    return f"^({'|'.join(sorted(names))})$".replace(".", "\\.")


def measure(builds, hidden, found):
    """Adds how much values differ."""
    functions = one_of({function for function, _ in found})
    sections = one_of({section for difference in found.values() for section in difference.sections})
    for before, after in builds.both(hidden, "--values", functions, "--sections", sections, "/dev/stdout"):
        left, right = (keyed(filter(is_values, lines), 3) for lines in (before, after))
        for key in left.keys() & right.keys() if left != right else ():
            if len(left[key]) != len(right[key]):
                found[key[1:]].words[f"{len(left[key])} -> {len(right[key])} calls"] = True
            for pair in zip(left[key], right[key]):
                if pair[0] != pair[1] and key[1:] in found:
                    compare_call(found[key[1:]], key[2], *pair)


def print_table(rows):
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    for row in rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def report(builds, hidden):
    """Whether all are equal."""
    found, total = differing(builds, hidden)
    count = sum(len(difference.sections) for difference in found.values())
    without = f"without {' and '.join(hidden)}: " if hidden else ""
    print(f"{without}{count} of {total} outputs differ", flush=True)
    if found:
        measure(builds, hidden, found)
        head = ["function", "output", "sections", "the first", "absolute", "relative", ""]
        rows = [[*key, str(len(each.sections)), each.sections[0], *each.told()] for key, each in sorted(found.items())]
        print_table([head, *rows])
    return not found


def hidden_sets():
    """What to hide from the library, so that it chooses each of its instruction sets in turn."""
    flags = Path("/proc/cpuinfo").read_text(encoding="ascii").split()
    wide = [name for name in ("AVX512F", "AVX2") if name.lower() in flags]
    return [tuple(wide[:count]) for count in range(len(wide) + 1)]


def main():
    builds = Builds(Path(sys.argv[1]), sys.argv[2:])
    return 0 if all([report(builds, hidden) for hidden in hidden_sets()]) else 1


sys.exit(main())
