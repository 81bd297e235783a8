# SPDX-License-Identifier: MIT
"""Splines as values in Python: properties, equality, pickles, copies, operators."""

import copy
import itertools
import multiprocessing
import pickle
import unittest
from concurrent.futures import ProcessPoolExecutor

import nurbs
from helpers import circle, near, np, patch, random_splines, same

SPLINES = random_splines(300, 20250101)


def bits(array):
    return None if array is None else (array.shape, array.tobytes())


def all_bits(spline):
    """Everything that tells one spline from another, and points of it."""
    ends = np.array([spline.domain[axis] for axis in range(spline.axes)])
    at = ends[:, 0] + np.linspace(0, 1, 9)[:, None] * (ends[:, 1] - ends[:, 0])
    with np.errstate(all="ignore"):
        points = spline.eval_derivs(at if spline.axes > 1 else at[:, 0], 1, nurbs.on_all_axes(spline.axes,
                                                                                              nurbs.NURBS_CLAMP))
    return (spline.degrees, spline.counts, spline.periodic, spline.rational, [bits(t) for t in spline.knots],
            bits(spline.points), bits(spline.weights), bits(spline.homogeneous_points), bits(points))


class Values(unittest.TestCase):
    def test_the_splines_are_of_every_kind(self):
        for told in (lambda s: s.axes == 1, lambda s: s.axes == 2, lambda s: s.axes == 3, lambda s: not s.rational,
                     lambda s: any(s.periodic), lambda s: any(not form for form in s.knot_forms),
                     lambda s: s.rational and (s.weights < 0).any(), lambda s: not np.isfinite(s.points).all(),
                     lambda s: s.rational and (s.weights == 0).any() and np.isfinite(s.points).all(),
                     lambda s: any((k.multiplicities > p).any() for k, p in zip(s.distinct_knots, s.degrees))):
            self.assertGreater(sum(map(told, SPLINES)), 5)

    def test_pickles_keep_every_bit(self):
        for spline in SPLINES:
            wanted = all_bits(spline)
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                again = pickle.loads(pickle.dumps(spline, protocol))
                self.assertEqual(again, spline)
            self.assertEqual(all_bits(again), wanted)

    def test_pickles_out_of_band(self):
        buffers = []
        head = pickle.dumps(circle(), 5, buffer_callback=buffers.append)
        self.assertEqual(pickle.loads(head, buffers=buffers), circle())
        self.assertEqual(len(buffers), 1)

    def test_pickles_know_public_names_only(self):
        for value in (circle(), circle().length(), nurbs.DomainError(100, "a", "b")):
            text = pickle.dumps(value, 0)
            self.assertNotIn(b"nurbs._", text)
            self.assertEqual(repr(pickle.loads(text)), repr(value))

    def test_copies(self):
        for spline in SPLINES[:50]:
            for other in (spline.copy(), copy.copy(spline), copy.deepcopy(spline), copy.deepcopy([spline])[0]):
                self.assertIsNot(other, spline)
                self.assertEqual((other, all_bits(other)), (spline, all_bits(spline)))

    def test_rebuilt_from_its_properties(self):
        for spline in SPLINES:
            flags = sum(nurbs.on_axis(k, nurbs.NURBS_PERIODIC) for k, wraps in enumerate(spline.periodic) if wraps)
            if not spline.rational or (spline.weights >= 0).all() and np.isfinite(spline.points).all():
                made = nurbs.Spline(spline.degrees, spline.knots, spline.points, spline.weights, flags)
                self.assertEqual((bits(made.points), bits(made.weights)), (bits(spline.points), bits(spline.weights)))
            if spline.rational:
                made = nurbs.Spline.create_homogeneous(spline.degrees, spline.knots, spline.homogeneous_points, flags)
                self.assertEqual(bits(made.homogeneous_points), bits(spline.homogeneous_points))

    def test_equality_is_bit_for_bit(self):
        c = circle()
        self.assertEqual(len({c, circle(), c.copy(), c.reverse().reverse()}), 1)
        others = [c.insert_knot(0.3), c.reverse(), c.elevate(), patch(), c.transform(np.eye(2) * (1 + 2**-52)),
                  c.make_periodic(1e-9).spline, c.clamp(0).set_weights([0], [1 + 2**-52]), c.reparametrize(0, 2),
                  nurbs.Spline(1, [0, 0, 1, 1], [[0.0], [1]]), nurbs.Spline(1, [0, 0, 1, 1], [[-0.0], [1]]),
                  nurbs.Spline(1, [0, 0, 1, 1], [[0.0], [1]], [1, 1]),
                  nurbs.Spline.create_homogeneous(1, [0, 0, 1, 1], [[0.0, 1], [1, 1]])]
        for one, other in itertools.combinations([c, *others], 2):
            self.assertFalse(one == other, (one, other))
            self.assertNotEqual(hash(one), hash(other))
        self.assertTrue(c != 1 and not c == None)  # noqa: E711 - what is tested
        self.assertEqual(len(set(SPLINES)), len(SPLINES))

    def test_processes(self):
        with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
            self.assertEqual(list(pool.map(nurbs.Spline.length, [circle(), nurbs.circle(2)])),
                             [circle().length(), nurbs.circle(2).length()])
            with self.assertRaisesRegex(nurbs.DomainError, "params.0. = 2 outside"):
                pool.submit(nurbs.Spline.eval, circle(), 2).result()


