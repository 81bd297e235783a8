#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Meshes by this library and by Open CASCADE: three tables, all of it measured in the same run, by turns.

    meshes.py PROGRAMS [--passes N] [--only REGEX] [--large]

PROGRAMS is the folder of bench_meshes_nurbs and bench_meshes_apart, and of bench_meshes_occt if that was built. Every mesh is made
by a process of its own, in one thread, of a shape without a mesh and with nothing kept from other calls; times are milliseconds
of process time, the best of all runs. Distances ("chord") are absolute, and angles have no limit.

The first table has shapes: the patch, of side 1, and the plane, trimmed or not, are the same splines in both libraries; sphere,
torus and cylinder (radii 1; 3 and 1; 1, of height 2) are what each library has for them. "off" is the largest distance of a sample
of the mesh from the shape or of one of the shape from the mesh, over the chord, sampled in the same way for both; behind it is
what ours proves. The second table has finer and finer meshes of the patch: microseconds and bytes for each triangle, the bytes
those that the process has at most beyond what it had before, and those of the mesh itself. The third one has all faces of
STEP and IGES files: of the examples, and of the folder that the environment variable NURBS_TEST_DATA names; the chord is 1e-3 of
the longest side of the box of the faces. "Wrong" are faces without triangles, and those whose triangles have an area that is off
by a tenth; "off" is told of the middles of triangles and sides, from the surfaces of the faces.

--large adds finer meshes, some of which take Open CASCADE minutes, and has 1e7 samples in place of 1e5. The exit status is 1 if a
sample is farther off than ours proves, if a mesh of a shape does not keep to its chord, or if a face of a file has no triangles.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "capi/examples/models"
LIBRARIES = {"libnurbs": "bench_meshes_nurbs", "Open CASCADE": "bench_meshes_occt"}
LIMIT = 1800  # seconds for one mesh
LONG = 60e3  # milliseconds after which a mesh is not made again
SHARE = 1e-3  # of the size of files

# What is meshed: its title; chords, and what it should take at each in triangles and in milliseconds; chords for --large.
SHAPES = {
    "patch": ("bicubic rational patch", {"1e-3": (6500, 6), "1e-4": (60000, 60)}, ["1e-5"]),
    "plane_polyline": ("plane in a polyline of 1000 corners", {"1e-3": (None, 3)}, []),
    "plane_segments": ("plane in 1000 segments", {"1e-3": (None, 3)}, []),
    "patch_polyline": ("patch in a polyline of 1000 corners", {"1e-3": (None, None)}, ["1e-4"]),
    "patch_segments": ("patch in 1000 segments", {"1e-3": (None, None)}, ["1e-4"]),
    "sphere": ("sphere", {"1e-3": (None, None)}, ["1e-4"]),
    "torus": ("torus", {"1e-3": (None, None)}, ["1e-4"]),
    "cylinder": ("cylinder", {"1e-3": (None, None)}, ["1e-4"]),
}
GROWTH = (["1e-3", "1e-4", "1e-5"], ["1e-6", "2.5e-7"])  # and those that only ours is asked for
GROWN = "patch"


class Runs:
    """What the programs tell."""

    def __init__(self, options):
        self.options = options
        self.programs = {library: options.programs / name for library, name in LIBRARIES.items()
                         if (options.programs / name).exists()}
        self.problems = []
        self.known = {}

    def one(self, library, *arguments):
        """A line of a program; None if it fails or is not there."""
        if library not in self.programs:
            return None
        try:
            run = subprocess.run([self.programs[library], *arguments], capture_output=True, text=True, timeout=LIMIT, check=False)
        except subprocess.TimeoutExpired:
            self.problems += [f"{arguments[0]}: over {LIMIT} s"] if library == "libnurbs" else []
            return {"late": True}
        if run.returncode != 0:
            print(f"{library}: {' '.join(map(str, arguments))}: {run.stderr.strip()[-300:]}", file=sys.stderr)
            if library == "libnurbs":
                self.problems.append(f"{arguments[0]}: there is no mesh")
            return None
        return json.loads(run.stdout.splitlines()[-1])

    def best(self, arguments, libraries=LIBRARIES):
        """The quickest runs of all libraries, by turns; what takes long is not repeated. `arguments` are those of a library."""
        runs = {library: [] for library in LIBRARIES}
        for _ in range(self.options.passes):
            for library in libraries:
                if not runs[library] or runs[library][-1].get("ms", LONG) < LONG:
                    runs[library] += filter(None, [self.one(library, *arguments(library))])
        return {library: min(each, key=lambda run: run.get("ms", 1e3 * LIMIT)) if each else None for library, each in runs.items()}

    def of_shape(self, shape, chord, libraries=LIBRARIES):
        """The same, once for all tables; meshes are left in files."""
        if (shape, chord) not in self.known:
            self.known[shape, chord] = self.best(lambda library: (shape, chord, self.mesh(library)), libraries)
        return self.known[shape, chord]

    def mesh(self, library):
        return self.options.programs / f"data/{library}.mesh"

    def apart(self, shape, path):
        samples = "1e7" if self.options.large else "1e5"
        run = subprocess.run([self.options.programs / "bench_meshes_apart", shape, path, samples],
                             capture_output=True, text=True, timeout=LIMIT, check=True)
        return json.loads(run.stdout)


def done(run):
    """Whether there is a mesh."""
    return run is not None and "late" not in run


def number(value):
    return "–" if value is None else f"{value:.3g}" if isinstance(value, float) else str(value)


def pair(runs, value):
    """Two cells, and how much more the other one has."""
    ours, other = (value(run) if done(run) else None for run in runs.values())
    ratio = f"{other / ours:.2g}" if ours and other else "–"
    return f"{number(ours)} | {number(other)} | {ratio}"


