// SPDX-License-Identifier: MIT
// Fits with as few knots as a tolerance allows.
#pragma once

#include "base/numbers.h"
#include "fit/adaptive/fit_domain.h"
#include "fit/least_squares/fit_points.h"

namespace nrb::fit {

struct ToleranceFit {
    FittedPoints points;
    bool reached;
    int rounds; // fits over all data
};

// A spline with few control points, at most max_count, from which no datum is farther than the tolerance;
// otherwise the closest one that was found. Knots are distributed by the KnotDensity of a fit over uniform
// knots. Their number is found by bisection on some of the data, checked with all, and raised where it is not
// enough. At the limit of work, a usual one unless the caller has set one, the best knots found so far make
// the result. That takes one more fit, which may take about `seconds_for_one` seconds; if it would take
// longer, there is no result. Throws what fit_points() throws.
ToleranceFit fit_to_tolerance(const Data &data, const eval::AxisRules &rules, const FitDomain &domain,
                              double tolerance, int64_t max_count, const FitWishes &wishes,
                              double seconds_for_one = infinity);

} // namespace nrb::fit
