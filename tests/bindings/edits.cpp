// SPDX-License-Identifier: MIT
// Changes of weights and points, constraints and deformations through the C++ wrapper: one known value of
// each.
#include "expect.hpp"

using namespace libnurbs;

// A parabola with its top (1, 1) in the middle, where R = (1/4, 1/2, 1/4).
static Spline arch() {
    return Spline::create_bezier({2}, 2, {0, 0, 1, 2, 2, 0});
}

static void weight_edits() {
    const WeightEdit one = pull_weight(arch(), 1, {0.5}, 0.5);
    EXPECT(near({one.weight}, {3}) && near(one.spline.eval({0.5}), {1, 1.5}));
    const WeightsEdit two = pull_weights(arch(), {0, 2}, {0.5}, 0.5);
    EXPECT(near({two.factor}, {3}) && near(two.spline.eval({0.5}), {1, 0.5}));
    const Spline heavy = set_weights(arch(), {1, 2}, {3, 1});
    EXPECT(near(heavy.weights(), {1, 3, 1}) && near(heavy.eval({0.5}), {1, 1.5}));
    const WeightPoints points = weight_points(heavy, 1, {0.5});
    EXPECT(near(points.at_zero, {1, 0}) && near(points.at_one, {1, 1}) && near(points.at_weight, {1, 1.5}));
    EXPECT(near({weight_cross_ratio({1, 2}, points.at_zero, points.at_one, points.at_weight)}, {3}));
    EXPECT(near({weight_through(arch(), 1, {0.5}, {1, 1.5}, 1e-9).weight}, {3}));
    EXPECT(status_of([] { (void)pull_weight(arch(), 1, {0}, 0.5); }) == Status::influence);
    EXPECT(status_of([] { (void)pull_weight(arch(), 1, {0.5}, -1); }) == Status::weight_sign);
    EXPECT(status_of([] { (void)pull_weight(arch(), 1, {0.5, 0.5}, 1); }) == Status::size);
    EXPECT(status_of([] { (void)set_weights(arch(), {1}, {1, 2}); }) == Status::size);
    EXPECT(status_of([] { (void)weight_cross_ratio({0}, {0}, {1}, {2}); }) == Status::collinear);
}

static void point_edits() {
    const PointEdit pulled = pull_point(arch(), 1, {0.5}, {0, 2}, 0.5);
    EXPECT(near({pulled.moved}, {1}) && near(pulled.spline.points(), {0, 0, 1, 3, 2, 0}));
    const Influences most = most_influential(arch(), {0.5, 0});
    EXPECT((most.indices == std::vector<std::int64_t>{1, 0}) && near(most.influences, {0.5, 1}));
    const LegEdit leg = insert_on_leg(arch(), 0, 0, 0.5);
    EXPECT(near({leg.knot}, {0.5}) && near(leg.spline.points(), {0, 0, 0.5, 1, 1.5, 1, 2, 0}));
    const LegEdit found = insert_at_point(arch().reparametrize(0, 0, 2), 0, {1.25, 1.5}, 1e-9);
    EXPECT(found.index == 1 && near({found.ratio, found.knot}, {0.25, 0.5}));
    EXPECT(near(found.spline.points(), {0, 0, 0.25, 0.5, 1.25, 1.5, 2, 0}));
    EXPECT(status_of([] { (void)insert_at_point(arch(), 0, {5, 5}, 0.1); }) == Status::off_polygon);
}

