# SPDX-License-Identifier: MIT
"""Distances, measures, boxes and features in Python: one known value of each."""

import copy
import math
import pickle
import unittest
from math import inf, nan, pi, sqrt

import nurbs
from helpers import near, np, status_of


def base():
    """Along x from 0 to 2, in the plane."""
    return nurbs.line([0, 0], [2, 0])


def square():
    """Closed, with its middle at the origin and sides of 2."""
    return nurbs.polyline([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])


class Closest(unittest.TestCase):
    def test_closest_points(self):
        found = base().closest_points([[0.5, 1], [3, 0]])
        near(found.params, [0.25, 1])
        near(found.points, [[0.5, 0], [2, 0]])
        near(found.distances, [1, 1])
        inside, end = found.status
        self.assertEqual(inside, nurbs.NURBS_CLOSEST_CERTIFIED)
        self.assertEqual(end, nurbs.NURBS_CLOSEST_CERTIFIED | nurbs.NURBS_CLOSEST_BOUNDARY)
        part = base().closest_points([0.5, 1], range=(0.5, 1))
        self.assertEqual((part.params.shape, part.points.shape, part.distances.shape), ((), (2,), ()))
        near(part.params, 0.5)

    def test_other_layouts(self):
        points = np.array([[[0.5, 1], [3, 0]], [[1, 1], [0, 2]]], order="F")
        found = base().closest_points(points)
        near(found.params, [[0.25, 1], [0.5, 0]])
        near(found.distances, [[1, 1], [1, 2]])

    def test_surfaces(self):
        found = nurbs.plane([2, 0, 0], [0, 4, 0]).closest_points([[0.5, 1, 3], [9, 9, 0]])
        near(found.params, [[0.25, 0.25], [1, 1]])
        near(found.distances, [3, sqrt(74)])

    def test_inversion(self):
        cube = nurbs.trilinear([[[[x, y, z] for z in (0, 1)] for y in (0, 1)] for x in (0, 1)])
        near(cube.closest_points([0.25, 0.5, 0.75]).params, [0.25, 0.5, 0.75])

    def test_farthest_points(self):
        found = base().farthest_points([0.5, 1])
        near(found.params, 1)
        near(found.distances, sqrt(3.25))

    def test_points_that_are_not_finite(self):
        self.assertEqual(status_of(base().closest_points, [nan, 0]), nurbs.NURBS_ERROR_POINT_NOT_FINITE)
        found = base().closest_points([[nan, 0], [1, 0]], nan_points=True)
        self.assertTrue(np.isnan(found.distances[0]) and found.distances[1] == 0)
        self.assertEqual(found.status[0], nurbs.NURBS_CLOSEST_INVALID)

    def test_closest_local(self):
        found = square().closest_local([[0, 0.5], [0, 0.5]], [0.3, 2.3])
        near(found.params, [0.5, 2.5])
        near(found.points, [[0, -1], [0, 1]])

    def test_closest_all(self):
        found = square().closest_all([0, 0], tolerance=1e-9)
        near(found.params, [0.5, 1.5, 2.5, 3.5])
        near(found.distances, 1)
        self.assertTrue(found.status & nurbs.NURBS_CLOSEST_CERTIFIED)

    def test_critical_points(self):
        found = base().critical_points([0.5, 1], tolerance=1e-9)
        near(found.params, [0, 0.25, 1])
        near(found.distances, [sqrt(1.25), 1, sqrt(3.25)])
        low, high = nurbs.NURBS_CRITICAL_MINIMUM, nurbs.NURBS_CRITICAL_MAXIMUM
        self.assertEqual(found.kinds.tolist(), [high, low, high])

    def test_signed_distances(self):
        found = base().signed_distances([[1, 1], [0.5, -2]])
        near(found.distances, [1, -2])
        near(found.params, [0.5, 0.25])
        self.assertEqual(found.status.tolist(), [nurbs.NURBS_CLOSEST_CERTIFIED] * 2)

    def test_distances(self):
        a, b = nurbs.line([0, 0, 0], [2, 0, 0]), nurbs.line([1, -1, 1], [1, 1, 1])
        found = a.distance(b, 1e-9)
        self.assertTrue(1 - 1e-8 <= found.at_least <= 1 <= found.at_most + 1e-12 <= 1 + 1e-8)
        near([found.params_a, found.params_b], 0.5, by=1e-4)
        self.assertEqual(found.status, nurbs.NURBS_CLOSEST_CERTIFIED)
        both = base().hausdorff_distance(nurbs.line([0, 1], [1, 1]), 1e-9)
        near(both.at_least, [sqrt(2), 1], by=1e-8)
        near(both.at_most, [sqrt(2), 1], by=1e-8)
        near(both.params_a, [1], by=1e-4)
        self.assertEqual(both.params_b.shape, (1,))


