// SPDX-License-Identifier: MIT
// Products of dense matrices, by which the time of sparse factors passes.
#pragma once

#include <cstdint>

namespace nrb::inline numeric {

// By columns, whose first elements are `stride` apart.
template <class Number>
struct ColumnMajor {
    Number *values;
    int64_t rows, columns, stride;
};

// c -= a b^T for c[rows][columns], a[rows][depth] and b[columns][depth]; with `lower` at least the elements on the diagonal and
// below, and no column but those of c. Each element is the result of depth products that are subtracted one after the
// other, each rounded: the same on all processors.
void subtract_product(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                      const ColumnMajor<const double> &b, bool lower);

} // namespace nrb::inline numeric
