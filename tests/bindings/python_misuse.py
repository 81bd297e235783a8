# SPDX-License-Identifier: MIT
"""What a user may do by mistake in Python: an exception at worst, never a crash, and never another value than the one
that was given."""

import pickle
import unittest

import nurbs
from helpers import circle, np, patch, same, spied

WIDE = 200_000  # numbers of an array whose memory goes back to the system when it is freed


class Memory(unittest.TestCase):
    """Arrays that are made of arguments live until the library has read them."""

    def test_a_list_as_a_vector(self):
        line = nurbs.Spline(1, [0, 0, 1, 1], np.zeros((2, WIDE)))
        self.assertTrue((line.extrude([1.0] * WIDE).points[:, 1] == 1).all())

    def test_corners_that_have_to_be_copied(self):
        corners = np.arange(8.0 * WIDE).reshape(8, WIDE)[::-1]
        same(nurbs.bilinear(corners[:4]).points.reshape(4, WIDE), corners[:4])
        same(nurbs.trilinear(corners).points.reshape(8, WIDE), corners)

    def test_arrays_that_are_not_aligned(self):
        def shifted(values):
            return np.frombuffer(b"." + np.array(values, float).tobytes(), offset=1).reshape(np.shape(values))

        c, t = circle(), [0.25, 0.5]
        same(c(shifted(t)), c(t))
        for name, use, argument in (("nurbs_refine", lambda: c.refine(shifted(t)), 3),
                                    ("nurbs_transform", lambda: shifted(np.eye(2)) @ c, 2),
                                    ("nurbs_create_hermite", lambda: nurbs.Spline.hermite(
                                        [0, 1], shifted(np.eye(2)), np.eye(2)), 3)):
            with spied(name) as calls:
                use()
            self.assertEqual(calls[0][argument] % 8, 0, name)

    def test_an_array_that_is_another_one_each_time(self):
        class Growing:
            size = 0

            def __array__(self, dtype=None, copy=None):
                Growing.size = 1000 * Growing.size + 2
                return np.zeros(Growing.size)

        for read in (circle().lengths, circle().curve_frames, lambda t: nurbs.find_spans(1, [0, 0, 1, 1], t)):
            Growing.size = 0
            found = read(Growing())
            self.assertEqual(len(getattr(found, "status", found)), 2)


class Objects(unittest.TestCase):
    def test_a_spline_is_initialised_once(self):
        c = circle()
        self.assertEqual(c.dimension, 2)
        self.assertRaisesRegex(TypeError, "does not change", c.__init__, 1, [0, 0, 1, 1], np.zeros((2, 3000)))
        self.assertEqual(c, circle())

    def test_a_spline_that_was_not_initialised(self):
        class Forgetful(nurbs.Spline):
            def __init__(self):
                pass

        empty = Forgetful()
        for use in (lambda: empty.axes, lambda: empty(0.5), lambda: repr(empty), lambda: empty == circle()):
            self.assertRaisesRegex(nurbs.ArgumentError, "NULL", use)
        self.assertRaisesRegex(nurbs.ArgumentError, "NULL", circle().distance, empty)

    def test_lists_come_from_the_library(self):
        for given in ((), (5,), ([circle()],)):
            self.assertRaisesRegex(TypeError, "comes from the library", nurbs.SplineList, *given)

    def test_derived_classes_stay(self):
        c = Named("unit")
        for made in (c.insert_knot(0.3), c.split(0.5)[1], 2 * c, c.copy(), pickle.loads(pickle.dumps(c))):
            self.assertIs(type(made), Named)
        self.assertEqual(pickle.loads(pickle.dumps(c)), c)


class Named(nurbs.Spline):
    """A class that asks for other arguments."""

    def __init__(self, name):
        super().__init__(1, [0, 0, 1, 1], [[0, 0], [1, len(name)]])


