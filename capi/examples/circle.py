#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A circle is a rational curve: create it, evaluate a batch, insert a knot, and see that the radius did not change."""

import numpy as np

import nurbs


def report(curve):
    """The largest distance of 1000 points of the curve from the unit circle."""
    x, y = curve.eval(np.linspace(0, 1, 1000)).T
    print(f"{curve.count()} control points, radius 1 to within {abs(np.hypot(x, y) - 1).max():.2g}")


def main():
    s = 0.5**0.5
    circle = nurbs.Spline(
        degrees=2,
        knots=[0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1],
        points=[[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]],
        weights=[1, s, 1, s, 1, s, 1, s, 1],
    )
    report(circle)
    report(circle.insert_knot(0.3, times=2))


if __name__ == "__main__":
    main()
