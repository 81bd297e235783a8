// SPDX-License-Identifier: MIT
// L D L^T of sparse symmetric matrices.
#pragma once

#include "numeric/double_double.h"
#include "numeric/solvers/sparse/supernodes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// Up-looking, as in T. Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 4: row k of L solves a
// triangular system with the rows before it; which of its elements are not 0 follows from the elimination tree.
// Cost: the sum of squares of the numbers of elements in the columns of L.
// Numbers are doubles, or have twice the precision. Doubles with many elements in a column are factorised by dense blocks.
template <class Number>
class LdltOf {
public:
    // Finds the tree, and how many elements the columns of L have.
    template <class Any>
    explicit LdltOf(const ColumnsOf<Any> &pattern);

    // Multiply-adds of a factorisation.
    [[nodiscard]] double cost() const noexcept;
    // The matrix has the pattern that was given first. Returns -1, or the first element of D that is not above its floor
    // (none: 0), behind which there are no factors.
    int64_t factorise(const ColumnsOf<Number> &matrix, std::span<const double> floors = {});
    // Solves for `width` right sides side by side, in place: x[size][width].
    void solve(Number *x, int64_t width) const;
    // L without its diagonal, by columns, and D.
    [[nodiscard]] std::span<const int64_t> starts() const noexcept { return starts_; }
    [[nodiscard]] std::span<const int32_t> rows() const noexcept { return rows_; }
    [[nodiscard]] std::span<const Number> values() const noexcept { return values_; }
    [[nodiscard]] std::span<const Number> diagonal() const noexcept { return diagonal_; }
    // Those that L is made of; none where its columns are short.
    [[nodiscard]] const Supernodes &supernodes() const noexcept { return supernodes_; }

private:
    template <class Any>
    void join_columns(const ColumnsOf<Any> &pattern);
    void fill_rows() noexcept; // with those of the supernodes
    int64_t factorise_rows(const ColumnsOf<Number> &matrix, std::span<const double> floors);
    template <class Any, class Visit>
    void for_each_in_row(const ColumnsOf<Any> &matrix, int32_t k, Visit &&visit);
    int64_t gather_row(const ColumnsOf<Number> &matrix, int32_t k);

    Supernodes supernodes_;
    std::vector<int32_t> parent_; // in the elimination tree, -1: a root
    std::vector<int64_t> starts_; // of the columns of L
    std::vector<int64_t> filled_; // elements of each column so far
    std::vector<int32_t> rows_;
    std::vector<Number> values_;
    std::vector<Number> diagonal_;
    std::vector<int32_t> flags_; // the row that saw a node last
    std::vector<int32_t> path_;  // the elements of a row, from the back in the order of the tree
    std::vector<Number> work_;
};

using SparseLdlt = LdltOf<double>;
extern template class LdltOf<double>;
extern template class LdltOf<DoubleDouble>;

} // namespace nrb::inline numeric
