# SPDX-License-Identifier: MIT
"""Changes of weights and points, constraints and deformations in Python: one known value of each."""

import sys
import unittest
from math import cos, inf, sin

try:
    import numpy as np
except ImportError:
    print("SKIPPED: NumPy is not installed")
    sys.exit(77)

import nurbs


def near(actual, expected, by=1e-12):
    np.testing.assert_allclose(actual, expected, rtol=0, atol=by)


def status_of(call, *arguments, **options):
    try:
        call(*arguments, **options)
    except nurbs.NurbsError as error:
        return error.status
    return nurbs.NURBS_OK


def arch():
    """A parabola with its top (1, 1) in the middle, where R = (1/4, 1/2, 1/4)."""
    return nurbs.Spline.bezier([[0, 0], [1, 2], [2, 0]])


class Weights(unittest.TestCase):
    def test_pulled_weights(self):
        made, weight = nurbs.pull_weight(arch(), 1, 0.5, 0.5)
        near(weight, 3)
        near(made.eval(0.5), [1, 1.5])
        made, factor = nurbs.pull_weights(arch(), [0, 2], 0.5, 0.5)
        near(factor, 3)
        near(made.eval(0.5), [1, 0.5])

    def test_set_weights(self):
        made = nurbs.set_weights(arch(), [1, 2], [3, 1])
        near(made.weights(), [1, 3, 1])
        near(made.eval(0.5), [1, 1.5])

    def test_cross_ratios(self):
        points = nurbs.weight_points(nurbs.set_weights(arch(), [1], [3]), 1, 0.5)
        near(points, [[1, 0], [1, 1], [1, 1.5]])
        near(nurbs.weight_cross_ratio([1, 2], *points), 3)
        made, weight = nurbs.weight_through(arch(), 1, 0.5, [1, 1.5], 1e-9)
        near(weight, 3)
        near(made.eval(0.5), [1, 1.5])


class Points(unittest.TestCase):
    def test_pulled_points(self):
        made, moved = nurbs.pull_point(arch(), 1, 0.5, [0, 2], 0.5)
        near(moved, 1)
        near(made.points(), [[0, 0], [1, 3], [2, 0]])

    def test_influences(self):
        found = nurbs.most_influential(arch(), [0.5, 0])
        self.assertEqual(found.indices.tolist(), [1, 0])
        near(found.influences, [0.5, 1])
        patch = nurbs.plane([1, 0, 0], [0, 1, 0])
        self.assertEqual(nurbs.most_influential(patch, [[1, 0]]).indices.tolist(), [2])

    def test_legs(self):
        made = nurbs.insert_on_leg(arch(), 0, 0.5)
        near(made.knot, 0.5)
        near(made.spline.points()[1], [0.5, 1])
        made = nurbs.insert_at_point(arch().reparametrize(0, 2), [1.25, 1.5], 1e-9)
        self.assertEqual(made.index, 1)
        near([made.ratio, made.knot], [0.25, 0.5])
        near(made.spline.points(), [[0, 0], [0.25, 0.5], [1.25, 1.5], [2, 0]])


class Constraints(unittest.TestCase):
    def test_a_point(self):
        made = nurbs.constrain(arch(), 0.5, [1, 2])
        near(made.spline.eval(0.5), [1, 2])
        near(made.spline.points() - arch().points(), [[0, 2 / 3], [0, 4 / 3], [0, 2 / 3]])
        near(made.moved, 4 / 3)
        near(made.residuals, [0])
        self.assertLess(made.optimality, 1e-9)

    def test_what_stays(self):
        for options in ({"keep": (0, 0)}, {"costs": [inf, 1, inf]}):
            made = nurbs.constrain(arch(), [0.5], [[1, 2]], **options)
            near(made.spline.points(), [[0, 0], [1, 4], [2, 0]])

    def test_kinds(self):
        kinds, orders = [nurbs.NURBS_CONSTRAIN_VALUE, nurbs.NURBS_CONSTRAIN_DIRECTION], [[0], [1]]
        made = nurbs.constrain(arch(), [0.5, 0.5], [[1, 1], [1, 1]], kinds, orders)
        near(made.spline.eval(0.5), [1, 1])
        x, y = made.spline.eval_derivs(0.5, 1)[1]
        near(x, y)
        near(made.residuals, [0, 0])

    def test_weights(self):
        made = nurbs.constrain(arch(), 0.5, [1, 1.5], costs=[inf] * 3, weight_costs=[inf, 1, inf], tolerance=1e-9)
        near(made.spline.eval(0.5), [1, 1.5], by=1e-8)
        near(made.spline.weights(), [1, 3, 1], by=1e-7)

    def test_contradictions(self):
        self.assertEqual(status_of(nurbs.constrain, arch(), [0.5, 0.5], [[1, 1], [1, 2]]),
                         nurbs.NURBS_ERROR_CONTRADICTION)
        self.assertEqual(status_of(nurbs.constrain, arch(), [0.5], [[1, 1]], [7]), nurbs.NURBS_ERROR_CONSTRAINT)


