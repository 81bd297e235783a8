// SPDX-License-Identifier: MIT
// Fits of data points, by way of their statistics.
#pragma once

#include "fit/least_squares/fit.h"
#include "fit/statistics/gather.h"

namespace nrb::fit {

struct FittedPoints {
    Fitted fit;
    int64_t data_count;
    // The largest |y - s(t)| and its index; -1 without data.
    double largest;
    int64_t largest_index;
    // For robust fits: the standard deviation of a coordinate of weight 1, the number of data far off
    // relative to it, the number of fits that were made, and whether the last one changed little.
    double scale = 0;
    int64_t outliers = 0;
    int rounds = 1;
    bool converged = true;
};

// fit() of the statistics of the data, gathered with the knots as breaks; compare() afterwards if `compared`.
// Throws what gather() and fit() throw.
FittedPoints fit_points(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes, bool compared);

// Sets in `found` the squares that the spline, as it is stored, leaves of the data, in the units of the
// misfit, and the largest distance.
void compare(const Data &data, const eval::AxisRules &rules, FittedPoints &found);

// The form of the statistics of the data with the knots as breaks.
std::shared_ptr<const StatisticsForm> form_for(const Data &data, const eval::AxisRules &rules,
                                               const std::vector<KnotVectorPtr> &axes);

// The smallest exponent for which value <= 2^exponent; 0 for the value 0. Precondition: value >= 0.
int exponent_above(double value) noexcept;

} // namespace nrb::fit
