// SPDX-License-Identifier: MIT
// Collocation matrices in compressed sparse rows: row i has the factors by which the control points enter
// point i, or a derivative there.
#pragma once

#include "eval/active_points.h"

namespace nrb::eval {

// The number of entries in a row: the product of degree + 1 over the axes.
int64_t row_length(const Spline::Axes &axes) noexcept;

// The arrays of a matrix in compressed sparse rows. Each may be null.
struct SparseRows {
    double *values;
    int64_t *columns;
    int64_t *row_pointers;
};

// Collocation matrix of the derivatives, of the given orders, of the B-spline basis functions. Precondition:
// all parameters have been checked. A parameter that gives NaN has NaN values, in the columns of the first
// degree + 1 layers of each axis. All memory is allocated before anything is written.
void collocation(const Spline::Axes &axes, const AxisRules &rules, const Orders &orders, ConstRecords params,
                 const SparseRows &rows);

// The same for the rational basis functions of a spline.
void rational_collocation(const Spline &spline, const AxisRules &rules, const Orders &orders,
                          ConstRecords params, const SparseRows &rows);

} // namespace nrb::eval
