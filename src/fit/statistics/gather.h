// SPDX-License-Identifier: MIT
// Statistics of points.
#pragma once

#include "base/records.h"
#include "eval/parameters.h"
#include "fit/statistics/statistics.h"

namespace nrb::fit {

// Data as the caller has them: values at parameters, with weights or without (data null: all 1).
struct Data {
    ConstRecords params;
    ConstRecords values;
    ConstRecords weights;
};

// Statistics of the data. A parameter that the rules make NaN leaves its point out, and so does a weight of 0, whatever the
// value is. Throws Status::parameter_not_finite, outside_domain, point_not_finite, weight_not_finite, weight_negative, and
// Status::scale for a value or a weight above its scale, with the index of the first one; none are gathered then.
Statistics gather(std::shared_ptr<const StatisticsForm> form, const Data &data, const eval::AxisRules &rules);

} // namespace nrb::fit
