// SPDX-License-Identifier: MIT
#include "numeric/gauss_rule.h"

#include "numeric/double_double.h"

#include <cmath>
#include <numbers>

namespace nrb::inline numeric {

namespace {

struct Legendre {
    DoubleDouble value, slope; // of P_n at x in (-1, 1)
};

// By the recurrence (k + 1) P_(k+1) = (2 k + 1) x P_k - k P_(k-1), and (1 - x^2) P_n' = n (P_(n-1) - x P_n).
Legendre legendre(int n, const DoubleDouble &x) noexcept {
    DoubleDouble before = 1, value = x;
    for (int k = 1; k < n; ++k) {
        const DoubleDouble next =
            (DoubleDouble(2 * k + 1) * x * value - DoubleDouble(k) * before) / DoubleDouble(k + 1);
        before = value;
        value = next;
    }
    return {value, DoubleDouble(n) * (before - x * value) / (DoubleDouble(1) - x * x)};
}

// Node i <= (n - 1) / 2, counted from the largest node down. Newton's method starts from Tricomi's
// approximation, which has a few correct digits; each step doubles them.
DoubleDouble node_of(int n, int i) noexcept {
    DoubleDouble x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 6; ++step) {
        const auto [value, slope] = legendre(n, x);
        x = x - value / slope;
    }
    return x;
}

} // namespace

GaussRule gauss_rule(int size) {
    const auto n = static_cast<size_t>(size);
    GaussRule rule{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    for (size_t i = 0; 2 * i < n; ++i) {
        const bool middle = 2 * i + 1 == n;
        const DoubleDouble x = middle ? DoubleDouble(0) : node_of(size, static_cast<int>(i));
        const DoubleDouble slope = legendre(size, x).slope;
        const DoubleDouble weight = DoubleDouble(1) / ((DoubleDouble(1) - x * x) * slope * slope);
        const size_t other = n - 1 - i;
        rule.places[i] = rule.rests[other] = (0.5 * (1 - x.high) - 0.5 * x.low);
        rule.rests[i] = rule.places[other] = (DoubleDouble(0.5) + DoubleDouble(0.5) * x).value();
        rule.weights[i] = rule.weights[other] = weight.value();
    }
    return rule;
}

} // namespace nrb::inline numeric
