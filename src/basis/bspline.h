// SPDX-License-Identifier: MIT
// B-spline and Bernstein basis functions at one parameter: the kernels of every evaluation.
#pragma once

#include "base/limits.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace nrb::inline basis {

inline constexpr int max_basis = max_degree + 1;

// A value divided in the ratio in which t divides the interval between two knots: alpha = value (t - left)
// / (right - left), and beta = value - alpha.
struct Parts {
    double alpha;
    double beta;
};

// Computes the smaller part by multiplication and the larger one by subtraction. For left <= t <= right and
// value >= 0 both parts then have small relative errors (4 and 5 roundings), their sum is the value up to one
// rounding of the larger part, and at the ends the parts are exactly 0 and the value. If each part were
// rounded on its own, the sums would drift with the degree.
inline Parts divide_in_ratio(double value, double left, double t, double right) noexcept {
    const double after = t - left;
    const double ahead = right - t;
    const double smaller = value * (std::min(after, ahead) / (right - left));
    const double larger = value - smaller;
    // Branch-free swap: a branch would be mispredicted every other time.
    const auto difference = std::bit_cast<uint64_t>(smaller) ^ std::bit_cast<uint64_t>(larger);
    const uint64_t swap = after < ahead ? difference : 0;
    return {std::bit_cast<double>(std::bit_cast<uint64_t>(larger) ^ swap),
            std::bit_cast<double>(std::bit_cast<uint64_t>(smaller) ^ swap)};
}

// One step of de Boor's algorithm on a row, in place. The input is the d coefficients of a polar form that
// has d - 1 arguments, besides some of the knots; the result is the d + 1 coefficients of the polar form that
// has the argument t as well. left[-1], left[-2], ... and right[0], right[1], ... are the knots on either
// side that are not arguments. All factors lie in [0, 1] if t lies between left[-1] and right[0]; beyond them
// the polynomial piece is continued.
inline void append_argument(const double *left, const double *right, int d, double t,
                            double *coefficients) noexcept {
    left -= d;
    double carried = 0;
    for (int r = 0; r < d; ++r) {
        const auto [alpha, beta] = divide_in_ratio(coefficients[r], left[r], t, right[r]);
        coefficients[r] = carried + beta;
        carried = alpha;
    }
    coefficients[d] = carried;
}

// One step of the Cox-de Boor recurrence at t on span s, in place: from the d functions of degree d - 1 to
// the d + 1 functions of degree d. If each step has an argument of its own, the result is the polar form
// (blossom) of the basis functions at these arguments.
void raise_degree(const double *knots, int d, int64_t span, double t, double *values) noexcept;

// N_(s-p), ..., N_s at t on span s, by the Cox-de Boor recurrence (de Boor 1972; Piegl & Tiller A2.2). Inside
// the span all terms are >= 0 and nothing cancels, so every value has a relative error of at most 3 p eps (6
// roundings of eps / 2 for each degree), and at a knot where only one function is nonzero its value is
// exactly 1. Preconditions: knots[s] < knots[s + 1], p <= s, and s + p is a valid index. Cost: p (p + 1) / 2
// divisions.
void basis_values(const double *knots, int degree, int64_t span, double t, double *values) noexcept;

// The same, bit for bit, at the first knot of the span, where the last function vanishes. Cost: p (p - 1) / 2
// divisions.
void basis_values_at_knot(const double *knots, int degree, int64_t span, double *values) noexcept;

// values[k * (p + 1) + j] = derivative k of N_(s-p+j) at t, k = 0, ..., order; row 0 equals basis_values()
// bit for bit. Derivative k starts from the functions of degree p - k, which have small relative errors, and
// applies the difference formula k times (Piegl & Tiller 2.7), so that its error is relative to the sum of
// the magnitudes of the terms.
void basis_derivs(const double *knots, int degree, int64_t span, double t, int order,
                  double *values) noexcept;

// values[k * (p + 1) + j] = function j of degree p - k at t, j = 0, ..., p - k, for k = 0, ..., min(order,
// p); row 0 equals basis_values() bit for bit. With these functions, each derivative of a spline is a linear
// combination of the control points of that derivative.
void basis_values_of_lower_degrees(const double *knots, int degree, int64_t span, double t, int order,
                                   double *values) noexcept;

// Index 0 or p of the only nonzero function (exactly 1) at t on span s, or -1 if there are more.
inline int sole_function(const double *knots, int degree, int64_t span, double t) noexcept {
    if (degree == 0 || (t == knots[span] && t == knots[span - degree + 1])) {
        return 0;
    }
    return t == knots[span + 1] && t == knots[span + degree] ? degree : -1;
}

// B_(j,p)(t) and its derivatives over [0, 1], in the layout of basis_derivs().
void bernstein_derivs(int degree, double t, int order, double *values) noexcept;

} // namespace nrb::inline basis
