// SPDX-License-Identifier: MIT
// Coefficients of polar forms for many rows of one shape, eight side by side.
#pragma once

#include "basis/bspline.h"

#include <cstdint>
#include <span>

namespace nrb::refine {

inline constexpr int row_lanes = 8;

// A knot of each row: that of row l is at[l * stride].
using KnotLanes = const double *;

// One polar form as a combination of steps + 1 control points, times `factor`: de Boor's steps with one
// argument after another, see append_argument(). The knots at its sides are left[-pitch], left[-2 pitch], ...
// and right[0], right[pitch], .... Its coefficients belong to control points target, ..., target + steps of
// the row.
struct BlossomTerm {
    int steps;
    int target;
    double factor;
    KnotLanes left;
    KnotLanes right;
    int64_t pitch;
    KnotLanes arguments[max_basis];
};

// row[i], i < width: the sum of the terms.
void blossom_row_sum(std::span<const BlossomTerm> terms, int width, double *row) noexcept;

// rows[l * pitch + i], l < count, i < width: the sum of the terms of row l, with the bits of
// blossom_row_sum(). The terms lie within the width; count is a multiple of row_lanes.
void blossom_row_sums(std::span<const BlossomTerm> terms, int64_t stride, int64_t count, int width,
                      int64_t pitch, double *rows) noexcept;

// One term for each row, of at least one step; row l goes to rows[l]; the stride is 1.
void blossom_rows(const BlossomTerm &term, int64_t count, double *const *rows) noexcept;

// Rows whose arguments slide along a list: row l of steps + 1 coefficients, l < count, has the arguments
// arguments[l], ..., arguments[l + steps - 1]; the knots at the sides are the same for all. There must be
// room for row_lanes more rows.
void sliding_blossom_rows(int steps, const double *left, const double *right, const double *arguments,
                          int64_t count, double *rows) noexcept;

} // namespace nrb::refine
