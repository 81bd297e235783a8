#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the quickstart example and looks at what it prints and writes.

    check_quickstart.py PROGRAM FILE.igs OUTPUT_FOLDER
"""

import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

SVG = "{http://www.w3.org/2000/svg}"


def run(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True, timeout=30)


def check_report(text):
    moved = [float(number) for number in re.findall(r"the shape moved by (\S+) eps \* hull", text)]
    # Each inserted knot may add 2 eps * hull, and evaluating twice adds twice the bound of the accuracy contract.
    assert len(moved) == 2 and max(moved) <= 32, moved
    assert re.search(r"^teapot.* surface +3 x 3", text, re.M), "the teapot is listed"
    assert re.search(r"^circle .*rational", text, re.M), "a rational curve is listed"


def check_drawing(path):
    root = xml.parse(path).getroot()
    styles = [element.get("class") for element in root.iter() if element.get("class")]
    for style in ("before", "after", "curve", "knot", "new"):
        assert style in styles, f"nothing is drawn as {style}"
    width, height = map(float, root.get("viewBox").split()[2:])
    for circle in root.iter(f"{SVG}circle"):
        assert 0 < float(circle.get("cx")) < width and 0 < float(circle.get("cy")) < height, "a dot outside the picture"


def check_mesh(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    vertices = [line for line in lines if line[0] == "v"]
    normals = [[float(x) for x in line[1:]] for line in lines if line[0] == "vn"]
    assert len(vertices) == len(normals) > 0 and any(line[0] == "f" for line in lines)
    assert all(abs(math.hypot(*normal) - 1) < 1e-3 for normal in normals), "a normal is not of length 1"


def main():
    program, model, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    result = run(program, model, str(folder))
    print(result.stdout + result.stderr)
    assert result.returncode == 0
    check_report(result.stdout)
    check_drawing(folder / "curve.svg")
    check_mesh(folder / "surfaces.obj")
    bad = run(program, __file__, str(folder))
    print(bad.stderr)
    assert bad.returncode == 1 and "NURBS_ERROR_FORMAT" in bad.stderr
    assert run(program, model, str(folder / "missing")).returncode == 1


if __name__ == "__main__":
    main()
