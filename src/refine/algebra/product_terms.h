// SPDX-License-Identifier: MIT
// The control points of a product as means of products of polar-form values (common_knots.h): which values of
// the two factors each layer of an axis combines.
#pragma once

#include "refine/algebra/common_knots.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::refine {

// Values of a polar form, each stored as coefficients of consecutive stored layers.
class PolarRows {
public:
    [[nodiscard]] int64_t size() const noexcept { return std::ssize(rows_); }
    int32_t add(const CommonKnots &axis, int member, const BlossomRow &row);
    // out[l], l < length: the row applied to layers of `length` values each.
    void contract(int64_t row, const double *layers, int64_t length, double *out) const noexcept;

private:
    struct Row {
        int64_t layer;
        int size;
        size_t offset;
    };
    std::vector<Row> rows_;
    std::vector<double> coefficients_;
};

// The terms of some consecutive layers of a product's axis. Each layer is the mean over its terms, and a term
// combines one row of each factor. A row that several layers use, as neighbouring layers do, is stored once.
class ProductTerms {
public:
    struct Term {
        double weight; // a number of choices times a power of two that brings the sum near 1
        int32_t a;
        int32_t b;
    };

    // The layers from `first` on; how many is chosen for efficiency, see end().
    ProductTerms(const CommonKnots &axis, int degree_a, int64_t first);

    [[nodiscard]] int64_t first() const noexcept { return first_; }
    [[nodiscard]] int64_t end() const noexcept { return first_ + std::ssize(ends_); }
    [[nodiscard]] const PolarRows &rows(int member) const noexcept {
        return rows_[static_cast<size_t>(member)];
    }
    [[nodiscard]] std::span<const Term> layer(int64_t layer) const noexcept {
        const auto at = static_cast<size_t>(layer - first_);
        const size_t begin = at == 0 ? 0 : ends_[at - 1];
        return std::span(terms_).subspan(begin, ends_[at] - begin);
    }

    // The sum of the weights of the terms of a layer.
    static double total(int degree, int degree_a) noexcept;

private:
    class Builder;

    int64_t first_;
    std::vector<Term> terms_;
    std::vector<size_t> ends_;
    std::array<PolarRows, 2> rows_;
};

} // namespace nrb::refine
