// SPDX-License-Identifier: MIT
// Output arrays for sparse matrices. A call with cap = 0 asks for their length; another call fills them.
#pragma once

#include "outputs.h"

#include "eval/functions/collocation.h"

namespace nrb::capi {

// The caller's arrays for a matrix in compressed sparse rows (CSR).
class SparseArrays {
public:
    SparseArrays(int64_t cap, double *values, int64_t *columns, int64_t *row_pointers, int64_t *entries)
        : cap_(cap), values_(values), columns_(columns), row_pointers_(row_pointers), entries_(entries) {}

    // Checks lengths and overlap for a matrix of n rows and `total` entries; returns the arrays to be filled,
    // which include row_pointers also if cap is 0.
    [[nodiscard]] eval::SparseRows check(int64_t n, int64_t total,
                                         std::initializer_list<Memory> inputs) const {
        const int64_t filled = checked_cap(cap_, total);
        const eval::SparseRows rows{cap_ == 0 ? nullptr : values_, cap_ == 0 ? nullptr : columns_,
                                    row_pointers_};
        check_apart({memory("values", rows.values, filled), memory("columns", rows.columns, filled),
                     memory("row_pointers", row_pointers_, n + 1), memory("entries", entries_, 1)},
                    inputs);
        return rows;
    }
    void finish(int64_t total) const noexcept { put(entries_, total); }

private:
    int64_t cap_;
    double *values_;
    int64_t *columns_;
    int64_t *row_pointers_;
    int64_t *entries_;
};

} // namespace nrb::capi
