// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/sparse_rows.h"

#include "numeric/norm.h"

#include <algorithm>
#include <utility>

namespace nrb::inline numeric {

double SparseRows::end_row() {
    std::sort(row_.begin(), row_.end(), [](const Element &a, const Element &b) {
        return std::pair(a.column, a.number) < std::pair(b.column, b.number);
    });
    const size_t begin = starts_.back();
    for (const Element &element : row_) {
        if (columns_.size() > begin && columns_.back() == element.column) {
            values_.back() += element.value;
        } else {
            columns_.push_back(element.column);
            values_.push_back(element.value);
        }
    }
    row_.clear();
    starts_.push_back(columns_.size());
    const double length = norm(values_.data() + begin, static_cast<int>(values_.size() - begin));
    for (size_t i = begin; i < values_.size() && length > 0; ++i) {
        values_[i] /= length;
    }
    return length;
}

} // namespace nrb::inline numeric
