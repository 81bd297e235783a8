// SPDX-License-Identifier: MIT
// Supernodes: consecutive columns of a sparse factor with the same row structure, treated as dense blocks.
#pragma once

#include "numeric/solvers/sparse/sparse_columns.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// Supernode s consists of the columns from first[s] to first[s + 1]. Each has as rows the later columns of s
// and rows[starts[s]] to rows[starts[s + 1]] below, which increase. The first of these belongs to the parent
// of s, which is eliminated after s; -1: no parent.
struct Supernodes {
    std::vector<int32_t> first;
    std::vector<int64_t> starts;
    std::vector<int32_t> rows;
    std::vector<int32_t> parent;

    [[nodiscard]] int64_t count() const noexcept { return static_cast<int64_t>(parent.size()); }
    [[nodiscard]] bool empty() const noexcept { return parent.empty(); }
    [[nodiscard]] std::span<const int32_t> below(int64_t s) const noexcept {
        const auto i = static_cast<size_t>(s);
        return std::span(rows).subspan(static_cast<size_t>(starts[i]),
                                       static_cast<size_t>(starts[i + 1] - starts[i]));
    }
    [[nodiscard]] int32_t columns(int64_t s) const noexcept {
        const auto i = static_cast<size_t>(s);
        return first[i + 1] - first[i];
    }
};

// The supernodes of a matrix with the elimination tree `parent`, whose factor has counts[j] elements below
// the diagonal in column j. Narrow neighbours are amalgamated where that adds few zeros to the factor.
template <class Number>
Supernodes find_supernodes(const ColumnsOf<Number> &matrix, std::span<const int32_t> parent,
                           std::span<const int64_t> counts);

extern template Supernodes find_supernodes(const ColumnsOf<double> &, std::span<const int32_t>,
                                           std::span<const int64_t>);

} // namespace nrb::inline numeric
