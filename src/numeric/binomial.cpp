// SPDX-License-Identifier: MIT
#include "numeric/binomial.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace nrb::inline numeric {

namespace {

using BinomialTable = std::array<std::array<double, max_product_degree + 1>, max_product_degree + 1>;

// Computed in integers: the largest, C(62, 31), has 59 bits.
BinomialTable make_binomials() noexcept {
    BinomialTable table{};
    std::array<uint64_t, max_product_degree + 1> row{1};
    for (size_t n = 0; n < table.size(); ++n) {
        std::transform(row.begin(), row.end(), table[n].begin(),
                       [](uint64_t x) { return static_cast<double>(x); });
        for (size_t k = row.size() - 1; k > 0; --k) {
            row[k] += row[k - 1];
        }
    }
    return table;
}

} // namespace

const double *binomials(int n) noexcept {
    static const BinomialTable table = make_binomials();
    return table[static_cast<size_t>(n)].data();
}

std::vector<DoubleDouble> precise_binomials(int n) {
    std::vector<DoubleDouble> row(static_cast<size_t>(n) + 1);
    row[0] = 1;
    for (int step = 1; step <= n; ++step) {
        for (auto k = static_cast<size_t>(step); k > 0; --k) {
            row[k] = row[k] + row[k - 1];
        }
    }
    return row;
}

double binomial(int n, int k) noexcept {
    return binomials(n)[k];
}

std::vector<DoubleDouble> precise_product_factors(int p) {
    const std::vector<DoubleDouble> lower = precise_binomials(p), higher = precise_binomials(2 * p);
    std::vector<DoubleDouble> factors;
    for (size_t i = 0; i < lower.size(); ++i) {
        for (size_t j = 0; j < lower.size(); ++j) {
            factors.push_back(lower[i] * lower[j] / higher[i + j]);
        }
    }
    return factors;
}

} // namespace nrb::inline numeric
