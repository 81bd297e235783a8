#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the gallery example: it draws each construction of nurbs.h, and draws what the README shows.

    check_gallery.py PROGRAM PICTURE.svg OUTPUT_FOLDER TOP
"""

import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project

CHAPTERS = ("curves", "shapes", "coons", "recognize", "fit")
SVG = "{http://www.w3.org/2000/svg}"


def cells(path):
    """{label: what is drawn in the cell, path by path}"""
    found = {}
    for cell in xml.parse(path).getroot().iter(f"{SVG}g"):
        paths = [(line.get("class"), line.get("d")) for line in cell.iter(f"{SVG}path")]
        assert paths, f"an empty cell in {path}"
        found[cell.find(f"{SVG}text").text] = paths
    return found


def alike(a, b):
    """Two paths that differ by no more than rounding to whole units does, in each step."""
    (style, path), (other_style, other) = a, b
    words, other_words = (re.findall(r"-?\d+|[A-Za-z]", text) for text in (path, other))
    return style == other_style and len(words) == len(other_words) and all(
        x == y or (x[-1].isdigit() and y[-1].isdigit() and abs(int(x) - int(y)) <= 2)
        for x, y in zip(words, other_words))


def check_same(drawn, shown):
    """The same picture but for coordinates that another processor rounds to a neighbour, and a few of which shades and
    order are on the edge."""
    assert list(drawn) == list(shown), f"cells differ: {set(drawn) ^ set(shown)}"
    for label, paths in drawn.items():
        new = [path for path in paths if path not in shown[label]]
        old = [path for path in shown[label] if path not in paths]
        different = max(len(new), len(old)) - sum(alike(a, b) for a, b in zip(new, old))
        assert different <= 0.05 * len(paths), f"{label} is drawn in another way"


def check_complete(top):
    """Every function of these chapters is called, but for second forms."""
    sources = [top / "capi/examples/gallery.c", *(top / "capi/examples/gallery").glob("*.h")]
    text = "\n".join(path.read_text() for path in sources)
    functions = [function for function in header.read(top).functions
                 if function.module.name in CHAPTERS and not function.name.endswith("_with")]
    missing = [function.name for function in functions if not re.search(rf"\b{function.name}\(", text)]
    assert len(functions) > 40
    assert not missing, f"not drawn: {missing}"


def main():
    program, shown, folder, top = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
    folder.mkdir(parents=True, exist_ok=True)
    result = subprocess.run([program, folder / "gallery.svg"], capture_output=True, text=True, timeout=60)
    print(result.stdout + result.stderr)
    assert result.returncode == 0
    assert "recognized a torus: radii 2 and 0.5" in result.stdout
    check_complete(top)
    check_same(cells(folder / "gallery.svg"), cells(shown))
    assert subprocess.run([program, folder / "missing" / "gallery.svg"], stderr=subprocess.DEVNULL).returncode == 1


if __name__ == "__main__":
    main()
