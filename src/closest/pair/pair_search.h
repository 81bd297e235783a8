// SPDX-License-Identifier: MIT
// The smallest distance of two splines.
#pragma once

#include "base/numbers.h"
#include "closest/pair/region.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::closest {

struct PairDistance {
    double at_least = 0;
    double at_most = 0; // distance of the points at the parameters
    std::array<double, max_axes> params_a{}, params_b{};
    std::array<bool, max_axes> left_a{}, left_b{}; // whether limits from below are meant
    bool certified = false;
    double rounding = 0; // what it leaves open between both bounds
};

// Best first over pairs of pieces, or groups of them in boxes. At each pair that is looked at a descent gives
// an upper bound, and separating surfaces a lower one that is good to the second order; near a minimum that
// grows to the second order a constant number of pairs is left at each size. `budget`: most pairs looked at.
// Throws Status::incompatible, not_representable.
PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget);

// The same for nearest points of regions that are no farther than `far` from each other. at_most is infinite if there are none;
// unless boundaries count, what lies on them may be nearer than at_least.
PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget,
                           const Regions &regions, double far);

} // namespace nrb::closest
