// SPDX-License-Identifier: MIT
// The smallest distance between two splines.
#pragma once

#include "base/numbers.h"
#include "closest/pair/region.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::closest {

struct PairDistance {
    double at_least = 0;
    double at_most = 0; // the distance of the points at the parameters
    std::array<double, max_axes> params_a{}, params_b{};
    std::array<bool, max_axes> left_a{}, left_b{}; // whether limits from below are meant
    bool certified = false;
    double rounding = 0; // the gap between both bounds that rounding may leave
};

// Best-first branch and bound over pairs of pieces, or of groups of pieces in boxes. For each pair examined,
// a descent gives an upper bound, and separating surfaces give a lower bound with an error of second order.
// Near a minimum from which the distance grows quadratically, only a constant number of pairs therefore
// remains at each size. `budget`: most pairs examined. Throws Status::incompatible, not_representable.
PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget);

// The same for the nearest points of two regions that are at most `far` apart. at_most is infinite if no such
// points are found. Unless boundaries count, points on them may be nearer than at_least.
PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget,
                           const Regions &regions, double far);

} // namespace nrb::closest