class Measures(unittest.TestCase):
    def test_lengths(self):
        found = nurbs.circle(2).length()
        near(found.value, 4 * pi)
        self.assertLess(found.error, 1e-10)
        near(nurbs.circle().length(1e-9, range=(0, 0.25)).value, pi / 2, by=1e-8)
        near(base().lengths([[0.5], [1]]), [[1], [2]])
        near(base().params_at_lengths([0, 1]), [0, 0.5])
        near(base().params_at_lengths(5, clamp=True), 1)
        self.assertEqual(status_of(base().params_at_lengths, 5), nurbs.NURBS_ERROR_LENGTH)

    def test_divisions(self):
        quarters = nurbs.circle().divide(4)
        near(quarters.params, [0, 0.25, 0.5, 0.75, 1])
        near(quarters.size, pi / 2)
        near(nurbs.circle().divide(4, equal_chords=True).size, sqrt(2))
        near(base().divide(2, range=(0.5, 1)).params, [0.5, 0.75, 1])

    def test_areas(self):
        near(nurbs.sphere(2).area().value, 16 * pi, by=1e-11)
        near(nurbs.plane([2, 0, 0], [0, 4, 0]).area(range=[[0, 0.5], [0, 0.25]]).value, 1)

    def test_moments(self):
        wire = base().moments()
        near(wire.content, 2)
        near(wire.centroid, [1, 0])
        near(wire.inertia, [[0, 0], [0, 2 / 3]])
        disc = nurbs.enclosed_area([nurbs.circle(2, center=[1, 1])])
        near(disc.area, 4 * pi)
        near(disc.centroid, [1, 1])
        near(disc.inertia, 4 * pi * np.eye(2), by=1e-11)
        ball = nurbs.enclosed_volume([nurbs.sphere(1, center=[1, 2, 3])])
        near(ball.volume, 4 / 3 * pi, by=1e-11)
        near(ball.centroid, [1, 2, 3], by=1e-11)
        near(ball.inertia, 8 / 15 * pi * np.eye(3), by=1e-10)
        near(ball.openness, 0, by=1e-11)
        self.assertEqual(status_of(nurbs.enclosed_area, [base()]), nurbs.NURBS_ERROR_GAP)

    def test_quadrature(self):
        sphere = nurbs.sphere(2, center=[1, 2, 3])
        params, weights, measures = sphere.quadrature(20)
        self.assertEqual((params.shape, weights.shape), ((len(measures), 2), measures.shape))
        self.assertAlmostEqual(measures.sum(), 16 * np.pi, 9)
        self.assertAlmostEqual(weights.sum(), np.prod([b - a for a, b in sphere.domain]), 12)
        np.testing.assert_allclose(measures @ sphere.eval(params) / measures.sum(), [1, 2, 3], atol=1e-9)
        wire = base().quadrature()
        self.assertEqual(wire.params.shape, wire.weights.shape)
        self.assertEqual(status_of(sphere.quadrature, 65), nurbs.NURBS_ERROR_COUNT)
        spans, gradients = sphere.basis_gradients(params[:4])
        self.assertEqual((spans.shape, gradients.shape), ((4, 2), (4, 3, 3, 3)))
        np.testing.assert_allclose(gradients.sum(axis=(1, 2)), 0, atol=1e-12)
        normals = sphere.eval(params[:4]) - [1, 2, 3]
        np.testing.assert_allclose(np.einsum("nijc,nc->nij", gradients, normals), 0, atol=1e-12)
        out = np.empty((3, 3, 3))
        self.assertIs(sphere.basis_gradients(params[0], out=out).gradients, out)

    def test_moments_that_do_not_exist_are_nan(self):
        eight = nurbs.polyline([[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]])
        flat = [nurbs.bilinear([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]])]
        for content, centroid, inertia in (nurbs.enclosed_area([eight])[:3], nurbs.enclosed_volume(flat)[:3],
                                           nurbs.line([1, 1], [1, 1]).moments()[:3]):
            self.assertEqual(content, 0)
            self.assertTrue(np.isnan(centroid).all() and np.isnan(inertia).all())
        large = nurbs.circle(1e150, center=[1e150, 0])
        disc = nurbs.enclosed_area([large])
        near(disc.area / 1e300, pi)
        self.assertEqual(status_of(nurbs.enclosed_area, [nurbs.circle(1e200)]), nurbs.NURBS_ERROR_NOT_REPRESENTABLE)

    def test_moments_that_overflow(self):
        size = 2.0**300
        disc = nurbs.circle(2 * size, center=[size, size])
        wire, area = disc.moments(), nurbs.enclosed_area([disc])
        near(wire.content / size, 4 * pi)
        near(area.area / size**2, 4 * pi)
        near(area.centroid / size, [1, 1])
        self.assertTrue(np.isfinite(wire.inertia).all() and np.isnan(area.inertia).all())
        ball = nurbs.enclosed_volume([nurbs.sphere(size)])
        near(ball.volume / size**3, 4 / 3 * pi, by=1e-11)
        self.assertTrue(np.isnan(ball.inertia).all())
        ball = nurbs.sphere(size * size)
        self.assertEqual(status_of(nurbs.enclosed_volume, [ball]), nurbs.NURBS_ERROR_NOT_REPRESENTABLE)


