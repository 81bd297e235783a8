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

// The spline with few control points, at most max_count, that no datum is farther from than the tolerance; else the closest
// one that was met. Knots lie where KnotDensity has them for a fit over even ones: their number is found by bisection on
// some of the data, checked with all, and raised where that does not do. At a limit of work, which is a usual one unless the
// caller has set one, the best knots that were met make the result: one fit more, which may take about so many seconds, else there is
// none. Throws what fit_points() does.
ToleranceFit fit_to_tolerance(const Data &data, const eval::AxisRules &rules, const FitDomain &domain,
                              double tolerance, int64_t max_count, const FitWishes &wishes,
                              double seconds_for_one = infinity);

} // namespace nrb::fit
