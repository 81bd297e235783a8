# SPDX-License-Identifier: MIT
"""The type hints of the Python binding: mypy --strict finds nothing in it, and its users get the right types. Skipped
without mypy."""

import pathlib
import re
import subprocess
import sys
import tempfile

import nurbs

USE = '''import numpy as np
import nurbs
spline = nurbs.Spline(1, [0, 0, 1, 1], np.zeros((2, 2)))
reveal_type(spline(np.zeros(3), nu=1))
reveal_type(spline.knots[0])
reveal_type(2 * spline + [1, 2])
reveal_type(spline.remove_knot(0.5).spline.insert_knot(0.5, 2))
reveal_type(spline.closest_points([1, 2]).params)
reveal_type(nurbs.read_file("a")[0].rational)
reveal_type(nurbs.NURBS_CLAMP)
reveal_type(nurbs.Statistics(3, [0, 1], value_scale=1).add([0.5], [1]).fit(0, [0, 1], smoothing="gcv").spline)
reveal_type(nurbs.fit_points([0, 1], [[0, 1], [1, 2]], [1], [[0, 0, 1, 1]], conditions=(0, None, [0, 1])).report.rms)
'''
REVEALED = ["numpy.ndarray", "numpy.ndarray", "nurbs._spline.Spline", "nurbs._spline.Spline", "numpy.ndarray",
            "builtins.bool", "builtins.int", "nurbs._spline.Spline", "builtins.float"]


def mypy(folder, *arguments):
    """What mypy says, without the lines that only sum up."""
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", f"{folder}/cache", *map(str, arguments)]
    lines = subprocess.run(command, capture_output=True, text=True, cwd=folder).stdout.splitlines()
    return [line for line in lines if not re.match(r"Success|Found", line)]


def main():
    package = pathlib.Path(nurbs.__file__).parent
    if not (package / "py.typed").exists():
        print("py.typed is missing: the package does not say that it has types")
        return 1
    if subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode:
        print("SKIPPED: mypy is not installed")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        problems = mypy(folder, package)
        use = pathlib.Path(folder) / "use.py"
        use.write_text(USE)
        said = mypy(folder, use)
    found = [re.sub(r'.*Revealed type is "([\w.]+).*', r"\1", line) for line in said]
    if found != REVEALED:
        problems += ["types that a user sees:", *said]
    print("\n".join(problems) or "no problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
