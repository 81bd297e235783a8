#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether an example tells a story, in which ROUNDING stands for numbers of at most 1e-13.

usage: check_story.py STORY COMMAND...     STORY is a file; exits with 77 if the command does, without its language
"""

import difflib
import pathlib
import re
import subprocess
import sys


def told(text):
    """The lines of an output without what differs between languages: digits of rounding, and blanks before numbers."""
    def number(match):
        return " ROUNDING" if float(match[1]) <= 1e-13 else match[0]

    return [re.sub(r" +(\d[\d.]*[eE]-?\d+|0)$", number, line) for line in text.splitlines()]


def main():
    run = subprocess.run(sys.argv[2:], stdout=subprocess.PIPE, text=True)
    if run.returncode == 77:
        print(run.stdout, end="")
        return 77
    wanted = pathlib.Path(sys.argv[1]).read_text().splitlines()
    found = told(run.stdout)
    difference = "\n".join(difflib.unified_diff(wanted, found, "the story", "this example", lineterm=""))
    print(difference or run.stdout, end="")
    return 0 if run.returncode == 0 and found == wanted else 1


if __name__ == "__main__":
    sys.exit(main())
