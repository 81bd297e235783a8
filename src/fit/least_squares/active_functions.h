// SPDX-License-Identifier: MIT
// The basis functions of a spline that do not vanish at a point of the domain.
#pragma once

#include "fit/least_squares/stencil_pattern.h"

#include <span>

namespace nrb::fit {

// Tensor products of the active basis functions of the axes, or of derivatives of these, last axis fastest.
// Allocates nothing after the first point.
class ActiveFunctions {
public:
    explicit ActiveFunctions(const std::vector<KnotVectorPtr> &axes);

    // Sets the parameter on an axis, which lies in `span`, and the order of the derivative along it.
    void set(size_t axis, int64_t span, double t, int order = 0);
    // Forms the products, after set() on all axes.
    void multiply() noexcept;

    [[nodiscard]] size_t size() const noexcept { return steps_.size(); }
    [[nodiscard]] std::span<const double> values() const noexcept { return values_; }
    // layer(): the indices of the control point of function i. step(): these relative to the control point of
    // function 0.
    [[nodiscard]] Index layer(size_t i) const noexcept;
    [[nodiscard]] const Index &step(size_t i) const noexcept { return steps_[i]; }

private:
    std::vector<KnotVectorPtr> axes_;
    Index first_{};
    std::array<size_t, max_axes> widths_{1, 1, 1};
    std::array<std::vector<double>, max_axes> along_; // derivatives up to an order; the last one is used
    std::vector<Index> steps_;
    std::vector<double> values_;
};

} // namespace nrb::fit
