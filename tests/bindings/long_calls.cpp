// SPDX-License-Identifier: MIT
// Long calls of the C++ wrapper: progress, exceptions of the callback, limits of work.
#include "expect.hpp"

#include <stdexcept>
#include <string>

using libnurbs::CallOptions;
using libnurbs::Spline;

// A curve that runs to and fro, so that its length takes a while.
static Spline winding(std::int64_t count) {
    std::vector<double> points, knots = libnurbs::knots_open_uniform(3, count, 0, 1);
    for (std::int64_t i = 0; i < count; ++i) {
        points.push_back(std::sin(static_cast<double>(i * i)));
        points.push_back(std::cos(static_cast<double>(3 * i * i)));
    }
    return Spline::create({3}, {count}, knots, 2, points);
}

static void progress(const Spline &curve) {
    const double alone = libnurbs::length(curve, 1e-9).value;
    double last = 0;
    int calls = 0;
    CallOptions call;
    call.progress = [&](double done) {
        EXPECT(done >= last && done <= 1);
        last = done;
        ++calls;
        return true;
    };
    EXPECT(libnurbs::length(curve, 1e-9, {}, call).value == alone);
    EXPECT(calls > 0);
}

static void ends(const Spline &curve) {
    CallOptions call;
    call.progress = [](double) { return false; };
    EXPECT(status_of([&] { libnurbs::length(curve, 1e-9, {}, call); }) == libnurbs::Status::cancelled);
    call.progress = [](double) -> bool { throw std::runtime_error("own"); };
    bool thrown = false;
    try {
        libnurbs::length(curve, 1e-9, {}, call);
    } catch (const std::runtime_error &error) {
        thrown = std::string(error.what()) == "own";
    }
    EXPECT(thrown);
    call = {};
    call.work = 1;
    EXPECT(status_of([&] { libnurbs::length(curve, 1e-9, {}, call); }) == libnurbs::Status::work);
    EXPECT(libnurbs::length(curve, 1e-9).value > 0);
}

// The watched form of each function gives what the plain one gives.
static void curves(const CallOptions &call) {
    using namespace libnurbs;
    const Spline g = winding(40), map = Spline::create_bezier({1}, 1, {0, 1});
    EXPECT(product(g, g, product_dot, call).points() == product(g, g, product_dot).points());
    EXPECT(compose(g, map, call).points() == compose(g, map).points());
    EXPECT(reduce_knots(g, 0, 0.1, call).bound == reduce_knots(g, 0, 0.1).bound);
    EXPECT(reduce_degree(g, 0, 1, call).bound == reduce_degree(g, 0, 1).bound);
    EXPECT(simplify(g, 0.1, call).bound == simplify(g, 0.1).bound);
    EXPECT(features(g, feature_inflection, call).params == features(g, feature_inflection).params);
    EXPECT(lengths(g, {0.3, 0.7}, 0, call) == lengths(g, {0.3, 0.7}));
    EXPECT(params_at_lengths(g, {0.3, 0.7}, 0, 0, call) == params_at_lengths(g, {0.3, 0.7}));
    EXPECT(divide(g, 5, 0, 0, {}, call).params == divide(g, 5).params);
    EXPECT(moments(g, 1e-6, call).content == moments(g, 1e-6).content);
    EXPECT(fair(g, 2, 0.1, {}, call).bound == fair(g, 2, 0.1).bound);
    const Constraints wanted{{0.5}, {1, 2}};
    EXPECT(constrain(g, wanted, {}, call).moved == constrain(g, wanted).moved);
    const Bend how{{0, 0}, {1, 0}, {0, 1}, 0.1};
    EXPECT(bend(g, how, 1e-3, call).deviation == bend(g, how, 1e-3).deviation);
}

static void places(const CallOptions &call) {
    using namespace libnurbs;
    const Spline g = winding(40), other = g.transform(2, {1, 0, 0, 1}, {3, 0});
    const Values points{0.3, 0.7, -0.2, 0.5};
    EXPECT(closest_points(g, points, Search{}, call).params == closest_points(g, points).params);
    EXPECT(farthest_points(g, points, Search{}, call).params == farthest_points(g, points).params);
    EXPECT(closest_local(g, points, {0.2, 0.8}, 0, call).params ==
           closest_local(g, points, {0.2, 0.8}).params);
    EXPECT(signed_distances(g, points, Search{}, call).distances == signed_distances(g, points).distances);
    EXPECT(closest_all(g, {0.3, 0.7}, Search{}, call).params == closest_all(g, {0.3, 0.7}).params);
    EXPECT(critical_points(g, {0.3, 0.7}, Search{}, call).params == critical_points(g, {0.3, 0.7}).params);
    EXPECT(distance(g, other, 0, 0, call).at_most == distance(g, other).at_most);
    EXPECT(hausdorff_distance(g, other, 0.1, 0, call).at_most == hausdorff_distance(g, other, 0.1).at_most);
}

static void shapes(const CallOptions &call) {
    using namespace libnurbs;
    const Spline sheet = Spline::create_bezier({1, 1}, 2, {0, 0, 0, 1, 1, 0, 1, 1}), ball = sphere({}, 1);
    const std::vector<Spline> ring{circle({.origin = {0, 0}}, 1)}, shell{ball};
    EXPECT(area(ball, 1e-6, {}, call).value == area(ball, 1e-6).value);
    EXPECT(enclosed_area(ring, 0, 0, call).area == enclosed_area(ring).area);
    EXPECT(enclosed_volume(shell, 0, call).volume == enclosed_volume(shell).volume);
    EXPECT(recognize(ball, 1e-6, call).shape == recognize(ball, 1e-6).shape);
    EXPECT(fold_test(sheet, {}, call).result == fold_test(sheet).result);
    EXPECT(free_form_deform(sheet, sheet, {0, 0}, {1, 1}, 1e-6, call).deviation ==
           free_form_deform(sheet, sheet, {0, 0}, {1, 1}, 1e-6).deviation);
}

static void files(const CallOptions &call) {
    EXPECT(status_of([&] { (void)libnurbs::List::read({}, {}, call); }) != libnurbs::Status::ok);
    EXPECT(status_of([&] { (void)libnurbs::List::read_file("none", {}, call); }) == libnurbs::Status::file);
}

int main() {
    const Spline curve = winding(200000);
    progress(curve);
    ends(curve);
    CallOptions call;
    call.progress = [](double) { return true; };
    curves(call);
    places(call);
    shapes(call);
    files(call);
    return failures == 0 ? 0 : 1;
}
