#include "basis/bspline.h"

#include "support/generators.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace bspline_test {

namespace {

TEST(BasisValues, are_exactly_one_where_a_function_is_alone) {
    const std::vector<double> knots{0, 0, 0, 0, 0.3, 0.3, 0.3, 0.7, 0.7, 0.7, 0.7};
    double values[4];
    nrb::basis_values(knots.data(), 3, 3, 0.0, values);
    EXPECT_EQ(std::vector<double>(values, values + 4), (std::vector<double>{1, 0, 0, 0}));
    nrb::basis_values(knots.data(), 3, 6, 0.3, values);
    EXPECT_EQ(std::vector<double>(values, values + 4), (std::vector<double>{1, 0, 0, 0}));
    nrb::basis_values(knots.data(), 3, 6, 0.7, values);
    EXPECT_EQ(std::vector<double>(values, values + 4), (std::vector<double>{0, 0, 0, 1}));
    EXPECT_EQ(nrb::sole_function(knots.data(), 3, 3, 0.0), 0);
    EXPECT_EQ(nrb::sole_function(knots.data(), 3, 3, 0.3), 3);
    EXPECT_EQ(nrb::sole_function(knots.data(), 3, 6, 0.5), -1);
}

// Outside the domain a parameter may equal an outer knot without a function being alone there.
TEST(SoleFunction, is_not_fooled_by_extrapolation) {
    const std::vector<double> knots{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(nrb::sole_function(knots.data(), 3, 3, 1.0), -1);
    EXPECT_EQ(nrb::sole_function(knots.data(), 3, 3, 6.0), -1);
}

TEST(BasisValues, have_the_same_bits_at_a_knot) {
    support::Random random(930410);
    for (int trial = 0; trial < 2000; ++trial) {
        const int p = random.whole(0, 9), span = p + random.whole(0, 3);
        std::vector<double> knots{random.between(-1, 1)};
        while (std::ssize(knots) < span + p + 2) {
            const bool again = std::ssize(knots) != span + 1 && random.whole(0, 2) == 0;
            knots.push_back(knots.back() + (again ? 0 : std::exp2(random.between(-30, 3))));
        }
        const auto functions = static_cast<size_t>(p) + 1;
        std::vector<double> values(functions), at_knot(functions, -1.0);
        nrb::basis_values(knots.data(), p, span, knots[static_cast<size_t>(span)], values.data());
        nrb::basis_values_at_knot(knots.data(), p, span, at_knot.data());
        ASSERT_EQ(std::memcmp(values.data(), at_knot.data(), functions * sizeof(double)), 0)
            << "degree " << p;
    }
}

TEST(BasisDerivs, row_zero_has_the_bits_of_the_values) {
    const std::vector<double> knots{-1, 0, 0.1, 0.37, 0.5, 2, 2.5, 9};
    double values[4];
    double derivs[12];
    for (const double t : {0.37, 0.4, 0.499, 0.5}) {
        nrb::basis_values(knots.data(), 3, 3, t, values);
        nrb::basis_derivs(knots.data(), 3, 3, t, 2, derivs);
        for (int j = 0; j < 4; ++j) {
            EXPECT_EQ(values[j], derivs[j]);
        }
    }
}

TEST(BasisValuesOfLowerDegrees, are_those_of_each_degree) {
    const std::vector<double> knots{-1, 0, 0.1, 0.37, 0.5, 2, 2.5, 9};
    double all[4 * 4];
    nrb::basis_values_of_lower_degrees(knots.data(), 3, 3, 0.4, 7, all);
    for (int k = 0; k <= 3; ++k) {
        double values[4];
        nrb::basis_values(knots.data(), 3 - k, 3, 0.4, values);
        for (int j = 0; j <= 3 - k; ++j) {
            EXPECT_EQ(all[k * 4 + j], values[j]);
        }
    }
}

TEST(BasisValues, stand_denormal_spans) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const std::vector<double> knots{0, 0, 0, 8 * tiny, 8 * tiny, 8 * tiny};
    double values[3];
    nrb::basis_values(knots.data(), 2, 2, 4 * tiny, values);
    EXPECT_EQ(std::vector<double>(values, values + 3), (std::vector<double>{0.25, 0.5, 0.25}));
}

TEST(BernsteinDerivs, are_the_polynomials_of_the_binomial_formula) {
    double values[3 * 4];
    nrb::bernstein_derivs(3, 0.5, 2, values);
    const std::vector<double> expected{0.125, 0.375, 0.375, 0.125, -0.75, -0.75, 0.75, 0.75, 3, -3, -3, 3};
    EXPECT_EQ(std::vector<double>(values, values + 12), expected);
}

} // namespace

} // namespace bspline_test
