#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A circle is a rational curve: points, tangents, a knot more, the closest point, the length, and a call that fails."""

import numpy as np

import nurbs


def radius_error(points):
    """The largest distance of points (n, 2) from the unit circle."""
    return abs(np.hypot(*points.T) - 1).max()


def main():
    circle, t = nurbs.circle(), np.linspace(0, 1, 1000)
    points, tangents = circle(t), circle(t, nu=1)
    print(f"{len(circle.points)} control points, radius 1 to within {radius_error(points):.2g}")
    print(f"tangents at right angles to within {abs((points * tangents).sum(axis=1)).max():.2g}")

    finer = circle.insert_knot(0.3, 2)
    print(f"{len(finer.points)} control points, radius 1 to within {radius_error(finer(t)):.2g}")
    print(f"the points moved by at most {abs(finer(t) - points).max():.2g}")

    closest = circle.closest_points([3, 4])
    x, y = closest.points
    certified = "certified" if closest.status & nurbs.NURBS_CLOSEST_CERTIFIED else "not certified"
    print(f"closest to (3, 4): ({x:.6f}, {y:.6f}), distance {closest.distances:.6f}, {certified}")

    length = circle.length()
    print(f"length {length.value:.12f}, error about {length.error:.2g}")
    try:
        circle(2)
    except nurbs.DomainError as error:
        print(f"a bad call says: {error.message}")


if __name__ == "__main__":
    main()
