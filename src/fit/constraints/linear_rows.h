// SPDX-License-Identifier: MIT
// Linear equations and inequalities for the control points of a fit.
#pragma once

#include "fit/least_squares/normal_equations.h"

#include <vector>

namespace nrb::fit {

// A row: for each coordinate, sum value x[unknown] equals `target`, or is at least that. The largest |value|
// is at most 1.
struct LinearRow {
    struct Coefficient {
        Index layer;
        int64_t unknown;
        double value;
    };
    std::vector<Coefficient> coefficients; // by increasing layers
    std::vector<double> target;            // [dim]
};

// The left side for coordinate c of x[unknowns][width].
DoubleDouble left_side(const LinearRow &row, const std::vector<DoubleDouble> &x, int64_t width,
                       int64_t c) noexcept;

// Adds factor times the square of the left side to the quadratic form of the matrix.
void add_square(const LinearRow &row, const DoubleDouble &factor, StencilMatrix &matrix) noexcept;

// right[unknowns][width] += factor times the row, for coordinate c.
void add_multiple(const LinearRow &row, const DoubleDouble &factor, int64_t width, int64_t c,
                  std::vector<DoubleDouble> &right) noexcept;

// The size of the numbers relative to which x may be in error: x itself, and the amounts by which it misses
// the rows, of which the first `equal` ones are equations.
double size_of(const std::vector<DoubleDouble> &x, const std::vector<LinearRow> &rows, size_t equal) noexcept;

// The largest magnitude.
double largest_of(const std::vector<DoubleDouble> &x) noexcept;

} // namespace nrb::fit
