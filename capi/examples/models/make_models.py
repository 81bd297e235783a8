#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes models.igs, the CAD file of the examples: many kinds of curves and surfaces, IGES 5.3, in mm.

    make_models.py            writes models.igs beside this script
    make_models.py --check    exits with 1 if models.igs is not what this script writes

Only sums, products and square roots of doubles are used, which are the same on every machine.
"""

import math
import pathlib
import sys

from teapot import PATCHES, VERTICES

TARGET = pathlib.Path(__file__).resolve().parent / "models.igs"
HALF_ROOT = math.sqrt(0.5)  # cosine of 45 degrees: weight of the corners of a circle in quarters

CURVE, SURFACE, MATRIX, PROPERTY = 126, 128, 124, 406
NAME_FORM = 15


# --- numbers and lines of IGES ---


def real(value):
    """The shortest decimal that reads back as the same double, with the point that IGES asks for."""
    text = repr(float(value)).upper()
    mantissa, mark, exponent = text.partition("E")
    if mantissa.endswith(".0"):
        mantissa = mantissa[:-1]
    elif "." not in mantissa:
        mantissa += "."
    return mantissa + mark + exponent


def hollerith(text):
    return f"{len(text)}H{text}"


def wrapped(fields, width):
    """Fields joined by commas and ended by a semicolon, in lines of at most `width` columns."""
    lines = [""]
    for index, field in enumerate(fields):
        piece = field + (";" if index + 1 == len(fields) else ",")
        if len(lines[-1]) + len(piece) > width:
            lines.append("")
        lines[-1] += piece
    return lines


def section(letter, texts):
    return [f"{text:<72}{letter}{number:7d}" for number, text in enumerate(texts, 1)]


class IgesFile:
    """Collects entities; every spline is followed by the property that holds its name."""

    def __init__(self):
        self.directory = []
        self.parameters = []
        self.largest = 0.0

    def next_pointer(self):
        return 2 * (len(self.directory) // 2) + 1

    def add(self, entity_type, fields, form=0, transform=0, status="00000000"):
        pointer = self.next_pointer()
        first = len(self.parameters) + 1
        lines = wrapped([str(entity_type)] + fields, 64)
        self.parameters += [f"{line:<64}{pointer:8d}" for line in lines]
        line_font = 1 if entity_type in (CURVE, SURFACE) else 0
        self.directory += [
            f"{entity_type:8d}{first:8d}{0:8d}{line_font:8d}{0:8d}{0:8d}{transform:8d}{0:8d}{status}",
            f"{entity_type:8d}{0:8d}{0:8d}{len(lines):8d}{form:8d}{'':24}{0:8d}",
        ]
        return pointer

    def add_spline(self, name, entity_type, fields, points, transform=0):
        self.largest = max(self.largest, max(abs(c) for point in points for c in point))
        name_pointer = self.next_pointer() + 2
        self.add(entity_type, fields + ["0", "1", str(name_pointer)], transform=transform)
        self.add(PROPERTY, ["1", hollerith(name)], form=NAME_FORM, status="00010300")

    def add_curve(self, name, degree, knots, points, weights=None, closed=False, periodic=False, normal=None,
                  transform=0):
        """A normal makes it planar."""
        count = len(points)
        assert len(knots) == count + degree + 1
        flags = [normal is not None, closed, weights is None, periodic]
        fields = [str(count - 1), str(degree)] + [str(int(flag)) for flag in flags]
        fields += [real(t) for t in knots]
        fields += [real(w) for w in weights or [1] * count]
        fields += [real(c) for point in points for c in point]
        fields += [real(knots[degree]), real(knots[count])]
        fields += [real(c) for c in normal or (0, 0, 0)]
        self.add_spline(name, CURVE, fields, points, transform)

    def add_surface(self, name, degrees, knots, net, weights=None, closed=(False, False)):
        """net[i][j] and weights[i][j]; the file lets i run fastest."""
        counts = (len(net), len(net[0]))
        for axis in (0, 1):
            assert len(knots[axis]) == counts[axis] + degrees[axis] + 1
        order = [(i, j) for j in range(counts[1]) for i in range(counts[0])]
        fields = [str(n) for n in (counts[0] - 1, counts[1] - 1) + tuple(degrees)]
        fields += [str(int(flag)) for flag in tuple(closed) + (weights is None, False, False)]
        fields += [real(t) for vector in knots for t in vector]
        fields += [real(weights[i][j] if weights else 1) for i, j in order]
        fields += [real(c) for i, j in order for c in net[i][j]]
        fields += [real(knots[k][n]) for k in (0, 1) for n in (degrees[k], counts[k])]
        self.add_spline(name, SURFACE, fields, [net[i][j] for i, j in order])

    def global_fields(self):
        return [
            "1H,", "1H;", hollerith("models"), hollerith("models.igs"), hollerith("libnurbs"),
            hollerith("make_models.py"), "32", "38", "6", "308", "15", hollerith("models"),
            "1.", "2", hollerith("MM"), "1", "0.1", hollerith("20240101.000000"), "1.E-06",
            real(self.largest), hollerith("libnurbs"), hollerith("libnurbs"), "11", "0",
            hollerith("20240101.000000"),
        ]

    def text(self):
        sections = [
            section("S", ["Curves and surfaces for the examples of libnurbs.",
                          "The teapot is Martin Newell's (University of Utah, 1975)."]),
            section("G", wrapped(self.global_fields(), 72)),
            section("D", self.directory),
            section("P", self.parameters),
        ]
        counts = "".join(f"{letter}{len(lines):7d}" for letter, lines in zip("SGDP", sections))
        return "".join(line + "\n" for lines in sections + [section("T", [counts])] for line in lines)


# --- shapes ---


def bezier_knots(degree):
    return [0] * (degree + 1) + [1] * (degree + 1)


def circle_knots():
    return [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]


# The square around a circle, from the point at angle 0: corners carry the weight HALF_ROOT.
SQUARE = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0))
SQUARE_WEIGHTS = [1 if i % 2 == 0 else HALF_ROOT for i in range(9)]


def teapot_point(vertex):
    """100 mm to Newell's unit; his y, which points up, becomes z. Rounding keeps the decimals short."""
    x, y, z = VERTICES[vertex]
    return tuple(round(100 * c, 7) + 0.0 for c in (x, -z, y))


