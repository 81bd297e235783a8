#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A picture of each file: its faces as triangles, within a pixel of them.

    model_plots.py PICTURE.png FILE...

IGES and STEP files, and JSON files with the degrees, knots, points and weights of surfaces. Needs Matplotlib.
"""

import io
import json
import pathlib
import sys

import matplotlib

import nurbs

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402 - after the choice of what draws
from PIL import Image  # noqa: E402 - which Matplotlib brings along

COLUMNS, CELL, DOTS, COLORS = 6, 1.6, 125, 48  # cells in inches, dots an inch
UP = {"utah_teaset": "y"}  # of others z


def read(path):
    """What a file holds, as a model."""
    if path.suffix != ".json":
        return nurbs.Model.read_file(path)
    surfaces = [entity for entity in json.loads(path.read_text())["entities"] if entity["kind"] == "surface"]
    return nurbs.Model.create([nurbs.Face(nurbs.Spline(one["degree"], one["knots"], one["points"], one["weights"]))
                               for one in surfaces])


def draw(path, ax):
    read(path).plot(ax, relative=4e-3)
    ax.view_init(vertical_axis=UP.get(path.stem, "z"))
    ax.set_axis_off()
    ax.set_title(path.name, fontsize=6.5, y=1)


def write_small(figure, picture):
    """A picture of few colours, which takes a quarter of the bytes."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=DOTS)
    Image.open(drawn).convert("RGB").quantize(COLORS, dither=Image.Dither.NONE).save(picture, optimize=True)


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    files = [pathlib.Path(name) for name in arguments[1:]]
    columns = min(COLUMNS, len(files))
    rows = -(-len(files) // columns)
    figure = plt.figure(figsize=(CELL * columns, CELL * rows))
    for place, path in enumerate(files):
        column, row = place % columns, rows - 1 - place // columns
        draw(path, figure.add_axes((column / columns, row / rows, 1 / columns, 0.88 / rows), projection="3d"))
    write_small(figure, arguments[0])


if __name__ == "__main__":
    main(sys.argv[1:])
