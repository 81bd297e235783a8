#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example that draws fits: it draws what the README shows.

    check_fitting_plots.py EXAMPLE PICTURE.svg OUTPUT_FOLDER
"""

import importlib.util
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

SVG = "{http://www.w3.org/2000/svg}"
NUMBER = r"\d+(?:\.\d+)?"


def contents(path):
    """What is written, and how many marks and lines there are."""
    root = xml.parse(path).getroot()
    texts = ["".join(text.itertext()) for text in root.iter(f"{SVG}text")]
    return texts, [len(list(root.iter(f"{SVG}{tag}"))) for tag in ("use", "path", "image")]


def check_alike(drawn, shown):
    """The same words, and numbers that differ by no more than another processor makes them."""
    for new, old in zip(drawn, shown):
        assert re.split(NUMBER, new) == re.split(NUMBER, old), f"{new!r} where {old!r} is shown"
        for x, y in zip(re.findall(NUMBER, new), re.findall(NUMBER, old)):
            assert abs(float(x) - float(y)) <= 0.05 * max(1, float(y)), f"{new!r} where {old!r} is shown"
    assert len(drawn) == len(shown)


def main():
    example, shown, folder = map(pathlib.Path, sys.argv[1:4])
    if importlib.util.find_spec("matplotlib") is None:
        print("SKIPPED: there is no Matplotlib")
        sys.exit(77)
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, example, folder / "fitting.svg"], check=True, timeout=300)
    texts, marks = contents(folder / "fitting.svg")
    texts_shown, marks_shown = contents(shown)
    check_alike(texts, texts_shown)
    assert marks == marks_shown, f"{marks} marks, lines and images, where {marks_shown} are shown"


if __name__ == "__main__":
    main()