def head(first, *columns):
    """Each column is of both libraries and their ratio, or is by itself."""
    cells = [first]
    for title, both in columns:
        cells += [f"{title}, libnurbs", "Open CASCADE", "ratio"] if both else [title]
    print(f"| {' | '.join(cells)} |")
    print(f"| --- |{' ---: |' * (len(cells) - 1)}")


def farthest(all_runs, shape, chord, runs):
    """How far both meshes are off, over the chord; ours has to keep to what it proves, and that to the chord."""
    cells = []
    for library, run in runs.items():
        if not done(run):
            cells.append(f"over {LIMIT} s" if run else "–")
            continue
        apart = all_runs.apart(shape, all_runs.mesh(library))
        text = number(max(apart.values()) / float(chord))
        if "reached" in run:
            text += f" (proven {max(run[key] for key in apart) / float(chord):.3g})"
            all_runs.problems += [f"{shape} {chord}: {key}: {apart[key]}, proven {run[key]}" for key in apart
                                  if not apart[key] <= run[key] * (1 + 1e-9)]
            all_runs.problems += [] if run["reached"] else [f"{shape} {chord}: not reached"]
        cells.append(text)
    return " | ".join(cells)


def aim(triangles, ms):
    wanted = [f"{triangles} triangles"] * (triangles is not None) + [f"{ms} ms"] * (ms is not None)
    return ", ".join(wanted) or "–"


def show_shapes(all_runs):
    head("shape and chord", ("triangles", True), ("milliseconds", True), ("off / chord, libnurbs", False), ("Open CASCADE", False),
         ("aim", False))
    for shape, (title, aims, finer) in SHAPES.items():
        if not re.search(all_runs.options.only, shape):
            continue
        for chord in [*aims, *(finer if all_runs.options.large else [])]:
            runs = all_runs.of_shape(shape, chord)
            if done(runs["libnurbs"]):
                print(f"| {title}, {chord} | {pair(runs, lambda run: run['triangles'])} | {pair(runs, lambda run: run['ms'])} | "
                      f"{farthest(all_runs, shape, chord, runs)} | {aim(*aims.get(chord, (None, None)))} |", flush=True)

def show_growth(all_runs):
    print()
    head("patch, chord", ("triangles", True), ("us each", True), ("bytes each, at most", True), ("bytes each, mesh", True))
    both, alone = GROWTH
    for chord in [*both, *alone] if all_runs.options.large else both[:2]:
        runs = all_runs.of_shape(GROWN, chord, ["libnurbs"] if chord in alone else LIBRARIES)
        cells = [pair(runs, lambda run: run["triangles"])]
        cells += [pair(runs, lambda run, key=key, by=by: by * run[key] / run["triangles"])
                  for key, by in (("ms", 1e3), ("peak", 1), ("held", 1))]
        print(f"| {chord} | {' | '.join(cells)} |", flush=True)


def files():
    data = os.environ.get("NURBS_TEST_DATA")
    if not data:
        print("SKIPPED: real files: NURBS_TEST_DATA is not set")
    folders = [EXAMPLES, *([pathlib.Path(data)] if data else [])]
    found = [path for folder in folders for end in ("step", "stp", "iges", "igs") for path in folder.glob(f"*.{end}")]
    return sorted(found, key=lambda path: path.stem)


def wrong(run):
    return f"{run['missing']} + {run['off']}" if done(run) else "–"


def show_files(all_runs):
    print()
    found = files()
    head("file", ("faces", False), ("triangles", True), ("milliseconds", True), ("wrong, libnurbs", False), ("Open CASCADE", False),
         ("off / chord, libnurbs", False), ("Open CASCADE", False))
    for path in found:
        if not re.search(all_runs.options.only, path.stem):
            continue
        first = all_runs.one("libnurbs", path, str(SHARE))
        if not done(first):
            continue
        chords = {"libnurbs": str(SHARE), "Open CASCADE": repr(first["chord"])}
        runs = all_runs.best(lambda library: (path, chords[library]))
        ours, other = runs.values()
        off = " | ".join(number(run["far"] / run["chord"]) if done(run) else "–" for run in (ours, other))
        print(f"| {path.stem} | {ours['faces']} | {pair(runs, lambda run: run['triangles'])} | {pair(runs, lambda run: run['ms'])} | "
              f"{wrong(ours)} | {wrong(other)} | {off} |", flush=True)
        all_runs.problems += [f"{path.stem}: {ours[key]} faces {text}" for key, text in
                              (("missing", "without triangles"), ("exceeded", "farther off than is proven")) if ours[key]]
        if ours["unproven"]:
            print(f"{path.stem}: {ours['unproven']} faces are not proven to keep to the chord", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--passes", type=int, default=3)
    parser.add_argument("--only", default="", metavar="REGEX", help="shapes and files whose name matches")
    parser.add_argument("--large", action="store_true")
    all_runs = Runs(parser.parse_args())
    for library in LIBRARIES.keys() - all_runs.programs.keys():
        print(f"SKIPPED: {library}: {LIBRARIES[library]} is not built")
    if "libnurbs" not in all_runs.programs:
        return 1
    (all_runs.options.programs / "data").mkdir(parents=True, exist_ok=True)
    show_shapes(all_runs)
    if re.search(all_runs.options.only, GROWN):
        show_growth(all_runs)
    for library in LIBRARIES:
        all_runs.mesh(library).unlink(missing_ok=True)
    show_files(all_runs)
    print(*all_runs.problems, sep="\n", end="\n" if all_runs.problems else "", file=sys.stderr)
    return 1 if all_runs.problems else 0


if __name__ == "__main__":
    sys.exit(main())
