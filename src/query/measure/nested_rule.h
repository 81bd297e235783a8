// Quadrature rules that contain each other: T. N. L. Patterson, "The optimum addition of points to quadrature
// formulae", Math. Comp. 22 (1968), from the three points of Gauss.
#pragma once

namespace nrb {

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
// Weights of a level, which add up to 1: rule_size(level) of them, zeros up to 16 behind.
const double *rule_weights(int level) noexcept;

// Values and derivatives of the Bernstein polynomials of a degree at the nodes: row i is that of B_i.
// Relative error of values: (degree + 2) eps.
void rule_basis(int degree, double *values) noexcept;                  // [degree + 1][rule_capacity]
void rule_basis_derivatives(int degree, double *derivatives) noexcept; // [degree + 1][rule_capacity]

// What three rules of consecutive levels say about the error of the last. Where the integrand is analytic the
// errors are squared from level to level: the second difference is about the square of the first, and the error
// their fourth power, relative to the integral of the magnitude. Elsewhere they fall by a ratio. One more step of
// the ratio seen is above the former and close to the latter; a second difference that is small by accident
// does not count for more than the first one promises.
double extrapolated_error(double first, double second, double third, double magnitude) noexcept;

} // namespace nrb
