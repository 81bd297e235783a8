#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what growth prints, and tells the exponents of its lines.

    plot.py CSV SVG
"""

import csv
import math
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "growth"  # the same file for the same numbers
matplotlib.rcParams["svg.fonttype"] = "none"
from matplotlib import pyplot  # noqa: E402 - after the choice of what draws

COLOURS = {1: "#4477aa", 3: "#228833", 9: "#ccbb44", 15: "#aa3377", 30: "#ee6677", 31: "#ee6677"}


def read(path):
    """{function: {degree: [(points, seconds), ...]}}"""
    lines = {}
    with open(path, encoding="utf-8") as file:
        for family, function, degree, points, seconds in csv.reader(file):
            lines.setdefault(f"{family}: {function}", {}).setdefault(int(degree), []).append((int(points), float(seconds)))
    return lines


def exponent(line):
    """The slope from 1000 points on, by least squares of logarithms."""
    logs = [(math.log(points), math.log(seconds)) for points, seconds in line if points >= 1000]
    if len(logs) < 2:
        return math.nan
    x, y = (sum(values) / len(logs) for values in zip(*logs))
    return sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, _ in logs)


def draw(lines, path):
    rows = math.ceil(len(lines) / 4)
    figure, axes = pyplot.subplots(rows, 4, figsize=(12, 2.5 * rows), sharex=True, layout="constrained")
    for place, (function, degrees) in zip(axes.flat, lines.items()):
        for degree, line in degrees.items():
            place.loglog(*zip(*line), color=COLOURS[degree], marker=".", label=f"degree {degree}")
        place.set_title(function, fontsize=9)
        place.grid(alpha=0.3)
    for place in (axes.flat[0], axes.flat[-2]):
        place.legend(fontsize=7)
    figure.supxlabel("control points")
    figure.supylabel("seconds of a first call")
    figure.savefig(path, metadata={"Date": None})


def main():
    lines = read(sys.argv[1])
    draw(lines, sys.argv[2])
    for function, degrees in lines.items():
        for degree, line in degrees.items():
            slope = exponent(line)
            print(f"{function}, degree {degree}: exponent {slope:.2f}{'  !!' if slope > 1.1 else ''}")


if __name__ == "__main__":
    main()
