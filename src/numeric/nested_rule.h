// SPDX-License-Identifier: MIT
// Nested quadrature rules: T. N. L. Patterson, "The optimum addition of points to quadrature formulae", Math.
// Comp. 22 (1968), starting from the three-point Gauss rule.
#pragma once

#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::inline numeric {

// Level l = 0, ..., 4 has 3, 7, 15, 31, 63 nodes and is exact up to degree 5, 11, 23, 47, 95; all weights are
// positive. Each level contains the nodes of the one before it, so that comparing with the two lower rules
// costs no further evaluations.
inline constexpr int rule_levels = 5;
inline constexpr int rule_capacity = 64;

// Number of nodes in storage, a multiple of 8 except at the first level: nodes that do not belong to the
// level have weight 0.
constexpr int rule_size(int level) noexcept {
    return 4 << level;
}

constexpr int rule_exactness(int level) noexcept {
    return level == 0 ? 5 : (12 << (level - 1)) - 1;
}

// The nodes x in [0, 1], and 1 - x.
const double *rule_places() noexcept;
const double *rule_rests() noexcept;
// The weights of a level, which sum to 1: rule_size(level) of them, then zeros up to 16.
const double *rule_weights(int level) noexcept;

// Values and derivatives of the Bernstein polynomials of a degree at the nodes: row i belongs to B_i. The
// relative error of the values is (degree + 2) eps.
void rule_basis(int degree, double *values) noexcept;                  // [degree + 1][rule_capacity]
void rule_basis_derivatives(int degree, double *derivatives) noexcept; // [degree + 1][rule_capacity]

// What the values of a function at the nodes of a level >= 1 say about the accuracy of the rule, relative to
// the integral of the magnitude of the function. The rule yields the Legendre coefficients a_k of the
// function up to about half its degree of exactness; the largest of three neighbours is used, since one may
// vanish by accident. Where the function is analytic, a_k decays like rho^-k, and the error of the rule is
// about a_k at twice the highest k; elsewhere a_k decays like a power of k.
struct RuleDecay {
    double integral;
    double last; // the largest of the three highest coefficients
    double rate; // last over the largest of three about half as high; at most 1

    // An estimate of the error. The factor rate^2 extrapolates from the highest coefficients to those that
    // make up the error. For analytic functions it does not reach far enough, so that the estimate is too
    // large by a factor of rho^2 to rho^5. For other functions it reaches them, or farther.
    [[nodiscard]] double error(double magnitude) const noexcept {
        constexpr double noise = 64 * eps;
        return last <= noise * magnitude ? 0 : last * rate * rate;
    }
    // The predicted error of a rule one or two levels higher, relative to the integral.
    [[nodiscard]] double one_higher() const noexcept {
        const double square = rate * rate, fourth = square * square;
        return fourth * fourth;
    }
    [[nodiscard]] double two_higher() const noexcept { return one_higher() * one_higher(); }
};
// For each level the factors by which the values at its nodes are summed: the weights, then the factors of
// three high Legendre coefficients and of three about half as high; zeros at level 0.
inline constexpr int decay_sums = 7;
using DecayRows = std::array<const double *, decay_sums>;
extern const std::array<DecayRows, rule_levels> decay_rows;

// From the sums of values times these factors.
inline RuleDecay decay_of(const std::array<double, decay_sums> &sums) noexcept {
    const double last = std::max({std::abs(sums[1]), std::abs(sums[2]), std::abs(sums[3])});
    const double low = std::max({std::abs(sums[4]), std::abs(sums[5]), std::abs(sums[6])});
    return {sums[0], last, last < low ? last / low : 1};
}

} // namespace nrb::inline numeric
