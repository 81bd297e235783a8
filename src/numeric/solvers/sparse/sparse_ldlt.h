// SPDX-License-Identifier: MIT
// L D L^T factorisation of sparse symmetric matrices.
#pragma once

#include "numeric/double_double.h"
#include "numeric/solvers/sparse/supernodes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// Up-looking, as in T. Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 4: row k of L solves
// a triangular system with the rows before it; the elimination tree determines its nonzeros. Cost: the sum of
// the squares of the column counts of L. Numbers are doubles or double-doubles. Factors of doubles with long
// columns are computed by dense blocks instead (multifrontal.h).
template <class Number>
class LdltOf {
public:
    // Symbolic analysis: computes the elimination tree and the column counts of L.
    template <class Any>
    explicit LdltOf(const ColumnsOf<Any> &pattern);

    // Multiply-adds of a factorisation.
    [[nodiscard]] double cost() const noexcept;
    // Numerical factorisation; the matrix has the pattern given to the constructor. Returns -1, or the index
    // of the first element of D that is not above its floor (no floors: 0); then there are no valid factors
    // from that element on.
    int64_t factorise(const ColumnsOf<Number> &matrix, std::span<const double> floors = {});
    // Solves for `width` right-hand sides stored side by side, in place: x[size][width].
    void solve(Number *x, int64_t width) const;
    // L without its diagonal, by columns, and D.
    [[nodiscard]] std::span<const int64_t> starts() const noexcept { return starts_; }
    [[nodiscard]] std::span<const int32_t> rows() const noexcept { return rows_; }
    [[nodiscard]] std::span<const Number> values() const noexcept { return values_; }
    [[nodiscard]] std::span<const Number> diagonal() const noexcept { return diagonal_; }
    // The supernodes of L; empty if its columns are short.
    [[nodiscard]] const Supernodes &supernodes() const noexcept { return supernodes_; }

private:
    template <class Any>
    void join_columns(const ColumnsOf<Any> &pattern);
    void fill_rows() noexcept; // with the rows of the supernodes
    int64_t factorise_rows(const ColumnsOf<Number> &matrix, std::span<const double> floors);
    template <class Any, class Visit>
    void for_each_in_row(const ColumnsOf<Any> &matrix, int32_t k, Visit &&visit);
    int64_t gather_row(const ColumnsOf<Number> &matrix, int32_t k);

    Supernodes supernodes_;
    std::vector<int32_t> parent_; // in the elimination tree, -1: a root
    std::vector<int64_t> starts_; // of the columns of L
    std::vector<int64_t> filled_; // end of the filled part of each column
    std::vector<int32_t> rows_;
    std::vector<Number> values_;
    std::vector<Number> diagonal_;
    std::vector<int32_t> flags_; // the last row that visited a node
    std::vector<int32_t> path_;  // the elements of a row, stored from the back in tree order
    std::vector<Number> work_;
};

using SparseLdlt = LdltOf<double>;
extern template class LdltOf<double>;
extern template class LdltOf<DoubleDouble>;

} // namespace nrb::inline numeric
