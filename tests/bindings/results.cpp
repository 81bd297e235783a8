// SPDX-License-Identifier: MIT
// The C++ wrapper without exceptions: what holds a value, what holds an error, and that nothing is called
// after one.
#include "expect.hpp"

#include <string>
#include <type_traits>
#include <utility>

using namespace libnurbs;

// In throwing.cpp, which is compiled with exceptions and linked with this file.
bool other_files_throw();

static_assert(std::is_same_v<decltype(circle({}, 1)), Result<Spline>>);
static_assert(std::is_same_v<decltype(Spline().eval({0})), Result<Values>>);

static Spline unit_circle() {
    return circle({}, 1).value();
}

static void values() {
    const Result<Spline> made = circle({}, 1);
    EXPECT(made && made.has_value() && made.status() == Status::ok);
    EXPECT(made->count(0).value() == 9 && *made->axes() == 1);
    const Result<Spline> finer = made->insert_knot(0, 0.3, 2);
    EXPECT(*finer->count(0) == 11 && near(*finer->eval({0.25}), {0, 1}));
    const auto [lower, upper] = *unit_circle().split(0, 0.5);
    EXPECT(near(*lower.eval({0.5}), *upper.eval({0.5})));
    EXPECT(near({length(unit_circle())->value}, {2 * pi}));
    EXPECT(closest_points(unit_circle(), {3, 4})->status[0] == closest_certified);
    EXPECT(near(surface_frames(*plane({1, 0, 0}, {0, 1, 0}), {0.5, 0.5})->normals, {0, 0, 1}));
    EXPECT(*decompose(unit_circle())->size() == 4 && *unit_circle().clone()->point_count() == 9);
    EXPECT(knots_open_uniform(1, 2).value() == (Values{0, 0, 1, 1}));
    EXPECT(rational_collocation(unit_circle(), {0})->columns.size() == 3);
    std::vector<double> points(4);
    const Result<void> filled = unit_circle().eval({0, 0.5}, points);
    EXPECT(filled && filled.has_value() && filled.status() == Status::ok && near(points, {1, 0, -1, 0}));
}

static void errors() {
    const Result<Spline> none = circle({}, -1);
    EXPECT(!none && none.status() == Status::length && none.error().status() == Status::length);
    EXPECT(std::string(none.error().name()) == "NURBS_ERROR_LENGTH");
    EXPECT(none->get() == nullptr && none->axes().status() == Status::null);
    const auto outside = unit_circle().eval({0.5, 2});
    EXPECT(std::string(outside.error().what()) == "params[1] = 2 outside [0, 1]");
    EXPECT(circle({}, -1).value_or(unit_circle()).get() != nullptr);
    EXPECT(unit_circle().eval({2}).value_or({7}) == Values{7});
    EXPECT(List::read_file("/no/such/file").status() == Status::file);
    EXPECT(divide(unit_circle(), 0).status() == Status::count);
    // A failure ends with the call that it belongs to.
    EXPECT(circle({}, 1) && unit_circle().eval({0.5}));
}

// A failure in the middle of a call leaves out the rest of it: nothing is read or written through arrays that
// do not suit.
static void calls_that_stop() {
    std::vector<double> points(3, 7.0);
    EXPECT(unit_circle().eval({0, 0.5}, points).status() == Status::size);
    EXPECT(points == (Values{7, 7, 7}));
    EXPECT(unit_circle().eval(Input(points, 9, 2)).status() == Status::size);
    EXPECT(Spline::create({2}, {9}, {0, 1}, 2, {0, 0}).status() == Status::size);
    EXPECT(closest_points(unit_circle(), {1, 2, 3}).status() == Status::size);
    EXPECT(closest_points(Spline(), {1, 2}).status() == Status::null);
    EXPECT(warp(unit_circle(), {0, 1, 2}, 1, 1).status() == Status::size);
    EXPECT(line({0, 0}, {1, 1, 1}).status() == Status::size);
    EXPECT(features(Spline(), feature_inflection).status() == Status::null);
    EXPECT(surface_frames(unit_circle(), {0.5}).status() == Status::size);
    EXPECT(moments(Spline()).status() == Status::null && box(Spline(), 0).status() == Status::null);
    EXPECT(Spline().transform(1, {1}).status() == Status::null);
    EXPECT(Spline().transform_projective(1, {1}).status() == Status::null);
    // The first failure is the one that is told.
    EXPECT(std::string(mirror(unit_circle(), {0}, {0}).error().what()) ==
           "vector holds 1 values, expected 2");
}

static void handles() {
    Spline a = unit_circle();
    const Spline b = a;
    Spline c = std::move(a);
    c = b;
    EXPECT(*c.point_count() == 9 && a.get() == nullptr);
}

int main() {
    values();
    errors();
    calls_that_stop();
    handles();
    EXPECT(other_files_throw());
    return failures == 0 ? 0 : 1;
}
