#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs an example that fits with several processes, really with two, and compares with one process: statistics and curve are
the same bits.

    check_fit_machines.py dask|mpi EXAMPLES OUTPUT_FOLDER
"""

import importlib
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import sys

CHUNKS = 7  # no multiple of the processes


def imported(kind):
    """The example as a module. A process that has started MPI itself cannot run mpirun."""
    try:
        if kind == "mpi":
            importlib.import_module("mpi4py").rc(initialize=False)
        return importlib.import_module(f"fit_{kind}")
    except ImportError as error:
        skip(error)


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(77)


def command(kind):
    """How the example is started with two processes."""
    if kind == "dask":
        return [sys.executable, "--workers", "2"]
    if not shutil.which("mpirun"):
        skip("mpirun is not installed")
    # Two processes also where there is one core; Open MPI asks whether root means it.
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", *root, "--oversubscribe", "-n", "2", sys.executable]


def run(start, program, *arguments):
    at = start.index(sys.executable) + 1
    done = subprocess.run([*start[:at], str(program), *start[at:], *arguments], capture_output=True, text=True, timeout=300)
    print(done.stdout + done.stderr)
    assert done.returncode == 0, f"{program.name} ended with {done.returncode}"
    return done.stdout


def alone(example):
    """What one process finds that has all points at once."""
    t, points = map(example.np.concatenate, zip(*map(example.chunk, range(CHUNKS))))
    total = example.EMPTY.add(t, points)
    return total, total.fit(3, example.KNOTS, smoothing="gcv").spline


def main():
    kind, examples, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
    sys.path.insert(0, str(examples))
    example = imported(kind)
    folder.mkdir(parents=True, exist_ok=True)
    saved = folder / "saved"
    saved.unlink(missing_ok=True)
    text = run(command(kind), examples / f"fit_{kind}.py", "--points", str(CHUNKS * example.CHUNK), "--save", str(saved))
    assert re.search(rf"^{CHUNKS * example.CHUNK} points, 131 control points, rms 0.0\d+$", text, flags=re.M)
    assert re.search(r"^at most \d+ MB in each of 2 processes$", text, flags=re.M)
    total, curve = pickle.loads(saved.read_bytes())
    one, one_curve = alone(example)
    assert total.to_bytes() == one.to_bytes(), "the statistics differ from those of one process"
    assert curve.points.tobytes() == one_curve.points.tobytes(), "the curve differs from that of one process"


if __name__ == "__main__":
    main()
