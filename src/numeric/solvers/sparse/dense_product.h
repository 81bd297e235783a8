// SPDX-License-Identifier: MIT
// Products of dense matrices, which take most of the time of sparse factorisations.
#pragma once

#include <cstdint>

namespace nrb::inline numeric {

// A dense matrix in column-major order; the columns start `stride` elements apart.
template <class Number>
struct ColumnMajor {
    Number *values;
    int64_t rows, columns, stride;
};

// c -= a b^T for c[rows][columns], a[rows][depth] and b[columns][depth]. With `lower`, at least the elements
// on and below the diagonal are computed, and no column outside c is touched. Each element is computed by
// subtracting depth products one after the other, each operation rounded: the result is the same on all
// processors.
void subtract_product(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                      const ColumnMajor<const double> &b, bool lower);

} // namespace nrb::inline numeric