class Bounds(unittest.TestCase):
    def test_boxes(self):
        found = nurbs.circle().box(1e-9)
        near([found.lower, found.upper], [[-1, -1], [1, 1]], by=1e-8)
        self.assertLess(found.gap, 1e-8)
        self.assertTrue((found.lower <= -1).all() and (found.upper >= 1).all())
        near(nurbs.circle().box(inf).upper, [1, 1])
        near(base().box(0, range=(0, 0.5)).upper, [1, 0])

    def test_oriented_boxes(self):
        found = nurbs.line([0, 0], [3, 4]).oriented_box(1e-9)
        near(found.center, [1.5, 2], by=1e-8)
        near(np.abs(found.axes[0]), [0.6, 0.8], by=1e-8)
        near(found.half, [2.5, 0], by=1e-8)

    def test_cones(self):
        direction, angle = base().tangent_cone(1e-3)
        near(direction, [1, 0])
        near(angle, 0, by=1e-6)
        direction, angle = nurbs.plane([2, 0, 0], [0, 4, 0]).normal_cone(1e-3)
        near(direction, [0, 0, 1])
        near(angle, 0, by=1e-6)

    def test_extreme_points(self):
        found = nurbs.circle(2).extreme_point([0, 1], 1e-9)
        near(found.params, [0.25], by=1e-4)
        near([found.value, found.bound], 2, by=1e-8)
        self.assertGreaterEqual(found.bound, 2)


def cusp():
    """C' vanishes in the middle."""
    return nurbs.Spline.bezier([[3, -1], [-1, 1], [-1, -1], [3, 1]])


class Intersections(unittest.TestCase):
    def test_roots(self):
        found = nurbs.Spline.bezier([[0.75], [-1.25], [0.75]]).roots()
        near(found.params, [0.25, 0.75])
        self.assertEqual((found.kinds.tolist(), found.complete), ([nurbs.NURBS_HIT_CROSSING] * 2, True))
        self.assertEqual(found.ranges.shape, (2, 2))
        self.assertEqual(nurbs.Spline.bezier([[0.75], [-1.25], [0.75]]).roots(-1).params.shape, (0,))

    def test_levels(self):
        circle = nurbs.circle()
        near(circle.curve_level(1, [0, 1, -0.5]).params, [1 / 12, 5 / 12], by=0.01)
        self.assertEqual(circle.curve_level(2, [0.25, 0, 0, 4, 0, -1]).params.size, 4)
        with self.assertRaises(ValueError):
            circle.curve_level(2, [1, 0, 0])
        with self.assertRaises(nurbs.ArgumentError):
            circle.curve_level(9, [0] * 55)

    def test_curves(self):
        a, b = nurbs.line([0, 0], [1, 1]), nurbs.line([0, 1], [1, 0])
        found = a.curve_intersections(b)
        near([found.params_a[0], found.params_b[0]], [0.5, 0.5])
        self.assertEqual((found.kinds.tolist(), found.complete), ([nurbs.NURBS_HIT_CROSSING], True))
        self.assertEqual(nurbs.circle(1).self_intersections().complete, True)
        with self.assertRaises(nurbs.ArgumentError):
            a.curve_intersections(a)
        self.assertEqual(len(nurbs.circle(1).self_intersections().kinds), 0)
        same = a.curve_intersections(a.reverse(), 1e-9)
        self.assertEqual(same.kinds.tolist(), [nurbs.NURBS_HIT_OVERLAP])
        self.assertGreater(same.ranges_b[0, 0], same.ranges_b[0, 1])

    def test_curves_and_surfaces(self):
        found = nurbs.line([0.5, 1, 3], [0.5, 1, -1]).surface_intersections(nurbs.plane([2, 0, 0], [0, 4, 0]))
        near(found.params_curve, [0.75])
        near(found.params_surface, [[0.25, 0.25]])
        self.assertEqual((found.kinds.tolist(), found.complete), ([nurbs.NURBS_HIT_CROSSING], True))
        self.assertEqual((found.ranges_curve.shape, found.ranges_surface.shape), ((1, 2), (1, 2, 2)))
        ball = nurbs.sphere(2)
        on_it = ball.iso(0, 0.25).surface_intersections(ball, 1e-9)
        self.assertEqual((on_it.kinds.tolist(), on_it.complete), ([nurbs.NURBS_HIT_OVERLAP], True))
        with self.assertRaises(nurbs.ArgumentError):
            ball.surface_intersections(ball)

    def test_rays(self):
        floor = nurbs.plane([2, 0, 0], [0, 4, 0])
        found = floor.rays([[0.5, 1, 3], [0.5, 1, -3], [9, 9, 9]], [0, 0, -1])
        near(found.params[0], [0.25, 0.25])
        near(found.distances[0], 3)
        self.assertEqual(found.status.tolist(), [nurbs.NURBS_RAY_HIT | nurbs.NURBS_RAY_CERTIFIED] +
                         [nurbs.NURBS_RAY_CERTIFIED] * 2)
        self.assertTrue(np.isnan(found.params[1:]).all())
        near(floor.ray_hits([0.5, 1, -3], [0, 0, -1], part=[-inf, 0]).distances, -3)
        hits = nurbs.sphere(2).ray_hits([0.5, 0.25, 5], [0, 0, -1])
        self.assertEqual((hits.kinds.tolist(), hits.complete),
                         ([nurbs.NURBS_RAY_HIT, nurbs.NURBS_RAY_HIT | nurbs.NURBS_RAY_BACK], True))
        near(hits.distances.sum(), 10)
        with self.assertRaises(nurbs.ArgumentError):
            floor.rays([0, 0, 1], [0, 0, 0])


