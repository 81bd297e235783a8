// SPDX-License-Identifier: MIT
// Layers of data along an axis, and the interpolation conditions that they give.
#pragma once

#include "fit/axis_interpolation.h"
#include "fit/interpolation_knots.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::fit {

// Layers of values at parameters, and of derivatives at the first and the last parameter.
struct AxisLayers : Sites {
    // The parameters of the values; `room` stores them if there are derivatives as well.
    [[nodiscard]] std::span<const double> params_of_values(std::vector<double> &room) const;
    // The numbers of derivatives at the start and at the end.
    [[nodiscard]] std::array<int, 2> derivatives() const noexcept;
};

// Requires finite parameters that increase, and repeat only where the orders rise; a value at each of them;
// and derivatives up to the degree, only at the first and the last parameter of an axis that is not periodic.
// `first` is where the axis begins in the caller's arrays. Throws Status::parameter_not_finite,
// knots_decreasing, order.
void check_layers(const AxisLayers &layers, int degree, bool periodic, size_t axis, int64_t first);

// Conditions, and for each the layer of data that it comes from; -1 stands for a layer of zeros. Without
// sources, condition i comes from layer i.
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

// The conditions on an axis over interpolation_knots(), in ascending order of parameters: those of the
// layers, except the last layer of a periodic axis, and the vanishing derivatives of natural ends. The value
// at the start is the first condition, the value at the end the last one. The arrays of the layers have to
// outlive the result.
AxisConditions conditions_of(const AxisLayers &layers, int degree, Ends ends, bool periodic);

} // namespace nrb::fit
