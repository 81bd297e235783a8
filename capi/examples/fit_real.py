#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Data of real shapes become splines: the section of a wing, a scanned line of a ship, and a grid of points on its hull.

    fit_real.py [FOLDER [PICTURE]]

The folder, by default that of the environment variable NURBS_TEST_DATA, has wing.iges and goteborg_hull.iges. What is fitted
is sampled from them, with noise, so that it can be told how far the results are from the truth. The picture, fit_real.svg by
default, shows the data on the left, and what becomes of them on the right; it needs Matplotlib.
"""

import os
import pathlib
import sys

import matplotlib
import numpy as np

import nurbs

matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402 - after the choice of what draws

RED, BLUE = "#d1495b", "#22577a"
SIDE = [[1, 0, 0], [0, 0, 1]]  # from the side: x and z


def shape_of(folder, file, name):
    """The spline of that name in a file."""
    shapes = nurbs.read_file(folder / file)
    return shapes[shapes.names.index(name)]


def curves(folder, file, names):
    """Curves of a file in the plane, as seen from the side."""
    return [shape_of(folder, file, name).transform(SIDE) for name in names]


def off(points, shapes):
    """The largest distance of points from the nearest of some shapes."""
    return np.min([shape.closest_points(points).distances for shape in shapes], axis=0).max()


def tell(what, data, fitted, truth, unit):
    """Prints what came out, and returns it for the picture."""
    (spline, report), (size, name) = fitted, unit
    found = f"{np.prod(spline.counts)} control points"
    close = f"rms {report.rms / size:.3f}, max {report.largest / size:.3f} {name}"
    print(f"{what}: {data} points, {found}, {close}; off the true shape by at most {truth / size:.3f} {name}")
    return f"{found}; {close}"


def draw_curve(before, after, points, curve, title):
    before.plot(*points.T, ".", color=RED, markersize=3, markeredgewidth=0, rasterized=True)
    after.plot(*points.T, ".", color=RED, markersize=3, markeredgewidth=0, alpha=0.3, rasterized=True)
    (start, end), = curve.domain
    after.plot(*curve(np.linspace(start, end, 2000)).T, color=BLUE, linewidth=1.2)
    after.plot(*curve(np.unique(curve.knots[0])).T, "o", color="white", markeredgecolor=BLUE, markersize=3.5)
    after.set_title(title, fontsize=9)


def airfoil(folder, random, before, after):
    """Coordinates of a section, from the trailing edge over the top and the nose back to it. They are smoothed as much as
    generalised cross validation finds right, and the curve begins and ends in the trailing edge."""
    sides = curves(folder, "wing.iges", ("126#17", "126#19"))
    steps = (1 - np.cos(np.linspace(0, np.pi, 81))) / 2  # closer at the edges
    exact = np.concatenate([side(start + steps * (end - start)) for side in sides for (start, end), in [side.domain]])
    points = exact + 5e-4 * random.standard_normal(exact.shape)
    # Chords of points with noise are too long; their square roots suffer less.
    params, = nurbs.parametrize(points, nurbs.NURBS_PARAMS_CENTRIPETAL)
    edge = ([0, 1], None, [exact[0], exact[-1]])
    fitted = nurbs.fit_points(params, points, 3, nurbs.knots_open_uniform(3, 43), smoothing="gcv", conditions=edge)
    truth = off(fitted.spline(np.linspace(0, 1, 2001)), sides)
    title = tell("section of a wing", len(points), fitted, truth, (0.01, "% of the chord"))
    before.set_title(f"section of a wing: {len(points)} coordinates", fontsize=9)
    draw_curve(before, after, points, fitted.spline, title)


def scan(folder, random, before, after):
    """The outline of a bow, scanned to half a millimetre: knots where a millimetre needs them, three at the corner of
    the deck."""
    bulb, stem, deck = curves(folder, "goteborg_hull.iges", ("126#15", "126#17", "126#19"))
    outline = nurbs.join([bulb, stem, deck.reverse()], tolerance=1e-6).spline
    exact = outline(outline.divide(20000).params)  # a scanner moves evenly
    points = exact + 0.0005 * random.uniform(-1, 1, exact.shape)
    along = np.linspace(0, 1, len(points))
    fitted = nurbs.fit_tolerance(along, points, 3, 0.001, smoothing="gcv")
    truth = off(fitted.spline(np.linspace(0, 1, 5001)), [outline])
    title = tell("outline of a bow", len(points), fitted, truth, (0.001, "mm"))
    before.set_title(f"outline of a bow: {len(points)} scanned points", fontsize=9)
    draw_curve(before, after, points, fitted.spline, title)


def shade(ax, surface):
    """The surface from the side, as a lamp ahead shows it."""
    grid = [np.linspace(*ends, count) for ends, count in zip(surface.domain, (700, 160))]
    points = surface.eval_grid(*grid)
    normals = surface.surface_grid_frames(*grid).normals
    light = np.abs(normals @ (np.array([0.5, 0.8, 0.33])))
    ax.pcolormesh(points[..., 0], points[..., 2], light, shading="gouraud", cmap="bone", vmin=0.3, vmax=1.05, rasterized=True)


def hull(folder, random, before, after):
    """A grid of points on the side of a ship: the surface through all of them, and the one that lies among them, with
    three knots along the edge where the bottom ends."""
    exact = shape_of(folder, "goteborg_hull.iges", "128#57")
    params = [np.linspace(*ends, count) for ends, count in zip(exact.domain, (160, 60))]
    points = exact.eval_grid(*params)
    points += 0.001 * random.standard_normal(points.shape)
    through = nurbs.interpolate([3, 3], params, points).spline
    knots = [nurbs.knots_open_uniform(3, count, *ends) for ends, count in zip(exact.domain, (33, 15))]
    knots[0] = np.sort([*knots[0], 7.5, 7.5, 7.5])
    places = np.stack(np.meshgrid(*params, indexing="ij"), axis=-1).reshape(-1, 2)
    fitted = nurbs.fit_points(places, points.reshape(-1, 3), [3, 3], knots, smoothing="gcv")
    finer = [np.linspace(*ends, count) for ends, count in zip(exact.domain, (101, 41))]
    truth = off(fitted.spline.eval_grid(*finer).reshape(-1, 3), [exact])
    title = tell("side of a ship", len(places), fitted, truth, (0.001, "mm"))
    before.set_title(f"side of a ship: the surface through {len(places)} points", fontsize=9)
    after.set_title(title, fontsize=9)
    shade(before, through)
    shade(after, fitted.spline)


def main():
    if len(sys.argv) > 1:
        folder = pathlib.Path(sys.argv[1])
    elif "NURBS_TEST_DATA" in os.environ:
        folder = pathlib.Path(os.environ["NURBS_TEST_DATA"])
    else:
        sys.exit(__doc__)
    figure, axes = pyplot.subplots(3, 2, figsize=(12, 7), layout="constrained",
                                   gridspec_kw={"height_ratios": [0.8, 2.2, 1]})
    for draw, (before, after) in zip((airfoil, scan, hull), axes):
        draw(folder, np.random.default_rng(5), before, after)
        for ax in before, after:
            ax.set_aspect("equal")
            ax.margins(0.04)
            ax.set_axis_off()
    figure.savefig(sys.argv[2] if len(sys.argv) > 2 else "fit_real.svg", dpi=150)


if __name__ == "__main__":
    main()