class Deformations(unittest.TestCase):
    def test_warps(self):
        near(nurbs.warp(arch(), [0, 1], 0.5, 1).eval([0, 0.5, 1]), [[0, 0], [1, 1.5], [2, 0]])
        made = nurbs.warp(arch(), [0, 1], 0.5, 0, range=(0.5, 1))
        near(made.eval([0.25, 0.75]), arch().eval([0.25, 0.75]) + [[0, 0], [0, 0.5]])

    def test_flattening(self):
        made, moved = nurbs.flatten(arch(), [0, 1], [0, 1])
        near(made.points(), [[0, 1], [1, 1], [2, 1]])
        near(moved, 1)
        made, _ = nurbs.flatten(arch(), [0, 1], [0, 1], direction=[1, 1])
        near(made.points(), [[1, 1], [0, 1], [3, 1]])

    def test_bends(self):
        made = nurbs.bend(nurbs.line([0, 0], [1, 0]), [0, 0], [1, 0], [0, 1], 1, 1e-6)
        near(made.spline.eval(1), [sin(1), cos(1) - 1], by=1e-6)
        self.assertLessEqual(made.deviation, 1e-6)
        self.assertIsInstance(made.proven, bool)
        half = nurbs.bend(nurbs.line([0, 0], [1, 0]), [0, 0], [1, 0], [0, 1], 1, 1e-6, lower=0, upper=0.5)
        near(half.spline.eval(1), [sin(0.5) + 0.5 * cos(0.5), cos(0.5) - 1 - 0.5 * sin(0.5)], by=2e-6)

    def test_volumes(self):
        doubled = nurbs.bilinear([[[0, 0], [0, 2]], [[2, 0], [2, 2]]])
        made = nurbs.free_form_deform(nurbs.line([0, 0], [1, 1]), doubled, [0, 0], [1, 1], 1e-9)
        near(made.spline.eval(0.5), [1, 1], by=1e-9)

    def test_fairing(self):
        wave = nurbs.Spline.bezier([[0, 0], [1, 1], [2, -1], [3, 0]])
        made = nurbs.fair(wave, 10)
        near(made.spline.eval([0, 0.5, 1]), [[0, 0], [1.5, 0], [3, 0]], by=1e-9)
        self.assertTrue(made.energies[1] < 1e-9 < made.energies[0] and 0 < made.bound <= 10)
        kept = nurbs.fair(wave, 10, keep=(1, 1))
        near(kept.spline.points(), wave.points(), by=1e-9)

    def test_snapping(self):
        a, b = nurbs.line([0, 0], [1, 0]), nurbs.line([2, 2], [3, 3])
        made = nurbs.snap_boundary(a, (0, nurbs.NURBS_END), b, (0, nurbs.NURBS_START))
        near(made.spline.eval([0, 1]), [[0, 0], [2, 2]])
        self.assertGreaterEqual(made.bound, np.sqrt(5))


class Errors(unittest.TestCase):
    def test_statuses(self):
        self.assertEqual(status_of(nurbs.pull_weight, arch(), 1, 0, 0.5), nurbs.NURBS_ERROR_INFLUENCE)
        self.assertEqual(status_of(nurbs.pull_weight, arch(), 3, 0.5, 0.5), nurbs.NURBS_ERROR_INDEX)
        self.assertEqual(status_of(nurbs.pull_weight, arch(), 1, 0.5, -1), nurbs.NURBS_ERROR_WEIGHT_SIGN)
        self.assertEqual(status_of(nurbs.weight_cross_ratio, [0], [0], [1], [2]), nurbs.NURBS_ERROR_COLLINEAR)
        self.assertEqual(status_of(nurbs.insert_at_point, arch(), [5, 5], 0.1), nurbs.NURBS_ERROR_OFF_POLYGON)
        self.assertEqual(status_of(nurbs.warp, arch(), [0, 0], 1, 1), nurbs.NURBS_ERROR_DIRECTION)
        self.assertEqual(status_of(nurbs.fair, arch(), -1), nurbs.NURBS_ERROR_TOLERANCE)

    def test_arrays_that_do_not_fit(self):
        for call in (lambda: nurbs.pull_weight(arch(), 1, [0.5, 0.5], 1),
                     lambda: nurbs.set_weights(arch(), [1], [1, 2]),
                     lambda: nurbs.weight_cross_ratio([1, 2], [1], [1, 2], [1, 2]),
                     lambda: nurbs.constrain(arch(), [0.5], [1, 2, 3]),
                     lambda: nurbs.constrain(arch(), [0.5], [1, 2], costs=[1, 1]),
                     lambda: nurbs.bend(arch(), [0, 0, 0], [1, 0], [0, 1], 1, 1)):
            with self.assertRaises(ValueError):
                call()


if __name__ == "__main__":
    unittest.main()
