#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example of fits to real data: the results are as close as the noise lets them be, and are drawn.

    check_fit_real.py EXAMPLE OUTPUT_FOLDER
"""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys

# The noise, and how far from the truth a fit may be at most, in the units that the example prints. The bow: no point is off
# by more than a millimetre, and everywhere some are half a millimetre off the truth on either side.
SHAPES = {"section of a wing": (0.05 * 2**0.5, 0.1), "outline of a bow": (0.5 * (2 / 3) ** 0.5, 0.5),
          "side of a ship": (3**0.5, 2)}
LINE = re.compile(r"(.*): (\d+) points, (\d+) control points, rms ([\d.]+), max ([\d.]+) .*; off the true shape by at most ([\d.]+) ")


def main():
    example, folder = map(pathlib.Path, sys.argv[1:3])
    for reason, holds in (("NURBS_TEST_DATA is not set: no real files to read", "NURBS_TEST_DATA" not in os.environ),
                          ("there is no Matplotlib", importlib.util.find_spec("matplotlib") is None)):
        if holds:
            print(f"SKIPPED: {reason}")
            sys.exit(77)
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([sys.executable, example], cwd=folder, capture_output=True, text=True, timeout=300)
    print(done.stdout + done.stderr)
    assert done.returncode == 0
    found = {match[1]: match for match in map(LINE.match, done.stdout.splitlines()) if match}
    assert list(found) == list(SHAPES)
    for what, (noise, off) in SHAPES.items():
        points, count, rms, largest, truth = map(float, found[what].groups()[1:])
        assert count < points / 3, f"{what}: {count} control points"
        assert 0.9 * noise < rms < 1.02 * noise, f"{what}: rms {rms} with noise of {noise}"
        assert rms < largest < 6 * noise, f"{what}: largest {largest}"
        assert truth < off, f"{what}: {truth} off the true shape"
    assert (folder / "fit_real.svg").stat().st_size > 10000


if __name__ == "__main__":
    main()
