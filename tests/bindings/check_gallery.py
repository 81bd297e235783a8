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

from check_coverage import header_functions, without_comments

SVG = "{http://www.w3.org/2000/svg}"


def cells(path):
    """{label: what is drawn in the cell, path by path}"""
    found = {}
    for cell in xml.parse(path).getroot().iter(f"{SVG}g"):
        paths = [(line.get("class"), line.get("d")) for line in cell.iter(f"{SVG}path")]
        assert paths, f"an empty cell in {path}"
        found[cell.find(f"{SVG}text").text] = paths
    return found


def check_same(drawn, shown):
    """The same picture but for coordinates that another processor rounds to a neighbour, or paints in another order."""
    assert list(drawn) == list(shown), f"cells differ: {set(drawn) ^ set(shown)}"
    for label, paths in drawn.items():
        different = set(paths) ^ set(shown[label])
        assert len(different) <= 0.1 * (len(paths) + len(shown[label])), f"{label} is drawn in another way"


def constructions(top):
    header = (top / "include/nurbs/nurbs.h").read_text()
    text = header[header.index("\\defgroup curves"):header.index("\\defgroup linear")]
    return list(header_functions(without_comments("/*" + text)))


def check_complete(top):
    """Every function of these groups is called."""
    sources = [top / "capi/examples/gallery.c", *(top / "capi/examples/gallery").glob("*.h")]
    text = "\n".join(path.read_text() for path in sources)
    missing = [name for name in constructions(top) if not re.search(rf"\b{name}\(", text)]
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
