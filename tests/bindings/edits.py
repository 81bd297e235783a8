# SPDX-License-Identifier: MIT
"""Changes of weights and points, constraints and deformations in Python: one known value of each."""

import unittest
from math import cos, inf, sin

import nurbs
from helpers import near, np, status_of


def arch():
    """A parabola with its top (1, 1) in the middle, where R = (1/4, 1/2, 1/4)."""
    return nurbs.Spline.bezier([[0, 0], [1, 2], [2, 0]])


class Weights(unittest.TestCase):
    def test_pulled_weights(self):
        made, weight = arch().pull_weight(1, 0.5, 0.5)
        near(weight, 3)
        near(made.eval(0.5), [1, 1.5])
        made, factor = arch().pull_weights([0, 2], 0.5, 0.5)
        near(factor, 3)
        near(made.eval(0.5), [1, 0.5])

    def test_set_weights(self):
        made = arch().set_weights([1, 2], [3, 1])
        near(made.weights, [1, 3, 1])
        near(made.eval(0.5), [1, 1.5])

    def test_cross_ratios(self):
        points = arch().set_weights([1], [3]).weight_points(1, 0.5)
        near(points, [[1, 0], [1, 1], [1, 1.5]])
        near(nurbs.weight_cross_ratio([1, 2], *points), 3)
        made, weight = arch().weight_through(1, 0.5, [1, 1.5], 1e-9)
        near(weight, 3)
        near(made.eval(0.5), [1, 1.5])


class Points(unittest.TestCase):
    def test_pulled_points(self):
        made, moved = arch().pull_point(1, 0.5, [0, 2], 0.5)
        near(moved, 1)
        near(made.points, [[0, 0], [1, 3], [2, 0]])

    def test_influences(self):
        found = arch().most_influential([0.5, 0])
        self.assertEqual(found.indices.tolist(), [1, 0])
        near(found.influences, [0.5, 1])
        patch = nurbs.plane([1, 0, 0], [0, 1, 0])
        self.assertEqual(patch.most_influential([[1, 0]]).indices.tolist(), [2])

    def test_legs(self):
        made = arch().insert_on_leg(0, 0.5)
        near(made.knot, 0.5)
        near(made.spline.points[1], [0.5, 1])
        made = arch().reparametrize(0, 2).insert_at_point([1.25, 1.5], 1e-9)
        self.assertEqual(made.leg, 1)
        near([made.ratio, made.knot], [0.25, 0.5])
        near(made.spline.points, [[0, 0], [0.25, 0.5], [1.25, 1.5], [2, 0]])


class Constraints(unittest.TestCase):
    def test_a_point(self):
        made = arch().constrain(0.5, [1, 2])
        near(made.spline.eval(0.5), [1, 2])
        near(made.spline.points - arch().points, [[0, 2 / 3], [0, 4 / 3], [0, 2 / 3]])
        near(made.moved, 4 / 3)
        near(made.residuals, [0])
        self.assertLess(made.optimality, 1e-9)

    def test_what_stays(self):
        for options in ({"keep": (0, 0)}, {"costs": [inf, 1, inf]}):
            made = arch().constrain([0.5], [[1, 2]], **options)
            near(made.spline.points, [[0, 0], [1, 4], [2, 0]])

    def test_kinds(self):
        kinds, orders = [nurbs.NURBS_CONSTRAIN_VALUE, nurbs.NURBS_CONSTRAIN_DIRECTION], [[0], [1]]
        made = arch().constrain([0.5, 0.5], [[1, 1], [1, 1]], kinds, orders)
        near(made.spline.eval(0.5), [1, 1])
        x, y = made.spline.eval_derivs(0.5, 1)[1]
        near(x, y)
        near(made.residuals, [0, 0])

    def test_weights(self):
        made = arch().constrain(0.5, [1, 1.5], costs=[inf] * 3, weight_costs=[inf, 1, inf], tolerance=1e-9)
        near(made.spline.eval(0.5), [1, 1.5], by=1e-8)
        near(made.spline.weights, [1, 3, 1], by=1e-7)

    def test_contradictions(self):
        self.assertEqual(status_of(arch().constrain, [0.5, 0.5], [[1, 1], [1, 2]]),
                         nurbs.NURBS_ERROR_CONTRADICTION)
        self.assertEqual(status_of(arch().constrain, [0.5], [[1, 1]], [7]), nurbs.NURBS_ERROR_CONSTRAINT)


