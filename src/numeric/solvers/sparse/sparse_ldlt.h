// SPDX-License-Identifier: MIT
// L D L^T of sparse symmetric matrices, row by row, so that the caller can be told of them.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// A symmetric matrix by columns: the rows of column j and their values are those from starts[j] to starts[j + 1].
// Rows ascend, and all diagonal elements are there.
struct SparseColumns {
    std::vector<int64_t> starts;
    std::vector<int32_t> rows;
    std::vector<double> values;

    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(starts.size()) - 1; }
};

// Up-looking, as in T. Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 4: row k of L solves a
// triangular system with the rows before it; which of its elements are not 0 follows from the elimination tree.
// Cost: the sum of squares of the numbers of elements in the columns of L.
class SparseLdlt {
public:
    // Finds the tree, and how many elements the columns of L have.
    explicit SparseLdlt(const SparseColumns &pattern);

    // Multiply-adds of a factorisation.
    [[nodiscard]] double cost() const noexcept;
    // False if D is not positive. The matrix has the pattern that was given first.
    bool factorise(const SparseColumns &matrix);
    // Solves for `width` right sides side by side, in place: x[size][width].
    void solve(double *x, int64_t width) const;

private:
    template <class Visit>
    void for_each_in_row(const SparseColumns &matrix, int32_t k, Visit &&visit);
    int64_t gather_row(const SparseColumns &matrix, int32_t k);

    std::vector<int32_t> parent_; // in the elimination tree, -1: a root
    std::vector<int64_t> starts_; // of the columns of L
    std::vector<int64_t> filled_; // elements of each column so far
    std::vector<int32_t> rows_;
    std::vector<double> values_;
    std::vector<double> diagonal_;
    std::vector<int32_t> flags_; // the row that saw a node last
    std::vector<int32_t> path_;  // the elements of a row, from the back in the order of the tree
    std::vector<double> work_;
};

} // namespace nrb::inline numeric
