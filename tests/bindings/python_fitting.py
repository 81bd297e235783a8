# SPDX-License-Identifier: MIT
"""Fits and statistics in Python: splines come back, smoothing is what dense algebra says, sums are exact, and what is wrong
is said."""

import copy
import pickle
import unittest

import nurbs
from helpers import circle, EPS, near, np, patch, same, spied, status_of

CUBIC = nurbs.knots_open_uniform(3, 11)
BREAKS = np.linspace(0, 1, 33)  # four cells in each span of CUBIC


def noisy(count=400, seed=7):
    """Parameters, values with noise of deviation 0.1, and what they are without it."""
    random = np.random.default_rng(seed)
    t = np.sort(random.random(count))
    exact = np.sin(7 * t)
    return t, exact + random.normal(scale=0.1, size=count), exact


def empty(**others):
    return nurbs.Statistics(3, BREAKS, **{"value_scale": 4.0, **others})


def spans(knots):
    return np.unique(knots)


def design(degree, knots, t, order=0):
    """The matrix (n, count) of basis functions or their derivatives."""
    values, columns, rows = nurbs.collocation(degree, knots, t, [order])
    matrix = np.zeros((len(t), len(knots) - degree - 1))
    np.add.at(matrix, (np.repeat(np.arange(len(t)), np.diff(rows)), columns), values)
    return matrix


