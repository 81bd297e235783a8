// SPDX-License-Identifier: MIT
// Distances of data from a spline.
#pragma once

#include "fit/statistics/gather.h"
#include "spline/spline.h"

#include <functional>
#include <span>

namespace nrb::fit {

// Calls visit(index of the first datum, distances |y - s(t)| of it and the data that follow) for one block of
// data after the other. The distance of data that do not count is NaN.
void for_each_distance(const Data &data, const eval::AxisRules &given, int weight_exponent,
                       const Spline &spline,
                       const std::function<void(int64_t, std::span<const double>)> &visit);

inline double weight_of(const Data &data, int64_t i) noexcept {
    return data.weights.data == nullptr ? 1 : data.weights(i, 0);
}

} // namespace nrb::fit
