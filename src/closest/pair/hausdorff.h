// SPDX-License-Identifier: MIT
// The one-sided Hausdorff distance between two splines.
#pragma once

#include "closest/pair/region.h"
#include "spline/spline.h"

#include <array>

namespace nrb::closest {

struct FarthestPoint {
    double at_least = 0;
    double at_most = 0;
    std::array<double, max_axes> params{}; // of a point of `from` at this distance
    bool certified = false;
};

// The one-sided Hausdorff distance max over points x of `from` of the distance from x to `to`. Best-first
// branch and bound over pieces of `from`: the nearest point of the middle of a piece gives a lower bound. The
// largest distance of a control point from that nearest point gives an upper bound, which is good where the
// splines are apart; matching the piece with a piece of `to` gives another one, which is good where they
// touch. `budget`: most pieces examined. Throws Status::incompatible, not_representable.
FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget);

// The same for the points of a region of `from` and the nearest points in a region of `to`; null: the whole
// spline. If at_least is 0, the parameters may be those of any place.
FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget,
                                 const Region *in_from, Region *in_to);

} // namespace nrb::closest
