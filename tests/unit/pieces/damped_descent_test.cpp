// SPDX-License-Identifier: MIT
#include "pieces/damped_descent.h"

#include <gtest/gtest.h>

namespace damped_descent_test {

using namespace nrb::pieces;

namespace {

using Vector = std::array<double, 2>;

// S = (u - a, v - b, u^2 / 2).
SquareJet<2> jet_of(const Vector &at, double a, double b) {
    const double x = at[0] - a, y = at[1] - b, z = at[0] * at[0] / 2;
    SquareJet<2> jet;
    jet.square = x * x + y * y + z * z;
    jet.gradient = {x + z * at[0], y};
    jet.metric = {{{1 + at[0] * at[0], 0}, {0, 1}}};
    jet.curvature = {{{z, 0}, {0, 0}}};
    return jet;
}

Descent descend(double a, double b, double sign, Vector &at) {
    const auto jet = [&](const Vector &place) { return jet_of(place, a, b); };
    const ParameterBox<2> box;
    return DampedDescent<2, decltype(jet)>(2, box, sign, 0, jet).run(at, 60);
}

} // namespace

TEST(DampedDescent, finds_the_minimum_inside) {
    Vector at{0.9, 0.1};
    const Descent found = descend(0.5, 0.5, 1, at);
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(at[0] + at[0] * at[0] * at[0] / 2, 0.5, 1e-14); // where the gradient is 0
    EXPECT_NEAR(at[1], 0.5, 1e-14);
    EXPECT_EQ(found.distance, std::sqrt(jet_of(at, 0.5, 0.5).square));
}

TEST(DampedDescent, stays_in_the_box) {
    Vector at{0.5, 0.5};
    EXPECT_TRUE(descend(-1, 7, 1, at).converged);
    EXPECT_EQ(at, (Vector{0, 1}));
}

// The matrix is nowhere definite there.
TEST(DampedDescent, finds_maxima_at_corners) {
    Vector at{0.5, 0.6};
    EXPECT_TRUE(descend(0, 0, -1, at).converged);
    EXPECT_EQ(at, (Vector{1, 1}));
}

} // namespace damped_descent_test
