#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the example that makes paths of a tool. On the faces of a bushing, which are parts of planes and cylinders, samples show
that what it claims holds: the centre keeps the distance, segments stay within the chord, and no scallop is higher than told, but
some are about as high. Balls that gouge are refused. Of its own surface the picture is the one that the README shows.

    check_toolpath.py PROGRAM PICTURE.svg OUTPUT_FOLDER MODELS
"""

import csv
import math
import pathlib
import re
import subprocess
import sys

from check_gallery import cells, check_same

TOLD = re.compile(r"(\w+): (\d+) passes, (\d+) lines, (\d+) positions, (\S+) long; proven: scallops below (\S+), chords within (\S+)")
RADIUS, SCALLOP, CHORD = 2.0, 0.05, 0.01


def run(program, table, picture, *arguments):
    """{kind: (what is told, [segments])}, segments as pairs of points with their chord"""
    result = subprocess.run([program, table, picture, *map(str, arguments)], capture_output=True, text=True, timeout=250)
    print(result.stdout + result.stderr)
    assert result.returncode == 0 and not result.stderr
    told = {kind: tuple(map(float, numbers)) for kind, *numbers in TOLD.findall(result.stdout)}
    found = {kind: (numbers, []) for kind, numbers in told.items()}
    rows = list(csv.DictReader(table.open()))
    places = [tuple(float(row[axis]) for axis in "xyz") for row in rows]
    for before, row, a, b in zip(rows, rows[1:], places, places[1:]):
        if all(before[key] == row[key] for key in ("kind", "pass", "line")):
            found[row["kind"]][1].append((a, b, float(row["chord"])))
    for kind, ((passes, lines, positions, length, scallop, chord), segments) in found.items():
        here = [row for row in rows if row["kind"] == kind]
        assert len(here) == positions and len({row["line"] for row in here}) == lines and passes >= 2
        assert len(segments) == positions - lines and math.isclose(sum(math.dist(a, b) for a, b, _ in segments), length, rel_tol=1e-5)
        for name, bound in (("chord", chord), ("scallop", scallop)):
            assert 0 <= min(float(row[name]) for row in here) and max(float(row[name]) for row in here) <= bound * (1 + 1e-3)
    return found


def from_segment(point, a, b):
    along = [y - x for x, y in zip(a, b)]
    square = sum(x * x for x in along)
    t = sum((p - x) * y for p, x, y in zip(point, a, along)) / square if square else 0
    return math.dist(point, [x + min(1, max(0, t)) * y for x, y in zip(a, along)])


def check_face(found, height, samples):
    """height: of a point above the face; samples: points of the face with normals."""
    assert sorted(found) == ["border", "planes"]
    for (_, _, _, _, scallop, chord), segments in found.values():
        assert scallop <= SCALLOP and chord <= CHORD
        for a, b, own_chord in segments:
            assert abs(height(a) - RADIUS) < 1e-9
            middle = [0.5 * (x + y) for x, y in zip(a, b)]
            assert abs(height(middle) - RADIUS) <= own_chord + 1e-9 and own_chord <= chord + 1e-6
        lifted = {share: max(min(from_segment([x + share * scallop * n for x, n in zip(point, normal)], a, b)
                                 for a, b, _ in segments if math.dist(point, a) < 1.5 * RADIUS)
                             for point, normal in samples) for share in (0.5, 1)}
        assert lifted[1] <= RADIUS + 1e-4 * scallop < lifted[0.5], f"scallops of {scallop}: {lifted}"


def ring(z, side):
    for i in range(5):
        for k in range(30):
            turn, radius = 2 * math.pi * k / 30, 3 + 0.5 * i
            yield (radius * math.cos(turn), radius * math.sin(turn), z), (0, 0, side)


def cylinder(radius, side):
    for i in range(5):
        for k in range(30):
            x, y = math.cos(2 * math.pi * k / 30), math.sin(2 * math.pi * k / 30)
            yield (radius * x, radius * y, i), (side * x, side * y, 0)


def check_bushing(program, folder, bushing):
    faces = [(lambda p: math.hypot(p[0], p[1]) - 5, cylinder(5, 1)), (lambda p: 3 - math.hypot(p[0], p[1]), cylinder(3, -1)),
             (lambda p: -p[2], ring(0, -1)), (lambda p: p[2] - 4, ring(4, 1))]
    for index, (height, samples) in enumerate(faces):
        found = run(program, folder / "bushing.csv", folder / "bushing.svg", RADIUS, SCALLOP, CHORD, bushing, index + 1)
        check_face(found, height, list(samples))


def check_refusals(program, folder, bushing):
    outputs = [folder / "refused.csv", folder / "refused.svg"]
    for status, message, arguments in (
            (1, "a ball of radius 4 gouges: the face is hollow with radius 3 at", [*outputs, 4, SCALLOP, CHORD, bushing, 2]),
            (1, "a ball of radius 12 gouges", [*outputs, 12, SCALLOP, CHORD]), (1, "no positive number", [*outputs, 2, "x", CHORD]),
            (1, "less than half of the radius", [*outputs, 2, 1.5, CHORD]), (1, "index", [*outputs, 2, 0.1, 0.1, bushing, 5]),
            (1, "missing.step", [*outputs, 2, 0.1, 0.1, folder / "missing.step", 1]), (2, "usage", [folder / "refused.csv"]),
            (1, "No such file", [folder / "missing" / "a.csv", folder / "a.svg"])):
        result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=250)
        print(result.stdout + result.stderr)
        assert result.returncode == status and message in result.stderr, f"{message!r} is expected"


def main():
    program, shown, folder, models = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
    folder.mkdir(parents=True, exist_ok=True)
    found = run(program, folder / "toolpath.csv", folder / "toolpath.svg")
    assert sorted(found) == ["border", "planes"]
    for (_, _, _, _, scallop, chord), _ in found.values():
        assert 0.14 < scallop <= 0.2 and 0.03 < chord <= 0.04
    check_bushing(program, folder, models / "bushing.step")
    check_refusals(program, folder, models / "bushing.step")
    check_same(cells(folder / "toolpath.svg"), cells(shown))


if __name__ == "__main__":
    main()