def penalty(degree, knots, order):
    """Integrals of products of derivatives, by Gauss's rule; the domain is [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(degree + 1)
    breaks = spans(knots)
    half = np.diff(breaks)[:, None] / 2
    at, weights = (breaks[:-1, None] + half * (x + 1)).ravel(), (half * w).ravel()
    derivatives = design(degree, knots, at, order)
    return derivatives.T @ (weights[:, None] * derivatives)


class Interpolation(unittest.TestCase):
    x, y = np.linspace(0, 1, 5), np.array([0, 0.5, 1.25, 2])
    start, end = nurbs.NURBS_START, nurbs.NURBS_END

    def heights(self, i=0, j=0):
        """Derivatives of (x^3 + 1) (y^2 - y) on the grid."""
        u = np.polynomial.Polynomial([1, 0, 0, 1]).deriv(i) if i else np.polynomial.Polynomial([1, 0, 0, 1])
        v = np.polynomial.Polynomial([0, -1, 1]).deriv(j) if j else np.polynomial.Polynomial([0, -1, 1])
        return (u(self.x)[:, None] * v(self.y))[..., None]

    def test_slopes_at_borders(self):
        slopes = {(0, self.start): self.heights(1)[:1], (0, self.end): self.heights(1)[-1:],
                  (1, self.end): self.heights(0, 1)[:, -1][None]}
        spline, residual = nurbs.interpolate([3, 3], [self.x, self.y], self.heights(), derivatives=slopes)
        self.assertEqual(spline.counts, (7, 5))
        self.assertLess(residual, 16 * EPS)
        near(spline.eval_grid_derivs(self.x, self.y, order=1)[:, :, 1], self.heights(1), 1e-13)
        near(spline.eval_grid_derivs(self.x, self.y, order=1)[:, :, 2], self.heights(0, 1), 1e-13)

    def test_slopes_of_curves_and_other_ends(self):
        curve, _ = nurbs.interpolate(3, self.x, self.heights()[:, 1], ends=(0, nurbs.NURBS_ENDS_NATURAL),
                                     derivatives={(0, self.start): [[7.0]]})
        near(curve.eval_derivs([0.0, 1.0], 2)[..., 0], [[-0.25, 7, curve.eval_derivs(0.0, 2)[2, 0]],
                                                         [-0.5, curve.eval_derivs(1.0, 1)[1, 0], 0]], 1e-12)

    def test_slopes_across_a_loop(self):
        """Of an even degree, whose domain does not begin with the data."""
        turn = np.linspace(0, 1, 9)
        circle = np.stack([np.cos(2 * np.pi * turn), np.sin(2 * np.pi * turn)], -1)
        circle[-1] = circle[0]
        for unit in 1, 1e-300, 1e300:
            cone = unit * circle[:, None] * np.arange(1, 5.0)[None, :, None]
            made = nurbs.interpolate([2, 3], [turn, np.arange(4.0)], cone, flags=nurbs.NURBS_PERIODIC,
                                     derivatives={(1, self.start): unit * circle[None]})
            self.assertLess(made.residual, 64 * EPS * unit)

    def test_wrong_slopes(self):
        for key, values, told in (((1, 0), [[1.0]], "axis below 1"), ((0, 2), [[1.0]], "NURBS_END"),
                                  ((0, 0), [[1.0, 2.0]], r"shape \(1, 2\) at \(0, 0\)")):
            self.assertRaisesRegex(ValueError, told, nurbs.interpolate, 3, self.x, self.heights()[:, 1],
                                   derivatives={key: values})
        self.assertRaisesRegex(ValueError, "orders", nurbs.interpolate_derivatives, 3, self.x, [0, 0],
                               self.heights()[:, 1])

    def test_directions(self):
        orders = [0, nurbs.NURBS_ORDER_DIRECTION] * 2
        given = (3, [0, 0, 1, 1], [[0, 0], [1, 1], [1, 0], [4, -4]], orders)
        near(nurbs.tangent_lengths(*given), [1, 0.75, 1, 0.1875], 1e-15)
        near(nurbs.curve_interpolate(*given).points, [[0, 0], [0.25, 0.25], [0.75, 0.25], [1, 0]], 1e-15)


class Shapes(unittest.TestCase):
    t, y, exact = noisy()

    def test_words_and_constants_say_the_same(self):
        rising = nurbs.fit_points(self.t, self.y, 3, CUBIC, shape="rising").spline
        self.assertTrue((np.diff(rising.points.ravel()) >= 0).all())
        self.assertEqual(rising, nurbs.fit_points(self.t, self.y, 3, CUBIC, shape=nurbs.NURBS_TREND_RISING).spline)
        both = nurbs.NURBS_TREND_FALLING + nurbs.NURBS_TREND_CONVEX
        stats = empty().add(self.t, self.y)
        self.assertEqual(stats.fit(3, CUBIC, shape="convex falling").spline, stats.fit(3, CUBIC, shape=[[both]]).spline)
        self.assertRaisesRegex(ValueError, "shape = 'steep'", stats.fit, 3, CUBIC, shape="steep")
        self.assertEqual(status_of(stats.fit, 3, CUBIC, shape="rising falling"), nurbs.NURBS_ERROR_RULE)

    def test_each_coordinate_has_its_own(self):
        values = np.column_stack([self.y, self.y])
        spline = nurbs.fit_points(self.t, values, 3, CUBIC, shape=[[0, nurbs.NURBS_TREND_FALLING]]).spline
        same(spline.points[:, 0], nurbs.fit_points(self.t, self.y, 3, CUBIC).spline.points.ravel())
        self.assertTrue((np.diff(spline.points[:, 1]) <= 0).all())

    def test_bounds(self):
        spline = nurbs.fit_tolerance(self.t, self.y, 3, 0.5, lower=-0.5, upper=[0.6]).spline
        self.assertTrue(spline.points.min() >= -0.5 and spline.points.max() <= 0.6)
        self.assertRaises(ValueError, nurbs.fit_points, self.t, self.y, 3, CUBIC, lower=[0, 0])


class Robust(unittest.TestCase):
    def test_outliers_do_not_pull(self):
        t, y, exact = noisy()
        y[::10] += 20
        plain = nurbs.fit_points(t, y, 3, CUBIC)
        for rule in "huber", nurbs.NURBS_ROBUST_TUKEY:
            spline, report = nurbs.fit_points(t, y, 3, CUBIC, robust=rule)
            self.assertLess(np.abs(spline(t).ravel() - exact).max(), 0.3)
            self.assertTrue(report.rounds > 2 and report.outliers >= 40 and report.sigma < 0.15)
        self.assertGreater(np.abs(plain.spline(t).ravel() - exact).max(), 1)
        self.assertEqual(nurbs.fit_points(t, y, 3, CUBIC, robust="huber", robust_width=1e9).spline, plain.spline)
        self.assertRaisesRegex(ValueError, "robust = 'l1'", nurbs.fit_points, t, y, 3, CUBIC, robust="l1")


class StandardErrors(unittest.TestCase):
    def test_they_are_what_dense_algebra_says(self):
        t, y, _ = noisy()
        stats, at = empty().add(t, y), np.linspace(0, 1, 17)
        for wishes in {}, {"smoothing": "gcv"}:
            fitted = stats.fit(3, CUBIC, **wishes)
            matrix, there = design(3, CUBIC, t), design(3, CUBIC, at)
            inverse = np.linalg.inv(matrix.T @ matrix + fitted.report.lam * penalty(3, CUBIC, 2))
            near(stats.fit_errors(fitted, at), fitted.report.sigma * np.sqrt(np.einsum("ij,jk,ik->i", there, inverse, there)),
                 by=1e-9)

    def test_criteria_are_smallest_where_the_fit_is(self):
        t, y, _ = noisy()
        stats = empty().add(t, y)
        for column, rule in (2, "gcv"), (3, "reml"):
            spline, report = stats.fit(3, CUBIC, smoothing=rule)
            found = stats.fit_criteria(spline, report.lam * np.array([0.5, 1, 2]))
            self.assertEqual(found.shape, (3, 4))
            self.assertEqual(found[:, column].argmin(), 1)
            near(found[1, :2], [report.squares, report.freedom], by=1e-9)


class Points(unittest.TestCase):
    def test_a_curve_comes_back(self):
        random = np.random.default_rng(1)
        curve = nurbs.Spline(3, CUBIC, random.normal(size=(11, 3)))
        t = random.random(200)
        spline, report = nurbs.fit_points(t, curve(t), 3, CUBIC, random.uniform(0.5, 2, 200))
        near(spline.points, curve.points, by=200 * EPS)
        same(spline.knots[0], CUBIC)
        self.assertEqual((report.data_count, report.bits, report.lam), (200, 0, 0))
        self.assertLess(report.largest, 200 * EPS)
        near(report.freedom, 11)

    def test_a_surface_and_a_volume_come_back(self):
        random = np.random.default_rng(2)
        volume = nurbs.Spline([1, 2, 2], [nurbs.knots_open_uniform(p, p + 2) for p in (1, 2, 2)],
                              random.normal(size=(3, 4, 4, 2)))
        for spline in (patch(), volume):
            params = random.random((2000, spline.axes))
            made, report = nurbs.fit_points(params, spline(params), spline.degrees, spline.knots)
            near(made.points, spline.points, by=1e-11)
            self.assertEqual((report.data_count, made.degrees), (2000, spline.degrees))

    def test_the_report_is_about_the_data(self):
        t, y, _ = noisy()
        weights = np.random.default_rng(3).uniform(0.5, 2, t.size)
        weights[5] = 0
        spline, report = nurbs.fit_points(t, y, 3, CUBIC, weights)
        left = np.abs(y - spline(t)[:, 0])
        counted = np.where(weights > 0, left, 0)
        self.assertEqual((report.data_count, report.largest_index), (t.size - 1, counted.argmax()))
        near(report.largest, counted.max())
        np.testing.assert_allclose((report.weight, report.squares), (weights.sum(), weights @ left**2), rtol=1e-10)
        np.testing.assert_allclose(report.rms, (report.squares / report.weight)**0.5)
        np.testing.assert_allclose(report.sigma, (report.squares / (t.size - 1 - report.freedom))**0.5)

    def test_values_may_be_a_vector(self):
        t, y, _ = noisy()
        columns = [nurbs.fit_points(at, of, 3, [CUBIC]).spline for at in (t, t[:, None]) for of in (y, y[:, None])]
        self.assertEqual(len(set(columns)), 1)
        self.assertEqual(columns[0].dimension, 1)

    def test_strides_are_used_in_place(self):
        random = np.random.default_rng(4)
        table = random.random((300, 8))
        params, values, weights = table[:, 1:5:2], np.asfortranarray(table[:, 5:7]), table[:, 7]
        knots = [nurbs.knots_open_uniform(2, 4)] * 2
        wanted = nurbs.fit_points(params.copy(), values.copy("C"), [2, 2], knots, weights.copy())
        with spied("nurbs_fit_points") as calls:
            self.assertEqual(nurbs.fit_points(params, values, [2, 2], knots, weights), wanted)
        data = calls[0][0]._obj
        self.assertEqual((data.params, data.param_stride, data.param_component_stride), (params.ctypes.data, 8, 2))
        self.assertEqual((data.values, data.value_stride, data.value_component_stride), (values.ctypes.data, 1, 300))
        self.assertEqual((data.weights, data.weight_stride), (weights.ctypes.data, 8))
        turned = nurbs.fit_points(params[::-1], values[::-1], [2, 2], knots, weights[::-1])  # copies
        self.assertEqual(turned.spline, wanted.spline)

    def test_periodic(self):
        knots = nurbs.knots_periodic(3, np.linspace(0, 1, 17))
        t = np.arange(200) / 200
        around = np.stack([np.cos(2 * np.pi * t), np.sin(2 * np.pi * t)], axis=1)
        spline, report = nurbs.fit_points(t, around, 3, knots, flags=nurbs.NURBS_PERIODIC)
        self.assertEqual((spline.periodic, spline.counts), ((True,), (19,)))
        near(report.freedom, 16)
        near(np.hypot(*spline(np.linspace(0, 1, 99)).T), 1, by=1e-4)
        near(spline.derivative()(0.0), spline.derivative()(1.0))
        # Parameters may be anywhere.
        shifted = nurbs.fit_points(t + np.arange(200) % 3, around, 3, knots, flags=nurbs.NURBS_PERIODIC,
                                   data_flags=nurbs.NURBS_WRAP)
        near(shifted.spline.points, spline.points)

    def test_flags_are_about_the_parameters(self):
        t, y, _ = noisy()
        wanted = nurbs.fit_points(t, y, 3, CUBIC)
        outside, more = np.append(t, [2, np.nan]), np.append(y, [1, 0])
        self.assertEqual(status_of(nurbs.fit_points, outside, more, 3, CUBIC), nurbs.NURBS_ERROR_OUTSIDE_DOMAIN)
        left_out = nurbs.fit_points(outside, more, 3, CUBIC, data_flags=nurbs.NURBS_NAN)
        self.assertEqual(left_out.spline, wanted.spline)
        clamped = nurbs.fit_points(outside[:-1], more[:-1], 3, CUBIC, data_flags=nurbs.NURBS_CLAMP)
        self.assertEqual(clamped.spline, nurbs.fit_points(np.append(t, 1), more[:-1], 3, CUBIC).spline)
        self.assertEqual(status_of(nurbs.fit_points, t, y, 3, CUBIC, data_flags=nurbs.NURBS_EXTRAPOLATE),
                         nurbs.NURBS_ERROR_FLAGS)


class Smoothing(unittest.TestCase):
    def test_a_given_factor(self):
        t, y, _ = noisy()
        b = design(3, CUBIC, t)
        for order in (1, 2, 3):
            p, lam = penalty(3, CUBIC, order), 10.0**(-2 * order)
            spline, report = nurbs.fit_points(t, y, 3, CUBIC, smoothing="lambda", lam=lam, penalty_order=order)
            near(spline.points[:, 0], np.linalg.solve(b.T @ b + lam * p, b.T @ y), by=1e-9)
            near(report.freedom, np.trace(np.linalg.solve(b.T @ b + lam * p, b.T @ b)), by=1e-8)
            self.assertEqual(report.lam, lam)

    def test_gcv(self):
        t, y, exact = noisy()
        knots = nurbs.knots_open_uniform(3, 60)
        rough, (spline, report) = (nurbs.fit_points(t, y, 3, knots, smoothing=how, regularize=True)
                                   for how in ("none", "gcv"))
        self.assertGreater(report.lam, 0)
        self.assertTrue(2 < report.freedom < 30, report)
        self.assertTrue(0.09 < report.sigma < 0.11, report)
        errors = [((s(t)[:, 0] - exact)**2).mean()**0.5 for s in (rough.spline, spline)]
        self.assertLess(errors[1], 0.7 * errors[0])

        def score(lam):
            found = nurbs.fit_points(t, y, 3, knots, smoothing="lambda", lam=lam).report
            return t.size * found.squares / (t.size - found.freedom)**2

        for factor in (0.5, 0.9, 1.1, 2):
            self.assertLess(score(report.lam), score(factor * report.lam))

    def test_reml(self):
        t, y, exact = noisy()
        spline, report = nurbs.fit_points(t, y, 3, nurbs.knots_open_uniform(3, 60), smoothing="reml")
        self.assertTrue(0.09 < report.sigma < 0.11, report)
        self.assertLess(((spline(t)[:, 0] - exact)**2).mean(), 0.03**2)

    def test_discrepancy(self):
        t, y, _ = noisy()
        least = nurbs.fit_points(t, y, 3, CUBIC).report.squares
        report = nurbs.fit_points(t, y, 3, CUBIC, smoothing="discrepancy", target=1.5 * least).report
        np.testing.assert_allclose(report.squares, 1.5 * least, rtol=1e-6)
        self.assertEqual(report.bits, 0)
        missed = nurbs.fit_points(t, y, 3, CUBIC, smoothing="discrepancy", target=least / 2).report
        self.assertEqual(missed.bits, nurbs.NURBS_FIT_TARGET_MISSED)

    def test_names_are_those_of_constants(self):
        t, y, _ = noisy()
        for name in ("none", "lambda", "gcv", "reml", "discrepancy"):
            rest = {"lam": 1e-3, "target": 5.0}
            constant = getattr(nurbs, f"NURBS_SMOOTHING_{name.upper()}")
            self.assertEqual(nurbs.fit_points(t, y, 3, CUBIC, smoothing=name, **rest),
                             nurbs.fit_points(t, y, 3, CUBIC, smoothing=constant, **rest))

    def test_regularize(self):
        t = np.linspace(0, 0.3, 20)
        self.assertEqual(status_of(nurbs.fit_points, t, t, 3, CUBIC), nurbs.NURBS_ERROR_RANK)
        spline = nurbs.fit_points(t, t, 3, CUBIC, regularize=True).spline
        near(spline(0.9), 0.9, by=1e-9)


class Conditions(unittest.TestCase):
    def test_they_hold(self):
        t, y, _ = noisy()
        values = np.stack([y, np.cos(7 * t)], axis=1)
        at, orders, targets = [0.0, 0.0, 0.4, 1.0], [0, 1, 0, 2], [[0, 1], [7, 0], [0.5, -1], [0, 0]]
        for smoothing in ("none", "gcv"):
            spline = nurbs.fit_points(t, values, 3, CUBIC, conditions=(at, orders, targets), smoothing=smoothing).spline
            for place, order, target in zip(at, orders, targets):
                near(spline(place, nu=order), target, by=1e-10)
        free = nurbs.fit_points(t, values, 3, CUBIC)
        self.assertEqual(nurbs.fit_points(t, values, 3, CUBIC, conditions=([], None, [])), free)

    def test_one_alone_and_those_of_surfaces(self):
        t, y, _ = noisy()
        near(nurbs.fit_points(t, y, 3, CUBIC, conditions=(0.5, None, 3)).spline(0.5), 3)
        near(nurbs.fit_points(t, y, 3, CUBIC, conditions=(0.5, 1, 3)).spline(0.5, nu=1), 3, by=1e-11)
        params = np.random.default_rng(5).random((400, 2))
        spline = nurbs.fit_points(params, patch()(params), [1, 2], patch().knots,
                                  conditions=([[0.5, 0.5], [1, 0]], [[1, 1], [0, 0]], [[0, 0, 2], [1, 0, 1]])).spline
        near(spline([1, 0]), [1, 0, 1], by=1e-11)
        near(spline.eval_derivs([0.5, 0.5], 2)[4], [0, 0, 2], by=1e-11)

    def test_statuses(self):
        t, y, _ = noisy()
        for status, wanted in ((nurbs.NURBS_ERROR_CONTRADICTION, ([0.5, 0.5], None, [1, 2])),
                               (nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, ([1.5], None, [1])),
                               (nurbs.NURBS_ERROR_PARAMETER_NOT_FINITE, ([np.nan], None, [1])),
                               (nurbs.NURBS_ERROR_POINT_NOT_FINITE, ([0.5], None, [np.inf])),
                               (nurbs.NURBS_ERROR_ORDER, ([0.5], [4], [1]))):
            self.assertEqual(status_of(nurbs.fit_points, t, y, 3, CUBIC, conditions=wanted), status)
        for wanted in (([0.5], None, [1, 2]), ([0.5], [1, 2], [1]), ([0.5], None)):
            self.assertRaises(ValueError, nurbs.fit_points, t, y, 3, CUBIC, conditions=wanted)


class Tolerance(unittest.TestCase):
    def test_no_datum_is_farther(self):
        t, counts = np.linspace(-1, 2, 3000), []
        values = np.stack([np.cos(t), np.exp(t)], axis=1)
        for tolerance in (1e-2, 1e-4, 1e-6):
            spline, report = nurbs.fit_tolerance(t, values, 3, tolerance)
            distances = np.linalg.norm(spline(t) - values, axis=1)
            self.assertLessEqual(distances.max(), tolerance * (1 + 1e-9))
            near(report.largest, distances.max())
            self.assertEqual((report.bits, report.largest_index), (0, distances.argmax()))
            self.assertEqual(spline.domain, ((-1, 2),))
            counts.append(spline.counts[0])
        self.assertTrue(4 <= counts[0] < counts[1] < counts[2] < 100, counts)
        near(nurbs.fit_tolerance(t, np.abs(t - 0.3), 3, 1e-6).spline(0.3), 0)  # a kink

    def test_a_limit_of_control_points(self):
        t, y, _ = noisy()
        spline, report = nurbs.fit_tolerance(t, y, 3, 1e-3, max_count=10)
        self.assertEqual(report.bits, nurbs.NURBS_FIT_TARGET_MISSED)
        self.assertLessEqual(spline.counts[0], 10)
        near(report.largest, np.abs(spline(t)[:, 0] - y).max())

    def test_other_domains(self):
        t, _, exact = noisy()
        self.assertEqual(nurbs.fit_tolerance(t, exact, 3, 1e-3, [-1, 2]).spline.domain, ((-1, 2),))
        params = np.random.default_rng(6).random((3000, 2))
        values = np.sin(5 * params[:, 0]) * params[:, 1]
        spline, report = nurbs.fit_tolerance(params, values, [3, 2], 1e-2, [[0, 1], [0, 2]])
        self.assertEqual((spline.domain, spline.degrees), (((0, 1), (0, 2)), (3, 2)))
        self.assertLessEqual(np.abs(spline(params)[:, 0] - values).max(), 1e-2)

    def test_periodic(self):
        t = np.arange(500) / 500
        around = np.stack([np.cos(2 * np.pi * t), np.sin(2 * np.pi * t)], axis=1)
        spline, report = nurbs.fit_tolerance(t, around, 3, 1e-4, [0, 1], flags=nurbs.NURBS_PERIODIC)
        self.assertEqual((spline.periodic, report.bits), ((True,), 0))
        near(spline(t), around, by=1e-4)

    def test_conditions_hold(self):
        t, _, exact = noisy()
        spline, report = nurbs.fit_tolerance(t, exact, 3, 1e-4, [0, 1], conditions=([0, 1], [0, 1], [0, 0.5]))
        near([spline(0)[0], spline(1, nu=1)[0]], [0, 0.5], by=1e-9)

    def test_statuses(self):
        t, y, _ = noisy()
        for status, arguments in ((nurbs.NURBS_ERROR_TOLERANCE, (t, y, 3, -1)),
                                  (nurbs.NURBS_ERROR_TOLERANCE, (t, y, 3, np.nan)),
                                  (nurbs.NURBS_ERROR_COUNT, ([], [], 3, 1)),
                                  (nurbs.NURBS_ERROR_EMPTY_DOMAIN, (t, y, 3, 1, [1, 1])),
                                  (nurbs.NURBS_ERROR_EMPTY_DOMAIN, ([0.5], [1], 3, 1)),
                                  (nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, (t, y, 3, 1, [0, 0.5])),
                                  (nurbs.NURBS_ERROR_TOO_FEW_POINTS, (t, y, 3, 1, None, 3)),
                                  (nurbs.NURBS_ERROR_DEGREE, (t, y, -1, 1))):
            self.assertEqual(status_of(nurbs.fit_tolerance, *arguments), status)


class Clouds(unittest.TestCase):
    RING = nurbs.knots_periodic(3, np.linspace(0, 1, 13))

    def ring(self, n=500):
        angle = 2 * np.pi * np.random.default_rng(12).random(n)
        return np.stack([2 + 3 * np.cos(angle), np.sin(angle)], axis=1)

    def test_an_ellipse(self):
        points = self.ring()
        start = nurbs.cloud_start(points, 3, self.RING, nurbs.NURBS_PERIODIC)
        spline, report = start.fit_cloud(points)
        self.assertEqual((spline.periodic, report.data_count, report.bits, report.uncertified), ((True,), 500, 0, 0))
        same(spline.knots[0], self.RING)
        distances = spline.closest_points(points).distances
        near([report.largest, report.rms], [distances.max(), np.sqrt((distances**2).mean())], by=1e-12)
        self.assertLess(report.largest, 2e-3)
        self.assertEqual(report.largest_index, distances.argmax())
        self.assertLess(report.noise, 1e-11)

    def test_a_surface_with_weights(self):
        params = np.random.default_rng(13).random((800, 2))
        points = np.column_stack([params, np.sin(3 * params[:, 0]) * params[:, 1]])
        weights = np.ones(801)
        weights[-1] = 0
        knots = [nurbs.knots_open_uniform(3, 6)] * 2
        start = nurbs.cloud_start(points, [3, 3], knots)
        self.assertEqual((start.degrees, start.counts, start.dimension), ((3, 3), (6, 6), 3))
        spline, report = start.fit_cloud(np.append(points, [[np.nan] * 3], axis=0), weights)
        self.assertEqual((report.data_count, report.weight), (800, 800))
        self.assertLess(report.largest, 1e-2)
        self.assertEqual(start.fit_cloud(points[::-1]).spline, spline)

    def test_settings(self):
        points = self.ring()
        start = nurbs.cloud_start(points, 3, self.RING, nurbs.NURBS_PERIODIC)
        report = start.fit_cloud(points, rounds=1).report
        self.assertEqual((report.rounds, report.bits), (1, nurbs.NURBS_CLOUD_NOT_CONVERGED))
        for lam in (0, 1e-3, 1.0):
            self.assertEqual(start.fit_cloud(points, lam=lam, first_lambda=2.0).report.lam, lam)
        stiff, soft = (start.fit_cloud(points, lam=10.0, penalty_order=order).report.rms for order in (3, 1))
        self.assertGreater(stiff, soft)
        self.assertLess(start.fit_cloud(points, tolerance=1e-9).report.rms,
                        start.fit_cloud(points, tolerance=0.5).report.rms)

    def test_strided_points(self):
        points = self.ring()
        start = nurbs.cloud_start(points, 3, self.RING, nurbs.NURBS_PERIODIC)
        wide = np.zeros((500, 5))
        wide[:, 1::2] = points
        with spied("nurbs_fit_cloud") as calls:
            self.assertEqual(start.fit_cloud(wide[:, 1::2]), start.fit_cloud(points))
        self.assertEqual(len(calls), 2)

    def test_statuses(self):
        points = self.ring()
        start = nurbs.cloud_start(points, 3, self.RING, nurbs.NURBS_PERIODIC)
        for status, arguments, rest in ((nurbs.NURBS_ERROR_COUNT, [np.empty((0, 2))], {}),
                                        (nurbs.NURBS_ERROR_POINT_NOT_FINITE, [points * np.nan], {}),
                                        (nurbs.NURBS_ERROR_WEIGHT_NEGATIVE, [points, -np.ones(500)], {}),
                                        (nurbs.NURBS_ERROR_ORDER, [points], {"penalty_order": 0}),
                                        (nurbs.NURBS_ERROR_FACTOR, [points], {"lam": np.nan}),
                                        (nurbs.NURBS_ERROR_TOLERANCE, [points], {"tolerance": -1}),
                                        (nurbs.NURBS_ERROR_COUNT, [points], {"rounds": 0})):
            self.assertEqual(status_of(start.fit_cloud, *arguments, **rest), status)
        self.assertEqual(status_of(circle().fit_cloud, points), nurbs.NURBS_ERROR_RATIONAL)
        self.assertEqual(status_of(nurbs.cloud_start, points[:, :1], 3, CUBIC), nurbs.NURBS_ERROR_DIMENSION)
        self.assertRaises(ValueError, nurbs.cloud_start, points[0], 3, CUBIC)
        self.assertRaises(ValueError, start.fit_cloud, points, [1, 2])
        self.assertRaises(ValueError, start.fit_cloud, points.ravel()[1:])


class Sums(unittest.TestCase):
    def test_parts_are_the_whole(self):
        t, y, _ = noisy(1000)
        weights = np.random.default_rng(8).random(1000)
        whole = empty().add(t, y, weights)
        order = np.random.default_rng(9).permutation(1000)
        for count in (2, 7):
            parts = [empty().add(t[i], y[i], weights[i]) for i in np.array_split(order, count)]
            one_by_one = empty()
            for i in np.array_split(order, count):
                one_by_one = one_by_one.add(t[i], y[i], weights[i])
            for made in (nurbs.Statistics.merge(parts), nurbs.Statistics.merge(iter(parts[::-1])), one_by_one,
                         sum(parts[1:], parts[0])):
                self.assertEqual(made.to_bytes(), whole.to_bytes())
            self.assertEqual((whole - parts[0]).to_bytes(), nurbs.Statistics.merge(parts[1:]).to_bytes())
            self.assertEqual(nurbs.Statistics.merge([whole, *parts], [1] + [-1] * count).to_bytes(),
                             empty().to_bytes())

    def test_what_they_hold(self):
        none = nurbs.Statistics([1, 2], [[0, 1], [0, 1, 3]], 3, value_scale=10)
        self.assertEqual((none.axes, none.dim, none.count, none.cells, none.weight), (2, 3, 0, 0, 0))
        some = none.add([[0.5, 0.5], [0.25, 2], [1, 3]], np.ones((3, 3)), [0.5, 0.25, 0])
        self.assertEqual((some.axes, some.dim, some.count, some.cells, some.weight), (2, 3, 2, 2, 0.75))
        self.assertEqual(none.count, 0)
        self.assertEqual(repr(some), "<Statistics: 2 values in 3D on 2 axes, in 2 cells, of weight 0.75>")
        self.assertEqual(none, none.add(np.empty((0, 2)), np.empty((0, 3))))

    def test_fits_of_them(self):
        t, y, _ = noisy()
        added = empty().add(t, y)
        for options in ({}, {"smoothing": "gcv"}, {"smoothing": "lambda", "lam": 1e-3, "penalty_order": 1},
                        {"conditions": ([0.5], [1], [2.0])}):
            spline, report = added.fit(3, CUBIC, **options)
            other = nurbs.fit_points(t, y, 3, CUBIC, **options)
            near(spline.points, other.spline.points, by=1e-10)
            self.assertEqual((report.data_count, report.largest_index), (400, -1))
            self.assertTrue(np.isnan(report.largest))
            np.testing.assert_allclose(report[1:8], other.report[1:8], rtol=1e-6, atol=1e-20)
        near(added.fit(2, nurbs.knots_open_uniform(2, 10)).spline(t),
             nurbs.fit_points(t, y, 2, nurbs.knots_open_uniform(2, 10)).spline(t), by=1e-11)

    def test_periodic_fits_and_surfaces(self):
        knots, t = nurbs.knots_periodic(3, BREAKS[::2]), np.arange(300) / 300
        added = empty().add(t, np.cos(2 * np.pi * t))
        spline = added.fit(3, knots, nurbs.NURBS_PERIODIC).spline
        self.assertEqual(spline.periodic, (True,))
        near(spline(t)[:, 0], np.cos(2 * np.pi * t), by=1e-3)
        params = np.random.default_rng(10).random((500, 2))
        surface = nurbs.Statistics([1, 2], [BREAKS, BREAKS], 3, value_scale=1).add(params, patch()(params))
        near(surface.fit([1, 2], patch().knots).spline.points, patch().points)

    def test_flags_are_about_the_parameters(self):
        t, y, _ = noisy()
        wanted = empty().add(t, y)
        self.assertEqual(empty().add(np.append(t, 7), np.append(y, 1), flags=nurbs.NURBS_NAN), wanted)
        self.assertEqual(status_of(empty().add, [7], [1]), nurbs.NURBS_ERROR_OUTSIDE_DOMAIN)


class Values(unittest.TestCase):
    def setUp(self):
        t, y, _ = noisy()
        self.statistics = empty().add(t, y)

    def test_bytes(self):
        contents = self.statistics.to_bytes()
        self.assertIsInstance(contents, bytes)
        shifted = bytearray(b"." + contents)
        for given in (contents, bytearray(contents), memoryview(shifted)[1:], memoryview(contents[::-1])[::-1]):
            again = nurbs.Statistics.from_bytes(given)
            self.assertEqual((again, again.to_bytes()), (self.statistics, contents))
        self.assertEqual(again.fit(3, CUBIC).spline, self.statistics.fit(3, CUBIC).spline)

    def test_other_bytes(self):
        contents, from_bytes = self.statistics.to_bytes(), nurbs.Statistics.from_bytes
        spoiled = bytearray(contents)
        spoiled[-1] ^= 1
        for status, given in ((nurbs.NURBS_ERROR_TRUNCATED, b""), (nurbs.NURBS_ERROR_TRUNCATED, contents[:-1]),
                              (nurbs.NURBS_ERROR_FORMAT, b"x" * 100), (nurbs.NURBS_ERROR_CHECKSUM, spoiled)):
            self.assertRaises(nurbs.ContentsError, from_bytes, given)
            self.assertEqual(status_of(from_bytes, given), status)
        for given in ("text", 5, [1, 2]):
            self.assertRaisesRegex(TypeError, "bytes-like", from_bytes, given)

    def test_pickles(self):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(self.statistics, protocol))
            self.assertIs(type(again), nurbs.Statistics)
            self.assertEqual(again, self.statistics)
        self.assertNotIn(b"nurbs._", pickle.dumps(self.statistics, 0))
        # Not a class method, which cloudpickle, and so Dask, does not find again by its name.
        self.assertIs(getattr(nurbs, self.statistics.__reduce_ex__(5)[0].__name__), self.statistics.__reduce_ex__(5)[0])
        buffers = []
        head = pickle.dumps(self.statistics, 5, buffer_callback=buffers.append)
        self.assertEqual((len(buffers), pickle.loads(head, buffers=buffers)), (1, self.statistics))
        self.assertLess(len(head), 200)

    def test_pickles_of_fits(self):
        fitted = self.statistics.fit(3, CUBIC, smoothing="gcv")
        text = pickle.dumps(fitted, 0)
        self.assertNotIn(b"nurbs._", text)
        self.assertEqual(repr(pickle.loads(text)), repr(fitted))

    def test_copies(self):
        for other in (self.statistics.copy(), copy.copy(self.statistics), copy.deepcopy([self.statistics])[0]):
            self.assertIsNot(other, self.statistics)
            self.assertEqual(other, self.statistics)

    def test_equality_is_bit_for_bit(self):
        t, y, _ = noisy()
        others = [self.statistics, empty(), empty().add(t[1:], y[1:]), empty().add(t, np.nextafter(y, 9) + 1e-9),
                  empty(value_scale=8.0).add(t, y), empty(weight_scale=2.0), empty(dim=2)]
        self.assertEqual(len({*others, empty().add(t[::-1], y[::-1])}), len(others))
        self.assertTrue(empty() != 1 and not empty() == None)  # noqa: E711 - what is tested

    def test_they_do_not_change(self):
        for change in (lambda: setattr(self.statistics, "count", 1), lambda: setattr(self.statistics, "name", 1),
                       lambda: delattr(self.statistics, "_handle")):
            self.assertRaisesRegex(AttributeError, "do not change", change)
        self.assertRaisesRegex(TypeError, "do not change", self.statistics.__init__, 3, BREAKS, value_scale=1)

    def test_derived_classes_stay(self):
        class Forgetful(nurbs.Statistics):
            def __init__(self):
                pass

        for use in (lambda: Forgetful().axes, lambda: Forgetful().to_bytes(), lambda: repr(Forgetful()),
                    lambda: Forgetful() + empty(), lambda: Forgetful().add([0.5], [1])):
            self.assertRaisesRegex(nurbs.ArgumentError, "NULL", use)
        named = Named()
        for made in (named.add([0.5], [1]), named + named, Named.merge([empty()]), named.copy(),
                     pickle.loads(pickle.dumps(named))):
            self.assertIs(type(made), Named)

    def test_handles_are_freed(self):
        with spied("nurbs_statistics_destroy") as calls:
            statistics = empty()
            statistics = statistics.add([0.5], [1])
            self.assertEqual(len(calls), 1)
            del statistics
            self.assertEqual(len(calls), 2)
            self.assertRaises(nurbs.NurbsError, empty().add, [2], [1])
        self.assertEqual(len(calls), 3)


class Named(nurbs.Statistics):
    """A class that asks for other arguments."""

    def __init__(self):
        super().__init__(1, [0, 1], value_scale=1)


class Errors(unittest.TestCase):
    def test_statuses(self):
        t, y, _ = noisy()
        added = empty().add(t, y)
        for status, call in (
                (nurbs.NURBS_ERROR_DEGREE, lambda: nurbs.Statistics(-1, BREAKS, value_scale=1)),
                (nurbs.NURBS_ERROR_AXES, lambda: nurbs.Statistics([1] * 4, [[0, 1]] * 4, value_scale=1)),
                (nurbs.NURBS_ERROR_COUNT, lambda: nurbs.Statistics(1, [0], value_scale=1)),
                (nurbs.NURBS_ERROR_KNOTS_DECREASING, lambda: nurbs.Statistics(1, [0, 1, 1], value_scale=1)),
                (nurbs.NURBS_ERROR_DIMENSION, lambda: empty(dim=0)),
                (nurbs.NURBS_ERROR_FACTOR, lambda: empty(value_scale=0.0)),
                (nurbs.NURBS_ERROR_FACTOR, lambda: empty(weight_scale=np.inf)),
                (nurbs.NURBS_ERROR_SCALE, lambda: empty().add([0.5], [4.5])),
                (nurbs.NURBS_ERROR_SCALE, lambda: empty().add([0.5], [1], [1.5])),
                (nurbs.NURBS_ERROR_WEIGHT_NEGATIVE, lambda: empty().add([0.5], [1], [-1])),
                (nurbs.NURBS_ERROR_WEIGHT_NOT_FINITE, lambda: empty().add([0.5], [1], [np.nan])),
                (nurbs.NURBS_ERROR_POINT_NOT_FINITE, lambda: empty().add([0.5], [np.nan])),
                (nurbs.NURBS_ERROR_PARAMETER_NOT_FINITE, lambda: empty().add([np.inf], [1])),
                (nurbs.NURBS_ERROR_AXES, lambda: empty().add([[0.5, 0.5]], [1])),
                (nurbs.NURBS_ERROR_DIMENSION, lambda: empty().add([0.5], [[1, 2]])),
                (nurbs.NURBS_ERROR_FLAGS, lambda: empty().add([0.5], [1], flags=0x40)),
                (nurbs.NURBS_ERROR_INCOMPATIBLE, lambda: added + empty(dim=2)),
                (nurbs.NURBS_ERROR_RULE, lambda: nurbs.Statistics.merge([added], [2])),
                (nurbs.NURBS_ERROR_COUNT, lambda: nurbs.Statistics.merge([])),
                (nurbs.NURBS_ERROR_COUNT, lambda: empty() - added),
                (nurbs.NURBS_ERROR_RANK, lambda: empty().fit(3, CUBIC)),
                (nurbs.NURBS_ERROR_DEGREE, lambda: added.fit(4, nurbs.knots_open_uniform(4, 5))),
                (nurbs.NURBS_ERROR_NOT_A_KNOT, lambda: added.fit(3, nurbs.knots_open_uniform(3, 12))),
                (nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, lambda: added.fit(3, nurbs.knots_open_uniform(3, 11, 0, 2))),
                (nurbs.NURBS_ERROR_TOO_FEW_POINTS, lambda: added.fit(3, [0, 0, 0, 1, 1, 1])),
                (nurbs.NURBS_ERROR_PERIODIC_KNOTS, lambda: added.fit(3, CUBIC, nurbs.NURBS_PERIODIC)),
                (nurbs.NURBS_ERROR_RULE, lambda: added.fit(3, CUBIC, smoothing=5)),
                (nurbs.NURBS_ERROR_ORDER, lambda: added.fit(3, CUBIC, penalty_order=0)),
                (nurbs.NURBS_ERROR_ORDER, lambda: added.fit(3, CUBIC, smoothing="gcv", penalty_order=4)),
                (nurbs.NURBS_ERROR_FACTOR, lambda: added.fit(3, CUBIC, smoothing="lambda", lam=-1)),
                (nurbs.NURBS_ERROR_FACTOR, lambda: added.fit(3, CUBIC, smoothing="discrepancy", target=np.nan)),
                (nurbs.NURBS_ERROR_RANK, lambda: nurbs.fit_points([0.5], [1], 3, CUBIC))):
            self.assertEqual(status_of(call), status)

    def test_arrays_that_do_not_fit(self):
        t, y, _ = noisy()
        knots = [CUBIC, CUBIC]
        for call in (lambda: empty().add(t, y[1:]), lambda: empty().add(0.5, 1), lambda: empty().add(t, y, y[1:]),
                     lambda: empty().add(t, y[:, None, None]), lambda: nurbs.fit_points(t, y, [3, 3], knots),
                     lambda: nurbs.fit_points(t, y, 3, knots), lambda: nurbs.fit_points(t[:, None, None], y, 3, CUBIC),
                     lambda: nurbs.fit_points(np.stack([t, t], 1), y, 3, CUBIC), lambda: empty().fit([3, 3], knots),
                     lambda: empty().fit(3, CUBIC, smoothing="best"), lambda: nurbs.Statistics.merge([empty()], [1, 1]),
                     lambda: nurbs.Statistics([1, 1], [0, 1, 2], value_scale=1),
                     lambda: nurbs.fit_tolerance(t, y, [3, 3], 1), lambda: nurbs.fit_tolerance(t, y, 3, 1, [0, 1, 2])):
            with self.assertRaises(ValueError) as raised:
                call()
            self.assertNotIsInstance(raised.exception, nurbs.NurbsError)

    def test_arguments_of_other_types(self):
        t, y, _ = noisy()
        for kind, call in ((TypeError, lambda: nurbs.Statistics(3, BREAKS)), (TypeError, lambda: empty() + 1),
                           (TypeError, lambda: empty() - circle()), (TypeError, lambda: 1 + empty()),
                           (TypeError, lambda: nurbs.Statistics.merge([circle()])),
                           (TypeError, lambda: nurbs.Statistics.merge(None)),
                           (TypeError, lambda: nurbs.Statistics(2.5, BREAKS, value_scale=1)),
                           (TypeError, lambda: empty().fit(3, CUBIC, smoothing=None)),
                           (TypeError, lambda: empty().fit(3, CUBIC, penalty_order=1.5)),
                           (TypeError, lambda: empty().fit(3, CUBIC, lam="a")),
                           (OverflowError, lambda: empty().fit(3, CUBIC, penalty_order=2**32 + 2)),
                           (OverflowError, lambda: empty().fit(3, CUBIC, smoothing=2**32)),
                           (OverflowError, lambda: empty().add(t, y, flags=2**32)),
                           (OverflowError, lambda: nurbs.fit_tolerance(t, y, 3, 1, max_count=2**64)),
                           (OverflowError, lambda: nurbs.fit_points(t, y, 3, CUBIC, flags=-1))):
            self.assertRaises(kind, call)


class LongCalls(unittest.TestCase):
    """As python_long_calls.py tests those of splines."""

    def setUp(self):
        self.t = np.random.default_rng(11).random(2_000_000)
        self.y = np.sin(9 * self.t)

    def calls(self):
        added = nurbs.Statistics(3, np.linspace(0, 1, 2**14 + 1), value_scale=1).add(self.t, self.y)
        knots = nurbs.knots_open_uniform(3, 2**14 + 3)
        yield lambda **wishes: empty().add(self.t, self.y, **wishes)
        yield lambda **wishes: added.fit(3, knots, smoothing="gcv", **wishes)
        yield lambda **wishes: nurbs.fit_points(self.t, self.y, 3, CUBIC, **wishes)
        yield lambda **wishes: nurbs.fit_points(self.t, self.y, 3, CUBIC, robust="tukey", **wishes)
        yield lambda **wishes: nurbs.fit_tolerance(self.t, self.y, 3, 1e-4, **wishes)

    def test_progress_rises_and_the_answer_is_the_same(self):
        for call in self.calls():
            seen = []
            watched, alone = call(progress=seen.append), call()
            self.assertEqual(getattr(watched, "spline", watched), getattr(alone, "spline", alone))
            self.assertTrue(seen and seen == sorted(seen) and 0 <= seen[0] and seen[-1] <= 1)

    def test_they_end(self):
        def end(done):
            raise KeyError("own")

        for call in self.calls():
            with self.assertRaisesRegex(KeyError, "own"):
                call(progress=end)
            self.assertRaises(nurbs.CancelledError, call, progress=lambda done: False)
            self.assertRaises(nurbs.WorkError, call, work=1)
            self.assertRaises(nurbs.ArgumentError, call, work=-1)
            self.assertRaises(TypeError, call, progress=7)


if __name__ == "__main__":
    unittest.main()