class Sections(unittest.TestCase):
    def test_of_a_sphere(self):
        meet = nurbs.sphere(2).sections([0, 0, 2], [0, 2, 5], 1e-6)
        self.assertEqual(meet.counts, (2, 4, True))
        self.assertEqual(repr(meet), "<Meet of 2 branches and 4 nodes>")
        self.assertEqual((meet.branches.levels.tolist(), meet.branches.loops.tolist()), ([0, 1], [0, 1]))
        self.assertEqual((meet.nodes.kinds.tolist(), meet.nodes.ranges.shape), ([nurbs.NURBS_NODE_SEAM] * 4, (4, 2, 2)))
        space, on_surface = meet.copy().branch(1)
        near(space.length().value, 2 * pi * sqrt(3), by=1e-4)
        self.assertEqual((on_surface.dimension, on_surface.knots[0].tolist()), (2, space.knots[0].tolist()))
        self.assertLess(meet.branches.deviations.max(), 1e-6)

    def test_of_a_plane(self):
        meet = nurbs.plane([2, 0, 0], [0, 4, 0]).sections([1, 0, 0], 0.5, 1e-9)
        ends = meet.nodes.params[meet.branches.end_nodes[0]]
        near(ends, [[0.25, 1], [0.25, 0]])
        near(meet.branch(0).space.length().value, 4)

    def test_of_a_face(self):
        ground = nurbs.plane([2, 0, 0], [0, 4, 0])
        ring = nurbs.circle(0.25, center=[0.5, 0.5])
        face = nurbs.Face.create(ground, [1], [ring], tolerance=1e-9)
        meet = ground.sections([1, 0, 0], [0.5, 1], 1e-9).trim(face)
        self.assertEqual((meet.counts, meet.branches.levels.tolist()), ((1, 2, True), [1]))
        near(meet.branch(0).space.length().value, 2, by=1e-8)

    def test_of_two_surfaces(self):
        meet = nurbs.sphere(2).meet(nurbs.plane([5, 0, 0], [0, 5, 0], [-1, -1, 1]), 1e-6, work=10**9)
        self.assertEqual((meet.counts, meet.ways.closed.tolist()), ((2, 4, True), [0]))
        (space, on_ball), on_plane = meet.branch(0), meet.branch_second(0)
        near(on_plane(on_plane.domain[0]), (space(space.domain[0])[:, :2] + 1) / 5)
        self.assertEqual(on_plane.knots[0].tolist(), on_ball.knots[0].tolist())
        near(meet.nodes_second.params, meet.nodes_second.ranges[:, :, 0])
        self.assertEqual(meet.kinds.tolist(), 2 * [nurbs.NURBS_BRANCH_CROSSING])
        ring = nurbs.torus(2, 0.5).meet(nurbs.plane([8, 0, 0], [0, 8, 0], [-4, -4, 0.5]), 1e-5)
        self.assertEqual((ring.counts.complete, ring.kinds.tolist()), (True, [nurbs.NURBS_BRANCH_TOUCH]))
        both = nurbs.plane([2, 0, 0], [0, 2, 0]).meet(nurbs.plane([2, 0, 0], [0, 2, 0], [1, 1, 0]), 1e-6)
        self.assertEqual((both.counts, both.kinds.tolist()), ((4, 5, True), 4 * [nurbs.NURBS_BRANCH_OVERLAP]))
        self.assertEqual(both.nodes.kinds.tolist().count(nurbs.NURBS_NODE_OVERLAP), 1)

    def test_of_two_faces(self):
        floor, wall = nurbs.plane([2, 0, 0], [0, 4, 0]), nurbs.plane([0, 4, 0], [0, 0, 2], [1, 0, -1])
        whole = floor.meet(wall, 1e-9)
        on_floor = nurbs.Face.create(floor, [1], [nurbs.circle(0.25, center=[0.5, 0.5])], tolerance=1e-9)
        on_wall = nurbs.Face.create(wall, [1], [nurbs.circle(0.25, center=[0.75, 0.5])], tolerance=1e-9)
        for trim, length in ((lambda m: m.trim(on_floor), 2), (lambda m: m.trim_second(on_wall), 2),
                             (lambda m: m.trim(on_floor).trim_second(on_wall, work=10**9), 1)):
            near(trim(whole).branch(0).space.length().value, length, by=1e-8)
        both = on_floor.meet(on_wall, 1e-9, work=10**9)
        near(both.branch(0).space.length().value, 1, by=1e-8)
        self.assertEqual(both.kinds.tolist(), [nurbs.NURBS_BRANCH_CROSSING])

    def test_of_three_surfaces(self):
        ball, side = nurbs.sphere(1), nurbs.plane([0, 4, 0], [0, 0, 4], [0.48, -2, -2])
        found = ball.common_points(side, nurbs.plane([4, 0, 0], [0, 4, 0], [-2, -2, 0.64]), work=10**9)
        self.assertEqual((found.complete, found.kinds.tolist()), (True, [nurbs.NURBS_HIT_CROSSING] * 2))
        near(sorted(found.points.tolist()), [[0.48, -0.6, 0.64], [0.48, 0.6, 0.64]])
        near(side(found.params[:, 1]), found.points)

    def test_projections(self):
        ball, line = nurbs.sphere(1, axis=[0, 1, 0]), nurbs.line([-2, 0.28, 3], [2, 0.28, 3])
        meet = ball.project_curve(line, [0, 0, -2], 1e-9, work=10**9)
        self.assertEqual((meet.counts.complete, int((meet.nodes.kinds == nurbs.NURBS_NODE_FOLD).sum())), (True, 4))
        folds = meet.nodes_second.params[meet.nodes.kinds == nurbs.NURBS_NODE_FOLD]
        near(abs(4 * folds[:, 0] - 2), [0.96] * 4, by=1e-7)
        lines = meet.branch_second(0)
        (t, h), space = lines(lines.domain[0][0]), meet.branch(0).space
        near(space(space.domain[0][0]), line(t) + [0, 0, -h], by=1e-8)
        feet = ball.project_curve(line, None, 1e-9, work=10**9)
        self.assertEqual((feet.counts.complete, feet.counts.branches >= 2), (True, True))
        lines, space = feet.branch_second(0), feet.branch(0).space
        t, h = lines(lines.domain[0][1])
        near(math.dist(space(space.domain[0][1]), line(t)), abs(h), by=1e-8)
        face = nurbs.Face.create(nurbs.plane([1, 0, 0], [0, 1, 0]), [1], [nurbs.circle(0.25, center=[0.5, 0.5])])
        inside = face.project_curve(nurbs.line([-1, 0.5, 3], [1, 0.5, 3]), [0, 0, 1], 1e-9)
        near(sorted(inside.nodes_second.params[:, 0]), [0.625, 0.875], by=1e-9)
        below = face.project_curve(nurbs.line([-1, 0.5, 3], [1, 0.5, 3]), None, 1e-9)
        near(sorted(below.nodes_second.params[:, 0]), [0.625, 0.875], by=1e-9)

    def test_contours(self):
        ball = nurbs.sphere(2)
        self.assertEqual(ball.contours(nurbs.NURBS_CONTOUR_SILHOUETTE, [0, 0, 1], tolerance=1e-6).counts.branches, 1)
        lit = ball.contours(nurbs.NURBS_CONTOUR_ISOPHOTE, [0, 0, 1], [0.5, -0.5], tolerance=1e-6)
        self.assertEqual(lit.branches.levels.tolist(), [0, 1])
        lights = [[0.5, 0, 0], [0, 0.5, 0]]
        mirrored = ball.reflections(nurbs.NURBS_REFLECTION_HIGHLIGHT, [0, 0, 1], lights, tolerance=1e-6)
        self.assertEqual(set(mirrored.branches.levels.tolist()), {0, 1})
        seen = ball.reflections(nurbs.NURBS_REFLECTION_FROM, [0, 0, 1], lights[0], [0, -9, 0], tolerance=1e-6)
        self.assertTrue(seen.counts.complete and seen.counts.branches > 0)
        self.assertEqual(ball.surface_level(1, [0, 0, 1, -1], 1e-6).counts.branches, 1)
        floor = nurbs.plane([1, 0, 0], [0, 1, 0])
        slope = nurbs.Spline([1, 1], floor.knots, [[[0], [0]], [[1], [1]]])
        near(floor.level_curves(slope, [0.25], 1e-9).branch(0).space.length().value, 1)

    def test_are_constant(self):
        meet = copy.deepcopy(nurbs.sphere().sections([0, 0, 1], [2], 1e-3))
        self.assertEqual(meet.counts, (0, 0, True))
        for wrong in (lambda: setattr(meet, "levels", 1), lambda: delattr(meet, "_handle")):
            self.assertRaises(AttributeError, wrong)
        self.assertRaises(TypeError, nurbs.Meet)
        self.assertRaises(TypeError, pickle.dumps, meet)

    def test_are_refused(self):
        ball = nurbs.sphere()
        self.assertRaises(ValueError, ball.sections, [0, 1], [0], 1e-3)
        for arguments in (([0, 0, 0], [0], 1e-3), ([0, 0, 1], [0], 0), ([0, 0, 1], [inf], 1e-3)):
            self.assertRaises(nurbs.ArgumentError, ball.sections, *arguments)
        self.assertRaises(IndexError, ball.sections([0, 0, 1], [0], 1e-3).branch, 1)

    def test_can_be_ended(self):
        meet = nurbs.sphere().sections([0, 0, 1], [0.5], 1e-9, work=10)
        self.assertFalse(meet.counts.complete)
        self.assertIn("not complete", repr(meet))


