// SPDX-License-Identifier: MIT
// Shapes through the C++ wrapper: one known value of each.
#include "expect.hpp"

using namespace libnurbs;

static bool same(const Values &a, const Values &b) {
    return near(a, b, 1e-14);
}

static void lines() {
    EXPECT((line({0, 0}, {2, 4}).eval({0.5}) == Values{1, 2}));
    EXPECT((polyline(2, {0, 0, 1, 0, 1, 1}).eval({1.5}) == Values{1, 0.5}));
    EXPECT((polyline(2, {0, 0, 1, 0, 1, 1}, {0, 2, 3}).eval({1}) == Values{0.5, 0}));
    const Values columns = {0, 1, 1, 0, 0, 1};
    EXPECT((polyline(2, Input(columns, 3, 1, 3)).eval({1.5}) == Values{1, 0.5}));
    EXPECT((polygon({}, 2, 4).eval({0.25}) == Values{0, 2}));
    EXPECT((rounded_rectangle({}, 4, 2, 0).eval({0}) == Values{-2, -1}));
    EXPECT((rounded_rectangle({.origin = {0, 0, 1}}, 4, 2, 0.5).eval({0}) == Values{-1.5, -1, 1}));
    EXPECT(status_of([] { (void)line({0, 0}, {1, 1, 1}); }) == Status::size);
}

static void circles() {
    EXPECT((circle({}, 1).eval({0, 0.25, 1}) == Values{1, 0, 0, 1, 1, 0}));
    EXPECT((circle({.axis = {1, 0, 0}, .x = {0, 3, 0}}, 1).eval({0.25}) == Values{0, 0, 1}));
    EXPECT(circle({}, 1, arc_thirds).count(0) == 7 && circle({}, 1, arc_smooth).count(0) == 6);
    EXPECT((arc({}, 1, 0, pi / 2).eval({1}) == Values{0, 1}));
    EXPECT((arc_through({1, 0}, {0, 1}, {-1, 0}).eval({0, 1}) == Values{1, 0, -1, 0}));
    EXPECT(same(arc_tangent({1, 0}, {0, 1}, {-1, 0}).eval({0.5}), {0, 1}));
    EXPECT(status_of([] { (void)circle({}, -1); }) == Status::length);
    EXPECT(status_of([] { (void)circle({}, 1, 7); }) == Status::form);
    EXPECT(status_of([] { (void)arc({}, 1, 0, 7); }) == Status::angle);
    EXPECT(status_of([] { (void)arc_through({0, 0}, {1, 1}, {2, 2}); }) == Status::collinear);
    EXPECT(status_of([] { (void)circle({.origin = {0, 0}, .axis = {0, 0, 1}}, 1); }) == Status::size);
}

static void conics() {
    EXPECT((ellipse({}, 2, 1).eval({0.25}) == Values{0, 1}));
    EXPECT((parabola({}, 1, -2, 2).eval({2}) == Values{1, 2}));
    EXPECT(same(hyperbola({}, 1, 2, 0, 1).eval({1}), {std::cosh(1), 2 * std::sinh(1)}));
    EXPECT(same(conic_shoulder({0, 0}, {1, 1}, {2, 0}, {1, -1}, 0.5).eval({0.5}), {1, 0.5}));
    const auto half = conic_point({-1, 0}, {0, 1}, {1, 0}, {0, 1}, {0, 1}).eval({0.2});
    EXPECT(std::abs(std::hypot(half[0], half[1]) - 1) <= 1e-14);
    const auto five = conic_through(2, circle({}, 1).eval({0, 0.1, 0.2, 0.3, 0.4})).eval({0.3});
    EXPECT(std::abs(std::hypot(five[0], five[1]) - 1) <= 1e-12);
    EXPECT(same(conic_focus({0, 0}, {1, 0}, 1, -pi / 2, pi).eval({0.5}), {0.5, 0}));
    const std::array<double, 6> equation = {1, 0, 4, 0, 0, -4};
    const ConicAxes axes = conic_axes(equation);
    EXPECT(axes.type == conic_ellipse && std::abs(axes.sizes[0] - 2) <= 1e-14);
    EXPECT(std::abs(std::abs(conic_implicit(equation, 0, full_turn).eval({0.25})[1]) - 1) <= 1e-14);
    EXPECT(status_of([] { (void)conic_axes({1, 0, 1, 0, 0, 1}); }) == Status::conic);
}

