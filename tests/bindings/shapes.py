# SPDX-License-Identifier: MIT
"""Shapes in Python: one known value of each."""

import unittest
from functools import partial
from math import cosh, inf, pi, sinh

import helpers
import nurbs
from helpers import np, same, status_of

near = partial(helpers.near, by=1e-14)


def segment(a, b):
    return nurbs.line(a, b)


class Curves(unittest.TestCase):
    def test_lines(self):
        same(nurbs.line([0, 0], [2, 4]).eval(0.5), [1, 2])
        corners = [[0, 0], [1, 0], [1, 1]]
        same(nurbs.polyline(corners).eval(1.5), [1, 0.5])
        same(nurbs.polyline(np.array(corners, order="F"), [0, 2, 3]).eval([1, 2]), [[0.5, 0], [1, 0]])
        same(nurbs.polygon(4, 2).eval(0.25), [0, 2])
        same(nurbs.rounded_rectangle(4, 2).eval(0), [-2, -1])
        same(nurbs.rounded_rectangle(4, 2, 0.5, center=[0, 0, 1]).eval(0), [-1.5, -1, 1])

    def test_circles(self):
        same(nurbs.circle().eval([0, 0.25, 0.5, 1]), [[1, 0], [0, 1], [-1, 0], [1, 0]])
        same(nurbs.circle(2, center=[1, 1]).eval(0.25), [1, 3])
        same(nurbs.circle(axis=[1, 0, 0], x=[0, 3, 0]).eval(0.25), [0, 0, 1])
        counts = [nurbs.circle(form=form).counts[0] for form in (nurbs.NURBS_ARC_THIRDS, nurbs.NURBS_ARC_SMOOTH)]
        self.assertEqual(counts, [7, 6])
        same(nurbs.arc(1, 0, pi / 2).eval(1), [0, 1])
        same(nurbs.arc_through([1, 0], [0, 1], [-1, 0]).eval([0, 1]), [[1, 0], [-1, 0]])
        near(nurbs.arc_tangent([1, 0], [0, 1], [-1, 0]).eval(0.5), [0, 1])

    def test_conics(self):
        same(nurbs.ellipse(2, 1).eval(0.25), [0, 1])
        same(nurbs.parabola(1, -2, 2).eval(2), [1, 2])
        near(nurbs.hyperbola(1, 2, 0, 1).eval(1), [cosh(1), 2 * sinh(1)])
        near(nurbs.conic_shoulder([0, 0], [1, 1], [2, 0], [1, -1], 0.5).eval(0.5), [1, 0.5])
        half = nurbs.conic_point([-1, 0], [0, 1], [1, 0], [0, 1], [0, 1])
        near(np.hypot(*half.eval([0.2, 0.7]).T), 1)
        five = nurbs.circle().eval([0, 0.1, 0.2, 0.3, 0.4])
        np.testing.assert_allclose(np.hypot(*nurbs.conic_through(five).eval([0.3, 0.8]).T), 1, rtol=1e-12)
        near(nurbs.conic_focus([0, 0], [1, 0], 1, -pi / 2, pi).eval(0.5), [0.5, 0])

    def test_shape_factors(self):
        same(nurbs.conic_triangle([0, 0], [1, 1], [2, 0], 1).eval(0.5), [1, 0.5])
        same(nurbs.conic_triangle([0, 0], [1, 1], [2, 0], inf).eval(0.5), [1, 1])
        found = nurbs.conic_triangle([0, 0], [1, 1], [2, 0], 0.25).shape_factor()
        self.assertEqual(found, (0.25, nurbs.NURBS_CONIC_ELLIPSE))

    def test_equations(self):
        equation = [1, 0, 4, 0, 0, -4]
        axes = nurbs.conic_axes(equation)
        self.assertEqual(axes.type, nurbs.NURBS_CONIC_ELLIPSE)
        near(axes.sizes, [2, 1])
        near(np.abs(axes.x), [1, 0])
        near(np.abs(nurbs.conic_implicit(equation).eval(0.25)), [0, 1])

    def test_helix(self):
        made, error = nurbs.helix(1, 2, 3, tolerance=1e-6, origin=[0, 0, 1])
        self.assertEqual(made.domain[0], (0, 3))
        near(made.eval([0, 3]), [[1, 0, 1], [1, 0, 7]])
        self.assertLessEqual(error, 1e-6)
        spiral = nurbs.helix(0, 0, 1, growth=1, tolerance=1e-6, origin=[0, 0]).spline
        near(spiral.eval(1), [1, 0])


