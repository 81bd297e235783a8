# SPDX-License-Identifier: MIT
"""The Python binding: create, evaluate a batch, insert a knot, and be told what is wrong."""

import pathlib
import threading
import unittest

import nurbs
from helpers import circle, EPS, np, patch, same


class Evaluation(unittest.TestCase):
    def test_version(self):
        self.assertEqual(nurbs.version(), nurbs.NURBS_VERSION)

    def test_known_points(self):
        points = circle().eval([0.0, 0.25, 0.5, 0.75, 1.0])
        np.testing.assert_array_equal(points, [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]])

    def test_knot_insertion_keeps_the_circle(self):
        before, t = circle(), np.linspace(0, 1, 1001)
        after = before.insert_knot(0.3, times=2)
        self.assertEqual(after.counts[0], 11)
        self.assertEqual(list(after.knots[0]).count(0.3), 2)
        self.assertLess(np.abs(after.eval(t) - before.eval(t)).max(), 8 * EPS)
        self.assertLess(np.abs(np.hypot(*after.eval(t).T) - 1).max(), 8 * EPS)

    def test_forms_and_maps(self):
        g, same = circle(), np.testing.assert_array_equal
        self.assertEqual(g.elevate(2).degrees, (4,))
        same(g.reverse().reverse().points, g.points)
        same(g.reverse(keep_domain=True).eval(0.25), [0, -1])
        same(g.reparametrize(1, 5).eval(2), [0, 1])
        same(g.to_homogeneous().from_homogeneous().weights, g.weights)
        self.assertTrue(g.make_rational().rational)
        same(g.transform([[0, 1], [2, 0]], [10, 20]).eval(0), [10, 22])
        same(g.transform_projective(np.diag([1, 1, 2])).eval(0.25), [0, 0.5])
        same(patch().transpose().points, np.swapaxes(patch().points, 0, 1))
        with self.assertRaises(ValueError):
            g.transform([[1]])

    def test_calculus_and_weights(self):
        g, same = circle(), np.testing.assert_array_equal
        line = nurbs.Spline(1, [0, 0, 1, 1], [[0, 2], [1, 4]])  # (t, 2 + 2 t)
        same(line.blossom([0.5], [0.25]), [0.25, 2.5])
        same(line.derivative().eval(0.3), [1, 2])
        same(line.antiderivative().eval(1), [0.5, 3])
        same(line.product(line, nurbs.NURBS_PRODUCT_DOT).eval(1), [17])
        square = nurbs.Spline(2, [0, 0, 0, 1, 1, 1], [[0], [0], [1]])
        same(line.compose(square).eval(0.5), [0.25, 2.5])
        same(line.sum(line, 2).eval(1), [3, 12])
        self.assertEqual(g.derivative().degrees, (4,))
        self.assertFalse(line.make_rational().normalize_weights().rational)
        moved = g.reparametrize_moebius(4)
        self.assertLess(abs(moved.weights[-1] - 4), 64 * EPS)
        self.assertLess(abs(moved.equalize_end_weights().weights[-1] - 1), 64 * EPS)
        with self.assertRaises(nurbs.NurbsError) as raised:
            g.antiderivative()
        self.assertEqual(raised.exception.status, nurbs.NURBS_ERROR_RATIONAL)

    def test_parts_of_the_circle(self):
        g, t = circle(), np.linspace(0, 1, 1001)
        self.assertEqual((g.refine([0.6, 0.3]).counts[0], g.refine_uniform(2).counts[0]), (11, 13))
        values, columns, rows = g.refinement_matrix([0.1])
        self.assertEqual((rows.size, values.size), (11, rows[-1]))
        joined = nurbs.join(g.split(0.3))
        self.assertEqual(joined.gap, 0)
        self.assertLess(np.abs(joined.spline.eval(t) - g.eval(t)).max(), 8 * EPS)
        self.assertEqual(g.extract([0.1], [0.2]).domain[0], (0.1, 0.2))
        self.assertEqual((len(g.decompose()), len(g.split_at_knots(0))), (4, 1))
        self.assertEqual(patch().decompose().names, ["0,0"])
        self.assertEqual(g.clamp().counts[0], 9)
        with self.assertRaises(nurbs.NurbsError) as raised:
            g.move_seam(0.3)
        self.assertEqual(raised.exception.status, nurbs.NURBS_ERROR_NOT_PERIODIC)

    def test_circles_made_compatible(self):
        finer = circle().insert_knot(0.3)
        made = nurbs.make_compatible([circle(), finer])
        self.assertEqual((made.deviation, made.splines[0].counts[0]), (0, 10))
        snapped = finer.snap_knots(0.06)
        self.assertTrue(snapped.deviation > 0 and snapped.spline.knots[0][5] == 0.25)

    def test_continuity_of_the_circle(self):
        rows = circle().continuity()
        found = rows.knots[0], rows.orders.tolist(), rows.geometric_orders.tolist()
        self.assertEqual(found, (0.25, [1] * 4, [2] * 4))
        halves = circle().split(0.3)
        found = halves[0].continuity_between(nurbs.NURBS_END, halves[1], nurbs.NURBS_START)
        self.assertEqual((found.order, found.geometric, found.position_gap), (2, 2, 0))

    def test_beyond_the_ends(self):
        self.assertEqual(circle().extend(0.5, 1).domain[0], (0, 1.5))
        self.assertEqual(circle().unclamp().counts[0], 9)
        steep = nurbs.Spline.bezier([[0.0], [1.0], [2.0]], [0.5, 2.0, 2.0])
        with self.assertRaisesRegex(nurbs.ArgumentError, "NURBS_HOMOGENEOUS"):
            steep.unclamp()
        both = nurbs.NURBS_FORM_CLAMPED_START | nurbs.NURBS_FORM_CLAMPED_END
        open_ended = steep.unclamp(both | nurbs.NURBS_HOMOGENEOUS)
        np.testing.assert_array_equal(open_ended(0.25), steep(0.25))
        loop = circle().make_periodic(1e-9)
        self.assertTrue(loop.order == 0 and loop.deviation < 1e-9 and loop.spline.detect_periodic())

    def test_images_in_a_plane(self):
        same = np.testing.assert_array_equal
        same(circle().mirror([0, 0], [0, 2]).eval(0.25), [0, -1])
        same(circle().project_to_plane([0, 0], [0, 2], [1, 1]).eval(0.25), [-1, 0])
        same(circle().project_from([0, -4], [0, 0], [0, 1]).eval(0), [1, 0])
        with self.assertRaises(ValueError):
            circle().mirror([0, 0, 0], [0, 2])

    def test_segments(self):
        same = np.testing.assert_array_equal
        g = nurbs.Spline.hermite([0, 1], [[0, 0], [1, 1]], [[3, 0], [0, 3]])
        same(g.eval(1), [1, 1])
        same(g.to_hermite().tangents, [[3, 0], [0, 3]])
        form = g.to_power()
        same(form.coefficients, [[[0, 0], [3, 0], [-3, 0], [1, 1]]])
        same(nurbs.Spline.power(*form).eval(1), [1, 1])
        round_form = circle().to_power()
        np.testing.assert_allclose(nurbs.Spline.power(*round_form, homogeneous=True).eval(0.25), [0, 1], atol=1e-15)
        same(nurbs.basis_matrix(nurbs.NURBS_BASIS_BERNSTEIN, nurbs.NURBS_BASIS_POWER, 1), [[1, 0], [-1, 1]])

    def test_reduction(self):
        g = circle()
        back = g.insert_knot(0.3, times=2).remove_knot(0.3, times=5, tolerance=1e-12)
        self.assertEqual((back.removed, back.spline.counts[0]), (2, 9))
        self.assertLessEqual(g.deviation(back.spline).at_most, 1e-12)
        self.assertEqual(g.refine_uniform(3).reduce_knots(1e-12).spline.counts[0], 9)
        self.assertEqual(g.elevate(1).reduce_degree().spline.counts[0], 9)
        self.assertLessEqual(g.elevate(1).simplify(1e-12).bound, 1e-12)
        with self.assertRaises(nurbs.NurbsError) as raised:
            g.remove_knot(0.3)
        self.assertEqual(raised.exception.status, nurbs.NURBS_ERROR_NOT_A_KNOT)

    def test_derivative_of_a_product(self):
        derivs = patch().eval_derivs([[0.25, 0.5]], order=2)
        self.assertEqual(derivs.shape, (1, 6, 3))
        np.testing.assert_array_equal(derivs[0, :, 2], [0.125, 0.5, 0.25, 0, 1, 0])

    def test_grid_equals_points_bit_for_bit(self):
        u, v = np.linspace(0, 1, 5), np.linspace(0, 1, 7)
        pairs = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1)
        np.testing.assert_array_equal(patch().eval_grid(u, v), patch().eval(pairs))
        np.testing.assert_array_equal(patch().eval_grid_derivs(u, v, order=1), patch().eval_derivs(pairs, order=1))


    def test_single_precision_is_rounded_once(self):
        t, u = np.linspace(0, 1, 99), np.linspace(0, 1, 5)
        out = np.zeros((2, 99), np.float32).T
        self.assertIs(circle().eval_f32(t, out=out), out)
        np.testing.assert_array_equal(out, circle().eval(t).astype(np.float32))
        np.testing.assert_array_equal(patch().eval_grid_f32(u, u), patch().eval_grid(u, u).astype(np.float32))


