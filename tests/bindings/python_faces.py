# SPDX-License-Identifier: MIT
"""Faces in Python: natural loops, what they answer, and what is wrong is said."""

import copy
import pickle
import unittest

import nurbs
from helpers import np, spied, status_of


def plane():
    """(2 u, 3 v, 0) over the unit square."""
    return nurbs.Spline([1, 1], [[0, 0, 1, 1]] * 2, [[[0, 0, 0], [0, 3, 0]], [[2, 0, 0], [2, 3, 0]]])


def line(a, b):
    return nurbs.Spline(1, [0, 0, 1, 1], [a, b])


def polygon(*corners):
    points = np.array([*corners, corners[0]], float)
    return nurbs.Spline(1, np.r_[0, np.arange(len(points)), len(points) - 1], points)


def square(a, b):
    return polygon((a, a), (b, a), (b, b), (a, b))


def sides(a, b):
    """The same as four curves."""
    corners = [(a, a), (b, a), (b, b), (a, b), (a, a)]
    return [line(*ends) for ends in zip(corners, corners[1:])]


class Loops(unittest.TestCase):
    def test_of_closed_curves_and_of_lists(self):
        hole = square(0.25, 0.5)
        for loops in ([square(0.125, 0.875), hole], [[hole], sides(0.125, 0.875)], (loop for loop in [[hole], [square(0.125, 0.875)]])):
            face = nurbs.Face(plane(), loops, tolerance=1e-9)
            self.assertAlmostEqual(face.area().value, 6 * (0.5625 - 0.0625), 12)
            np.testing.assert_array_equal(face.classify([[0.75, 0.75], [0.3, 0.3], [0, 0], [0.25, 0.3]]), [1, -1, -1, 0])
            np.testing.assert_array_equal(face.gaps, [0, 0])
        self.assertEqual(face.tolerance, 1e-9)
        self.assertEqual(face.surface, plane())

    def test_whole_surface(self):
        for face in nurbs.Face(plane()), nurbs.Face(plane(), None), nurbs.Face(plane(), []), nurbs.Face.create(plane(), []):
            self.assertEqual(face.loops, (4,))
            self.assertAlmostEqual(face.area(1e-12).value, 6, 11)

    def test_edges_alone_and_in_part(self):
        first = nurbs.Face(plane(), [sides(0.25, 0.75)], tolerance=1e-9)
        edges = [first.edge(0, i).spline for i in range(4)]
        back = edges[1].reverse()
        for loops, own in ((None, [[edges[0], back, *edges[2:]]]),
                           ([[first.curve(0, 0), None, first.curve(0, 2), None]], [[None, back, None, edges[3]]])):
            face = nurbs.Face(plane(), loops, edges=own, keys=[[1, -2, 3, 4]], tolerance=1e-9)
            self.assertEqual([face.edge(0, i).key for i in range(4)], [1, -2, 3, 4])
            self.assertEqual(face.edge(0, 1).spline, back)
            self.assertAlmostEqual(face.area().value, 1.5, 9)
            for i in range(4):
                self.assertLessEqual(face.deviation(0, i).distance, 1e-9)
                self.assertIs(face.deviation(0, i).proven, True)
        self.assertEqual(nurbs.Face(plane(), [square(0.25, 0.75)], keys=[5]).edge(0, 0).key, 5)

    def test_curves_are_those_of_the_loops(self):
        face = nurbs.Face(plane(), [sides(0.25, 0.75), square(0.375, 0.5)], tolerance=1e-9)
        self.assertEqual(face.loops, (4, 1))
        self.assertEqual([len(loop) for loop in face.curves], [4, 1])
        self.assertEqual(face.curves[0][2], sides(0.25, 0.75)[2])
        again = nurbs.Face(face.surface, face.curves, tolerance=face.tolerance, as_oriented=True)
        self.assertAlmostEqual(again.area().value, face.area().value, 12)

    def test_as_oriented_and_gaps(self):
        hole = square(0.25, 0.75).reverse()
        self.assertEqual(nurbs.Face(plane(), [hole]).classify([0.5, 0.5]), 1)
        self.assertEqual(nurbs.Face(plane(), [hole], as_oriented=True).classify([0.5, 0.5]), -1)
        open_loop = sides(0.25, 0.75)[:3]
        with self.assertRaises(nurbs.ArgumentError) as caught:
            nurbs.Face(plane(), [open_loop])
        self.assertEqual(caught.exception.name, "NURBS_ERROR_GAP")
        np.testing.assert_allclose(caught.exception.gaps, [1.5])
        face = nurbs.Face(plane(), [open_loop], keep_gaps=True)
        np.testing.assert_allclose(face.gaps, [1.5])
        self.assertAlmostEqual(face.area().value, 1.5, 12)

    def test_loops_that_cross_are_refused_if_asked_for(self):
        apart, across = [square(0.25, 0.75), square(0.375, 0.5)], [square(0.25, 0.75), square(0.74, 0.875)]
        self.assertAlmostEqual(nurbs.Face(plane(), apart, check_crossings=True).area().value,
                               nurbs.Face(plane(), apart).area().value, 12)
        nurbs.Face(plane(), across)
        with self.assertRaises(nurbs.ArgumentError) as caught:
            nurbs.Face(plane(), across, check_crossings=True)
        self.assertEqual(caught.exception.name, "NURBS_ERROR_CROSSING")


