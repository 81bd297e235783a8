// Signs of coordinates of curves, where they change, and monotony.
#include "refine/compose/crossings.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace crossings_test {

using namespace nrb;
using namespace shapes;
using refine::strictly_monotone;

namespace {

SignProfile profile_of(const SplinePtr &curve, double c, int k = 0) {
    return refine::sign_profile(refine::CurvePiece(*curve, curve->axis(0).degree()), k, c);
}

TEST(Crossings, of_a_line_is_one) {
    const SignProfile profile = profile_of(bezier(1, {0, 1}), 0.25);
    EXPECT_TRUE(profile.below && profile.above);
    EXPECT_EQ(profile.crossings, std::vector<double>{0.25});
}

TEST(Crossings, at_the_ends_are_none) {
    const SignProfile profile = profile_of(bezier(1, {0, 1}), 0);
    EXPECT_TRUE(!profile.below && profile.above && profile.crossings.empty());
}

// (t - 1/4) (t - 1/2) (t - 3/4): the middle one is where the interval is halved.
TEST(Crossings, of_a_cubic_are_three) {
    const std::vector<double> power{-3.0 / 32, 11.0 / 16, -1.5, 1};
    const SplinePtr cubic =
        bezier(1, {power[0], power[0] + power[1] / 3, power[0] + power[1] * 2 / 3 + power[2] / 3,
                   power[0] + power[1] + power[2] + power[3]});
    const SignProfile profile = profile_of(cubic, 0);
    ASSERT_EQ(profile.crossings.size(), 3U);
    EXPECT_NEAR(profile.crossings[0], 0.25, 1e-15);
    EXPECT_NEAR(profile.crossings[1], 0.5, 1e-15);
    EXPECT_NEAR(profile.crossings[2], 0.75, 1e-15);
}

// (t - 0.3)^2 touches 0, (t - 0.3)^3 crosses it once.
TEST(Crossings, of_tangents_are_none_and_of_inflections_one) {
    const SignProfile touching = profile_of(bezier(1, {0.09, -0.21, 0.49}), 0);
    EXPECT_TRUE(touching.above && !touching.below && touching.crossings.empty());
    const SignProfile inflection = profile_of(bezier(1, {-0.027, 0.063, -0.147, 0.343}), 0);
    ASSERT_EQ(inflection.crossings.size(), 1U);
    EXPECT_NEAR(inflection.crossings[0], 0.3, 1e-4); // known to the third root of eps
}

TEST(Crossings, of_a_constant_are_none) {
    const SignProfile profile = profile_of(bezier(2, {0, 5, 1, 5}), 5, 1);
    EXPECT_TRUE(!profile.below && !profile.above && profile.crossings.empty());
}

TEST(Crossings, polar_values_of_a_piece_are_its_coefficients) {
    const SplinePtr f = curve(2, {0, 0, 0, 1, 2, 2, 2}, 1, {0, 2, 4, 6});
    const refine::CurvePiece piece(*f, 2);
    EXPECT_EQ(vector_of(piece.coefficients(0)), (std::vector<double>{0, 2, 3}));
    const refine::Coefficients half = piece.coefficients_between(0, 0, 0.5);
    EXPECT_EQ(half[0], 0);
    EXPECT_EQ(half[1], 1);
    EXPECT_EQ(half[2], 1.75);
}

// Made together where no knot is among the arguments, else one by one: with the same bits.
TEST(Crossings, coefficients_between_are_polar_values_bit_for_bit) {
    for (const int q : {1, 2, 3, 8, 31}) {
        for (const bool rational : {false, true}) {
            std::vector<double> knots, points, weights;
            for (int i = 0; i < 2 * q + 4; ++i) {
                knots.push_back(i + 0.25 * (i % 3));
            }
            for (int i = 0; i < q + 3; ++i) {
                points.push_back(std::sin(i + 1.0));
                weights.push_back(1 + 0.5 * std::cos(i));
            }
            const SplinePtr f =
                make_spline({make_knot_vector(q, knots)}, 1, rational ? Form::rational : Form::polynomial,
                            points, rational ? weights : std::vector<double>());
            const refine::CurvePiece piece(*f, q + 1);
            const double lower = piece.lower(), length = piece.upper() - lower;
            for (const auto &[from, to] : {std::array{0.125, 0.875}, {0.0, 0.5}, {0.3, 1.0}, {0.0, 1.0}}) {
                const double a = lower + from * length, b = to == 1 ? piece.upper() : lower + to * length;
                const refine::Coefficients values = piece.coefficients_between(0, a, b),
                                           factors = piece.weights_between(a, b);
                for (int j = 0; j <= q; ++j) {
                    std::vector<double> arguments(static_cast<size_t>(q), a);
                    std::fill_n(arguments.end() - j, j, b);
                    EXPECT_EQ(values[static_cast<size_t>(j)], piece.polar_value(0, arguments));
                    if (rational) {
                        EXPECT_EQ(factors[static_cast<size_t>(j)], piece.polar_weight(arguments));
                    }
                }
            }
        }
    }
}

TEST(Monotony, is_decided_by_signs) {
    EXPECT_TRUE(strictly_monotone(bezier(1, {0, 1})));
    EXPECT_TRUE(strictly_monotone(bezier(1, {3, 2, -1})));
    EXPECT_TRUE(strictly_monotone(bezier(1, {0, 0.9, 0.1, 1})));   // its control polygon turns, it does not
    EXPECT_TRUE(strictly_monotone(bezier(1, {-1, 1, -1, 1})));     // (2 t - 1)^3 stands still at a point
    EXPECT_FALSE(strictly_monotone(bezier(1, {0, 1.5, -0.5, 1}))); // turns
    EXPECT_FALSE(strictly_monotone(bezier(1, {0, 1, 0})));
    EXPECT_FALSE(strictly_monotone(bezier(1, {1, 1})));
    EXPECT_FALSE(strictly_monotone(curve(0, {0, 1, 2}, 1, {0, 1})));
    EXPECT_FALSE(strictly_monotone(curve(1, {0, 0, 1, 2, 2}, 1, {0, 1, 1}))); // constant behind 1
    EXPECT_TRUE(strictly_monotone(curve(1, {0, 0, 1, 1, 2, 2}, 1, {0, 1, 4, 5})));
    EXPECT_FALSE(strictly_monotone(curve(1, {0, 0, 1, 1, 2, 2}, 1, {0, 1, 0.5, 5}))); // jumps back
}

} // namespace

} // namespace crossings_test
