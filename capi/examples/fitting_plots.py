#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what fits do, one picture for each kind: data, the fit and its knots, and below them what is left over.

    fitting_plots.py [PICTURE]

Needs Matplotlib. The picture is fitting.svg, if no other name is given.
"""

import io
import pathlib
import re
import sys

import matplotlib
import numpy as np

import nurbs

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "fitting", "svg.fonttype": "none", "font.sans-serif": "DejaVu Sans",
                            "font.size": 8, "axes.titlesize": 9, "xtick.labelsize": 7, "ytick.labelsize": 7,
                            "axes.spines.top": False, "axes.spines.right": False})
from matplotlib import pyplot  # noqa: E402 - after the choice of what draws

RED, BLUE, GREY, GREEN, YELLOW = "#d1495b", "#22577a", "#999999", "#3a7d44", "#e0a030"
DOTS = {"linestyle": "", "marker": ".", "markersize": 3.5, "markeredgewidth": 0, "color": RED}
FINE = np.linspace(0, 1, 301)


def panel(place, title):
    """Axes for data and fit, and a strip below for residuals."""
    above, below = place.subgridspec(2, 1, height_ratios=[4, 1.1], hspace=0.02).subplots()
    above.set_title(title)
    below.axhline(0, color=GREY, linewidth=0.5)
    below.set_ylabel("residual", fontsize=7)
    return above, below


def at_knots(curve):
    """The points of a curve over [0, 1] at its knots."""
    places = np.unique(curve.knots[0])
    return curve(places[(places >= 0) & (places <= 1)])


def draw_graph(above, below, t, y, curve, **data):
    """A function of one parameter."""
    above.plot(t, y, **{**DOTS, **data}, label="data")
    above.plot(FINE, curve(FINE), color=BLUE, linewidth=1.2, label="fit")
    draw_knots(above, curve)
    below.plot(t, y - curve(t).ravel(), **DOTS)
    for ax in above, below:
        ax.set_xlim(-0.02, 1.02)
    above.tick_params(labelbottom=False)


def draw_knots(ax, curve):
    """Knots as ticks on the axis of the parameter, as many above each other as there are at one place."""
    places, counts = np.unique(curve.knots[0], return_counts=True)
    low, high = ax.get_ylim()
    high += 0.12 * (high - low)  # below the data
    low -= 0.12 * (high - low)
    ax.set_ylim(low, high)
    for k in range(counts[1:-1].max() if len(counts) > 2 else 1):
        at = places[(counts > k) & (places >= 0) & (places <= 1)]
        ax.plot(at, np.full(at.size, low + (0.02 + 0.03 * k) * (high - low)), "^", color=GREEN, markersize=4,
                markerfacecolor="none", label="knots" if k == 0 else None, clip_on=False)


def draw_curve(above, below, t, points, curve):
    """A curve in the plane; residuals are distances."""
    above.plot(*points.T, **DOTS, label="data")
    above.plot(*curve(FINE).T, color=BLUE, linewidth=1.2, label="fit")
    above.plot(*at_knots(curve).T, "^", color=GREEN, markersize=4, markerfacecolor="none", label="knots")
    above.set_aspect("equal", "datalim")
    below.plot(t, np.linalg.norm(points - curve(t), axis=1), **DOTS)
    below.set_xlim(-0.02, 1.02)


def wave(t):
    return np.sin(9 * t**2) + 0.5 * t


def interpolation(place, random):
    points = np.array([[0, 0], [0.4, 1.1], [0.9, 1.2], [1.1, 0.4], [1.9, 0.2], [2.1, 1.3], [2.9, 1.4], [3.2, 0.3]])
    t, = nurbs.parametrize(points)
    curve, residual = nurbs.interpolate(3, t, points)
    above, below = panel(place, f"interpolation of {len(points)} points")
    draw_curve(above, below, t, points, curve)
    above.lines[0].set_markersize(7)
    below.lines[-1].set_markersize(6)
    below.set_ylim(-1e-16, 6e-16)


def least_squares(place, random):
    t = np.sort(random.random(120))
    y = wave(t) + random.normal(scale=0.12, size=t.size)
    curve, report = nurbs.fit_points(t, y, 3, nurbs.knots_open_uniform(3, 11))
    draw_graph(*panel(place, f"least squares over given knots: rms {report.rms:.2f}"), t, y, curve)


def smoothing(place, beside, random):
    """One curve with three factors of the penalty; beside it the criterion by which one of them was chosen."""
    t = np.sort(random.random(120))
    y = wave(t) + random.normal(scale=0.25, size=t.size)
    knots = nurbs.knots_open_uniform(3, 63)
    curve, report = nurbs.fit_points(t, y, 3, knots, smoothing="gcv")
    above, below = panel(place, "smoothing, the factor chosen by GCV")
    for factor, colour, label in (report.lam / 3e3, YELLOW, "λ too small"), (report.lam * 1e4, GREY, "λ too large"):
        other = nurbs.fit_points(t, y, 3, knots, smoothing="lambda", lam=factor).spline
        above.plot(FINE, other(FINE), color=colour, linewidth=0.8, label=label)
    draw_graph(above, below, t, y, curve)
    above.legend(*zip(*[(line, line.get_label()) for line in above.lines[:2]]), fontsize=7, frameon=False, loc="lower left",
                 bbox_to_anchor=(0, 0.1))

    factors = report.lam * 10.0 ** np.linspace(-5, 4, 46)
    scores, freedoms = [], []
    for factor in factors:
        found = nurbs.fit_points(t, y, 3, knots, smoothing="lambda", lam=factor).report
        scores.append(t.size * found.squares / (t.size - found.freedom) ** 2)
        freedoms.append(found.freedom)
    above, below = panel(beside, "what GCV minimises, against λ")
    above.loglog(factors, scores, color=BLUE, linewidth=1.2)
    above.plot(report.lam, t.size * report.squares / (t.size - report.freedom) ** 2, "o", color=RED, markersize=5)
    above.annotate(f"λ = {report.lam:.0e}", (report.lam, min(scores)), (0, 14), textcoords="offset points", ha="center")
    above.tick_params(labelbottom=False, which="both")
    above.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    below.set_ylabel("freedom", fontsize=7)
    below.semilogx(factors, freedoms, color=BLUE, linewidth=1.2)
    below.plot(report.lam, report.freedom, "o", color=RED, markersize=4)


def tolerance(place, random):
    t, within = np.linspace(0, 1, 241), 0.01
    exact = np.where(t < 0.35, np.sin(9 * t), np.sin(3.15) + 10 * (t - 0.35)) + np.where(t > 0.7, np.sin(14 * t) - 3.7, 0)
    y = exact + 0.3 * within * random.uniform(-1, 1, t.size)
    curve = nurbs.fit_tolerance(t, y, 3, within).spline
    above, below = panel(place, f"to a tolerance of {within}: {len(curve.points)} points, a kink, a jump")
    draw_graph(above, below, t, y, curve, markersize=2.5, markevery=4)
    below.axhspan(-within, within, color=BLUE, alpha=0.12, linewidth=0)
    below.set_ylim(-1.5 * within, 1.5 * within)


def scattered(place, random):
    """Heights over the unit square but for a hole: what the data leave open is as flat as can be."""
    where = random.random((450, 2))
    where = where[np.hypot(*(where - [0.62, 0.42]).T) > 0.2]
    heights = np.sin(5 * where[:, 0]) * np.cos(4 * where[:, 1]) + random.normal(scale=0.05, size=len(where))
    knots = nurbs.knots_open_uniform(3, 13)
    surface, report = nurbs.fit_points(where, heights, [3, 3], [knots, knots], smoothing="gcv")
    above, below = panel(place, f"scattered data with a hole: rms {report.rms:.3f}")
    side = np.linspace(0, 1, 64)
    image = surface.eval_grid(side, side)[..., 0]
    above.imshow(image.T, origin="lower", extent=(0, 1, 0, 1), cmap="GnBu", interpolation="bilinear", aspect="auto")
    above.contour(side, side, image.T, 9, colors=BLUE, linewidths=0.5)
    above.plot(*where.T, linestyle="", marker=".", markersize=3, markeredgewidth=0, color=RED)
    for ticks in above.set_xticks, above.set_yticks:
        ticks(np.unique(knots), minor=False)
    above.tick_params(color=GREEN, labelbottom=False, labelleft=False, length=5, width=1.5)
    below.plot(where[:, 0], heights - surface.eval(where).ravel(), **{**DOTS, "markersize": 2})
    below.set_xlim(0, 1)


def approximation(place, random):
    """A circle, which is rational, by a polynomial curve; the bound holds everywhere."""
    circle = nurbs.circle()
    curve, bound = circle.approximate(1e-3, 3)
    above, below = panel(place, f"polynomial for a circle: proven to {bound:.1e}")
    above.plot(*circle(FINE).T, color=RED, linewidth=3, alpha=0.35, label="rational curve")
    above.plot(*curve(FINE).T, color=BLUE, linewidth=1.2)
    above.plot(*at_knots(curve).T, "^", color=GREEN, markersize=4, markerfacecolor="none")
    above.set_aspect("equal", "datalim")
    below.plot(FINE, np.linalg.norm(circle(FINE) - curve(FINE), axis=1), color=BLUE, linewidth=0.8)
    below.axhspan(0, bound, color=BLUE, alpha=0.12, linewidth=0)
    below.set_xlim(-0.02, 1.02)


def periodic(place, random):
    t = np.sort(random.random(120))
    turn = 2 * np.pi * t
    radius = 1 + 0.25 * np.cos(5 * turn) + random.normal(scale=0.03, size=t.size)
    points = radius[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    knots = nurbs.knots_periodic(3, np.linspace(0, 1, 21))
    curve, report = nurbs.fit_points(t, points, 3, knots, flags=nurbs.NURBS_PERIODIC)
    draw_curve(*panel(place, f"periodic, least squares: rms {report.rms:.3f}"), t, points, curve)


def main():
    figure = pyplot.figure(figsize=(13, 6.4), layout="constrained")
    places = figure.add_gridspec(2, 4, hspace=0.06, wspace=0.04)
    interpolation(places[0, 0], np.random.default_rng(1))
    least_squares(places[0, 1], np.random.default_rng(2))
    smoothing(places[0, 2], places[0, 3], np.random.default_rng(3))
    tolerance(places[1, 0], np.random.default_rng(4))
    scattered(places[1, 1], np.random.default_rng(5))
    approximation(places[1, 2], np.random.default_rng(6))
    periodic(places[1, 3], np.random.default_rng(7))
    figure.axes[0].legend(fontsize=7, frameon=False, loc="lower right")
    picture = io.StringIO()
    figure.savefig(picture, metadata={"Date": None})
    # Hundredths of a point are enough, and make the file smaller.
    shorter = re.sub(r"(\.\d\d)\d+", r"\1", picture.getvalue())
    pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "fitting.svg").write_text(shorter, encoding="utf-8")


if __name__ == "__main__":
    main()
