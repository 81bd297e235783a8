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
struct AxisLayers : Sites {
    // Parameters of the values, in `room` where there are others.
    [[nodiscard]] std::span<const double> params_of_values(std::vector<double> &room) const;
    // How many derivatives there are at the start and at the end.
    [[nodiscard]] std::array<int, 2> derivatives() const noexcept;
};

// Parameters finite, increasing, and equal only where orders rise; values at each of them, derivatives up to the degree at the
// first and the last one of an axis that is not periodic. `first` is the place of the axis in the caller's arrays. Throws
// Status::parameter_not_finite, knots_decreasing, order.
void check_layers(const AxisLayers &layers, int degree, bool periodic, size_t axis, int64_t first);

// Conditions, and the layers of data that they come from, -1 for zeros; no sources: the layers in turn.
class AxisConditions {
public:
    AxisConditions() = default;
    explicit AxisConditions(const Sites &layers) : sites_(layers) {}
    AxisConditions(AxisConditions &&) noexcept = default;
    AxisConditions(const AxisConditions &) = delete;
    AxisConditions &operator=(const AxisConditions &) = delete;

    void reserve(size_t count);
    void add(double param, int order, int64_t source);

    [[nodiscard]] Sites sites() const noexcept { return sources_.empty() ? sites_ : Sites{params_, orders_}; }
    [[nodiscard]] std::span<const int64_t> sources() const noexcept { return sources_; }

private:
    Sites sites_;
    std::vector<double> params_;
    std::vector<int32_t> orders_;
    std::vector<int64_t> sources_;
};

// The conditions on an axis over interpolation_knots(), by rising parameters: those of the layers, but for the last one of a
// periodic axis, and the derivatives that vanish at natural ends. The value at an end is the first, and the last one. The arrays
// of the layers have to outlive them.
AxisConditions conditions_of(const AxisLayers &layers, int degree, Ends ends, bool periodic);

} // namespace nrb::fit