class Meshes(unittest.TestCase):
    def test_of_a_sphere(self):
        mesh = nurbs.sphere(2).mesh(1e-2)
        counts, bound = mesh.counts, mesh.bound
        self.assertEqual((counts.triangles, counts.faces, counts.edges), (2 * counts.points - 4, 1, 0))
        self.assertTrue(bound.reached and 0 < bound.from_shape <= 4e-3 and 0 < bound.from_mesh <= 4e-3)
        near(np.linalg.norm(mesh.points, axis=1), np.full(counts.points, 2.0))
        vertices = mesh.vertices
        self.assertEqual(mesh.vertex_triangles.max(), counts.vertices - 1)
        np.testing.assert_array_equal(vertices.points[mesh.vertex_triangles], mesh.triangles)
        near(nurbs.sphere(2)(mesh.params), mesh.points[vertices.points])
        near(mesh.normals, mesh.points[vertices.points] / 2, by=1e-9)
        a, b, c = mesh.points[mesh.triangles.T]
        self.assertTrue((np.einsum("ij,ij->i", np.cross(b - a, c - a), a + b + c) > 0).all())
        self.assertEqual(repr(mesh), f"<Mesh of {counts.triangles} triangles, {counts.points} points and 1 faces>")

    def test_in_single_precision(self):
        mesh = nurbs.torus(3, 1).mesh(relative=0.1)
        drawn = mesh.vertices_f32
        np.testing.assert_array_equal(drawn.points, mesh.points_f32[mesh.vertices.points])
        np.testing.assert_array_equal(drawn.normals, mesh.normals.astype(np.float32))
        self.assertEqual((mesh.triangles_i32(True) == mesh.triangles).all(), True)
        self.assertEqual(mesh.triangles_i32().dtype, np.int32)

    def test_to_an_angle(self):
        cylinder = nurbs.cylinder(1, 2)
        mesh = cylinder.mesh(relative=1, angle=0.1)
        a, b, c = np.swapaxes(mesh.normals[mesh.vertex_triangles], 0, 1)
        self.assertTrue(mesh.bound.reached and (np.einsum("ij,ij->i", a, b) >= np.cos(0.1) - 1e-15).all())
        self.assertGreater(mesh.counts.triangles, cylinder.mesh(relative=1, angle=0.4).counts.triangles)
        self.assertRaises(nurbs.ArgumentError, cylinder.mesh, angle=4.0)

    def test_for_several_distances(self):
        ball = nurbs.sphere()
        face = nurbs.Face(ball)
        for shape in ball, face, nurbs.Model.create([face]):
            fine, coarse = shape.mesh_levels([1e-2, 1e-1])
            np.testing.assert_array_equal(fine.points, shape.mesh(1e-2, relative=0).points)
            self.assertLess(coarse.counts.triangles, fine.counts.triangles)
        self.assertEqual(ball.mesh_levels([]), [])
        self.assertRaises(nurbs.ArgumentError, ball.mesh_levels, [1.0, 0.0])

    def test_without_small_angles(self):
        tube = nurbs.cylinder(1, 20)
        plain, mesh = tube.mesh(0.05), tube.mesh(0.05, minimum_angle=0.5)
        self.assertTrue(mesh.bound.reached and mesh.counts.triangles > 5 * plain.counts.triangles)
        self.assertRaises(nurbs.ArgumentError, tube.mesh, minimum_angle=0.6)

    def test_quads(self):
        mesh = nurbs.torus(3, 1).mesh(1e-2)
        quads, points = mesh.quads, mesh.vertex_quads
        np.testing.assert_array_equal(mesh.vertices.points[points.corners], quads.corners)
        self.assertEqual(2 * len(quads.triangles) + len(quads.rest), mesh.counts.triangles)
        halves = np.stack([quads.corners[:, [0, 1, 2]], quads.corners[:, [0, 2, 3]]], 1)
        found = np.stack([mesh.triangles[quads.triangles], mesh.triangles[quads.triangles + 1]], 1)
        np.testing.assert_array_equal(np.sort(found), np.sort(halves))
        self.assertFalse(set(quads.rest) & (set(quads.triangles) | set(quads.triangles + 1)))

    def test_of_faces_and_models(self):
        face = nurbs.Face.create(nurbs.plane([2, 0, 0], [0, 4, 0]), [1], [nurbs.circle(0.25, center=[0.5, 0.5])])
        mesh, twice = face.mesh(1e-3), nurbs.Model.create([face, face]).mesh(1e-3)
        self.assertEqual((mesh.counts.faces, twice.counts.faces), (1, 2))
        self.assertEqual(mesh.faces.triangle_counts.tolist(), [mesh.counts.triangles])
        self.assertEqual(twice.edges.sizes.sum(), len(twice.edge_points))
        near(mesh.points[mesh.edge_points[0]], mesh.points[mesh.edge_points[-1]])

    def test_of_a_volume(self):
        block = nurbs.plane([1, 0, 0], [0, 0, 2], [1, 0, 0]).revolve(pi / 2)
        mesh = block.mesh_volume(1e-2)
        cells = mesh.hexahedra
        self.assertTrue(mesh.bound.reached and len(cells.corners) > 3)
        self.assertEqual(len(np.unique(cells.corners)), mesh.counts.points)
        near(mesh.points[cells.corners[:, 6]], block(cells.domains[:, :, 1]))
        self.assertTrue((cells.folds == nurbs.NURBS_FOLD_NONE).all() and len(np.unique(cells.signs)) == 1)
        self.assertEqual(block.fold_pieces().signs.tolist(), [cells.signs[0]])
        self.assertLessEqual(len(block.mesh_volume(1e-9, limit=20).hexahedra.corners), 20)
        self.assertRaises(nurbs.ArgumentError, nurbs.sphere().mesh_volume)
        self.assertRaises(nurbs.ArgumentError, block.mesh_volume, 0.1, limit=-1)

    def test_bezier_cells(self):
        circle = nurbs.circle()
        found, own = circle.bezier_cells(), circle.bezier_cell_points()
        self.assertEqual((found.kind, found.point_count), (75, 8))
        self.assertEqual(found.cells.tolist(), [[0, 2, 1], [2, 4, 3], [4, 6, 5], [6, 0, 7]])
        pieces = circle.bezier_pieces()
        near(own.points[found.cells[0, [0, 2, 1]]], pieces.points[0])
        near(own.weights[found.cells[3, 2]], pieces.weights[3, 1])

    def test_are_constant(self):
        mesh = copy.deepcopy(nurbs.sphere().mesh())
        for wrong in (lambda: setattr(mesh, "points", 1), lambda: delattr(mesh, "_handle")):
            self.assertRaises(AttributeError, wrong)
        self.assertRaises(TypeError, nurbs.Mesh)
        self.assertRaises(TypeError, pickle.dumps, mesh)

    def test_are_refused_or_ended(self):
        ball = nurbs.sphere()
        for arguments in ((0,), (inf, 0), (1, -1), (1, 0, -1)):
            self.assertRaises(nurbs.ArgumentError, ball.mesh, *arguments)
        self.assertRaises(nurbs.ArgumentError, nurbs.circle().mesh)
        self.assertFalse(ball.mesh(1e-6, work=1000).bound.reached)


