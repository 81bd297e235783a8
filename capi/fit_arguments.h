// SPDX-License-Identifier: MIT
// Data and wishes of fits.
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
// Axes, dimension, layout and flags; the numbers are left to fit::gather().
CheckedData checked_data(const nurbs_data *data);

// Evaluation flags for places of data, which are not extrapolated; `where` precedes the name in messages.
eval::AxisRules data_rules(uint32_t flags, int axes, const char *where);

// NULL: the defaults.
fit::FitWishes checked_wishes(const nurbs_fit_options *options, const Spline::Axes &axes, int dim);

} // namespace nrb::capi
