// SPDX-License-Identifier: MIT
// Sparse symmetric matrices in compressed column form.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// A symmetric matrix by columns: the row indices and values of column j are those from starts[j] to starts[j
// + 1]. Row indices increase, and all diagonal elements are present.
template <class Number>
struct ColumnsOf {
    std::vector<int64_t> starts;
    std::vector<int32_t> rows;
    std::vector<Number> values;

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(starts.size()) - 1; }
};
using SparseColumns = ColumnsOf<double>;

namespace sparse {

// Indices of unknowns are signed, positions in vectors are not.
constexpr size_t at(int64_t i) noexcept {
    return static_cast<size_t>(i);
}

} // namespace sparse

} // namespace nrb::inline numeric