class Surfaces(unittest.TestCase):
    def test_from_curves(self):
        same(segment([0, 0], [1, 0]).extrude([0, 2]).eval([0.5, 0.5]), [0.5, 1])
        with self.assertRaisesRegex(ValueError, r"3 numbers, expected 2.*transform\(numpy.eye\(3, 2\)\)"):
            segment([0, 0], [1, 0]).extrude([0, 0, 2])
        same(segment([0, 0], [1, 0]).transform(np.eye(3, 2)).extrude([0, 0, 2]).eval([0.5, 0.5]), [0.5, 0, 1])
        same(segment([1, 0, 0], [1, 0, 1]).revolve().eval([0.25, 0.5]), [0, 1, 0.5])
        around = segment([2, 0, 0], [2, 0, 1]).revolve(pi, point=[1, 0, 0], axis=[0, 0, 2])
        near(around.eval([1, 0.5]), [0, 0, 0.5])
        a, b = segment([0, 0, 0], [1, 0, 0]), segment([0, 1, 0], [1, 1, 2])
        for cartesian in (False, True):
            same(a.ruled(b, cartesian=cartesian).eval([0.5, 0.5]), [0.5, 0.5, 0.5])
        same(a.tensor_sum(b, 2, 3).eval([0.5, 0.5]), [2.5, 3, 3])
        same(segment([1], [3]).tensor_product(segment([1, 2], [1, 4])).eval([0.5, 0.5]), [2, 6])
        same(nurbs.circle().swung(segment([1, 0], [2, 1]), 2).eval([0.25, 0.5]), [0, 3, 0.5])

    def test_patches(self):
        same(nurbs.plane([2, 0, 0], [0, 1, 0], [1, 1, 1]).eval([0.5, 0.5]), [2, 1.5, 1])
        same(nurbs.bilinear([[[0], [1]], [[2], [5]]]).eval([0.5, 0.5]), [2])
        same(nurbs.trilinear(np.arange(8.0).reshape(8, 1)).eval([0.5, 0.5, 0.5]), [3.5])

    def test_spheres(self):
        near(nurbs.sphere(2, center=[1, 0, 0]).eval([0.25, 0.5]), [1, 2, 0])
        near(nurbs.spherical_patch(1, 0, pi / 2, 0, pi / 2).eval([1, 0]), [0, 1, 0])
        self.assertEqual(nurbs.sphere_patches().names, ["+X", "+Y", "-X", "-Y", "+Z", "-Z"])
        self.assertEqual(len(nurbs.sphere_patches(hemisphere=True)), 5)
        near(nurbs.ellipsoid(1, 2, 3).eval([0.25, 0.5]), [0, 2, 0])

    def test_quadrics(self):
        near(nurbs.cylinder(2, 3).eval([0.25, 1]), [0, 2, 3])
        near(nurbs.cone(1, 0, 2).eval([0.25, 0.5]), [0, 0.5, 1])
        near(nurbs.torus(2, 0.5).eval([0.25, 0.5]), [0, 1.5, 0])
        near(nurbs.paraboloid().eval([0.25, 0.5]), [0, 0.5, 0.25])
        near(nurbs.saddle().eval([1, 0.5]), [1, 0, 1])
        x, y, z = nurbs.hyperboloid(1, 1, 1, -1, 1).eval([0.3, 0.7])
        near(x * x + y * y - z * z, 1)
        x, y, z = nurbs.hyperboloid(1, 1, 1, 1, 2, two_sheets=True).eval([0.3, 0.7])
        near(z * z - x * x - y * y, 1)


def patch():
    """z = u v over the unit square."""
    return nurbs.bilinear([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])


