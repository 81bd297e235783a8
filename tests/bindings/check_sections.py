#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example of sections: all of them are found, their areas rise with the height, frames are widest amidships, and the
picture is the one that the README shows.

    check_sections.py PROGRAM PICTURE.svg OUTPUT_FOLDER
"""

import pathlib
import re
import subprocess
import sys

from check_gallery import cells, check_same


def run(*arguments):
    result = subprocess.run(arguments, capture_output=True, text=True, timeout=60)
    print(result.stdout + result.stderr)
    assert result.returncode == 0 and not result.stderr
    return result.stdout


def main():
    program, shown, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
    folder.mkdir(parents=True, exist_ok=True)
    told = run(program, folder / "sections.svg")
    areas = {name: [float(area) for area in re.findall(name + r" at +\S+: area (\S+)", told)] for name in ("waterplane", "frame")}
    assert len(areas["waterplane"]) == len(areas["frame"]) == 8
    assert areas["waterplane"] == sorted(areas["waterplane"])
    widest = areas["frame"].index(max(areas["frame"]))
    assert areas["frame"] == sorted(areas["frame"][:widest]) + sorted(areas["frame"][widest:], reverse=True)
    check_same(cells(folder / "sections.svg"), cells(shown))
    assert subprocess.run([program, folder / "missing" / "hull.svg"], stderr=subprocess.DEVNULL).returncode == 1


if __name__ == "__main__":
    main()
