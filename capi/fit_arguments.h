// SPDX-License-Identifier: MIT
// Arguments of fits: data, statistics and options.
#pragma once

#include "checks.h"

#include "fit/least_squares/fit.h"
#include "fit/statistics/gather.h"

struct nurbs_statistics {
    nrb::fit::StatisticsPtr statistics;
};

namespace nrb::capi {

const fit::StatisticsPtr &statistics_of(const nurbs_statistics *statistics, const char *name = "statistics");

struct CheckedData {
    fit::Data data;
    eval::AxisRules rules;
};
// Checks axes, dimension, layout and flags; fit::gather() checks the numbers.
CheckedData checked_data(const nurbs_data *data);

// Evaluation flags for the parameters of data, which are never extrapolated: NURBS_EXTRAPOLATE is refused.
// `where` precedes "flags" in messages.
eval::AxisRules data_rules(uint32_t flags, int axes, const char *where);

// The options, checked; NULL stands for the defaults.
fit::FitWishes checked_wishes(const nurbs_fit_options *options, const Spline::Axes &axes, int dim);

} // namespace nrb::capi
