#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example that draws models: each file has a picture that is not empty and, with the files of the tests, the one that the
README shows.

    check_model_plots.py EXAMPLE PICTURE.png MODELS OUTPUT_FOLDER
"""

import importlib.util
import os
import pathlib
import subprocess
import sys

DATA = ("boxed_sphere.step", "countersunk_screw.step", "stellarator_magnets.step", "nacelle.stp", "satellite_mainbody.stp",
        "dtmb5415_bow.iges", "goteborg_hull.iges", "pipe_hollow_deformed.iges", "propeller_blade_upper.iges", "propeller_shaft.iges",
        "wigley_hull.iges", "wing.iges", "iea15mw_blade.igs", "nist_ctc_02_splines.json", "utah_teaset.json")
SIDE = 200  # of a cell


def cells(path):
    """The cells of a picture, row by row, as arrays (SIDE, SIDE, 3) of whole numbers."""
    import numpy as np
    from PIL import Image

    dots = np.asarray(Image.open(path).convert("RGB")).astype(int)
    rows, columns = dots.shape[0] // SIDE, dots.shape[1] // SIDE
    assert dots.shape == (rows * SIDE, columns * SIDE, 3), dots.shape
    return list(dots.reshape(rows, SIDE, columns, SIDE, 3).swapaxes(1, 2).reshape(-1, SIDE, SIDE, 3))


def run(example, picture, files):
    subprocess.run([sys.executable, example, picture, *files], check=True, timeout=600)
    drawn = cells(picture)
    for name, cell in zip(files, drawn):
        inked = (cell[SIDE // 8:] < 230).any(axis=-1).mean()
        assert inked > 0.005, f"{name}: {inked:.2%} is drawn"
    return drawn


def main():
    example, shown, models, folder = map(pathlib.Path, sys.argv[1:5])
    if importlib.util.find_spec("matplotlib") is None:
        print("SKIPPED: there is no Matplotlib")
        sys.exit(77)
    folder.mkdir(parents=True, exist_ok=True)
    files, data = [models / "bushing.step", models / "models.igs"], os.environ.get("NURBS_TEST_DATA")
    if data:
        files += [pathlib.Path(data, name) for name in DATA]
    else:
        print("without NURBS_TEST_DATA: only the files of the examples are drawn")
    drawn = run(example, folder / "models.png", files)
    expected = cells(shown)
    assert len(expected) == 18
    for index, (new, old) in enumerate(zip(drawn, expected)):
        different = (abs(new - old).max(axis=-1) > 48).mean()
        assert different < 0.02, f"cell {index}: {different:.2%} is drawn in another way"
    assert subprocess.run([sys.executable, example], stderr=subprocess.DEVNULL).returncode == 1


if __name__ == "__main__":
    main()
