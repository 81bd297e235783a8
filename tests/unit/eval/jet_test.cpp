// Taylor coefficients with error bounds, the bounds that hold everywhere, and the vector helpers.
#include "eval/derivative_errors.h"
#include "eval/frames/jet.h"
#include "reference/magnitudes.h"
#include "support/cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace jet_test {

namespace {

using nrb::Vector3;
using nrb::eval::AxisRules;
using nrb::eval::DerivativeErrors;
using nrb::eval::Jet;
using support::Random;
using support::SplineData;

constexpr double infinity = std::numeric_limits<double>::infinity();

nrb::SplinePtr spline_of(const SplineData &data) {
    nrb::Spline::Axes axes;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        axes.push_back(nrb::make_knot_vector(data.degrees[k], data.knots[k]));
    }
    return nrb::make_spline(std::move(axes), data.dim,
                            data.rational() ? nrb::Form::rational : nrb::Form::polynomial, data.points,
                            data.weights);
}

SplineData random_data(Random &random, int axes) {
    support::Recipe recipe = support::random_recipe(random, axes, axes == 1 ? 7 : 4);
    recipe.dim = 3;
    return support::random_spline(random, recipe);
}

// Coefficient (i, j) times i! j! over the units is the derivative, within the bound.
TEST(Jet, coefficients_are_within_their_bounds) {
    long double worst = 0;
    support::for_each_case(950000, 600, [&](Random &random, uint64_t seed) {
        const SplineData data = random_data(random, random.whole(1, 2));
        const auto spline = spline_of(data);
        const auto param = support::away_from_underflow(support::random_params(random, data, 1));
        const bool left = random.chance(50);
        AxisRules rules;
        rules[0].left = rules[1].left = left;
        Jet jet;
        Jet::prepare(*spline);
        const int order = 3;
        ASSERT_TRUE(jet.evaluate(*spline, rules, param.data(), order));
        const auto exact = reference::exact_derivatives(data, order, param.data(), {left, left, left});
        for (const auto &index : support::graded_indices(data.axes(), order)) {
            const int i = index[0];
            const int j = data.axes() == 2 ? index[1] : 0;
            if (i + j == 0) {
                continue;
            }
            const long double factor = std::tgamma(static_cast<long double>(i + 1)) *
                                       std::tgamma(static_cast<long double>(j + 1)) /
                                       std::pow(static_cast<long double>(jet.side(0) * jet.unit(0)), i) /
                                       std::pow(static_cast<long double>(jet.side(1) * jet.unit(1)), j);
            const Vector3 &x = jet.at(i, j);
            const double coordinates[] = {x.x, x.y, x.z};
            const auto &want = exact[static_cast<size_t>(support::slot_of(index))];
            long double squared = 0;
            for (size_t c = 0; c < 3; ++c) {
                const long double error =
                    coordinates[c] - reference::quotient(want[c].numerator, want[c].denominator) / factor;
                squared += error * error;
            }
            const long double error = std::sqrt(squared);
            worst = std::max(worst, error == 0 ? 0 : error / jet.error(i, j));
            ASSERT_LE(error, jet.error(i, j)) << support::where(seed, data) << "order " << i << " " << j;
        }
    });
    std::printf("jets: largest error %.3Lf of the bound\n", worst);
}

// What the cheap test lets pass is regular by the local bounds too.
TEST(Jet, bounds_that_hold_everywhere_hold_here) {
    support::for_each_case(960000, 1500, [](Random &random, uint64_t seed) {
        const SplineData data = random_data(random, random.whole(1, 2));
        const auto spline = spline_of(data);
        const auto params = support::random_params(random, data, 1);
        Jet jet;
        Jet::prepare(*spline);
        ASSERT_TRUE(jet.evaluate(*spline, {}, params.data(), 2));
        const DerivativeErrors all = nrb::eval::derivative_errors(*spline, {}, 1 << 20);
        const double u = jet.unit(0);
        ASSERT_LE(jet.error(1), all.u * u) << support::where(seed, data);
        ASSERT_LE(2 * jet.error(2), all.uu * u * u) << support::where(seed, data);
        if (data.axes() == 2) {
            const double v = jet.unit(1);
            ASSERT_LE(jet.error(0, 1), all.v * v) << support::where(seed, data);
            ASSERT_LE(jet.error(1, 1), all.uv * u * v) << support::where(seed, data);
            ASSERT_LE(2 * jet.error(0, 2), all.vv * v * v) << support::where(seed, data);
        }
    });
}

TEST(Jet, bounds_that_hold_nowhere_are_infinite) {
    const SplineData data = {{1}, {2}, {{0, 0, 1, 1}}, 3, {0, 0, 0, 1, 1, 1}, {}, 0};
    const SplineData zero = {{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 3, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {1, 0, 1}, 0};
    AxisRules extrapolating;
    extrapolating[0].outside = nrb::eval::Outside::extrapolate;
    EXPECT_LT(nrb::eval::derivative_errors(*spline_of(data), {}, 1).u, infinity);
    EXPECT_EQ(nrb::eval::derivative_errors(*spline_of(data), extrapolating, 1).u, infinity);
    EXPECT_EQ(nrb::eval::derivative_errors(*spline_of(zero), {}, 1).u, infinity);
}

TEST(Jet, sides_point_into_the_domain) {
    const SplineData data = {{1}, {3}, {{0, 0, 1, 2, 2}}, 3, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {}, 0};
    const auto spline = spline_of(data);
    Jet::prepare(*spline);
    AxisRules left;
    left[0].left = true;
    const auto side = [&](double t, const AxisRules &rules) {
        Jet jet;
        EXPECT_TRUE(jet.evaluate(*spline, rules, &t, 1));
        return jet.side(0);
    };
    EXPECT_EQ(side(0, {}), 1);
    EXPECT_EQ(side(1, {}), 1);
    EXPECT_EQ(side(0.5, {}), 1);
    EXPECT_EQ(side(2, {}), -1);
    EXPECT_EQ(side(0, left), 1);
    EXPECT_EQ(side(1, left), -1);
    EXPECT_EQ(side(0.5, left), -1);
    EXPECT_EQ(side(2, left), -1);
}

TEST(Vector3, any_size_has_a_direction) {
    for (const double size : {1e-320, 1e-300, 1e-160, 1.0, 1e160, 1e300}) {
        const Vector3 v = nrb::unit({3 * size, 0, -4 * size});
        EXPECT_NEAR(v.x, 0.6, size < 1e-310 ? 1e-3 : 1e-15);
        EXPECT_NEAR(v.z, -0.8, size < 1e-310 ? 1e-3 : 1e-15);
        EXPECT_NEAR(nrb::length({3 * size, 0, -4 * size}) / size, 5, size < 1e-310 ? 1e-2 : 1e-14);
    }
    EXPECT_TRUE(std::isnan(nrb::unit({0, 0, 0}).x));
}

TEST(Vector3, the_default_normal_is_across_the_smallest_coordinate) {
    const Vector3 t = nrb::unit({2, -1, 2});
    const Vector3 n = nrb::any_normal(t);
    EXPECT_NEAR(nrb::dot(t, n), 0, 1e-16);
    EXPECT_NEAR(nrb::length(n), 1, 1e-15);
    EXPECT_GT(n.y, 0.9);
    EXPECT_EQ(nrb::any_normal({0, 0, 1}).x, 1);
    EXPECT_EQ(nrb::any_normal({1, 0, 0}).y, 1);
}

} // namespace

} // namespace jet_test