class Deformations(unittest.TestCase):
    def test_warps(self):
        near(arch().warp([0, 1], 0.5, 1).eval([0, 0.5, 1]), [[0, 0], [1, 1.5], [2, 0]])
        made = arch().warp([0, 1], 0.5, 0, range=(0.5, 1))
        near(made.eval([0.25, 0.75]), arch().eval([0.25, 0.75]) + [[0, 0], [0, 0.5]])

    def test_flattening(self):
        made, moved = arch().flatten([0, 1], [0, 1])
        near(made.points, [[0, 1], [1, 1], [2, 1]])
        near(moved, 1)
        made, _ = arch().flatten([0, 1], [0, 1], direction=[1, 1])
        near(made.points, [[1, 1], [0, 1], [3, 1]])

    def test_bends(self):
        made = nurbs.line([0, 0], [1, 0]).bend([0, 0], [1, 0], [0, 1], 1, 1e-6)
        near(made.spline.eval(1), [sin(1), cos(1) - 1], by=1e-6)
        self.assertLessEqual(made.deviation, 1e-6)
        self.assertIsInstance(made.proven, bool)
        half = nurbs.line([0, 0], [1, 0]).bend([0, 0], [1, 0], [0, 1], 1, 1e-6, lower=0, upper=0.5)
        near(half.spline.eval(1), [sin(0.5) + 0.5 * cos(0.5), cos(0.5) - 1 - 0.5 * sin(0.5)], by=2e-6)

    def test_volumes(self):
        doubled = nurbs.bilinear([[[0, 0], [0, 2]], [[2, 0], [2, 2]]])
        made = nurbs.line([0, 0], [1, 1]).free_form_deform(doubled, [0, 0], [1, 1], 1e-9)
        near(made.spline.eval(0.5), [1, 1], by=1e-9)

    def test_fairing(self):
        wave = nurbs.Spline.bezier([[0, 0], [1, 1], [2, -1], [3, 0]])
        made = wave.fair(10)
        near(made.spline.eval([0, 0.5, 1]), [[0, 0], [1.5, 0], [3, 0]], by=1e-9)
        self.assertTrue(made.energies[1] < 1e-9 < made.energies[0] and 0 < made.bound <= 10)
        kept = wave.fair(10, keep=(1, 1))
        near(kept.spline.points, wave.points, by=1e-9)

    def test_fairing_of_a_large_shape(self):
        wave = nurbs.Spline.bezier(np.array([[0, 0], [1, 1], [2, -1], [3, 0]]) * 2.0**600)
        made = wave.fair(2.0**604)
        near(made.spline.eval(0.5) / 2.0**600, [1.5, 0], by=1e-9)
        self.assertTrue(np.isinf(made.energies).all() and 0 < made.bound <= 2.0**604)

    def test_snapping(self):
        a, b = nurbs.line([0, 0], [1, 0]), nurbs.line([2, 2], [3, 3])
        made = a.snap_boundary((0, nurbs.NURBS_END), b, (0, nurbs.NURBS_START))
        near(made.spline.eval([0, 1]), [[0, 0], [2, 2]])
        self.assertGreaterEqual(made.bound, np.sqrt(5))


class Errors(unittest.TestCase):
    def test_statuses(self):
        self.assertEqual(status_of(arch().pull_weight, 1, 0, 0.5), nurbs.NURBS_ERROR_INFLUENCE)
        self.assertEqual(status_of(arch().pull_weight, 3, 0.5, 0.5), nurbs.NURBS_ERROR_INDEX)
        self.assertEqual(status_of(arch().pull_weight, 1, 0.5, -1), nurbs.NURBS_ERROR_WEIGHT_SIGN)
        self.assertEqual(status_of(nurbs.weight_cross_ratio, [0], [0], [1], [2]), nurbs.NURBS_ERROR_COLLINEAR)
        self.assertEqual(status_of(arch().insert_at_point, [5, 5], 0.1), nurbs.NURBS_ERROR_OFF_POLYGON)
        self.assertEqual(status_of(arch().warp, [0, 0], 1, 1), nurbs.NURBS_ERROR_DIRECTION)
        self.assertEqual(status_of(arch().fair, -1), nurbs.NURBS_ERROR_TOLERANCE)

    def test_arrays_that_do_not_fit(self):
        for call in (lambda: arch().pull_weight(1, [0.5, 0.5], 1),
                     lambda: arch().set_weights([1], [1, 2]),
                     lambda: nurbs.weight_cross_ratio([1, 2], [1], [1, 2], [1, 2]),
                     lambda: arch().constrain([0.5], [1, 2, 3]),
                     lambda: arch().constrain([0.5], [1, 2], costs=[1, 1]),
                     lambda: arch().bend([0, 0, 0], [1, 0], [0, 1], 1, 1)):
            with self.assertRaises(ValueError):
                call()


if __name__ == "__main__":
    unittest.main()
