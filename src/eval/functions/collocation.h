// SPDX-License-Identifier: MIT
// Collocation matrices as sparse rows: the factors of the control points in a point or a derivative.
#pragma once

#include "eval/active_points.h"

namespace nrb::eval {

// Number of entries in a row: the product of degree + 1 over the axes.
int64_t row_length(const Spline::Axes &axes) noexcept;

// Arrays of compressed sparse rows; each may be null.
struct SparseRows {
    double *values;
    int64_t *columns;
    int64_t *row_pointers;
};

// Derivative `orders` of the B-spline basis functions. All parameters must have been checked. A parameter
// that gives NaN has NaN values in the first columns of the axes. May throw only std::bad_alloc, before
// anything is written.
void collocation(const Spline::Axes &axes, const AxisRules &rules, const Orders &orders, ConstRecords params,
                 const SparseRows &rows);

// The same for the rational basis functions of a spline.
void rational_collocation(const Spline &spline, const AxisRules &rules, const Orders &orders,
                          ConstRecords params, const SparseRows &rows);

} // namespace nrb::eval
