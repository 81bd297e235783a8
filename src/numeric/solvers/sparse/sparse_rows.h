// SPDX-License-Identifier: MIT
// Sparse matrices by rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

class SparseRows {
public:
    // Adds an element to the last row, in any order; elements of the same column are summed.
    void add(int64_t column, double value) { row_.push_back({column, value, row_.size()}); }
    // Ends the row and scales it to length 1 unless it is 0; returns its length before scaling.
    double end_row();

    [[nodiscard]] int64_t size() const noexcept { return std::ssize(starts_) - 1; }
    // In increasing order.
    [[nodiscard]] std::span<const int64_t> columns(int64_t row) const noexcept { return part(columns_, row); }
    [[nodiscard]] std::span<const double> values(int64_t row) const noexcept { return part(values_, row); }
    [[nodiscard]] const std::vector<double> &all_values() const noexcept { return values_; }

private:
    template <class T>
    [[nodiscard]] std::span<const T> part(const std::vector<T> &all, int64_t row) const noexcept {
        const size_t begin = starts_[static_cast<size_t>(row)], end = starts_[static_cast<size_t>(row) + 1];
        return std::span(all).subspan(begin, end - begin);
    }

    struct Element {
        int64_t column;
        double value;
        size_t number; // order of insertion, so that sums do not depend on the sorting
    };
    std::vector<Element> row_;
    std::vector<size_t> starts_{0};
    std::vector<int64_t> columns_;
    std::vector<double> values_;
};

} // namespace nrb::inline numeric