static void constraints() {
    const Constrained free = constrain(arch(), {.params = {0.5}, .targets = {1, 2}});
    EXPECT(near(free.spline.points(), {0, 2.0 / 3, 1, 10.0 / 3, 2, 2.0 / 3}));
    EXPECT(near({free.moved, free.residuals[0]}, {4.0 / 3, 0}) && free.optimality <= 1e-9);
    const Values held = {0, 0, 1, 4, 2, 0};
    const Constraints top{.params = {0.5}, .targets = {1, 2}};
    EXPECT(near(constrain(arch(), top, {.keep = {0, 0}}).spline.points(), held));
    EXPECT(near(constrain(arch(), top, {.costs = {infinity, 1, infinity}}).spline.points(), held));
    const Constrained turned = constrain(arch(), {.params = {0.5, 0.5},
                                                  .targets = {1, 1, 1, 1},
                                                  .kinds = {constrain_value, constrain_direction},
                                                  .orders = {0, 1}});
    const Values at = turned.spline.eval_derivs(1, {0.5});
    EXPECT(near({at[0], at[1], at[2] - at[3]}, {1, 1, 0}) && turned.residuals.size() == 2);
    const Constrained weighed = constrain(arch(), {.params = {0.5}, .targets = {1, 1.5}},
                                          {.costs = {infinity, infinity, infinity},
                                           .weight_costs = {infinity, 1, infinity},
                                           .tolerance = 1e-9});
    EXPECT(near(weighed.spline.weights(), {1, 3, 1}, 1e-7));
    const Constraints both{.params = {0.5, 0.5}, .targets = {1, 1, 1, 2}};
    EXPECT(status_of([&] { (void)constrain(arch(), both); }) == Status::contradiction);
    const Constraints odd{.params = {0.5}, .targets = {1, 1}, .kinds = {7}};
    EXPECT(status_of([&] { (void)constrain(arch(), odd); }) == Status::constraint);
    EXPECT(status_of([] { (void)constrain(arch(), {.params = {0.5}, .targets = {1}}); }) == Status::size);
}

static void regions() {
    EXPECT(near(warp(arch(), {0, 1}, 0.5, 1).eval({0, 0.5, 1}), {0, 0, 1, 1.5, 2, 0}));
    const Values before = arch().eval({0.25, 0.75});
    EXPECT(near(warp(arch(), {0, 1}, 0.5, 0, {0.5, 1}).eval({0.25, 0.75}),
                {before[0], before[1], before[2], before[3] + 0.5}));
    EXPECT(status_of([] { (void)warp(arch(), {0, 0}, 1, 1); }) == Status::direction);
    const PointEdit flat = flatten(arch(), {0, 1}, {0, 1});
    EXPECT(near(flat.spline.points(), {0, 1, 1, 1, 2, 1}) && near({flat.moved}, {1}));
    EXPECT(near(flatten(arch(), {0, 1}, {0, 1}, {1, 1}).spline.points(), {1, 1, 0, 1, 3, 1}));
}

static void deformations() {
    const Spline bar = line({0, 0}, {1, 0});
    const Bend how{.origin = {0, 0}, .along = {1, 0}, .across = {0, 1}, .curvature = 1};
    const Deformed bent = bend(bar, how, 1e-6);
    EXPECT(near(bent.spline.eval({1}), {std::sin(1), std::cos(1) - 1}, 1e-6) && bent.deviation <= 1e-6);
    const Spline doubled = bilinear(2, {0, 0, 0, 2, 2, 0, 2, 2});
    const Deformed mapped = free_form_deform(line({0, 0}, {1, 1}), doubled, {0, 0}, {1, 1}, 1e-9);
    EXPECT(near(mapped.spline.eval({0.5}), {1, 1}, 1e-9));
    const Spline wave = Spline::create_bezier({3}, 2, {0, 0, 1, 1, 2, -1, 3, 0});
    const Faired smooth = fair(wave, 2, 10);
    EXPECT(near(smooth.spline.eval({0, 0.5, 1}), {0, 0, 1.5, 0, 3, 0}, 1e-9));
    EXPECT(smooth.energies[1] < 1e-9 && smooth.energies[0] > 1e-9 && smooth.bound <= 10);
    EXPECT(near(fair(wave, 2, 10, {1, 1}).spline.points(), wave.points(), 1e-9));
    EXPECT(status_of([&] { (void)fair(wave, 2, -1); }) == Status::tolerance);
    const Reduced snapped = snap_boundary(bar, {0, end_of_axis}, line({2, 2}, {3, 3}), {0, start_of_axis});
    EXPECT(near(snapped.spline.eval({0, 1}), {0, 0, 2, 2}) && snapped.bound >= std::sqrt(5));
}

int main() {
    weight_edits();
    point_edits();
    constraints();
    regions();
    deformations();
    return failures == 0 ? 0 : 1;
}
