# SPDX-License-Identifier: MIT
"""Spline.plot() in Python: what it draws; skipped without Matplotlib."""

import sys
import unittest
import warnings
from unittest import mock

import nurbs
from helpers import circle, near, np, patch

try:
    # Matplotlib and what it imports may be older than the interpreter.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        from mpl_toolkits.mplot3d import art3d
except ImportError:
    print("SKIPPED: Matplotlib is not installed")
    sys.exit(77)


def drawn(ax):
    """The axes as a picture that is not empty."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ax.figure.canvas.draw()
    picture = np.asarray(ax.figure.canvas.buffer_rgba())
    return (picture[..., :3] < 250).any()


def new_axes(shape):
    return plt.figure().add_subplot(projection="3d" if shape.dimension == 3 else None)


def within(ax, *shapes):
    """The limits of the axes are those of the shapes, with a margin."""
    boxes = [shape.box(1e-6) for shape in shapes]
    lower, upper = (np.min([box.lower for box in boxes], axis=0), np.max([box.upper for box in boxes], axis=0))
    limits = np.array([getattr(ax, f"get_{axis}lim")() for axis in "xyz"[:len(lower)]])
    margin = 0.12 * (upper - lower) + 1e-5
    np.testing.assert_array_less(limits[:, 0], lower + 1e-5)
    np.testing.assert_array_less(lower - margin, limits[:, 0])
    np.testing.assert_array_less(upper - 1e-5, limits[:, 1])
    np.testing.assert_array_less(limits[:, 1], upper + margin)


class Plots(unittest.TestCase):
    def tearDown(self):
        plt.close("all")

    def test_a_curve_with_its_polygon_and_knots(self):
        ax = circle().plot()
        curve, knots, polygon = (np.stack(line.get_data(), -1) for line in ax.lines)
        near(np.hypot(*curve.T), 1)
        self.assertGreater(len(curve), 100)
        near(knots, [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]])
        near(polygon, circle().points)
        self.assertEqual(ax.get_aspect(), 1)
        self.assertTrue(drawn(ax))
        self.assertEqual([len(circle().plot(plt.figure().add_subplot(), control=False, knots=knots).lines)
                          for knots in (False, True)], [1, 2])

    def test_the_axes_given(self):
        ax = plt.figure().add_subplot()
        self.assertIs(circle().plot(ax, color="red"), ax)
        self.assertIs(nurbs.circle(2).plot(ax), ax)
        self.assertEqual((len(ax.lines), ax.lines[0].get_color()), (6, "red"))
        self.assertEqual(len(plt.get_fignums()), 1)

    def test_curves_in_space_and_graphs(self):
        ax = nurbs.helix(1, 2, 3, tolerance=1e-6).spline.plot()
        self.assertEqual((ax.name, len(ax.lines)), ("3d", 3))
        self.assertTrue(drawn(ax))
        graph = nurbs.Spline(2, [0, 0, 0, 1, 1, 1], [[0], [0], [1]]).plot()
        x, y = graph.lines[0].get_data()
        near(y, x * x)
        near(graph.lines[2].get_xdata(), [0, 0.5, 1])
        self.assertEqual(nurbs.bilinear([[[0], [1]], [[2], [5]]]).plot().name, "3d")

    def test_no_line_across_a_jump(self):
        step = nurbs.Spline(1, [0, 0, 1, 1, 2, 2], [[0, 0], [1, 0], [1, 1], [2, 1]]).plot(control=False, knots=False)
        ends = [(line.get_ydata()[0], line.get_ydata()[-1]) for line in step.lines]
        self.assertEqual(ends, [(0, 0), (1, 1)])

    def test_surfaces_and_volumes(self):
        inner, outer = (nurbs.arc(radius, 0, 3, center=[0, 0, 0]) for radius in (1, 2))
        for shape in (nurbs.sphere(), patch(), outer.extrude([0, 0, 1]), inner.ruled(outer).extrude([0, 0, 1])):
            with mock.patch.object(art3d, "Poly3DCollection", wraps=art3d.Poly3DCollection) as made:
                ax = shape.plot()
            corners = np.concatenate(made.call_args.args[0])
            self.assertEqual(len(ax.collections), 1)
            near(shape.closest_points(corners[::7]).distances, 0, by=1e-9)
            lower, upper, _ = shape.box(1e-6)
            near([corners.min(axis=0), corners.max(axis=0)], [lower, upper], by=1e-3)
            self.assertTrue(drawn(ax))
        self.assertGreater(len(patch().plot(control=True).lines), 4)

    def test_the_limits_are_those_of_what_is_drawn(self):
        ball, tile = nurbs.sphere(0.01), nurbs.bilinear([[[3, 0], [3, 1]], [[4, 0], [4, 1]]])
        small, far = nurbs.circle(1e-3, center=[5, 5]), nurbs.sphere(100, center=[1000, 0, 0])
        helix = nurbs.helix(1e-3, 2e-3, 3, tolerance=1e-6).spline
        body = nurbs.arc(1, 0, 3, center=[0, 0, 0]).extrude([0, 0, 1]).extrude([7, 7, 7])
        for shape in (ball, far, tile, tile.transform(1e-3 * np.eye(2)), small, helix, body):
            line = nurbs.line([-1.0] * shape.dimension, [7.0] * shape.dimension)
            within(shape.plot(control=False), shape)
            within(shape.plot(new_axes(shape), control=False), shape)
            for drawn_before in (line, shape.transform(2 * np.eye(shape.dimension))):
                within(shape.plot(drawn_before.plot(new_axes(shape), control=False), control=False), shape, drawn_before)
            ax = new_axes(shape)
            ax.plot(*line.points.T)
            within(shape.plot(ax, control=False), shape, line)
            plt.close("all")

    def test_surfaces_in_the_plane(self):
        ax = nurbs.bilinear([[[0, 0], [0, 1]], [[1, 0], [2, 3]]]).plot()
        points = np.concatenate([path.vertices for path in ax.collections[0].get_paths()])
        near([points.min(axis=0), points.max(axis=0)], [[0, 0], [2, 3]])
        self.assertTrue(drawn(ax))

    def test_what_cannot_be_drawn(self):
        for spline in (nurbs.line([0] * 4, [1] * 4), nurbs.trilinear(np.arange(8.0).reshape(8, 1))):
            with self.assertRaisesRegex(ValueError, "cannot be drawn"):
                spline.plot()

    def test_without_matplotlib(self):
        with mock.patch.dict(sys.modules, {"matplotlib.pyplot": None, "matplotlib": None}):
            with self.assertRaisesRegex(ImportError, "plot.. needs Matplotlib"):
                circle().plot()


if __name__ == "__main__":
    unittest.main()
