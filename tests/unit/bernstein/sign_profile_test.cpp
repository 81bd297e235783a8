// SPDX-License-Identifier: MIT
// Signs as far as uncertain coefficients tell them.
#include "bernstein/sign_profile.h"

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