def add_teapot(iges):
    for number, patch in enumerate(PATCHES, 1):
        points = [teapot_point(vertex) for vertex in patch]
        net = [points[4 * i:4 * i + 4] for i in range(4)]
        iges.add_surface(f"teapot {number}", (3, 3), (bezier_knots(3), bezier_knots(3)), net)


# Stations of the hull from transom to stem: position, height of the keel, half breadth and height at the
# chine, the same at the deck, and how far the deck leans forward of the keel.
STATIONS = (
    (0, 34, 52, 44, 60, 112, -8),
    (40, 26, 58, 41, 68, 110, -5),
    (130, 10, 66, 34, 77, 106, 0),
    (270, 0, 70, 28, 82, 102, 0),
    (420, 0, 66, 30, 80, 104, 2),
    (520, 2, 44, 38, 62, 110, 10),
    (575, 8, 16, 50, 32, 118, 24),
    (600, 16, 0, 60, 0, 126, 44),
)


def hull_station(x, keel, chine_breadth, chine_height, deck_breadth, deck_height, lean):
    """Seven points from keel to deck; the fourth is the chine, where bottom and side meet in a kink."""

    def point(breadth, height):
        along = (height - keel) / (deck_height - keel)
        return (round(x + lean * along - 300, 6), breadth - 300, height)

    def between(start, end, eighths):
        return start + (end - start) * eighths / 8

    bottom = [(0, 0), (3, 1), (6, 4)]
    side = [(0, 0), (4, 2), (7, 5), (8, 8)]
    return [point(between(0, chine_breadth, s), between(keel, chine_height, r)) for s, r in bottom] + [
        point(between(chine_breadth, deck_breadth, s), between(chine_height, deck_height, r)) for s, r in side
    ]


