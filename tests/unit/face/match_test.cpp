// Curves that run along each other: bounds of their distance hold, and are as small as the tolerance asks for, whatever their
// parameters, directions and knots.
#include "base/numbers.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "face/deviation.h"
#include "face/made/along_feet.h"
#include "numeric/norm.h"
#include "refine/compose/compose.h"
#include "refine/forms/parametrization.h"
#include "spline/part.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace match_test {

using namespace nrb;
using support::Random;

namespace {

SplinePtr curve_of(int degree, std::vector<double> knots, int dim, std::vector<double> points,
                   std::vector<double> weights = {}) {
    const Form form = weights.empty() ? Form::polynomial : Form::rational;
    return make_spline({make_knot_vector(degree, std::move(knots))}, dim, form, std::move(points),
                       std::move(weights));
}

// An arc in space that does not come near itself.
SplinePtr any_curve(Random &random) {
    std::vector<double> points, weights;
    for (int i = 0; i < 6; ++i) {
        points.insert(points.end(),
                      {i + random.between(-0.2, 0.2), random.between(-0.7, 0.7), random.between(-0.7, 0.7)});
        weights.push_back(random.between(0.7, 1.4));
    }
    return curve_of(3, {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1}, 3, points,
                    random.chance(50) ? weights : std::vector<double>{});
}

// The same at another speed, from start to end.
SplinePtr respaced(Random &random, const SplinePtr &curve) {
    const double a = random.between(0.1, 0.5), b = random.between(0.5, 0.9);
    return refine::compose(curve, curve_of(3, {2, 2, 2, 2, 5, 5, 5, 5}, 1, {0, a, b, 1}));
}

SplinePtr moved(const SplinePtr &curve, double by) {
    std::vector<double> points(curve->points().begin(), curve->points().end());
    for (size_t i = 2; i < points.size(); i += 3) {
        points[i] += by;
    }
    return make_spline({make_knot_vector(curve->axis(0).degree(),
                                         {curve->axis(0).knots().begin(), curve->axis(0).knots().end()})},
                       3, curve->form(), std::move(points),
                       {curve->weights().begin(), curve->weights().end()});
}

double seen_from(const Spline &a, const Spline &b) {
    double most = 0;
    for (int i = 0; i <= 40; ++i) {
        const std::vector<double> x = eval::curve_point(a, parameter_in(a.axis(0).domain(), i / 40.0), false);
        most = std::max(most, closest::locator_of(b)
                                  .nearest({x.data(), nullptr, 1e-12, closest::usual_budget(b), false, true})
                                  .distance);
    }
    return most;
}

} // namespace

TEST(Match, OneCurveAtTwoSpeeds) {
    support::for_each_case(1, 40, [](Random &random, uint64_t seed) {
        const SplinePtr curve = any_curve(random), again = respaced(random, curve);
        const double tolerance = random.magnitude(1e-9, 1e-3);
        for (const auto &[a, b] : {std::pair{curve, again}, std::pair{again, curve}}) {
            EXPECT_LE(face::distance_along_feet(a, b, tolerance), tolerance) << seed;
        }
        const SplinePtr back = refine::reverse(*again, 0, false);
        const auto match = face::match_within(curve, back, tolerance);
        ASSERT_TRUE(match) << seed;
        EXPECT_TRUE(match->against) << seed;
        EXPECT_LE(match->distance, tolerance) << seed;
    });
}

TEST(Match, TheDistanceDecides) {
    support::for_each_case(1, 40, [](Random &random, uint64_t seed) {
        const SplinePtr curve = any_curve(random), again = respaced(random, curve);
        const double tolerance = random.magnitude(1e-7, 1e-3);
        const SplinePtr near = moved(again, 0.9 * tolerance), far = moved(again, 1.1 * tolerance);
        const auto match = face::match_within(curve, near, tolerance);
        ASSERT_TRUE(match) << seed;
        EXPECT_FALSE(match->against) << seed;
        EXPECT_LE(match->distance, tolerance) << seed;
        EXPECT_GE(match->distance, (1 - 1e-6) * std::max(seen_from(*curve, *near), seen_from(*near, *curve)))
            << seed;
        EXPECT_FALSE(face::match_within(curve, far, tolerance)) << seed;
        EXPECT_GE(face::distance_along_feet(curve, far, tolerance), (1 - 1e-6) * seen_from(*curve, *far))
            << seed;
    });
}

// A circle from its start on, once each way round.
TEST(Match, ClosedCurvesHaveADirection) {
    const double w = std::sqrt(0.5);
    const SplinePtr circle =
        curve_of(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, 3,
                 {1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0, -1, 0, 0, -1, -1, 0, 0, -1, 0, 1, -1, 0, 1, 0, 0},
                 {1, w, 1, w, 1, w, 1, w, 1});
    const SplinePtr slow = refine::compose(circle, curve_of(2, {0, 0, 0, 1, 1, 1}, 1, {0, 1.5, 4}));
    for (const bool against : {false, true}) {
        const auto match =
            face::match_within(circle, against ? refine::reverse(*slow, 0, false) : slow, 1e-7);
        ASSERT_TRUE(match);
        EXPECT_EQ(match->against, against);
        EXPECT_LE(match->distance, 1e-7);
    }
}

} // namespace match_test