static void shape_factors() {
    EXPECT((conic_triangle({0, 0}, {1, 1}, {2, 0}, 1).eval({0.5}) == Values{1, 0.5}));
    EXPECT((conic_triangle({0, 0}, {1, 1}, {2, 0}, infinity).eval({0.5}) == Values{1, 1}));
    const ShapeFactor found = shape_factor(conic_triangle({0, 0}, {1, 1}, {2, 0}, 4));
    EXPECT(found.factor == 4 && found.type == conic_hyperbola);
}

static void helices() {
    const Helix made = helix({.origin = {0, 0, 1}}, {.pitch = 2, .turns = 3}, 1e-6);
    EXPECT(same(made.spline.eval({0, 3}), {1, 0, 1, 1, 0, 7}) && made.error <= 1e-6);
    EXPECT(same(helix({.origin = {0, 0}}, {.radius = 0, .growth = 1}, 1e-6).spline.eval({1}), {1, 0}));
}

static void from_curves() {
    const Spline a = line({0, 0, 0}, {1, 0, 0}), b = line({0, 1, 0}, {1, 1, 2});
    EXPECT((extrude(a, {0, 2, 0}).eval({0.5, 0.5}) == Values{0.5, 1, 0}));
    EXPECT((revolve(line({1, 0, 0}, {1, 0, 1})).eval({0.25, 0.5}) == Values{0, 1, 0.5}));
    const Spline around = revolve(line({2, 0, 0}, {2, 0, 1}), pi, {1, 0, 0}, {0, 0, 2});
    EXPECT(same(around.eval({1, 0.5}), {0, 0, 0.5}));
    EXPECT((ruled(a, b).eval({0.5, 0.5}) == Values{0.5, 0.5, 0.5}));
    EXPECT((ruled(a, b, ruled_cartesian).eval({0.5, 0.5}) == Values{0.5, 0.5, 0.5}));
    EXPECT((tensor_sum(a, 2, b, 3).eval({0.5, 0.5}) == Values{2.5, 3, 3}));
    EXPECT((tensor_product(line({1}, {3}), line({1, 2}, {1, 4})).eval({0.5, 0.5}) == Values{2, 6}));
    EXPECT((swung(circle({}, 1), line({1, 0}, {2, 1}), 2).eval({0.25, 0.5}) == Values{0, 3, 0.5}));
}

static void patches() {
    EXPECT((plane({2, 0, 0}, {0, 1, 0}, {1, 1, 1}).eval({0.5, 0.5}) == Values{2, 1.5, 1}));
    EXPECT((bilinear(1, {0, 1, 2, 5}).eval({0.5, 0.5}) == Values{2}));
    EXPECT((trilinear(1, {0, 1, 2, 3, 4, 5, 6, 7}).eval({0.5, 0.5, 0.5}) == Values{3.5}));
    EXPECT(status_of([] { (void)bilinear(3, {0, 1, 2, 5}); }) == Status::size);
}

static void spheres() {
    EXPECT(same(sphere({.origin = {1, 0, 0}}, 2).eval({0.25, 0.5}), {1, 2, 0}));
    EXPECT(same(spherical_patch({}, 1, 0, pi / 2, 0, pi / 2).eval({1, 0}), {0, 1, 0}));
    EXPECT(sphere_patches({}, 1).name(4) == "+Z" && sphere_patches({}, 1, hemisphere).size() == 5);
    EXPECT(same(ellipsoid({}, {1, 2, 3}).eval({0.25, 0.5}), {0, 2, 0}));
    EXPECT(status_of([] { (void)sphere({.origin = {0, 0}}, 1); }) == Status::size);
}