class Data(unittest.TestCase):
    def test_matrix_times_points(self):
        c, t = circle(), np.linspace(0, 1, 33)
        for orders in (None, [1], [2]):
            values, columns, rows = c.rational_collocation(t, orders)
            products = np.add.reduceat(values[:, None] * c.points[columns], rows[:-1])
            wanted = c.eval_derivs(t, order=2)[:, 0 if orders is None else orders[0]]
            np.testing.assert_allclose(products, wanted, atol=1e-12)
        values, columns, rows = nurbs.collocation([1, 2], [patch().knots[0], patch().knots[1]], [[0.25, 0.5]], [0, 1])
        self.assertEqual((columns.tolist(), rows.tolist()), ([0, 1, 2, 3, 4, 5], [0, 6]))
        np.testing.assert_array_equal(values, [-0.75, 0, 0.75, -0.25, 0, 0.25])

    def test_bezier_extraction(self):
        operators, firsts, domains = circle().bezier_extraction()
        np.testing.assert_array_equal(operators, [np.eye(3)] * 4)
        self.assertEqual((firsts.tolist(), domains[3].tolist()), ([0, 2, 4, 6], [0.75, 1]))

    def test_bezier_pieces(self):
        points, weights, domains = circle().bezier_pieces()
        self.assertEqual((points.shape, weights.shape, domains.shape), ((4, 3, 2), (4, 3), (4, 1, 2)))
        np.testing.assert_array_equal(points[1], circle().decompose()[1].points)
        self.assertEqual((weights[3].tolist(), domains[3].tolist()), ([1, 0.5**0.5, 1], [[0.75, 1]]))
        points, weights, domains = patch().bezier_pieces()
        self.assertEqual((points.shape, weights.shape, domains.tolist()), ((1, 1, 2, 3, 3), (1, 1, 2, 3), [[[[0, 1], [0, 1]]]]))

    def test_gradients_are_slopes(self):
        c, t, h = circle(), np.array([0.1, 0.6]), 1e-6
        g = np.array([[0.3, -1.0], [2.0, 0.7]])
        got = c.eval_adjoint(t, g)
        self.assertEqual([a.shape for a in got], [(9, 2), (9,), (2,)])
        change = np.sin(np.arange(9))

        def loss(points, weights, params):
            return (c.with_points(points, weights).eval(params) * g).sum()

        p, w = c.points, c.weights
        both = [(loss(p + s * np.outer(change, [1, 2]), w, t), loss(p, w + s * change, t), loss(p, w, t + s))
                for s in (h, -h)]
        slopes = (np.array(both[0]) - both[1]) / (2 * h)
        wanted = [(got.points * np.outer(change, [1, 2])).sum(), got.weights @ change, got.params.sum()]
        np.testing.assert_allclose(slopes, wanted, rtol=1e-6, atol=1e-8)

    def test_gradients_accumulate_in_place(self):
        c, t, g = circle(), np.linspace(0, 1, 9), np.ones((9, 2))
        whole = c.eval_adjoint(t, g)
        points, weights = np.zeros((9, 2), order="F"), np.zeros(18)[::2]
        for part in (slice(0, 4), slice(4, 9)):
            c.eval_adjoint(t[part], g[part], flags=nurbs.NURBS_ACCUMULATE, points=points, weights=weights)
        np.testing.assert_array_equal(points, whole.points)
        np.testing.assert_array_equal(weights, whole.weights)
        with self.assertRaises(ValueError):
            c.eval_adjoint(t, np.ones((9, 3)))

    def test_gradients_that_are_not_wanted_are_none(self):
        c, t, g = circle(), np.linspace(0, 1, 9), np.ones((9, 2))
        whole = c.eval_adjoint(t, g)
        alone = c.eval_adjoint(t, g, wanted="points")
        np.testing.assert_array_equal(alone.points, whole.points)
        self.assertEqual((alone.weights, alone.params), (None, None))
        others = c.eval_adjoint(t, g, wanted=["params", "weights"])
        np.testing.assert_array_equal(others.params, whole.params)
        self.assertIsNone(others.points)
        with self.assertRaisesRegex(ValueError, "knots"):
            c.eval_adjoint(t, g, wanted="knots")

    def test_gradients_of_knots(self):
        line = nurbs.Spline(1, [0, 0, 1, 2, 2], [[0], [1], [3]])
        moved = line.eval_knot_derivative(2)
        np.testing.assert_allclose(moved.eval([0.25, 1.5]), [[-0.25], [-1]])
        np.testing.assert_allclose(line.eval_adjoint_knots([0.25, 1.5], [[1], [2]])[2], -2.25)
        room = np.ones(10)[::2]
        line.eval_adjoint_knots([0.25, 1.5], [[1], [2]], flags=nurbs.NURBS_ACCUMULATE, knots=room)
        np.testing.assert_allclose(room[2], -1.25)
        with self.assertRaises(ValueError):
            line.eval_adjoint_knots([0.25], [[1, 2]])

    def test_gradients_through_closest_points(self):
        line = nurbs.Spline(1, [0, 0, 1, 1], [[0, 0], [2, 0]])
        got = line.closest_adjoint([[0.5, 1]], [0.25], [1], None, [1])
        np.testing.assert_allclose(got.queries, [[0.5, 1]])
        np.testing.assert_allclose(got.points, [[-0.375, -1], [-0.125, 0]])
        self.assertEqual(got.status.tolist(), [0])
        alone = line.closest_adjoint([[0.5, 1]], [0.25], distance_cotangents=[1], wanted="queries")
        np.testing.assert_allclose(alone.queries, [[0, 1]])
        self.assertIsNone(alone.points)

    def test_gradients_of_lengths(self):
        line = nurbs.Spline(1, [0, 0, 1, 1], [[0, 0], [3, 4]])
        got = line.length_adjoint(1e-12)
        np.testing.assert_allclose(got.points, [[-0.6, -0.8], [0.6, 0.8]])
        np.testing.assert_allclose(got.weights, [0, 0], atol=1e-12)
        self.assertLess(got.error, 1e-9)
        half = line.length_adjoint(1e-12, cotangent=2, range=[0, 0.5], wanted="points")
        np.testing.assert_allclose(half.points, [[-0.6, -0.8], [0.6, 0.8]])
        self.assertIsNone(half.weights)