class Answers(unittest.TestCase):
    def setUp(self):
        self.face = nurbs.Face(plane(), [square(0.25, 0.75)], tolerance=1e-9)

    def test_shapes_of_places(self):
        self.assertEqual(self.face.classify([0.5, 0.5]).shape, ())
        self.assertEqual(self.face.classify(np.full((3, 4, 2), 0.5)).tolist(), [[1] * 4] * 3)
        self.assertEqual(self.face.classify(np.empty((0, 2))).shape, (0,))
        np.testing.assert_array_equal(self.face.classify(np.asfortranarray([[0.5, 0.5], [0.1, 0.5]])), [1, -1])
        self.assertEqual(self.face.classify([0.74, 0.5], 0.03), 0)

    def test_rays(self):
        above = self.face.surface([[0.5, 0.5], [0.1, 0.5], [0.25, 0.5]]) + [0, 0, 2]
        found = self.face.rays(above, [0, 0, -1])
        np.testing.assert_array_equal(found.distances, [2, np.nan, 2])
        self.assertEqual(found.status.tolist(), [nurbs.NURBS_RAY_HIT | nurbs.NURBS_RAY_CERTIFIED,
                                                 nurbs.NURBS_RAY_CERTIFIED, nurbs.NURBS_RAY_TOUCH])

    def test_closest_points(self):
        on = self.face.surface([[0.5, 0.5], [0.75, 0.75]])
        found = self.face.closest_points([on[0] + [0, 0, 1], on[1] + [3, 4, 12]], 1e-9)
        np.testing.assert_allclose(found.distances, [1, 13], atol=2e-9)
        np.testing.assert_allclose(found.points, on, atol=1e-8)
        self.assertEqual(found.status.tolist(), [nurbs.NURBS_CLOSEST_CERTIFIED,
                                                 nurbs.NURBS_CLOSEST_CERTIFIED | nurbs.NURBS_CLOSEST_BOUNDARY])
        self.assertEqual(self.face.closest_points(on[0]).distances.shape, ())

    def test_distances(self):
        other = nurbs.Face(nurbs.plane([2, 0, 0], [0, 3, 0], [0, 0, 2]), [square(0.25, 0.75)])
        found, far = self.face.distance(other, 1e-9), self.face.hausdorff_distance(other, 1e-3)
        self.assertAlmostEqual(found.at_most, 2, 8)
        self.assertLessEqual(found.at_least, found.at_most)
        self.assertEqual((found.status, found.params_a.shape), (nurbs.NURBS_CLOSEST_CERTIFIED, (2,)))
        np.testing.assert_allclose(far.at_most, [2, 2], atol=1e-3)
        np.testing.assert_array_equal(self.face.hausdorff_distance(self.face, 0).at_most, [0, 0])
        with self.assertRaises(TypeError):
            self.face.distance(other.surface)

    def test_quadrature(self):
        params, weights, measures = self.face.quadrature(2)
        self.assertEqual((params.shape, weights.shape), ((len(measures), 2), measures.shape))
        self.assertAlmostEqual(measures.sum(), 1.5, 11)
        self.assertEqual(set(self.face.classify(params)), {1})
        np.testing.assert_allclose(measures @ self.face.surface.eval(params) / 1.5, [1, 1.5, 0], atol=1e-11)
        self.assertEqual(status_of(lambda: self.face.quadrature(-1)), nurbs.NURBS_ERROR_COUNT)
        self.assertEqual(status_of(lambda: self.face.quadrature(work=1)), nurbs.NURBS_ERROR_WORK)

    def test_moments_and_boxes(self):
        moments, box = self.face.moments(1e-12), self.face.box(1e-9)
        self.assertAlmostEqual(moments.content, 1.5, 11)
        np.testing.assert_allclose(moments.centroid, [1, 1.5, 0], atol=1e-11)
        np.testing.assert_allclose(np.diag(moments.inertia), [1.5 * 1.5**2 / 12, 1.5 / 12, 1.5 * (1 + 1.5**2) / 12], atol=1e-11)
        np.testing.assert_allclose(box.lower, [0.5, 0.75, 0], atol=1e-8)
        np.testing.assert_allclose(box.upper, [1.5, 2.25, 0], atol=1e-8)

    def test_values(self):
        face = self.face
        for other in face.copy(), copy.copy(face), copy.deepcopy([face])[0]:
            self.assertIsNot(other, face)
            self.assertEqual(other.area(), face.area())
            np.testing.assert_array_equal(other.gaps, face.gaps)
        self.assertEqual(repr(face), "<Face of 1 loop with 1 curves>")
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(face, protocol))
            self.assertEqual((again.to_bytes(), again.area()), (face.to_bytes(), face.area()))
            np.testing.assert_array_equal(again.gaps, face.gaps)
        for change in (lambda: setattr(face, "tolerance", 1), lambda: delattr(face, "_handle")):
            self.assertRaisesRegex(AttributeError, "does not change", change)
        self.assertRaisesRegex(TypeError, "does not change", face.__init__, plane())

    def test_handles_are_freed_once(self):
        with spied("nurbs_face_destroy") as calls:
            face = nurbs.Face(plane(), [square(0.25, 0.75)])
            del face
            self.assertEqual(len(calls), 1)

    def test_long_calls(self):
        done = []
        for ask in (self.face.area, self.face.moments, self.face.box, lambda **more: self.face.classify([[0.5, 0.5]], **more)):
            ask(progress=done.append)
            ask(work=10**9)
        nurbs.Face(plane(), [square(0.25, 0.75)], progress=done.append, work=10**9)