static void quadrics() {
    EXPECT(same(cylinder({}, 2, 3).eval({0.25, 1}), {0, 2, 3}));
    EXPECT(same(cone({}, 1, 0, 2).eval({0.25, 0.5}), {0, 0.5, 1}));
    EXPECT(same(torus({}, 2, 0.5).eval({0.25, 0.5}), {0, 1.5, 0}));
    EXPECT(same(paraboloid({}, {1, 1}, 1).eval({0.25, 0.5}), {0, 0.5, 0.25}));
    EXPECT(same(saddle({}, {1, 1}, 1).eval({1, 0.5}), {1, 0, 1}));
    const auto one = hyperboloid({}, {1, 1, 1}, -1, 1).eval({0.3, 0.7});
    EXPECT(same({one[0] * one[0] + one[1] * one[1] - one[2] * one[2]}, {1}));
    const auto two =
        hyperboloid({}, {1, 1, 1}, 1, 2, 0, full_turn, arc_quarters, two_sheets).eval({0.3, 0.7});
    EXPECT(same({two[2] * two[2] - two[0] * two[0] - two[1] * two[1]}, {1}));
}

// The boundaries of z = u v over the unit square, and the derivatives across them.
static FourCurves around(const Spline &patch) {
    const List list = boundaries(patch);
    return {list[0], list[1], list[2], list[3]};
}
static FourCurves across(const Spline &patch) {
    const Spline u = derivative(patch, 0), v = derivative(patch, 1);
    return {u.iso(0, 0), u.iso(0, 1), v.iso(1, 0), v.iso(1, 1)};
}

static void coons_surfaces() {
    const Spline patch = bilinear(3, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});
    FourCurves curves = around(patch), cross = across(patch);
    const Values expected = {0.25, 0.5, 0.125};
    EXPECT(boundaries(patch).name(3) == "1+" && coons(curves).eval({0.25, 0.5}) == expected);
    EXPECT(same(coons_hermite(curves, {}, twist_bilinear).spline.eval({0.25, 0.5}), expected));
    const auto made = coons_hermite(curves, cross, twist_compatible);
    EXPECT(same(made.spline.eval({0.25, 0.5}), expected) && made.bound == 0);
    const Values twists = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    EXPECT(same(coons_hermite(curves, cross, twist_given, 0, twists).spline.eval({0.25, 0.5}), expected));
    EXPECT(status_of([&] { (void)coons_hermite(curves, cross, 9); }) == Status::twist_rule);
    cross[0] = line({2, 0, 0}, {2, 0, 1});
    EXPECT(status_of([&] { (void)coons_hermite(curves, cross, twist_average); }) == Status::tangent);
    EXPECT(coons_gaps(curves, cross).tangents[0][0] == 1 && coons_gaps(curves).positions[1] == 0);
    curves[3] = line({0, 1, 3}, {1, 1, 1});
    EXPECT(coons_gaps(curves).positions[1] == 3);
    EXPECT(status_of([&] { (void)coons(curves, 1); }) == Status::gap);
}

static void coons_volumes() {
    const List list =
        boundaries(trilinear(3, {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1}));
    const SixFaces faces = {list[0], list[1], list[2], list[3], list[4], list[5]};
    EXPECT((coons_volume(faces).eval({0.25, 0.5, 0.75}) == Values{0.25, 0.5, 0.75}));
}

static void recognition() {
    const Recognized found = recognize(circle({.origin = {1, 1}}, 2), 1e-9);
    EXPECT(found.shape == shape_circle && found.axis[2] == 1 && found.deviation <= 1e-9);
    EXPECT(same({found.origin[0], found.origin[1], found.sizes[0]}, {1, 1, 2}));
    const Spline curve = Spline::create_bezier({3}, 2, {0, 0, 1, 2, 2, -2, 3, 0});
    EXPECT(recognize(curve, 1e-3).shape == shape_none);
}

int main() {
    lines();
    circles();
    conics();
    shape_factors();
    helices();
    from_curves();
    patches();
    spheres();
    quadrics();
    coons_surfaces();
    coons_volumes();
    recognition();
    return failures == 0 ? 0 : 1;
}