class Arrays(unittest.TestCase):
    def test_strided_output_is_filled_in_place(self):
        t = np.linspace(0, 1, 9)
        expected = circle().eval(t)
        for out in (np.zeros((9, 2), order="F"), np.zeros((9, 5))[:, 1:3], np.zeros((18, 2))[::2]):
            self.assertIs(circle().eval(t, out=out), out)
            np.testing.assert_array_equal(out, expected)

    def test_reversed_arrays_are_copied(self):
        t, out = np.linspace(0, 1, 9), np.zeros((9, 2))
        circle().eval(t[::-1], out=out[::-1])
        np.testing.assert_array_equal(out, circle().eval(t))

    def test_fortran_points(self):
        points = np.asfortranarray(circle().points)
        same = circle().with_points(points)
        np.testing.assert_array_equal(same.points, points)
        np.testing.assert_array_equal(same.weights, circle().weights)

    def test_shapes(self):
        self.assertEqual(circle().eval(0.5).shape, (2,))
        self.assertEqual(circle().eval(np.zeros((3, 4))).shape, (3, 4, 2))
        self.assertEqual(patch().eval(np.zeros((3, 4, 2))).shape, (3, 4, 3))
        self.assertEqual(circle().eval([]).shape, (0, 2))
        with self.assertRaises(ValueError):
            patch().eval([0.5, 0.5, 0.5])
        with self.assertRaises(ValueError):
            circle().eval([0.5], out=np.zeros((1, 3)))