class Mistakes(unittest.TestCase):
    def test_statuses(self):
        face, out = nurbs.Face(plane()), square(1.25, 1.5)
        for status, call in (
                (nurbs.NURBS_ERROR_AXES, lambda: nurbs.Face(square(0, 1))),
                (nurbs.NURBS_ERROR_DIMENSION, lambda: nurbs.Face(plane(), [plane().iso(0, 0.5)])),
                (nurbs.NURBS_ERROR_TOLERANCE, lambda: nurbs.Face(plane(), tolerance=-1)),
                (nurbs.NURBS_ERROR_OUTSIDE_DOMAIN, lambda: nurbs.Face(plane(), [out])),
                (nurbs.NURBS_ERROR_NULL, lambda: nurbs.Face(plane(), [[None]])),
                (nurbs.NURBS_ERROR_COUNT, lambda: nurbs.Face(plane(), [[]])),
                (nurbs.NURBS_ERROR_ORIENTATION, lambda: nurbs.Face(plane(), [polygon((0.25, 0.25), (0.5, 0.5))])),
                (nurbs.NURBS_ERROR_INDEX, lambda: face.curve(1, 0)),
                (nurbs.NURBS_ERROR_INDEX, lambda: face.edge(0, 4)),
                (nurbs.NURBS_ERROR_INDEX, lambda: face.deviation(-1, 0)),
                (nurbs.NURBS_ERROR_PARAMETER_NOT_FINITE, lambda: face.classify([0, np.nan])),
                (nurbs.NURBS_ERROR_TOLERANCE, lambda: face.area(np.nan)),
                (nurbs.NURBS_ERROR_TOLERANCE, lambda: face.box(-1))):
            self.assertEqual(status_of(call), status)

    def test_arguments(self):
        loop = sides(0.25, 0.75)
        for kind, call in ((ValueError, lambda: nurbs.Face(plane(), [loop], edges=[loop[:3]])),
                           (ValueError, lambda: nurbs.Face(plane(), [loop], keys=[1])),
                           (ValueError, lambda: nurbs.Face.create(plane(), [4], loop[:3])),
                           (ValueError, lambda: nurbs.Face(plane()).classify([1, 2, 3])),
                           (TypeError, lambda: nurbs.Face(plane(), [[1]])), (TypeError, lambda: nurbs.Face(None)),
                           (TypeError, lambda: nurbs.Face.create(plane(), [0.5])),
                           (TypeError, lambda: nurbs.Face(plane(), progress=1))):
            self.assertRaises(kind, call)


if __name__ == "__main__":
    unittest.main()