class Boundaries(unittest.TestCase):
    def test_boundaries(self):
        around = patch().boundaries()
        self.assertEqual(around.names, ["0-", "0+", "1-", "1+"])
        same(around[1].eval(0.5), [1, 0.5, 0.5])

    def test_coons_surfaces(self):
        around = patch().boundaries()
        same(nurbs.coons(around).eval([0.25, 0.5]), [0.25, 0.5, 0.125])
        cross = [patch().derivative(axis=k // 2).iso(k // 2, k % 2) for k in range(4)]
        for made in (nurbs.coons_hermite(around), nurbs.coons_hermite(around, cross),
                     nurbs.coons_hermite(around, cross, nurbs.NURBS_TWIST_COMPATIBLE),
                     nurbs.coons_hermite(around, twists=[[0, 0, 1]] * 4)):
            near(made.spline.eval([0.25, 0.5]), [0.25, 0.5, 0.125])
            self.assertEqual(made.bound, 0)
        gaps = nurbs.coons_gaps([around[0], around[1], around[2], segment([0, 1, 3], [1, 1, 1])], cross)
        same(gaps.positions, [0, 3, 0, 0])
        self.assertEqual((gaps.tangents.shape, gaps.twists.tolist()), ((4, 2), [0] * 4))

    def test_coons_volumes(self):
        cube = nurbs.trilinear([[[[x, y, z] for z in (0, 1)] for y in (0, 1)] for x in (0, 1)])
        same(nurbs.coons_volume(cube.boundaries()).eval([0.25, 0.5, 0.75]), [0.25, 0.5, 0.75])


class Recognition(unittest.TestCase):
    def test_a_circle(self):
        found = nurbs.circle(2, center=[1, 1]).recognize(1e-9)
        self.assertEqual(found.shape, nurbs.NURBS_SHAPE_CIRCLE)
        near(found.origin, [1, 1, 0])
        near(found.axis, [0, 0, 1])
        near(found.sizes, [2, 0, 0])
        self.assertLess(found.deviation, 1e-9)

    def test_surfaces_that_are_shrunk(self):
        point = nurbs.bilinear([[[1, 2, 3]] * 2] * 2).recognize(1e-9)
        self.assertEqual(point.shape, nurbs.NURBS_SHAPE_POINT)
        same([point.origin, point.axis, point.x], [[1, 2, 3], [0, 0, 0], [0, 0, 0]])
        line = nurbs.bilinear([[[0, 0, 0], [0, 3, 4]]] * 2).recognize(1e-9)
        self.assertEqual(line.shape, nurbs.NURBS_SHAPE_LINE)
        near(line.axis, [0, 0.6, 0.8])

    def test_no_shape(self):
        curve = nurbs.Spline.bezier([[0, 0], [1, 2], [2, -2], [3, 0]])
        self.assertEqual(curve.recognize(1e-3).shape, nurbs.NURBS_SHAPE_NONE)


class Errors(unittest.TestCase):
    def test_statuses(self):
        self.assertEqual(status_of(nurbs.circle, -1), nurbs.NURBS_ERROR_LENGTH)
        self.assertEqual(status_of(nurbs.circle, form=7), nurbs.NURBS_ERROR_FORM)
        self.assertEqual(status_of(nurbs.arc, 1, 0, 7), nurbs.NURBS_ERROR_ANGLE)
        self.assertEqual(status_of(nurbs.arc_through, [0, 0], [1, 1], [2, 2]), nurbs.NURBS_ERROR_COLLINEAR)
        self.assertEqual(status_of(nurbs.conic_axes, [1, 0, 1, 0, 0, 1]), nurbs.NURBS_ERROR_CONIC)

    def test_boundaries_that_do_not_fit(self):
        around = list(patch().boundaries())
        cross = [segment([2, 0, 0], [2, 0, 1]), *(segment([1, 0, 0], [1, 0, 1]) for _ in range(3))]
        self.assertEqual(status_of(nurbs.coons, [around[1], *around[1:]]), nurbs.NURBS_ERROR_GAP)
        self.assertEqual(status_of(nurbs.coons_hermite, around, cross), nurbs.NURBS_ERROR_TANGENT)
        self.assertEqual(status_of(nurbs.coons_hermite, around, twist=9), nurbs.NURBS_ERROR_TWIST_RULE)

    def test_vectors_that_do_not_fit(self):
        with self.assertRaises(ValueError):
            nurbs.circle(center=[0, 0], axis=[0, 0, 1])
        with self.assertRaises(ValueError):
            nurbs.sphere(center=[0, 0])
        with self.assertRaises(ValueError):
            nurbs.coons(patch().boundaries()[:3])


if __name__ == "__main__":
    unittest.main()
