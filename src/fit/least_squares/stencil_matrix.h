// SPDX-License-Identifier: MIT
// Symmetric matrices over the control points of a spline, which couple those whose basis functions overlap.
#pragma once

#include "fit/least_squares/stencil_pattern.h"
#include "numeric/double_double.h"
#include "numeric/solvers/sparse/sparse_ldlt.h"

namespace nrb::fit {

class StencilMatrix {
public:
    explicit StencilMatrix(const std::vector<KnotVectorPtr> &axes, const Index &least_reach = {});

    [[nodiscard]] const StencilPattern &pattern() const noexcept { return pattern_; }
    [[nodiscard]] int axes() const noexcept { return pattern_.axes(); }
    [[nodiscard]] int64_t size() const noexcept { return pattern_.size(); }
    [[nodiscard]] int64_t unknown(const Index &layer) const noexcept { return pattern_.unknown(layer); }
    // Adds to the element of two control points and to its mirror image; `second` is not before `first` in
    // lexicographic order.
    void add(const Index &first, const Index &second, const DoubleDouble &value) noexcept;
    // Adds factor times a matrix of the same pattern.
    void add_multiple(double factor, const StencilMatrix &other) noexcept;
    [[nodiscard]] DoubleDouble trace() const noexcept;
    // The mean of the diagonal; 1 where that is 0.
    [[nodiscard]] DoubleDouble mean() const noexcept;

    [[nodiscard]] std::vector<int64_t> elimination_order() const { return pattern_.elimination_order(); }
    // The columns in that order, with all elements that overlapping functions can have, whether 0 or not.
    [[nodiscard]] ColumnsOf<DoubleDouble> columns(const std::vector<int64_t> &order) const;

private:
    StencilPattern pattern_;
    std::vector<DoubleDouble> values_; // by places of the pattern
};

} // namespace nrb::fit
