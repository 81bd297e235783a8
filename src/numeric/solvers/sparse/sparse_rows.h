// SPDX-License-Identifier: MIT
// Matrices of which few elements are not 0, by rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

class SparseRows {
public:
    // Elements of the last row, in any order; several of one column are added.
    void add(int64_t column, double value) { row_.push_back({column, value, row_.size()}); }
    // Ends the row, scaled to length 1 unless it is 0; returns the length it had.
    double end_row();

    [[nodiscard]] int64_t size() const noexcept { return std::ssize(starts_) - 1; }
    // Ascending.
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
        size_t number; // in the order in which they came, so that sums do not depend on the sorting
    };
    std::vector<Element> row_;
    std::vector<size_t> starts_{0};
    std::vector<int64_t> columns_;
    std::vector<double> values_;
};

} // namespace nrb::inline numeric
