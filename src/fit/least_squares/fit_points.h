// SPDX-License-Identifier: MIT
// Fits of data that are at hand.
#pragma once

#include "fit/least_squares/fit.h"
#include "fit/statistics/gather.h"

namespace nrb::fit {

struct FittedPoints {
    Fitted fit;
    int64_t data_count;
    // Of |y - s(t)|, and where; -1 without data.
    double largest;
    int64_t largest_index;
    // Of robust fits: the standard deviation of a coordinate of weight 1, how many data are far off beside it, how many fits
    // were made, and whether the last one changed little.
    double scale = 0;
    int64_t outliers = 0;
    int rounds = 1;
    bool converged = true;
};

// fit() of the statistics of the data over the knots as breaks; `compared` with the data afterwards. Throws what gather() and fit() do.
FittedPoints fit_points(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes, bool compared);

// The squares that are left of the data by the spline as it is stored, in the units that the misfit has, and the largest
// distance, into `found`.
void compare(const Data &data, const eval::AxisRules &rules, FittedPoints &found);

// What statistics of the data over the knots as breaks are about.
std::shared_ptr<const StatisticsForm> form_for(const Data &data, const eval::AxisRules &rules,
                                               const std::vector<KnotVectorPtr> &axes);

// The smallest exponent for which |value| <= 2^exponent.
int exponent_above(double value) noexcept;

} // namespace nrb::fit
