#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""STEP and IGES files read by this library and by Open CASCADE: one table, all of it measured in the same run, by turns.

    files.py PROGRAMS [--passes N]

PROGRAMS is the folder of bench_files_nurbs, and of bench_files_occt if that was built. Read are the bushing of the examples,
2000 of them in one file, and the STEP and IGES files in the folder that the environment variable NURBS_TEST_DATA names. "read" is
from the path to faces that can be asked; Open CASCADE's transfer, which heals shapes, is in it. "areas" is that and the sum of
the areas of all faces, to 1e-6. Times are milliseconds of process time, medians of the passes. The exit status is 1 if ours is
missing, or if two libraries find other numbers of faces, or areas that differ by more than 1e-3 of them; a file that Open
CASCADE does not read is told. What ours reads it also writes, in both formats, and the other library has to find the same there:
the largest difference of areas is told.
"""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys

BUSHING = pathlib.Path(__file__).resolve().parents[3] / "capi/examples/models/bushing.step"
LIBRARIES = {"libnurbs": "bench_files_nurbs", "Open CASCADE": "bench_files_occt"}
COPIES = 2000
LIMIT = 300  # seconds for one file
#: What areas may differ by. Those of boxed_sphere do by 4e-4: the file states an uncertainty of 0.1 mm. On its small faces ours agree
#: with polygons of many corners that were projected from the edges of the file.
CLOSE = 1e-3


def copies(text, count):
    """A file with so many of what one holds: instances are numbered on."""
    head, data, tail = re.fullmatch(r"(.*?\nDATA;\n)(.*?)(ENDSEC;\nEND-ISO-10303-21;\n)", text, re.S).groups()
    step = max(map(int, re.findall(r"#(\d+)", data)))

    def numbered(k):
        return re.sub(r"#(\d+)", lambda name: f"#{int(name[1]) + k * step}", data)

    return head + "".join(map(numbered, range(count))) + tail


def files(folder):
    """{name: path}"""
    folder.mkdir(parents=True, exist_ok=True)
    many = folder / "bushings.step"
    many.write_text(copies(BUSHING.read_text(encoding="ascii"), COPIES), encoding="ascii")
    found = {"a bushing": BUSHING, f"{COPIES} bushings": many}
    data = os.environ.get("NURBS_TEST_DATA")
    real = sorted(path for end in ("step", "stp", "iges", "igs") for path in pathlib.Path(data).glob(f"*.{end}")) if data else []
    return {**found, **{path.stem: path for path in real}}


def measured(program, path):
    """What a program says, or None if it does not read the file."""
    run = subprocess.run([program, path], capture_output=True, text=True, timeout=LIMIT, check=False)
    if run.returncode != 0:
        print(f"{program.name}: {path.name}: {run.stderr.strip()}", file=sys.stderr)
        return None
    return json.loads(run.stdout.splitlines()[-1])


def middle(runs):
    """The last answer, with the medians of the times."""
    good = [run for run in runs if run]
    return {**good[-1], **{key: statistics.median(run[key] for run in good) for key in ("read", "areas")}} if good else None


def difference(name, ours, other):
    """What is wrong with two answers, or None."""
    if ours is None:
        return f"{name} is not read"
    if other is None:
        return None
    if ours["faces"] != other["faces"]:
        return f"{name}: {ours['faces']} faces, the other library has {other['faces']}"
    if abs(ours["area"] - other["area"]) > CLOSE * abs(other["area"]):
        return f"{name}: area {ours['area']}, the other library has {other['area']}"
    return None


def written(programs, folder, name, path, ours):
    """What the other library finds in our copies of a file: differences of areas, and what is wrong."""
    apart, problems = [], []
    for end in ("step", "iges"):
        copy = folder / f"copy.{end}"
        subprocess.run([programs["libnurbs"], path, copy], timeout=LIMIT, check=True)
        other = measured(programs["Open CASCADE"], copy)
        problems += filter(None, [difference(f"{name}, written as {end}", ours, other), None if other else f"{copy} is not read"])
        apart += [abs(other["area"] / ours["area"] - 1)] if other else []
    return max(apart, default=0), problems


def row(name, ours, other):
    def pair(key):
        theirs = f"{other[key]:.3g}" if other else "–"
        ratio = f"{other[key] / ours[key]:.2g}" if other else ""
        return f"{ours[key]:.3g} | {theirs} | {ratio}"

    return f"| {name} | {ours['faces']} | {pair('read')} | {pair('areas')} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--passes", type=int, default=5)
    options = parser.parse_args()
    programs = {library: options.programs / name for library, name in LIBRARIES.items()}
    for library in [library for library, program in programs.items() if not program.exists()]:
        print(f"SKIPPED: {library}: {programs.pop(library).name} is not built")
    print("| milliseconds | faces | read, libnurbs | Open CASCADE | ratio | areas, libnurbs | Open CASCADE | ratio |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    problems = [] if "libnurbs" in programs else ["there is nothing to measure"]
    data = options.programs / "data"
    for name, path in files(data).items():
        runs = {library: [] for library in LIBRARIES}
        for _ in range(options.passes):
            for library, program in programs.items():
                runs[library].append(measured(program, path))
        ours, other = (middle(of) for of in runs.values())
        problems += filter(None, [difference(name, ours, other)])
        if ours:
            print(row(name, ours, other), flush=True)
        if ours and other:
            apart, wrong = written(programs, data, name, path, ours)
            print(f"written by libnurbs, read by Open CASCADE: {name}: areas differ by {apart:.1e}", file=sys.stderr)
            problems += wrong
    print(*problems, sep="\n", end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
