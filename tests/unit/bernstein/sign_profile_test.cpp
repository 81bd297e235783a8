// SPDX-License-Identifier: MIT
// Signs as far as uncertain coefficients tell them.
#include "bernstein/sign_profile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace sign_profile_test {

using namespace nrb;

namespace {

// (t - 1/4) (t - 3/4) over [0, 1].
UncertainNet<3> parabola(double uncertainty) {
    return {2, uncertainty, false, {3.0 / 16, -5.0 / 16, 3.0 / 16}};
}

double value(double t) {
    return (t - 0.25) * (t - 0.75);
}

TEST(SignProfile, crossings_are_found_to_the_last_bit) {
    const SignProfile profile = signs_between(0, 1, parabola(1e-12), value);
    EXPECT_TRUE(profile.below);
    EXPECT_TRUE(profile.above);
    EXPECT_EQ(profile.crossings, (std::vector{0.25, 0.75}));
}

// At neighbouring doubles, whatever the shape of the function between; a straight line is met at once.
TEST(SignProfile, crossings_take_few_evaluations) {
    const UncertainNet<3> rising{1, 1e-12, false, {-1, 1}};
    int evaluations = 0;
    const auto crossing_of = [&](auto function) {
        evaluations = 0;
        const SignProfile profile = signs_between(0, 1, rising, [&](double t) {
            ++evaluations;
            return function(t);
        });
        EXPECT_EQ(profile.crossings.size(), 1U);
        return profile.crossings.empty() ? NAN : profile.crossings.front();
    };
    EXPECT_EQ(crossing_of([](double t) { return t - 0.3; }), 0.3);
    EXPECT_LE(evaluations, 3);
    int most = 0;
    const auto check = [&](auto function, int limit) {
        const double t = crossing_of(function);
        EXPECT_LE(function(std::nextafter(t, 0)), 0);
        EXPECT_GE(function(std::nextafter(t, 1)), 0);
        EXPECT_LE(evaluations, limit);
        most = std::max(most, evaluations);
    };
    for (const double root : {0.3, 0.77, 1e-9, 1 - 1e-9}) {
        check([=](double t) { return (t - root) * (1 + t + t * t); }, 20);
        check([=](double t) { return t * t * t - root * root * root; }, 60);
        check([=](double t) { return std::atan(1e6 * (t - root)); }, 110);
        check([=](double t) { return std::pow(t, 31) - std::pow(root, 31); }, 110);
    }
    EXPECT_GT(most, 20); // some are hard
    // Values at both ends of one sign, as rounding may leave them: halving goes on.
    EXPECT_EQ(crossing_of([](double t) { return t < 1e-3 ? 1e-17 : t - 0.3; }), 0.3);
}

TEST(SignProfile, nothing_is_known_below_the_uncertainty) {
    const SignProfile profile = signs_between(0, 1, parabola(0.5), value);
    EXPECT_FALSE(profile.below);
    EXPECT_FALSE(profile.above);
    EXPECT_TRUE(profile.crossings.empty());
}

TEST(SignProfile, uncertainties_count_times_weights) {
    UncertainNet<3> net = parabola(0.25);
    net.weighted = true;
    net.weights = {1, 2, 0.5};
    EXPECT_EQ(net.sign(0), 0);
    EXPECT_EQ(net.sign(1), 0);
    EXPECT_EQ(net.sign(2), 1);
    const UncertainNet<3> lower = net.take_lower_half();
    EXPECT_EQ(lower.weights, (std::array{1.0, 1.5, 1.375}));
    EXPECT_EQ(net.weights, (std::array{1.375, 1.25, 0.5}));
    EXPECT_EQ(lower.values, (std::array{3.0 / 16, -1.0 / 16, -1.0 / 16}));
}

} // namespace

} // namespace sign_profile_test
