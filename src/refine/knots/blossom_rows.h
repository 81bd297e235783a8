// SPDX-License-Identifier: MIT
// Coefficients of polar forms for many rows of the same shape, in vectors of eight rows.
#pragma once

#include "basis/bspline.h"

#include <cstdint>
#include <span>

namespace nrb::refine {

inline constexpr int row_lanes = 8;

// One knot for each row; that of row l is at[l * stride].
using KnotLanes = const double *;

// One polar form, times `factor`, as a combination of steps + 1 control points. It is computed by de Boor's
// algorithm, one step for each argument (see append_argument()). The knots on either side are left[-pitch],
// left[-2 pitch], ... and right[0], right[pitch], .... The coefficients are added to elements target, ...,
// target + steps of the row.
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

// rows[l * pitch + i], l < count, i < width: the sum of the terms of row l, with the same bits as from
// blossom_row_sum(). Preconditions: the terms lie within the width; count is a multiple of row_lanes.
void blossom_row_sums(std::span<const BlossomTerm> terms, int64_t stride, int64_t count, int width,
                      int64_t pitch, double *rows) noexcept;

// Rows of one term each, of at least one step. Row l is written to rows[l]; the stride of knots is 1.
// Precondition: count is a multiple of row_lanes.
void blossom_rows(const BlossomTerm &term, int64_t count, double *const *rows) noexcept;

// Rows with arguments that slide along a list: row l, l < count, has the arguments arguments[l], ...,
// arguments[l + steps - 1] and steps + 1 coefficients. The knots on the sides are the same for all rows.
// There must be room for row_lanes more rows.
void sliding_blossom_rows(int steps, const double *left, const double *right, const double *arguments,
                          int64_t count, double *rows) noexcept;

} // namespace nrb::refine
