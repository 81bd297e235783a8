// B-spline basis functions and their derivatives without rounding.
#pragma once

#include "reference/number.h"

#include <cstdint>
#include <vector>

namespace reference {

// Which polynomial piece a parameter is evaluated on: [t_s, t_s+1), the last span closed; `left` takes (t_s,
// t_s+1], the first span closed. Outside the domain it is the first or the last piece. Searched by walking
// over all spans.
int64_t exact_span(const std::vector<double> &knots, int degree, double t, bool left = false);

// Derivative k of N_(span - degree + j) is numerators[k][j] / denominator, denominator > 0.
struct ExactBasis {
    int64_t span = 0;
    std::vector<std::vector<Integer>> numerators;
    Integer denominator;
};

// The recurrence of Cox and de Boor on the piece of t. Fraction-free: knots and t are scaled to integers, and
// the functions of one level share the least common multiple of that level's knot differences as their
// denominator, so that no common divisor of long numbers is ever sought. Derivatives follow d/dt N_(i,r) = r
// (N_(i,r-1) / (t_i+r - t_i) - N_(i+1,r-1) / (t_i+r+1 - t_i+1)).
ExactBasis exact_basis(const std::vector<double> &knots, int degree, double t, int order, bool left = false);

} // namespace reference