class Inspection(unittest.TestCase):
    def test_circle(self):
        c = circle()
        self.assertEqual((c.axes, c.dimension, c.degrees, c.counts, c.rational), (1, 2, (2,), (9,), True))
        self.assertEqual((c.point_count, c.domain[0]), (9, (0.0, 1.0)))
        values, times = c.distinct_knots[0]
        self.assertEqual((values.tolist(), times.tolist()), ([0, 0.25, 0.5, 0.75, 1], [3, 2, 2, 2, 3]))
        self.assertEqual(c.knot_forms[0], nurbs.NURBS_FORM_CLAMPED_START | nurbs.NURBS_FORM_CLAMPED_END)
        self.assertEqual(c.greville[0][1], 0.125)
        self.assertEqual(c.hull_size([0.1, 0.9]).tolist(), [1, 1])
        self.assertEqual(c.homogeneous_points[1].tolist(), [0.5**0.5, 0.5**0.5, 0.5**0.5])
        self.assertEqual(repr(c.copy()), repr(c))

    def test_constructors_agree(self):
        c, s = circle(), circle().knots[0]
        values, times = c.distinct_knots[0]
        for other in (nurbs.Spline.create_short(2, s[1:-1], c.points, c.weights),
                      nurbs.Spline.create_multiplicities(2, values, times, c.points, c.weights),
                      nurbs.Spline.create_homogeneous(2, s, c.homogeneous_points)):
            np.testing.assert_array_equal(other.knots[0], s)
            np.testing.assert_allclose(other.eval(0.1), c.eval(0.1), rtol=4 * EPS)

    def test_bases(self):
        knots = nurbs.knots_open_uniform(2, 4)
        spans, values = nurbs.basis(2, knots, [0.0, 0.5, 1.0], order=1)
        self.assertEqual(spans.tolist(), nurbs.find_spans(2, knots, [0.0, 0.5, 1.0]).tolist())
        self.assertEqual(spans.tolist(), [2, 3, 3])
        np.testing.assert_array_equal(values.sum(axis=-1), [[1, 0]] * 3)
        np.testing.assert_array_equal(nurbs.bernstein(2, [0.5]), [[[0.25, 0.5, 0.25]]])
        spans, values = circle().rational_basis([0.0])
        self.assertEqual((spans.tolist(), values.tolist()), ([[2]], [[1, 0, 0]]))
        self.assertEqual(nurbs.knots_uniform(1, 3).tolist(), [-0.5, 0, 0.5, 1, 1.5])
        self.assertEqual(nurbs.knots_periodic(1, [0, 1, 2]).tolist(), [-1, 0, 1, 2, 3])
        self.assertEqual(nurbs.knots_averaged(2, [0, 1, 2, 4]).tolist(), [0, 0, 0, 1.5, 4, 4, 4])

    def test_iso_curve(self):
        np.testing.assert_array_equal(patch().iso(0, 0.5).eval([0.0, 1.0]), [[0.5, 0, 0], [0.5, 1, 0.5]])

    def test_frames(self):
        at = [[[0, 0], [0.5, 0.25]]]
        frames = patch().surface_frames(at)
        np.testing.assert_array_equal(frames.normals[0, 0], [0, 0, 1])
        np.testing.assert_array_equal(frames.status, [[0, 0]])
        grid = patch().surface_grid_frames([0, 0.5], [0.25])
        np.testing.assert_array_equal(grid.normals[1, 0], frames.normals[0, 1])
        curvatures = patch().surface_curvatures(at)
        np.testing.assert_allclose(curvatures.principal[0, 0], [1, -1], rtol=4 * EPS)
        self.assertEqual(curvatures.directions.shape, (1, 2, 2, 3))
        flat = circle().curve_frames([0.0, 0.3])
        np.testing.assert_allclose(flat.curvatures, 1, rtol=64 * EPS)
        self.assertIsNone(flat.torsions)
        line = nurbs.Spline.bezier([[0, 0, 0], [1, 0, 0]])
        self.assertEqual(line.curve_frames(0.5).status, nurbs.NURBS_FRAME_RULE)
        minimal = line.rotation_minimizing_frames([0, 1], [0, 0, 2])
        np.testing.assert_array_equal(minimal.normals, [[0, 0, 1], [0, 0, 1]])
        with self.assertRaises(nurbs.NurbsError) as raised:
            line.rotation_minimizing_frames([0, 1], [1, 0, 0])
        self.assertEqual(raised.exception.status, nurbs.NURBS_ERROR_DIRECTION)


