// SPDX-License-Identifier: MIT
#include "measure/length/speed_net.h"

#include "reference/number.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace speed_net_test {

using namespace nrb;
using reference::Rational;

namespace {

constexpr double eps = 0x1p-52;

using Row = std::vector<Rational>;

// De Casteljau's algorithm.
Rational value_of(Row row, const Rational &t) {
    for (; row.size() > 1; row.pop_back()) {
        for (size_t i = 0; i + 1 < row.size(); ++i) {
            row[i] += t * (row[i + 1] - row[i]);
        }
    }
    return row[0];
}

Rational slope_of(const Row &row, const Rational &t) {
    Row steps;
    for (size_t i = 0; i + 1 < row.size(); ++i) {
        steps.push_back(static_cast<int>(row.size() - 1) * (row[i + 1] - row[i]));
    }
    return value_of(steps, t);
}

Row row_of(const double *values, int degree) {
    return Row(values, values + degree + 1);
}

std::vector<double> random_row(std::mt19937_64 &random, int size, double lower = -1) {
    std::uniform_real_distribution<double> place(lower, 1);
    std::vector<double> values(static_cast<size_t>(size));
    for (double &x : values) {
        x = place(random);
    }
    return values;
}

double off(double value, const Rational &truth) {
    return std::fabs(static_cast<double>(value - truth));
}

} // namespace

// A' w - A w' of its definition, at more places than its degree.
TEST(SpeedNet, wronskian_is_what_the_quotient_rule_says) {
    std::mt19937_64 random(4711);
    for (int p = 1; p <= 12; ++p) {
        const std::vector<double> a = random_row(random, p + 1), w = random_row(random, p + 1, 0.5);
        std::vector<double> n(static_cast<size_t>(2 * p - 1));
        measure::wronskian(p, a.data(), w.data(), n.data());
        for (int k = 0; k <= 2 * p; ++k) {
            const Rational t = Rational(k) / (2 * p);
            const Row ra = row_of(a.data(), p), rw = row_of(w.data(), p);
            const Rational truth = slope_of(ra, t) * value_of(rw, t) - value_of(ra, t) * slope_of(rw, t);
            EXPECT_LE(off(0, value_of(row_of(n.data(), 2 * p - 2), t) - truth), 8 * p * p * eps) << p;
        }
    }
}

TEST(SpeedNet, halves_are_the_same_curve_at_half_the_speed) {
    std::mt19937_64 random(4712);
    for (int p = 1; p <= 9; ++p) {
        for (const bool rational : {false, true}) {
            const int degree = rational ? 2 * p - 2 : p - 1, weights = rational ? p : -1;
            const measure::SpeedForm form{2, degree, weights, nullptr, nullptr};
            const std::vector<double> whole = random_row(random, form.size());
            std::vector<double> upper = whole, lower(whole.size());
            measure::halve_net(form, upper.data(), lower.data());
            for (int row = 0; row < (rational ? 3 : 2); ++row) {
                const int at = row * (degree + 1), d = row < 2 ? degree : weights;
                const Rational scale = row < 2 ? Rational(1) / 2 : Rational(1);
                for (const double t : {0.0, 0.25, 0.5, 0.875, 1.0}) {
                    const Row r = row_of(whole.data() + at, d);
                    const double low = static_cast<double>(value_of(row_of(lower.data() + at, d), t));
                    const double high = static_cast<double>(value_of(row_of(upper.data() + at, d), t));
                    EXPECT_LE(off(low, scale * value_of(r, Rational(t) / 2)), (d + 2) * eps);
                    EXPECT_LE(off(high, scale * value_of(r, Rational(t) / 2 + Rational(1) / 2)),
                              (d + 2) * eps);
                }
            }
        }
    }
}

// The limits of the directions and of the sizes, from both sides, and signs of weights.
TEST(SpeedNet, shapes_are_even_within_their_limits) {
    const measure::SpeedForm polynomial{2, 2, -1, nullptr, nullptr}, rational{1, 1, 1, nullptr, nullptr};
    const auto even = [&](const std::vector<double> &x) {
        return measure::net_shape(polynomial, x.data()).even;
    };
    const auto turned = [&](double degrees) {
        const double a = degrees * std::acos(-1) / 180;
        return even({std::cos(a), 1, std::cos(a), std::sin(a), 0, -std::sin(a)});
    };
    EXPECT_TRUE(turned(75));
    EXPECT_FALSE(turned(76));
    EXPECT_TRUE(even({1, 1, 1 / 63.0, 0, 0, 0}));
    EXPECT_FALSE(even({1, 1, 1 / 65.0, 0, 0, 0}));
    EXPECT_FALSE(even({1, 1, 1e-7, 0, 0, 0}));
    EXPECT_TRUE(even({1, 1, 1e-9, 0, 0, 0}));
    EXPECT_TRUE(even({0, 0, 0, 0, 0, 0}));
    const auto shape = [&](double a, double b) {
        const std::vector<double> net = {3, 4, a, b};
        return measure::net_shape(rational, net.data());
    };
    EXPECT_TRUE(shape(1, 64).even);
    EXPECT_TRUE(shape(-1, -64).even);
    EXPECT_FALSE(shape(1, 65).even);
    EXPECT_EQ(shape(0.5, 1).bound(), 16);
    EXPECT_EQ(shape(-0.5, -1).bound(), 16);
    EXPECT_EQ(shape(-0.5, 1).bound(), INFINITY);
    EXPECT_EQ(shape(0, 1).bound(), INFINITY);
    EXPECT_FALSE(shape(-0.5, 1).even);
}

} // namespace speed_net_test