def add_hull(iges):
    along = [0, 0, 0, 0, 0.1, 0.35, 0.7, 0.9, 1, 1, 1, 1]
    around = [0, 0, 0, 0, 0.45, 0.45, 0.45, 1, 1, 1, 1]
    iges.add_surface("hull", (3, 3), (along, around), [hull_station(*station) for station in STATIONS])


def add_circle(iges):
    radius = 80
    points = [(radius * x, radius * y, -10) for x, y in SQUARE]
    iges.add_curve("circle", 2, circle_knots(), points, SQUARE_WEIGHTS, closed=True, normal=(0, 0, 1))


def add_conic_arc(iges):
    """Weight 2 > 1: an arc of a hyperbola."""
    points = [(150, -40, 0), (200, 60, 0), (250, -40, 0)]
    iges.add_curve("conic arc", 2, bezier_knots(2), points, [1, 2, 1], normal=(0, 0, 1))


def add_torus(iges):
    """Radius 60 of the middle circle, 20 of the tube, around the z axis, 200 below the origin."""
    net = [[((60 + 20 * s) * x, (60 + 20 * s) * y, 20 * t - 200) for s, t in SQUARE] for x, y in SQUARE]
    weights = [[a * b for b in SQUARE_WEIGHTS] for a in SQUARE_WEIGHTS]
    iges.add_surface("torus", (2, 2), (circle_knots(), circle_knots()), net, weights, (True, True))


def add_cylinder(iges):
    """Radius 30 around the z axis, from 350 to 270 below the origin."""
    net = [[(30 * x, 30 * y, z) for z in (-350, -270)] for x, y in SQUARE]
    weights = [[w, w] for w in SQUARE_WEIGHTS]
    iges.add_surface("cylinder", (2, 1), (circle_knots(), [0, 0, 80, 80]), net, weights, (True, False))


def add_polynomial_curves(iges):
    planar = [(150, 60, 0), (165, 120, 0), (190, 40, 0), (205, 130, 0), (230, 95, 0), (245, 150, 0),
              (270, 70, 0)]
    iges.add_curve("planar cubic", 3, [0, 0, 0, 0, 0.5, 2, 2.25, 4, 4, 4, 4], planar, normal=(0, 0, 1))
    space = [(150, 200, 0), (170, 260, 25), (200, 180, 60), (230, 270, 80), (260, 190, 95), (280, 240, 140),
             (300, 200, 150)]
    iges.add_curve("space quintic", 5, [0] * 6 + [0.3] + [1] * 6, space)
    ring = [(-150, 200, 0), (-220, 240, 20), (-260, 180, 0), (-230, 120, -20), (-160, 130, 10)]
    iges.add_curve("closed loop", 3, list(range(12)), ring + ring[:3], closed=True, periodic=True)
    zigzag = [(150, -100, 0), (170, -140, 10), (190, -100, 20), (210, -140, 30), (230, -100, 40)]
    iges.add_curve("polyline", 1, [0, 0, 1, 2, 3, 4, 4], zigzag)


def add_transformed_curve(iges):
    """A quarter turn about the z axis, then a shift: the point (x, y, z) lies at (-y - 200, x, z + 50)."""
    rows = ((0, -1, 0, -200), (1, 0, 0, 0), (0, 0, 1, 50))
    matrix = iges.add(MATRIX, [real(value) for row in rows for value in row])
    points = [(0, 0, 0), (20, 40, 0), (60, 40, 0), (80, 0, 0)]
    iges.add_curve("transformed curve", 3, bezier_knots(3), points, normal=(0, 0, 1), transform=matrix)


def models():
    iges = IgesFile()
    add_teapot(iges)
    add_hull(iges)
    add_circle(iges)
    add_conic_arc(iges)
    add_torus(iges)
    add_cylinder(iges)
    add_polynomial_curves(iges)
    add_transformed_curve(iges)
    return iges.text().encode("ascii")


def main(arguments):
    if arguments not in ([], ["--check"]):
        print("usage: make_models.py [--check]", file=sys.stderr)
        return 2
    if not arguments:
        TARGET.write_bytes(models())
        return 0
    same = TARGET.is_file() and TARGET.read_bytes() == models()
    print(f"{TARGET.name} is {'what' if same else 'NOT what'} make_models.py writes")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
