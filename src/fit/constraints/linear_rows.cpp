// SPDX-License-Identifier: MIT
#include "fit/constraints/linear_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

DoubleDouble left_side(const LinearRow &row, const std::vector<DoubleDouble> &x, int64_t width,
                       int64_t c) noexcept {
    DoubleDouble sum;
    for (const LinearRow::Coefficient &coefficient : row.coefficients) {
        sum = sum + DoubleDouble(coefficient.value) * x[static_cast<size_t>(coefficient.unknown * width + c)];
    }
    return sum;
}

void add_square(const LinearRow &row, const DoubleDouble &factor, StencilMatrix &matrix) noexcept {
    for (const LinearRow::Coefficient &a : row.coefficients) {
        for (const LinearRow::Coefficient &b : row.coefficients) {
            if (a.layer <= b.layer) {
                matrix.add(a.layer, b.layer, factor * DoubleDouble::product(a.value, b.value));
            }
        }
    }
}

void add_multiple(const LinearRow &row, const DoubleDouble &factor, int64_t width, int64_t c,
                  std::vector<DoubleDouble> &right) noexcept {
    for (const LinearRow::Coefficient &coefficient : row.coefficients) {
        DoubleDouble &value = right[static_cast<size_t>(coefficient.unknown * width + c)];
        value = value + factor * DoubleDouble(coefficient.value);
    }
}

double size_of(const std::vector<DoubleDouble> &x, const std::vector<LinearRow> &rows,
               size_t equal) noexcept {
    double size = largest_of(x);
    for (size_t i = 0; i < rows.size(); ++i) {
        const double miss = (DoubleDouble(rows[i].target[0]) - left_side(rows[i], x, 1, 0)).high;
        size = std::max(size, i < equal ? std::abs(miss) : miss);
    }
    return size;
}

double largest_of(const std::vector<DoubleDouble> &x) noexcept {
    double most = 0;
    for (const DoubleDouble &value : x) {
        most = std::max(most, std::abs(value.high));
    }
    return most;
}

} // namespace nrb::fit
