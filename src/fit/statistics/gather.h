// SPDX-License-Identifier: MIT
// Gathers the statistics of data points.
#pragma once

#include "base/records.h"
#include "eval/parameters.h"
#include "fit/statistics/statistics.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

// Data as the caller has them: values at parameters, with weights or without (data null: all 1).
struct Data {
    ConstRecords params;
    ConstRecords values;
    ConstRecords weights;
};

// The largest finite weight; 0 without weights.
double largest_weight(const Data &data) noexcept;

// Which data count: those of a weight above 2^-54 of the scale, at parameters that the rules do not make NaN.
class CountedData {
public:
    // `domains` of the axes.
    CountedData(const Data &data, const eval::AxisRules &rules, std::vector<Interval> domains,
                int weight_exponent)
        : data_(data), rules_(rules), domains_(std::move(domains)),
          least_weight_(std::ldexp(1.0, weight_exponent - value_bits - 1)) {}

    [[nodiscard]] bool operator()(int64_t i) const noexcept {
        if (data_.weights.data != nullptr && !(data_.weights(i, 0) > least_weight_)) {
            return false;
        }
        for (size_t k = 0; k < domains_.size(); ++k) {
            const double t = place(i, k);
            if (!(t == t)) {
                return false;
            }
        }
        return true;
    }
    // Whether a quick look at all parameters shows that these data count; false does not mean that some do
    // not.
    [[nodiscard]] bool surely_all(int64_t first, int64_t count) const noexcept {
        const ConstRecords &params = data_.params;
        const auto axes = static_cast<int>(domains_.size());
        const bool packed = params.stride == axes && (params.component_stride == 1 || axes == 1);
        const bool wrapped =
            std::any_of(rules_.begin(), rules_.begin() + axes,
                        [](const eval::AxisRule &rule) { return rule.outside == eval::Outside::wrap; });
        return data_.weights.data == nullptr && packed && !wrapped &&
               eval::all_inside(params.record(first), count * axes, axes, domains_.data());
    }
    // The parameter of a datum on an axis, as the rules place it.
    [[nodiscard]] double place(int64_t i, size_t k) const noexcept {
        return eval::place(data_.params(i, static_cast<int64_t>(k)), rules_[k], domains_[k]);
    }

private:
    const Data &data_;
    const eval::AxisRules &rules_;
    std::vector<Interval> domains_;
    double least_weight_;
};

// The statistics of the data. A point is left out, whatever its value is, if the rules make a parameter NaN
// or if its weight is 0. Throws Status::parameter_not_finite, outside_domain, point_not_finite,
// weight_not_finite, weight_negative, and Status::scale for a value or a weight above its scale, with the
// index of the first such datum; nothing is gathered then.
Statistics gather(std::shared_ptr<const StatisticsForm> form, const Data &data, const eval::AxisRules &rules);

// The weight of datum i, 1 without weights. Throws Status::weight_not_finite, weight_negative.
double checked_weight(const ConstRecords &weights, int64_t i);

// Throws what gather() would throw, without gathering.
void check_data(const StatisticsForm &form, const Data &data, const eval::AxisRules &rules);

} // namespace nrb::fit