class Features(unittest.TestCase):
    def test_features(self):
        bend = nurbs.Spline.bezier([[0, 0], [1, 2], [2, -2], [3, 0]])
        found = bend.features(nurbs.NURBS_FEATURE_INFLECTION)
        near(found.params, [0.5])
        self.assertEqual((found.found.tolist(), found.complete), ([nurbs.NURBS_FEATURE_INFLECTION], True))
        kink = nurbs.polyline([[0, 0], [1, 0], [1, 1]]).features()
        self.assertEqual(kink.found.tolist(), [nurbs.NURBS_FEATURE_KINK])
        near(kink.params, [1])
        near(kink.values, [pi / 2])

    def test_extrema(self):
        found = nurbs.Spline.bezier([[[0], [1]], [[1], [0]]]).extrema()
        near(found.params, [[0, 0], [0, 1], [0.5, 0.5], [1, 0], [1, 1]])
        near(found.values, [0, 1, 0.5, 1, 0])
        self.assertEqual(found.found.tolist(), [nurbs.NURBS_EXTREMUM_MINIMUM, nurbs.NURBS_EXTREMUM_MAXIMUM,
                                                nurbs.NURBS_EXTREMUM_SADDLE, nurbs.NURBS_EXTREMUM_MAXIMUM,
                                                nurbs.NURBS_EXTREMUM_MINIMUM])
        self.assertTrue(found.complete)
        hill = nurbs.Spline.bezier([[0], [1], [0]]).extrema(nurbs.NURBS_EXTREMUM_MAXIMUM)
        self.assertTrue(hill.boxes[0, 0, 0] <= 0.5 <= hill.boxes[0, 0, 1])
        self.assertEqual(len(hill.params), 1)

    def test_mesh_curve(self):
        line = nurbs.circle().mesh_curve(1e-3)
        self.assertTrue(line.reached and 0 < line.bound <= 1e-3)
        self.assertTrue(70 <= len(line.params) <= 80)
        near(line.points, nurbs.circle()(line.params))
        self.assertEqual(len(nurbs.circle().mesh_curve(angle=1.6).params), 5)
        self.assertEqual(nurbs.line([0, 0], [3, 4]).mesh_curve(longest=1.01).params.size, 6)

    def test_monotone_pieces(self):
        found = nurbs.circle().monotone_pieces([1, 0])
        near(found.starts, [0, 0.5])
        self.assertEqual((found.signs.tolist(), found.complete), ([-1, 1], True))

    def test_flatness(self):
        self.assertEqual(nurbs.circle().convexity(), nurbs.NURBS_CONVEXITY_LEFT)
        self.assertEqual(base().convexity(), nurbs.NURBS_CONVEXITY_STRAIGHT)
        line = base().straightness()
        near(line.direction, [1, 0])
        near([line.bound, line.origin[1]], 0)
        plane = nurbs.circle(center=[0, 0, 1]).planarity()
        near(plane.normal, [0, 0, 1])
        near([plane.bound, plane.origin[2] - 1], 0)

    def test_boundaries(self):
        found = nurbs.sphere().boundary_contacts(1e-9)
        self.assertEqual(found.closed.tolist(), [True, False])
        self.assertEqual(found.collapsed.tolist(), [[False, False], [True, True]])
        near(found.gaps[0], 0)
        near(found.sizes[1], [0, 0])

    def test_singular_points(self):
        found = cusp().singular_points(1e-3)
        near(found.params, [[0.5]], by=1e-3)
        self.assertTrue(found.complete and found.boxes.shape == (1, 1, 2))
        self.assertTrue(found.boxes[0, 0, 0] <= 0.5 <= found.boxes[0, 0, 1])
        self.assertEqual(base().singular_points(1e-3).params.shape, (0, 1))

    def test_folds(self):
        flat = nurbs.bilinear([[[0, 0], [0, 1]], [[1, 0], [1, 1]]])
        self.assertEqual(flat.fold_test().result, nurbs.NURBS_FOLD_NONE)
        crossed = nurbs.bilinear([[[0, 0], [0, 1]], [[1, 1], [1, 0]]]).fold_test()
        self.assertEqual(crossed.result, nurbs.NURBS_FOLD_FOUND)
        self.assertTrue(np.isfinite([crossed.positive, crossed.negative]).all())
        tent = nurbs.plane([2, 0, 0], [0, 4, 0])
        self.assertEqual(tent.fold_test(reference=[0, 0, 1]).result, nurbs.NURBS_FOLD_NONE)


class Errors(unittest.TestCase):
    def test_statuses(self):
        self.assertEqual(status_of(base().closest_points, [0, 0], tolerance=-1), nurbs.NURBS_ERROR_TOLERANCE)
        self.assertEqual(status_of(base().closest_points, [0, 0], range=(0, 2)),
                         nurbs.NURBS_ERROR_OUTSIDE_DOMAIN)
        self.assertEqual(status_of(nurbs.sphere().length), nurbs.NURBS_ERROR_AXES)
        self.assertEqual(status_of(base().extreme_point, [0, 0], 0), nurbs.NURBS_ERROR_DIRECTION)
        self.assertEqual(status_of(base().distance, nurbs.sphere()), nurbs.NURBS_ERROR_INCOMPATIBLE)

    def test_arrays_that_do_not_fit(self):
        for call in (lambda: base().closest_points([[1, 2, 3]]), lambda: base().closest_points(1),
                     lambda: base().closest_points([1, 2], range=[1]),
                     lambda: base().closest_local([1, 2], [0.1, 0.2]),
                     lambda: base().monotone_pieces([1, 2, 3]), lambda: base().fold_test([1, 2])):
            with self.assertRaises(ValueError):
                call()


if __name__ == "__main__":
    unittest.main()
