// SPDX-License-Identifier: MIT
// How far data are from a spline.
#pragma once

#include "fit/statistics/gather.h"
#include "spline/spline.h"

#include <functional>
#include <span>

namespace nrb::fit {

// Calls visit(index of the first datum, |y - s(t)| of it and those that follow) for one block of data after the other; NaN for
// data that do not count.
void for_each_distance(const Data &data, const eval::AxisRules &given, int weight_exponent,
                       const Spline &spline,
                       const std::function<void(int64_t, std::span<const double>)> &visit);

inline double weight_of(const Data &data, int64_t i) noexcept {
    return data.weights.data == nullptr ? 1 : data.weights(i, 0);
}

} // namespace nrb::fit
