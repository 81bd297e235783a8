#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the hull example: three points are met, and the picture is the one that the README shows.

    check_hull.py PROGRAM PICTURE.svg OUTPUT_FOLDER
"""

import pathlib
import re
import subprocess
import sys

from check_gallery import cells, check_same


def main():
    program, shown, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
    folder.mkdir(parents=True, exist_ok=True)
    result = subprocess.run([program, folder / "hull.svg"], capture_output=True, text=True, timeout=60)
    print(result.stdout + result.stderr)
    assert result.returncode == 0
    found = re.search(r"3 points, 9 equations: missed by at most (\S+), control points moved by up to (\S+)", result.stdout)
    assert found and float(found[1]) < 4e-12 and 0.5 < float(found[2]) < 2
    check_same(cells(folder / "hull.svg"), cells(shown))
    assert subprocess.run([program, folder / "missing" / "hull.svg"], stderr=subprocess.DEVNULL).returncode == 1


if __name__ == "__main__":
    main()
