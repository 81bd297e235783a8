// SPDX-License-Identifier: MIT
// An axis of a spline that is fitted, over the breaks of the data.
#pragma once

#include "basis/knot_vector.h"
#include "numeric/double_double.h"

#include <cstdint>
#include <vector>

namespace nrb::fit {

// What an axis makes of the sums of a span: the coefficients, in Bernstein functions of degree p, of the functions of the
// spline, [q + 1][p + 1], and in those of degree 2 p, of the products of the i-th and j-th function, i <= j, row after row,
// [(q + 1)(q + 2) / 2][2 p + 1].
struct SpanTables {
    std::vector<DoubleDouble> functions;
    std::vector<DoubleDouble> pairs;
};

class FitAxis {
public:
    // Data over `breaks` (of degree 0), in polynomials of degree `data_degree`. Throws Status::degree if that of the knots is
    // higher, Status::not_a_knot with the index of a knot in the domain that is no break, and Status::outside_domain where
    // the domain is not that of the breaks.
    FitAxis(KnotVectorPtr knots, KnotVectorPtr breaks, int data_degree, int axis);

    [[nodiscard]] const KnotVectorPtr &knots() const noexcept { return knots_; }
    [[nodiscard]] int degree() const noexcept { return knots_->degree(); }
    [[nodiscard]] int data_degree() const noexcept { return data_degree_; }
    [[nodiscard]] int64_t spans() const noexcept { return std::ssize(spans_); }
    // Knots [i] and [i + 1] are the ends of non-empty span number s.
    [[nodiscard]] int64_t knot_index(int64_t s) const noexcept { return spans_[static_cast<size_t>(s)]; }
    // The span that a cell lies in.
    [[nodiscard]] int64_t span_of(int64_t cell) const noexcept { return span_of_[static_cast<size_t>(cell)]; }

    [[nodiscard]] SpanTables tables(int64_t span) const;
    // What the pairs of a curve make of the sums of a span, without a table of theirs: for one use less work.
    [[nodiscard]] std::vector<DoubleDouble> pair_sums(const std::vector<DoubleDouble> &functions,
                                                      const std::vector<DoubleDouble> &sums) const;
    [[nodiscard]] std::vector<DoubleDouble> function_table(int64_t span) const;
    // Sums of the functions of a degree on a cell, [degree + 1][inner], become those of the functions on its span.
    void widen(int64_t cell, int degree, int64_t inner, DoubleDouble *sums) const noexcept;

private:
    KnotVectorPtr knots_, breaks_;
    int data_degree_;
    std::vector<int64_t> spans_;
    std::vector<int64_t> span_of_;
    std::vector<DoubleDouble> product_factors_; // [p + 1][p + 1]: B_i B_j = factor B_(i+j) of degree 2 p
};

} // namespace nrb::fit
