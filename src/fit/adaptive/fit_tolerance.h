// SPDX-License-Identifier: MIT
// Fits with as few knots as a tolerance allows.
#pragma once

#include "fit/adaptive/find_breaks.h"
#include "fit/least_squares/fit_points.h"

#include <array>
#include <vector>

namespace nrb::fit {

// What a fit to a tolerance is over.
struct FitDomain {
    std::vector<int> degrees;
    std::vector<Interval> domains;
    std::array<bool, max_axes> periodic{};
    bool find_breaks = true;                           // kinks and jumps of curves become multiple knots
    std::array<std::vector<Break>, max_axes> breaks{}; // that are known; kept if there is room
    std::array<int, max_axes> seams{1, 1, 1};          // multiplicities of the ends of periodic axes
};

struct ToleranceFit {
    FittedPoints points;
    bool reached;
    int rounds; // over all data
};

// The spline with few control points, at most max_count, that no datum is farther from than the tolerance; else the closest
// one that was met. Knots lie where KnotDensity has them for a fit over even ones: their number is found by bisection on
// some of the data, checked with all, and raised where that does not do. Throws what fit_points() does.
ToleranceFit fit_to_tolerance(const Data &data, const eval::AxisRules &rules, const FitDomain &domain,
                              double tolerance, int64_t max_count, const FitWishes &wishes);

} // namespace nrb::fit
