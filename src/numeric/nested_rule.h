// SPDX-License-Identifier: MIT
// Quadrature rules that contain each other: T. N. L. Patterson, "The optimum addition of points to quadrature
// formulae", Math. Comp. 22 (1968), from the three points of Gauss.
#pragma once

#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::inline numeric {

// Level l has 3, 7, 15, 31, 63 nodes and is exact up to degree 5, 11, 23, 47, 95; all weights are positive.
// Each level repeats the nodes of the one before it, so that two more rules to compare with cost nothing.
inline constexpr int rule_levels = 5;
inline constexpr int rule_capacity = 64;

// Nodes in storage, whole vectors of 8 but for the first level: those that do not belong to it have weight 0.
constexpr int rule_size(int level) noexcept {
    return 4 << level;
}

constexpr int rule_exactness(int level) noexcept {
    return level == 0 ? 5 : (12 << (level - 1)) - 1;
}

// The nodes in [0, 1], and how far they are from 1.
const double *rule_places() noexcept;
const double *rule_rests() noexcept;
// Weights of a level, which add up to 1: rule_size(level) of them, then zeros up to 16.
const double *rule_weights(int level) noexcept;

// Values and derivatives of the Bernstein polynomials of a degree at the nodes: row i is that of B_i.
// Relative error of values: (degree + 2) eps.
void rule_basis(int degree, double *values) noexcept;                  // [degree + 1][rule_capacity]
void rule_basis_derivatives(int degree, double *derivatives) noexcept; // [degree + 1][rule_capacity]

// What the values of a function at the nodes of a level >= 1 tell, relative to the integral of its magnitude.
// The rule gives the Legendre coefficients a_k of the function up to about half its exactness; of three
// neighbours the largest is taken, since one may vanish by accident. Where the function is analytic a_k falls
// like rho^-k and the rule is off by about a_k at twice the highest k; elsewhere a_k falls like a power of k.
struct RuleDecay {
    double integral;
    double last; // the largest of the highest coefficients
    double rate; // over the largest of those half as high; at most 1

    // The factor rate^2 leads from the highest coefficients on to those that the error consists of. For
    // analytic functions it does not lead far enough, so that the estimate is too large by a factor of rho^2
    // to rho^5. For other functions it leads there, or too far.
    [[nodiscard]] double error(double magnitude) const noexcept {
        constexpr double noise = 64 * eps;
        return last <= noise * magnitude ? 0 : last * rate * rate;
    }
    // What the error of a rule will be that is one or two levels higher, relative to the integral.
    [[nodiscard]] double one_higher() const noexcept {
        const double square = rate * rate, fourth = square * square;
        return fourth * fourth;
    }
    [[nodiscard]] double two_higher() const noexcept { return one_higher() * one_higher(); }
};
// For each level the factors by which the values at its nodes are summed: the weights, and those of three
// high Legendre coefficients and of three about half as high; zeros at level 0.
inline constexpr int decay_sums = 7;
using DecayRows = std::array<const double *, decay_sums>;
extern const std::array<DecayRows, rule_levels> decay_rows;

// Of the sums of values times factors.
inline RuleDecay decay_of(const std::array<double, decay_sums> &sums) noexcept {
    const double last = std::max({std::abs(sums[1]), std::abs(sums[2]), std::abs(sums[3])});
    const double low = std::max({std::abs(sums[4]), std::abs(sums[5]), std::abs(sums[6])});
    return {sums[0], last, last < low ? last / low : 1};
}

} // namespace nrb::inline numeric
