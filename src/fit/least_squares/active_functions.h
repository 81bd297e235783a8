// SPDX-License-Identifier: MIT
// The basis functions of a spline that do not vanish at a place.
#pragma once

#include "fit/least_squares/stencil_pattern.h"

#include <span>

namespace nrb::fit {

// Products of those of the axes, or of derivatives of these, last axis fastest. Allocates nothing after the first place.
class ActiveFunctions {
public:
    explicit ActiveFunctions(const std::vector<KnotVectorPtr> &axes);

    // The place on an axis, which is in a span, and of which order the derivative is.
    void set(size_t axis, int64_t span, double t, int order = 0);
    // After the places on all axes.
    void multiply() noexcept;

    [[nodiscard]] size_t size() const noexcept { return steps_.size(); }
    [[nodiscard]] std::span<const double> values() const noexcept { return values_; }
    // Of the control point of a function, and that of function 0 with what the others are away from it.
    [[nodiscard]] Index layer(size_t i) const noexcept;
    [[nodiscard]] const Index &step(size_t i) const noexcept { return steps_[i]; }

private:
    std::vector<KnotVectorPtr> axes_;
    Index first_{};
    std::array<size_t, max_axes> widths_{1, 1, 1};
    std::array<std::vector<double>, max_axes> along_; // derivatives up to an order, the last one counts
    std::vector<Index> steps_;
    std::vector<double> values_;
};

} // namespace nrb::fit
