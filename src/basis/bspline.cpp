// SPDX-License-Identifier: MIT
#include "basis/bspline.h"

#include <algorithm>

namespace nrb::inline basis {

void raise_degree(const double *knots, int d, int64_t span, double t, double *values) noexcept {
    append_argument(knots + span + 1, knots + span + 1, d, t, values);
}

namespace {

// From the derivatives of order j - 1 of the d functions of degree d - 1 to those of order j of the d + 1
// functions of degree d, in place: N'_(i,d) = d (N_(i,d-1) / (t_(i+d) - t_i) - N_(i+1,d-1) / (t_(i+d+1)
// - t_(i+1))).
void differentiate(const double *knots, int d, int64_t span, double *values) noexcept {
    const double *right = knots + span + 1;
    const double *left = right - d;
    double carried = 0;
    for (int r = 0; r < d; ++r) {
        const double slope = d * (values[r] / (right[r] - left[r]));
        values[r] = carried - slope;
        carried = slope;
    }
    values[d] = carried;
}

} // namespace

void basis_values(const double *knots, int degree, int64_t span, double t, double *values) noexcept {
    values[0] = 1;
    for (int d = 1; d <= degree; ++d) {
        raise_degree(knots, d, span, t, values);
    }
}

// The first knot of the span is an argument of the polar form from the start.
void basis_values_at_knot(const double *knots, int degree, int64_t span, double *values) noexcept {
    values[degree] = 0;
    values[0] = 1;
    for (int d = 1; d < degree; ++d) {
        append_argument(knots + span, knots + span + 1, d, knots[span], values);
    }
}

void basis_derivs(const double *knots, int degree, int64_t span, double t, int order,
                  double *values) noexcept {
    const int width = degree + 1;
    const int highest = std::min(order, degree);
    std::fill(values, values + static_cast<int64_t>(order + 1) * width, 0.0);
    double functions[max_basis];
    functions[0] = 1;
    for (int d = 0; d <= degree; ++d) {
        if (d > 0) {
            raise_degree(knots, d, span, t, functions);
        }
        const int k = degree - d;
        if (k <= highest) {
            double *row = values + static_cast<int64_t>(k) * width;
            std::copy(functions, functions + d + 1, row);
            for (int e = d + 1; e <= degree; ++e) {
                differentiate(knots, e, span, row);
            }
        }
    }
}

void basis_values_of_lower_degrees(const double *knots, int degree, int64_t span, double t, int order,
                                   double *values) noexcept {
    double functions[max_basis];
    functions[0] = 1;
    for (int d = 0; d <= degree; ++d) {
        if (d > 0) {
            raise_degree(knots, d, span, t, functions);
        }
        if (degree - d <= order) {
            std::copy_n(functions, d + 1, values + static_cast<int64_t>(degree - d) * (degree + 1));
        }
    }
}

void bernstein_derivs(int degree, double t, int order, double *values) noexcept {
    double knots[2 * max_basis];
    std::fill_n(knots, degree + 1, 0.0);
    std::fill_n(knots + degree + 1, degree + 1, 1.0);
    basis_derivs(knots, degree, degree, t, order, values);
}

} // namespace nrb::inline basis
