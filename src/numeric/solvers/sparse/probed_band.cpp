// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/probed_band.h"

#include <algorithm>

namespace nrb::inline numeric {

using sparse::at;

namespace {

// The pattern of the band, clipped at the ends of the matrix, with all elements 0.
SparseColumns empty_columns(int64_t size, int64_t reach) {
    SparseColumns columns;
    columns.starts.push_back(0);
    for (int64_t j = 0; j < size; ++j) {
        for (int64_t i = std::max<int64_t>(j - reach, 0); i <= std::min(j + reach, size - 1); ++i) {
            columns.rows.push_back(static_cast<int32_t>(i));
        }
        columns.starts.push_back(std::ssize(columns.rows));
    }
    columns.values.resize(columns.rows.size());
    return columns;
}

} // namespace

// Each element is the mean of the two values that the products give for it and for its mirror image.
std::optional<SparseLdlt>
probed_band(int64_t size, int64_t reach,
            const std::function<std::vector<double>(const std::vector<double> &)> &product) {
    SparseColumns columns = empty_columns(size, reach);
    const auto place = [&](int64_t i, int64_t j) { // of element (i, j)
        return at(columns.starts[at(j)] + i - std::max<int64_t>(j - reach, 0));
    };
    const int64_t apart = std::min(2 * reach + 1, size);
    for (int64_t first = 0; first < apart; ++first) {
        std::vector<double> x(at(size), 0.0);
        for (int64_t j = first; j < size; j += apart) {
            x[at(j)] = 1;
        }
        const std::vector<double> image = product(x);
        for (int64_t j = first; j < size; j += apart) {
            for (int64_t i = std::max<int64_t>(j - reach, 0); i <= std::min(j + reach, size - 1); ++i) {
                columns.values[place(i, j)] += image[at(i)] / 2;
                columns.values[place(j, i)] += image[at(i)] / 2;
            }
        }
    }
    std::optional<SparseLdlt> factors(std::in_place, columns);
    if (factors->factorise(columns) >= 0) {
        factors.reset();
    }
    return factors;
}

} // namespace nrb::inline numeric
