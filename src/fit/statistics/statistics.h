// SPDX-License-Identifier: MIT
// Sufficient statistics of data: all that least-squares fits of splines over given breaks need to know of
// them.
#pragma once

#include "basis/knot_vector.h"
#include "numeric/exact_sum.h"

#include <memory>
#include <span>
#include <vector>

namespace nrb::fit {

// What statistics must have in common to be added.
struct StatisticsForm {
    std::vector<int> degrees;
    std::vector<KnotVectorPtr> breaks; // of degree 0: a cell is a span on each axis
    int dim;
    // Exponents of powers of two that no |value|, and no weight, exceeds.
    int value_exponent;
    int weight_exponent;

    [[nodiscard]] int axes() const noexcept { return static_cast<int>(degrees.size()); }
    [[nodiscard]] int64_t cells_along(size_t axis) const noexcept { return breaks[axis]->count(); }
    friend bool operator==(const StatisticsForm &a, const StatisticsForm &b) noexcept;
};

// The sums of a cell, in this order, of w_i times
// - the products of the Bernstein polynomials of degree 2 p on each axis at the parameters, last axis fastest
//   ("moments"). The product of two Bernstein polynomials of degree p is a multiple of one of degree 2 p, so
//   that these sums give the normal equations of all polynomials of degree p on the cell, in fewer numbers;
// - the products of those of degree p, times the value: [..][dim];
// - the squared values: [dim];
// - 1.
struct CellLayout {
    explicit CellLayout(const StatisticsForm &form) noexcept;

    int64_t moments, functions, dim;
    [[nodiscard]] int64_t right() const noexcept { return moments; }
    [[nodiscard]] int64_t squares() const noexcept { return moments + functions * dim; }
    [[nodiscard]] int64_t weight() const noexcept { return squares() + dim; }
    [[nodiscard]] int64_t entries() const noexcept { return weight() + 1; }
};

// Bernstein polynomials are integers in units of 2^-62, values and weights integers in units of 2^-53 of
// their scales. Products of two polynomials, and of a value and a weight, are rounded to the same units; sums
// of w_i times one of them are exact. The sums therefore depend neither on the order of the data nor on the
// machine.
inline constexpr int function_bits = 62, value_bits = 53;

class Statistics {
public:
    explicit Statistics(std::shared_ptr<const StatisticsForm> form) : form_(std::move(form)) {}

    [[nodiscard]] const StatisticsForm &form() const noexcept { return *form_; }
    [[nodiscard]] const std::shared_ptr<const StatisticsForm> &shared_form() const noexcept { return form_; }

    // cells(): those that hold data, ascending, last axis fastest; counts(): the number of data in each;
    // sums(i): the sums of the i-th one.
    [[nodiscard]] std::span<const int64_t> cells() const noexcept { return cells_; }
    [[nodiscard]] std::span<const int64_t> counts() const noexcept { return counts_; }
    [[nodiscard]] std::span<const ExactSum> sums(int64_t i) const noexcept {
        const auto entries = static_cast<size_t>(CellLayout(*form_).entries());
        return std::span(sums_).subspan(static_cast<size_t>(i) * entries, entries);
    }
    [[nodiscard]] int64_t data_count() const noexcept;
    [[nodiscard]] double weight() const noexcept;

    // Cells have to be appended in ascending order; those without data are left out.
    void append(int64_t cell, int64_t count, std::span<const ExactSum> sums);
    void reserve(size_t cells);

private:
    std::shared_ptr<const StatisticsForm> form_;
    std::vector<int64_t> cells_, counts_;
    std::vector<ExactSum> sums_;
};

using StatisticsPtr = std::shared_ptr<const Statistics>;

// The sum of at least one part, each times its sign, 1 or -1 (empty: all 1). Throws Status::incompatible
// where the forms differ, and Status::count where more data are taken from a cell than it holds.
Statistics merged(std::span<const StatisticsPtr> parts, std::span<const int32_t> signs);

} // namespace nrb::fit
