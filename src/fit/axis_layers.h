// SPDX-License-Identifier: MIT
// What the layers of data along an axis are, and which conditions they make.
#pragma once

#include "fit/axis_interpolation.h"
#include "fit/interpolation_knots.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

// Layers of values at parameters, and of derivatives at the first and the last one.
struct AxisLayers {
    std::span<const double> params;
    std::span<const int32_t> orders; // empty: values only

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(params); }
    [[nodiscard]] int order(int64_t i) const noexcept {
        return orders.empty() ? 0 : orders[static_cast<size_t>(i)];
    }
    [[nodiscard]] double param(int64_t i) const noexcept { return params[static_cast<size_t>(i)]; }
    // Those of values, in `room` where they are not all.
    [[nodiscard]] std::span<const double> sites(std::vector<double> &room) const;
    // How many derivatives there are at the start and at the end.
    [[nodiscard]] std::array<int, 2> derivatives() const noexcept;
};

// Parameters finite, increasing, and equal only where orders rise; values at each of them, derivatives up to the degree at the
// first and the last one of an axis that is not periodic. `first` is the place of the axis in the caller's arrays. Throws
// Status::parameter_not_finite, knots_decreasing, order.
void check_layers(const AxisLayers &layers, int degree, bool periodic, size_t axis, int64_t first);

// Conditions, and the layers of data that they come from, -1 for zeros.
struct AxisConditions {
    std::vector<Condition> conditions;
    std::vector<int64_t> sources;

    void add(double param, int order, int64_t source) {
        conditions.push_back({param, order});
        sources.push_back(source);
    }
};

// The conditions on an axis over interpolation_knots(), by rising parameters: those of the layers, but for the last one of a
// periodic axis, and the derivatives that vanish at natural ends. The value at an end is the first, and the last one.
AxisConditions conditions_of(const AxisLayers &layers, int degree, Ends ends, bool periodic);

} // namespace nrb::fit
