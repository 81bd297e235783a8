#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example that cuts files: of a bushing all lines are loops, with the areas of rings; of the hull and the blade of the
files of the tests the picture is the one that the README shows, and the sections of the blade close.

    check_cut.py PROGRAM PICTURE.svg OUTPUT_FOLDER MODELS
"""

import math
import os
import pathlib
import re
import subprocess
import sys

from check_gallery import cells, check_same

TOLD = re.compile(r"across (.): (\d+) loops closed to (\S+), (\d+) open lines, (proven to be all|there may be more); areas (.*)")


def run(program, picture, *files):
    """[(axis, loops, gap, open lines, complete, areas)], three of each file"""
    result = subprocess.run([program, picture, *files], capture_output=True, text=True, timeout=60)
    print(result.stdout + result.stderr)
    assert result.returncode == 0 and not result.stderr
    return [(axis, int(loops), float(gap), int(lines), proof == "proven to be all", [float(area) for area in areas.split()])
            for axis, loops, gap, lines, proof, areas in TOLD.findall(result.stdout)]


def check_bushing(program, folder, models):
    found = run(program, folder / "bushing.svg", models / "bushing.step")
    assert [one[0] for one in found] == ["x", "y", "z"]
    for _, loops, gap, lines, complete, _ in found:
        assert loops >= 100 and lines == 0 and complete and gap < 1e-6, found
    assert len(found[2][5]) == 20 and all(abs(area - math.pi * (5**2 - 3**2)) < 0.2 for area in found[2][5]), found[2]


def check_real_files(program, folder, shown):
    data = os.environ.get("NURBS_TEST_DATA")
    if not data:
        print("without NURBS_TEST_DATA: the hull and the blade are left out")
        return
    files = [pathlib.Path(data, name) for name in ("goteborg_hull.iges", "iea15mw_blade.igs")]
    found = run(program, folder / "cut.svg", *files)
    check_same(cells(folder / "cut.svg"), cells(shown))
    _, loops, gap, lines, complete, areas = found[5]
    assert (loops, lines, complete) == (100, 0, True) and gap < 1e-12, found[5]
    assert areas == sorted(areas, reverse=True) and abs(areas[0] - math.pi * 2.6**2) < 0.1


def main():
    program, shown, folder, models = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
    folder.mkdir(parents=True, exist_ok=True)
    check_bushing(program, folder, models)
    check_real_files(program, folder, shown)
    assert subprocess.run([program, folder / "a.svg", folder / "missing.step"], stderr=subprocess.DEVNULL).returncode == 1
    assert subprocess.run([program], stderr=subprocess.DEVNULL).returncode == 2


if __name__ == "__main__":
    main()
