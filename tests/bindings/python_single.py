# SPDX-License-Identifier: MIT
"""The compiled calls for one place: whatever they are given, they do what the package does without them."""

import itertools
import sys
import threading
import unittest
from unittest import mock

import nurbs
from helpers import circle, np, patch, random_splines
from nurbs import _evaluation

SPLINES = random_splines(300, 20261126)


def outcome(function):
    """What a call returns or raises, as something that compares."""
    try:
        with np.errstate(all="ignore"):
            found = function()
    except Exception as error:
        return type(error), str(error)
    return type(found), found.shape, found.dtype, found.tobytes(), found.flags.writeable, found.flags.c_contiguous


def without(function):
    with mock.patch.object(_evaluation, "single", None):
        return outcome(function)


class Counted:
    """The module, and how many of its calls had an answer."""

    def __init__(self):
        self.module, self.answers = _evaluation.single, 0

    def __getattr__(self, name):
        def call(*arguments):
            found = getattr(self.module, name)(*arguments)
            self.answers += found is not None
            return found

        return call


class Single(unittest.TestCase):
    def agree(self, function, *told):
        self.assertEqual(outcome(function), without(function), told)

    def test_the_extension_is_there_and_answers(self):
        c, s, counted = circle(), patch(), Counted()
        with mock.patch.object(_evaluation, "single", counted):
            for function in (lambda: c(0.3), lambda: c.eval(0.3), lambda: c(0.3, nu=2), lambda: s(0.3, 0.4),
                             lambda: s((0.3, 0.4)), lambda: s([0.3, 0.4]), lambda: s(0.3, 0.4, nu=(1, 0))):
                before = counted.answers
                function()
                self.assertEqual(counted.answers, before + 1)

    def test_same_bits(self):
        for number, spline in enumerate(SPLINES):
            ends = np.array(spline.domain)
            for part in (0, 0.37, 1):
                at = tuple(float(t) for t in ends[:, 0] + part * (ends[:, 1] - ends[:, 0]))
                self.agree(lambda: spline(*at), number, at)
                for nu in itertools.product(range(3), repeat=spline.axes):
                    self.agree(lambda: spline(*at, nu=nu if spline.axes > 1 else nu[0]), number, at, nu)

    def test_all_kinds_of_arguments(self):
        places = (0, 1, True, 0.3, -0.0, np.float64(0.3), np.float32(0.3), np.int32(1), np.array(0.3), [0.3], (0.3,), [0.1, 0.9],
                  "0.3", None, float("nan"), float("inf"), 1.5, -1, 10**400, 2**70, b"x", {}, 1j, np.zeros((2, 0)))
        for place in places:
            for nu in (0, 1, 9, 200, -1, (1,), [1], None, True, 1.0, np.int64(1)):
                self.agree(lambda: circle()(place, nu=nu), place, nu)
            self.agree(lambda: circle().eval(place), place)
            for other in (0.3, None, [0.1, 0.2], "x"):
                self.agree(lambda: patch()(place, other), place, other)
                self.agree(lambda: patch()((place, other)), place, other)
                self.agree(lambda: patch().eval([place, other]), place, other)

    def test_numbers_of_places(self):
        for count in range(4):
            self.agree(lambda: circle()(*[0.5] * count), count)
            self.agree(lambda: patch()(*[0.5] * count), count)
            self.agree(lambda: patch()([0.5] * count), count)
            self.agree(lambda: patch()(0.5, 0.5, nu=(1,) * count), count)

    def test_flags(self):
        for flags in (0, nurbs.NURBS_CLAMP, nurbs.NURBS_WRAP, nurbs.NURBS_LEFT, nurbs.NURBS_NAN, 1 << 31, 1 << 32, -1, None,
                      1.0, True, np.uint32(nurbs.NURBS_CLAMP)):
            for place in (0.25, 1.25, float("nan")):
                self.agree(lambda: circle()(place, flags=flags), place, flags)
                self.agree(lambda: circle()(place, nu=1, flags=flags), place, flags)
                self.agree(lambda: circle().eval(place, flags), place, flags)

    def test_outputs_are_filled_by_the_other_way(self):
        out = np.empty(2)
        self.assertIs(circle()(0.25, out=out), out)
        self.assertEqual(out.tolist(), circle()(0.25).tolist())

    def test_each_point_is_an_array_of_its_own(self):
        c = circle()
        first, second = c(0.25), c(0.25)
        first[0] = 7
        self.assertEqual(second.tolist(), c(0.25).tolist())

    def test_a_spline_without_handle(self):
        class Unfinished(nurbs.Spline):
            pass

        broken = Unfinished._owner(None)
        self.agree(lambda: broken(0.5))

    def test_wide_points_and_high_orders(self):
        wide = nurbs.Spline(degrees=2, knots=[0, 0, 0, 1, 1, 1], points=np.arange(6000.0).reshape(3, 2000))
        for nu in (0, 1, 8):
            self.agree(lambda: wide(0.3, nu=nu), nu)

    def test_nothing_leaks(self):
        c, s = circle(), patch()

        def calls(count):
            for _ in range(count):
                c(0.3), c(0.3, nu=1), s(0.3, 0.4), s([0.3, 0.4])

        calls(1000)
        before, nones, empties = sys.getallocatedblocks(), sys.getrefcount(None), sys.getrefcount(np.empty)
        calls(25000)
        self.assertLess(sys.getallocatedblocks() - before, 500)
        self.assertLess(abs(sys.getrefcount(None) - nones), 500)
        self.assertLess(abs(sys.getrefcount(np.empty) - empties), 10)

    def test_threads(self):
        spline = SPLINES[0] if SPLINES[0].axes == 1 else circle()
        lower, upper = spline.domain[0]
        places = [lower + i / 400 * (upper - lower) for i in range(400)]
        expected, wrong = [spline(t).tobytes() for t in places], []

        def work():
            wrong.extend(t for t, bits in zip(places * 5, expected * 5) if spline(t).tobytes() != bits)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_addresses_have_to_be_numbers(self):
        module = _evaluation.single
        self.assertRaises(TypeError, module.bind)
        self.assertRaises(TypeError, module.bind, "x", None, np.empty)
        self.assertIsNone(module.eval())
        self.assertIsNone(module.derivative(1, 2))


if __name__ == "__main__":
    unittest.main()
