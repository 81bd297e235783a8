// Rules of Gauss against what they are exact for, and against nodes that are known.
#include "numeric/gauss_rule.h"

#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace nrb;

// By sums over both halves: small places and small rests each to their own precision.
TEST(GaussRule, IsExactForPolynomials) {
    for (int n = 1; n <= most_gauss_nodes; ++n) {
        const GaussRule rule = gauss_rule(n);
        for (int k = 0; k < 2 * n; ++k) {
            long double below = 0, above = 0;
            for (size_t i = 0; i < rule.places.size(); ++i) {
                below += static_cast<long double>(rule.weights[i]) *
                         std::pow(static_cast<long double>(rule.places[i]), k);
                above += static_cast<long double>(rule.weights[i]) *
                         std::pow(static_cast<long double>(rule.rests[i]), k);
            }
            EXPECT_NEAR(static_cast<double>(below * (k + 1)), 1, (4 + 2 * k) * eps) << n << ' ' << k;
            EXPECT_NEAR(static_cast<double>(above * (k + 1)), 1, (4 + 2 * k) * eps) << n << ' ' << k;
        }
    }
}

// One degree more and it is off by (n!)^4 / ((2 n + 1) (2 n)!^2).
TEST(GaussRule, IsNotExactBeyond) {
    for (int n = 1; n <= 8; ++n) {
        const GaussRule rule = gauss_rule(n);
        double sum = 0, off = 1.0 / (2 * n + 1);
        for (size_t i = 0; i < rule.places.size(); ++i) {
            sum += rule.weights[i] * std::pow(rule.places[i], 2 * n);
        }
        for (int i = 1; i <= n; ++i) { // the square of (n choose 2 n)
            off *= std::pow(static_cast<double>(i) / (n + i), 2);
        }
        EXPECT_NEAR(1.0 / (2 * n + 1) - sum, off, 1e-3 * off + 4 * eps) << n;
    }
}

TEST(GaussRule, HasKnownNodes) {
    EXPECT_EQ(gauss_rule(1).places, std::vector<double>{0.5});
    EXPECT_EQ(gauss_rule(2).rests[1], gauss_rule(2).places[0]);
    EXPECT_DOUBLE_EQ(gauss_rule(2).places[1], 0.5 + std::sqrt(1.0 / 12));
    EXPECT_DOUBLE_EQ(gauss_rule(3).places[0], 0.5 - std::sqrt(0.15));
    EXPECT_EQ(gauss_rule(3).places[1], 0.5);
    EXPECT_DOUBLE_EQ(gauss_rule(3).weights[1], 4.0 / 9);
    EXPECT_DOUBLE_EQ(gauss_rule(64).places[63], 0.99965252086788605);
}

} // namespace