class Properties(unittest.TestCase):
    def test_one_entry_for_each_axis(self):
        for spline in SPLINES:
            for name in ("degrees", "counts", "knots", "domain", "greville", "distinct_knots", "knot_forms",
                         "periodic"):
                self.assertEqual((type(getattr(spline, name)), len(getattr(spline, name))), (tuple, spline.axes), name)
            self.assertEqual(spline.points.shape, (*spline.counts, spline.dimension))
            self.assertEqual(spline.point_count, np.prod(spline.counts))
            for knots, (low, high), degree, count in zip(spline.knots, spline.domain, spline.degrees, spline.counts):
                self.assertEqual((knots[degree], knots[count]), (low, high))

    def test_nothing_can_be_set(self):
        c = circle()
        for change in (lambda: setattr(c, "points", 1), lambda: setattr(c, "anything", 1), lambda: delattr(c, "knots")):
            self.assertRaisesRegex(AttributeError, "does not change", change)
        before = all_bits(c)
        for array in (c.points, c.knots[0], c.weights, c.homogeneous_points, c.greville[0], *c.distinct_knots[0]):
            array[...] = 0
        self.assertEqual(all_bits(c), before)

    def test_one_line_says_what_it_is(self):
        self.assertEqual(repr(circle()), "<Spline: rational curve in 2D: degree 2, 9 points, domain [0, 1]>")
        self.assertEqual(repr(patch()), "<Spline: polynomial surface in 3D: degree 1 x 2, 2 x 3 points, "
                                        "domain [0, 1] x [0, 1]>")
        self.assertRegex(repr(circle().make_periodic(1e-9).spline), r"domain \[0, 1\], periodic>$")
        tube = circle().make_periodic(1e-9).spline.transform(np.eye(3, 2)).extrude([0, 0, 1])
        self.assertRegex(repr(tube), r"domain \[0, 1\] x \[0, 1\], periodic on axis 0>$")


class Functions(unittest.TestCase):
    def test_calls(self):
        c, p, t = circle(), patch(), np.linspace(0, 1, 12).reshape(3, 4)
        same(c(t), c.eval(t))
        same(c(t, nu=1), c.eval_derivs(t, 1)[..., 1, :])
        same(c(t, nu=[2]), c.eval_derivs(t, 2)[..., 2, :])
        same(p(0.25, t), p.eval(np.stack([np.full(t.shape, 0.25), t], -1)))
        same(p([0.25, 0.5]), p(0.25, 0.5))
        for nu in ((1, 0), (0, 1), (1, 1), (0, 2)):
            uv = np.stack([t, t * t], -1)
            same(p(t, t * t, nu=nu), p.eval_derivs(uv, 2)[..., nurbs.derivative_slot(*nu), :])
            with np.errstate(all="raise"):
                near(p(t, t * t, nu=nu), p.derivative(nu[0]).derivative(nu[1], axis=1)(uv))
        same(c([2.0, -1.0], flags=nurbs.NURBS_CLAMP), [[1, 0], [1, 0]])
        for bad in (lambda: c(0.5, 0.5), lambda: p(0.5, 0.5, 0.5), lambda: p(0.5), lambda: p(0.5, 0.5, nu=1),
                    lambda: c(0.5, nu=-1), lambda: c(0.5, nu=(1, 1))):
            self.assertRaises(ValueError, bad)

    def test_slots_of_derivatives(self):
        for axes, order in ((1, 6), (2, 6), (3, 6)):
            slots = {nurbs.derivative_slot(*orders) for orders in np.ndindex(*(order + 1,) * axes)
                     if sum(orders) <= order}
            self.assertEqual(slots, set(range(nurbs.derivative_slots(axes, order))))
        cube = nurbs.trilinear([[[[x * y * z] for z in (0, 1)] for y in (0, 1)] for x in (0, 1)])
        self.assertEqual((cube(0.5, 0.25, 1, nu=(1, 0, 0)), cube(0.5, 0.25, 1, nu=(1, 1, 0)),
                          cube(0.5, 0.25, 1, nu=(0, 1, 1))), (0.25, 1, 0.5))

    def test_operators_are_those_of_values(self):
        f, g = circle(), circle().reverse(keep_domain=True)
        t, v, a = np.linspace(0, 1, 17), np.array([2.0, -3.0]), np.array([[1.0, 2], [3, 4], [5, 6]])
        x, y = f(t), g(t)
        for made, wanted in ((f + g, x + y), (f - g, x - y), (f * g, x * y), (f @ g, (x * y).sum(-1)[:, None]),
                             (-f, -x), (f + v, x + v), (v + f, x + v), (f - v, x - v), (v - f, v - x), (f + 1, x + 1),
                             (f * v, x * v), (v * f, x * v), (2 * f, 2 * x), (f / v, x / v), (f / 2, x / 2),
                             (f + [1, 2], x + [1, 2]), ([1, 2] - f, [1, 2] - x), (a @ f, x @ a.T),
                             (np.float64(2) * f, 2 * x)):
            near(made(t), wanted, by=1e-14)
        for bad in (lambda: f + "a", lambda: f * [1, 2, 3], lambda: np.eye(3) @ f, lambda: f @ 2, lambda: [1] * 3 - f,
                    lambda: f / "a", lambda: f - "a", lambda: "a" * f):
            self.assertRaises(TypeError, bad)


if __name__ == "__main__":
    unittest.main()