class Numbers(unittest.TestCase):
    def test_integers_are_not_rounded(self):
        c, points = circle(), [[0, 0], [1, 0], [1, 1]]
        for use in (lambda: nurbs.Spline(2.7, [0, 0, 0, 1, 1, 1], points), lambda: nurbs.Spline("2", [0] * 6, points),
                    lambda: c.set_weights([0.9], [2]), lambda: patch().transpose(1.2, 0),
                    lambda: nurbs.knots_bezier(2, 2.5), lambda: nurbs.knots_periodic(2, [0, 1, 2], [1, 1.5, 1]),
                    lambda: c(0.5, nu=1.5), lambda: c(0.5, nu=[1.5])):
            self.assertRaises(TypeError, use)

    def test_integers_are_not_cut_off(self):
        for degree in (2**40 + 2, 2**70, -(2**70)):
            self.assertRaises(OverflowError, nurbs.Spline, degree, [0] * 6, np.zeros((3, 2)))
        self.assertRaises(OverflowError, circle().set_weights, [2**70], [1])
        self.assertRaises(OverflowError, nurbs.status_name, 2**31)
        self.assertRaises(TypeError, nurbs.status_name, 0.5)
        self.assertRaisesRegex(OverflowError, "8589934592 does not fit int32_t", circle().insert_knot, 0.5, 2**33)

    def test_integers_of_numpy(self):
        c = circle()
        same(c(0.3, nu=np.int64(1)), c(0.3, nu=1))
        same(c(0.3, nu=np.array([1])), c(0.3, nu=1))
        self.assertEqual(c.set_weights(np.array([1], np.uint8), [2]), c.set_weights([1], [2]))
        same(nurbs.knots_bezier(2, np.int32(4)), nurbs.knots_bezier(2, 4))

    def test_numbers_in_another_order(self):
        knots, points = [[0, 0, 1, 1], [0, 0, 0, 1, 1, 1]], np.zeros((2, 3, 3))
        plane, turned = nurbs.Spline([1, 2], knots, points), np.ones((3, 2))
        for bad in (turned, turned.ravel(), np.ones((2, 3, 1))):
            self.assertRaisesRegex(ValueError, "weights of shape .*, expected", nurbs.Spline, [1, 2], knots, points, bad)
            self.assertRaisesRegex(ValueError, "weights of shape .*, expected", plane.with_points, points, bad)
        for name in ("costs", "weight_costs"):
            self.assertRaisesRegex(ValueError, f"{name} of shape .*, expected", plane.constrain, [0.5, 0.5], [0, 0, 1],
                                   **{name: turned})
        self.assertRaisesRegex(ValueError, "params of shape", nurbs.collocation, [1, 2], knots, np.zeros((2, 3)))

    def test_what_is_no_number(self):
        c = circle()
        for use in (lambda: c - "a", lambda: c - None, lambda: c * None, lambda: c / "a", lambda: c * "3",
                    lambda: c + (1 + 2j)):
            self.assertRaisesRegex(TypeError, "unsupported operand|can.t multiply", use)
        self.assertRaisesRegex(nurbs.ArgumentError, "not finite", lambda: c / 0)
        for function in (nurbs.coons, nurbs.coons_hermite, nurbs.coons_gaps, nurbs.join):
            self.assertRaisesRegex(TypeError, "NoneType", function, None)


class Files(unittest.TestCase):
    def test_a_path_ends_where_it_ends(self):
        self.assertRaises(ValueError, nurbs.read_file, __file__ + "\0b")

    def test_contents_are_bytes(self):
        for contents in ("text", 5, [1, 2]):
            self.assertRaisesRegex(TypeError, "bytes-like", nurbs.read, contents)
        for contents in (b"no", bytearray(b"no"), memoryview(b"n.o.")[::2]):
            self.assertRaises(nurbs.ContentsError, nurbs.read, contents)

    def test_an_error_is_no_errno(self):
        with self.assertRaises(OSError) as raised:
            nurbs.read_file("/does/not/exist")
        for error in (raised.exception, pickle.loads(pickle.dumps(raised.exception))):
            self.assertEqual((error.errno, error.filename, error.status), (None, None, nurbs.NURBS_ERROR_FILE))
            self.assertIn("/does/not/exist", error.message)


if __name__ == "__main__":
    unittest.main()
