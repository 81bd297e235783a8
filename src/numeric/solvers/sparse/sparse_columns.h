// SPDX-License-Identifier: MIT
// Sparse symmetric matrices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// A symmetric matrix by columns: the rows of column j and their values are those from starts[j] to starts[j + 1].
// Rows ascend, and all diagonal elements are there.
template <class Number>
struct ColumnsOf {
    std::vector<int64_t> starts;
    std::vector<int32_t> rows;
    std::vector<Number> values;

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(starts.size()) - 1; }
};
using SparseColumns = ColumnsOf<double>;

namespace sparse {

// Numbers of unknowns have signs, places in vectors have none.
constexpr size_t at(int64_t i) noexcept {
    return static_cast<size_t>(i);
}

} // namespace sparse

} // namespace nrb::inline numeric