class Errors(unittest.TestCase):
    def test_outside_the_domain(self):
        params = np.full(20, 0.5)
        params[17] = 1.25
        out = np.full((20, 2), 7.0)
        with self.assertRaises(nurbs.NurbsError) as caught:
            circle().eval(params, out=out)
        error = caught.exception
        print(error)
        self.assertEqual((error.status, error.name), (nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, "NURBS_ERROR_OUTSIDE_DOMAIN"))
        self.assertIn("params[17]", error.message)
        self.assertIn("1.25", error.message)
        self.assertTrue((out == 7).all(), "a failing call writes nothing")
        np.testing.assert_array_equal(circle().eval([1.25], nurbs.NURBS_CLAMP), [[1, 0]])

    def test_bad_knot(self):
        with self.assertRaises(nurbs.NurbsError) as caught:
            nurbs.Spline(1, [0, 0, 2, 1, 3, 3], np.zeros((4, 2)))
        self.assertEqual(caught.exception.status, nurbs.NURBS_ERROR_KNOTS_DECREASING)
        self.assertRegex(caught.exception.message, r"knots\[3\]")

    def test_numbers_that_do_not_fit(self):
        with self.assertRaisesRegex(OverflowError, "4294967296 does not fit"):
            circle().insert_knot(0.5, axis=2**32)
        with self.assertRaisesRegex(TypeError, "argument 3"):
            circle().insert_knot("0.5")

    def test_files(self):
        with self.assertRaises(nurbs.NurbsError) as caught:
            nurbs.read(b"no file of a known format")
        self.assertEqual(caught.exception.status // 100, 4)
        with self.assertRaises(nurbs.NurbsError) as caught:
            nurbs.read_file("/no/such/file")
        self.assertEqual(caught.exception.status, nurbs.NURBS_ERROR_FILE)

    def test_lists(self):
        models = pathlib.Path(__file__).resolve().parents[2] / "capi/examples/models/models.igs"
        found = nurbs.read_file(models, unit=0.001)
        self.assertEqual((len(found), found.names[37], found.unit, found.notes), (38, "transformed curve", 0.001, []))
        same(found[-1].points, found[37].points)
        self.assertEqual(len(found[:5]), 5)
        self.assertEqual(repr(nurbs.sphere_patches()), "<SplineList of 6: +X, +Y, -X, -Y, ...>")
        # A point in place of the first surface.
        others = nurbs.read(models.read_bytes().replace(b"     128", b"     116", 2))
        self.assertEqual((len(others), others.names[0]), (37, found.names[1]))
        note, _ = others.notes
        self.assertEqual((note.entity_type, note.line, note.reason), (116, 1, nurbs.NURBS_ERROR_UNSUPPORTED))
        self.assertTrue(note.text)
        with self.assertRaises(IndexError):
            found[38]
        with self.assertRaises(nurbs.ResourceError):
            nurbs.read_file(models, max_bytes=10)


class Threads(unittest.TestCase):
    def test_one_spline_in_many_threads(self):
        shared, t = circle(), np.linspace(0, 1, 20000)
        expected, results = shared.eval(t), [None] * 4

        def work(i):
            results[i] = shared.insert_knot(0.3).eval(t), shared.eval(t)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for inserted, plain in results:
            np.testing.assert_array_equal(plain, expected)
            self.assertLess(np.abs(inserted - expected).max(), 8 * EPS)


if __name__ == "__main__":
    unittest.main()
