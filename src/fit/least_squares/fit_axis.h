// SPDX-License-Identifier: MIT
// An axis of a spline that is fitted, over the breaks of the data statistics.
#pragma once

#include "basis/knot_vector.h"
#include "numeric/double_double.h"

#include <cstdint>
#include <vector>

namespace nrb::fit {

// The coefficients that turn the sums of a span into normal equations, for degree q of the spline and p of
// the data. `functions`: the basis functions of the spline in Bernstein polynomials of degree p,
// [q + 1][p + 1]. `pairs`: the products of the i-th and j-th function, i <= j, in Bernstein polynomials of
// degree 2 p, row by row, [(q + 1)(q + 2) / 2][2 p + 1].
struct SpanTables {
    std::vector<DoubleDouble> functions;
    std::vector<DoubleDouble> pairs;
};

class FitAxis {
public:
    // The data are over `breaks` (an axis of degree 0), in polynomials of degree `data_degree`. Throws
    // Status::degree if the degree of the knots is higher, Status::not_a_knot with the index of a knot in the
    // domain that is not a break, and Status::outside_domain if the domain is not that of the breaks.
    FitAxis(KnotVectorPtr knots, KnotVectorPtr breaks, int data_degree, int axis);

    [[nodiscard]] const KnotVectorPtr &knots() const noexcept { return knots_; }
    [[nodiscard]] int degree() const noexcept { return knots_->degree(); }
    [[nodiscard]] int data_degree() const noexcept { return data_degree_; }
    [[nodiscard]] int64_t spans() const noexcept { return std::ssize(spans_); }
    // The index i of the knot at which non-empty span number s begins; it ends at knot i + 1.
    [[nodiscard]] int64_t knot_index(int64_t s) const noexcept { return spans_[static_cast<size_t>(s)]; }
    // The span that a cell lies in.
    [[nodiscard]] int64_t span_of(int64_t cell) const noexcept { return span_of_[static_cast<size_t>(cell)]; }

    [[nodiscard]] SpanTables tables(int64_t span) const;
    // The sums of the pairs of a curve, from the sums of a span, without a table of pairs: less work for a
    // single use.
    [[nodiscard]] std::vector<DoubleDouble> pair_sums(const std::vector<DoubleDouble> &functions,
                                                      const std::vector<DoubleDouble> &sums) const;
    [[nodiscard]] std::vector<DoubleDouble> function_table(int64_t span) const;
    // Turns the sums of the Bernstein polynomials of a degree on a cell, [degree + 1][inner], into the sums
    // of those on its span.
    void widen(int64_t cell, int degree, int64_t inner, DoubleDouble *sums) const noexcept;

private:
    KnotVectorPtr knots_, breaks_;
    int data_degree_;
    std::vector<int64_t> spans_;
    std::vector<int64_t> span_of_;
    std::vector<DoubleDouble> product_factors_; // [p + 1][p + 1]: B_i B_j = factor B_(i+j) of degree 2 p
};

} // namespace nrb::fit
