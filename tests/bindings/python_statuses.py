# SPDX-License-Identifier: MIT
"""Every status that a call returns is listed in its entry of nurbs.h, whatever a spline holds: the largest and smallest
numbers, weights of any signs and sizes, periods beside which no double is left."""

import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # from the project
import nurbs
from helpers import np, random_spline

TOP = Path(__file__).resolve().parents[2]
ANYWHERE = {"NURBS_OK", "NURBS_ERROR_MEMORY"}
SIZES = [1, 1, 1, 1e-310, 1e-300, 1e-160, 1e15, 1e160, 1e300]
BUDGET = 200


class Case:
    """A spline with numbers of any size, another one of its dimension, and arguments for calls."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        self.g = self.spline(int(self.random.integers(1, 4)))
        self.h = self.spline(self.g.dimension)

    def size(self):
        return float(self.random.choice(SIZES))

    def spline(self, dim):
        while True:
            s = random_spline(self.random)
            knots = [t * self.size() + self.random.choice([0, 0, 1e8, 8e307]) for t in s.knots]
            flags = sum(nurbs.on_axis(k, nurbs.NURBS_PERIODIC) for k, wraps in enumerate(s.periodic) if wraps)
            records = s.homogeneous_points
            points = np.take(records[..., :-1], np.arange(dim) % s.dimension, axis=-1) * self.size()
            weights = records[..., -1] * self.size()
            if not flags and self.random.random() < 0.3:
                weights = weights * 10.0 ** self.random.integers(-300, 300, weights.shape)
            try:
                if s.is_homogeneous:
                    net = np.concatenate([points, weights[..., None]], -1)
                    return nurbs.Spline.create_homogeneous(s.degrees, knots, net, flags)
                return nurbs.Spline(s.degrees, knots, points, weights if s.rational else None, flags)
            except nurbs.NurbsError:
                pass  # the sizes do not suit

    def number(self):
        return float(self.random.normal()) * self.size()

    def vector(self):
        return self.random.normal(size=self.g.dimension) * self.size()

    def matrix(self, n):
        return self.random.normal(size=(n, n)) * self.size()

    def params(self, n):
        domain = np.array(self.g.domain).reshape(-1, 2)
        share = self.random.choice([0, 0.25, 0.6, 1], (n, self.g.axes))
        u = np.clip((1 - share) * domain[:, 0] + share * domain[:, 1], domain[:, 0], domain[:, 1])
        return u[:, 0] if self.g.axes == 1 else u

    def param(self):
        return np.atleast_1d(self.params(1)[0])

    def tolerance(self):
        return float(self.random.choice([0, 1e-6, 1e-300, 1e300, np.inf]))

    def index(self):
        return int(self.random.integers(self.g.point_count))

    def along(self):
        return int(self.random.integers(self.g.axes))


# Calls by which new splines are made, and those that ask about one.
MAKE = [
    lambda c: c.g.insert_knot(float(c.param()[0])),
    lambda c: c.g.refine_uniform(2),
    lambda c: c.g.split(float(c.param()[0])),
    lambda c: list(c.g.decompose()),
    lambda c: c.g.clamp(),
    lambda c: c.g.move_seam(float(c.param()[0])),
    lambda c: nurbs.make_compatible([c.g, c.h], tolerance=0.7, flags=nurbs.NURBS_MAP_DOMAINS),
    lambda c: c.g.snap_knots(0.9),
    lambda c: c.g.extend(abs(c.number()), 2),
    lambda c: c.g.unclamp(),
    lambda c: c.g.make_periodic(c.tolerance(), axis=c.along()),
    lambda c: c.g.elevate(1, axis=c.along()),
    lambda c: c.g.reverse(),
    lambda c: c.g.reparametrize(c.number(), c.number()),
    lambda c: c.g.normalize_weights(),
    lambda c: c.g.to_homogeneous().from_homogeneous(),
    lambda c: c.g.reparametrize_moebius(abs(c.number())),
    lambda c: c.g.equalize_end_weights(),
    lambda c: c.g.derivative(1, axis=c.along()),
    lambda c: c.g.antiderivative(),
    lambda c: c.g.product(c.g),
    lambda c: c.g.sum(c.g, c.number(), c.number()),
    lambda c: c.g.remove_knot(float(c.random.choice(c.g.knots[0])), tolerance=c.tolerance()),
    lambda c: c.g.reduce_knots(c.tolerance()),
    lambda c: c.g.reduce_degree(1, axis=c.along()),
    lambda c: c.g.simplify(c.tolerance()),
    lambda c: c.g.transform(c.matrix(c.g.dimension), c.vector()),
    lambda c: c.g.transform_projective(c.matrix(c.g.dimension + 1)),
    lambda c: c.g.mirror(c.vector(), c.vector()),
    lambda c: c.g.project_to_plane(c.vector(), c.vector(), c.vector()),
    lambda c: c.g.project_from(c.vector(), c.vector(), c.vector()),
    lambda c: c.g.extrude(c.vector()),
    lambda c: c.g.revolve(2.0, c.vector()),
    lambda c: c.g.ruled(c.h),
    lambda c: c.g.tensor_sum(c.h, c.number(), c.number()),
    lambda c: c.g.tensor_product(c.h),
    lambda c: list(c.g.boundaries()),
    lambda c: nurbs.coons([c.g, c.h, c.g, c.h], np.inf),
    lambda c: c.g.pull_weight(c.index(), c.param(), c.number()),
    lambda c: c.g.set_weights([0], [c.size()]),
    lambda c: c.g.weight_through(0, c.param(), c.vector(), 1e308),
    lambda c: c.g.pull_point(c.index(), c.param(), c.vector(), c.number()),
    lambda c: c.g.insert_on_leg(c.index(), 0.4),
    lambda c: c.g.insert_at_point(c.vector(), 1e308),
    lambda c: c.g.constrain(c.params(2), np.array([c.vector(), c.vector()])),
    lambda c: c.g.warp(c.vector(), c.number(), 2),
    lambda c: c.g.flatten(c.vector(), c.vector()),
    lambda c: c.g.fair(c.tolerance(), 2),
    lambda c: c.g.snap_boundary((0, 1), c.h, (0, 0), 1),
]
ASK = [
    lambda c: c.g(c.params(3)),
    lambda c: c.g.eval_derivs(c.params(3), 3),
    lambda c: c.g.iso(c.along(), float(c.param()[0])),
    lambda c: c.g.to_hermite(),
    lambda c: c.g.to_power(),
    lambda c: c.g.continuity(),
    lambda c: c.g.continuity_between(1, c.h, 0),
    lambda c: c.g.detect_periodic(),
    lambda c: c.g.deviation(c.g.make_rational()),
    lambda c: c.g.recognize(c.tolerance()),
    lambda c: c.g.closest_points([c.vector()], budget=BUDGET),
    lambda c: c.g.farthest_points([c.vector()], budget=BUDGET),
    lambda c: c.g.closest_local([c.vector()], c.params(1)),
    lambda c: c.g.closest_all(c.vector(), tolerance=c.tolerance(), budget=BUDGET),
    lambda c: c.g.critical_points(c.vector(), tolerance=c.tolerance(), budget=BUDGET),
    lambda c: c.g.signed_distances([c.vector()], budget=BUDGET),
    lambda c: c.g.distance(c.h, c.tolerance(), budget=BUDGET),
    lambda c: c.g.hausdorff_distance(c.h, c.tolerance(), budget=BUDGET),
    lambda c: c.g.length(1e-3),
    lambda c: c.g.lengths(c.params(3), 1e-3),
    lambda c: c.g.area(1e-3),
    lambda c: nurbs.enclosed_area([c.g], 1e308, 1e-3),
    lambda c: c.g.box(c.tolerance()),
    lambda c: c.g.oriented_box(c.tolerance()),
    lambda c: c.g.tangent_cone(c.tolerance()),
    lambda c: c.g.normal_cone(c.tolerance()),
    lambda c: c.g.extreme_point(c.vector(), c.tolerance()),
    lambda c: c.g.features(),
    lambda c: c.g.extrema(),
    lambda c: c.g.mesh_curve(abs(c.number()), 0.5, c.tolerance(), work=1 << 20),
    lambda c: c.g.mesh_volume(c.tolerance(), 0.1, limit=50),
    lambda c: c.g.bezier_cells(),
    lambda c: c.g.bezier_cell_points(),
    lambda c: c.g.fold_pieces(),
    lambda c: c.g.roots(0, c.tolerance()),
    lambda c: c.g.curve_level(1, [1] * (c.g.dimension + 1), c.tolerance()),
    lambda c: c.g.curve_intersections(c.h, c.tolerance()),
    lambda c: c.g.self_intersections(c.tolerance()),
    lambda c: c.g.surface_intersections(c.h, c.tolerance()),
    lambda c: c.g.meet(c.h, abs(c.tolerance()) + 1e-3, work=1 << 24).nodes,
    lambda c: c.g.common_points(c.h, c.g, abs(c.tolerance()) + 1e-3, work=1 << 22),
    lambda c: c.g.project_curve(c.h, c.random.normal(size=3), abs(c.tolerance()) + 1e-3, work=1 << 24).nodes,
    lambda c: c.g.project_curve(c.h, None, abs(c.tolerance()) + 1e-3, work=1 << 24).nodes,
    lambda c: c.g.rays(c.random.normal(size=3), c.random.normal(size=3)),
    lambda c: c.g.sections(c.random.normal(size=3), c.random.normal(size=2), c.tolerance()).nodes,
    lambda c: c.g.ray_hits(c.random.normal(size=3), c.random.normal(size=3)),
    lambda c: c.g.monotone_pieces(c.vector()),
    lambda c: c.g.convexity(),
    lambda c: c.g.straightness(),
    lambda c: c.g.planarity(),
    lambda c: c.g.boundary_contacts(c.tolerance()),
    lambda c: c.g.fold_test(),
    lambda c: c.g.weight_points(0, c.param()),
    lambda c: c.g.most_influential(c.params(3)),
    lambda c: c.g.rational_collocation(c.params(3)),
    lambda c: c.g.eval_adjoint(c.params(2), np.ones((2, 1, c.g.dimension)), 0),
    lambda c: c.g.eval_adjoint_knots(c.params(2), np.ones((2, 1, c.g.dimension)), 0),
    lambda c: c.g.eval_knot_derivative(1),
    lambda c: c.g.closest_adjoint(np.ones((2, c.g.dimension)), c.params(2)),
    lambda c: c.g.length_adjoint(1e-3),
    lambda c: c.g.surface_frames(c.params(3)),
    lambda c: c.g.surface_curvatures(c.params(3)),
    lambda c: c.g.curve_frames(c.params(3)),
    lambda c: c.g.rotation_minimizing_frames(c.params(1)),
]


class Statuses(unittest.TestCase):
    def setUp(self):
        functions = header.read(TOP).functions
        listed = {function.name: ANYWHERE.union(function.statuses) for function in functions}
        self.counts = {"NURBS_OK": 0}
        real = nurbs._library._result

        def checked(function, *arguments):
            result = real(function, *arguments)
            if function.__name__ in listed and len(listed[function.__name__]) > len(ANYWHERE):
                status = nurbs.status_name(result)
                self.counts[status] = self.counts.get(status, 0) + 1
                self.assertIn(status, listed[function.__name__], f"{function.__name__}: {nurbs.last_error()}")
            return result

        patched = mock.patch.object(nurbs._library, "_result", checked)
        patched.start()
        self.addCleanup(patched.stop)

    def run_one(self, call, case):
        try:
            call(case)
        except (nurbs.NurbsError, ValueError):
            pass  # ValueError: the call is for other numbers of axes or dimensions

    def run_all(self, calls, seeds):
        with np.errstate(all="ignore"):
            for seed in seeds:
                case = Case(seed)
                for number in case.random.choice(len(calls), 12, replace=False):
                    with self.subTest(seed=seed, number=int(number)):
                        self.run_one(calls[number], case)
        self.assertGreater(self.counts["NURBS_OK"], len(seeds))
        self.assertGreater(len(self.counts), 10)

    def test_of_calls_that_make_splines(self):
        self.run_all(MAKE, range(400))

    def test_of_calls_that_ask(self):
        self.run_all(ASK, range(1000, 1300))


if __name__ == "__main__":
    unittest.main()
