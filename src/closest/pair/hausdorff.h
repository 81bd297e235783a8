// SPDX-License-Identifier: MIT
// How far the point of a spline that is farthest from another one is from it.
#pragma once

#include "closest/pair/region.h"
#include "spline/spline.h"

#include <array>

namespace nrb::closest {

struct FarthestPoint {
    double at_least = 0;
    double at_most = 0;
    std::array<double, max_axes> params{}; // of a point that is at_least away
    bool certified = false;
};

// The largest distance of a point of `from` to the nearest one of `to`. Best first over pieces of `from`: the
// nearest point of the middle gives a lower bound; the farthest control point from that point an upper one,
// which is good where the splines are apart, and matching with a piece of `to` another, which is good where
// they touch. `budget`: most pieces looked at. Throws Status::incompatible, not_representable.
FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget);

// The same for points of one region and nearest points of another one; null: all of a spline. Where at_least is 0 the parameters
// may be those of any place.
FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget,
                                 const Region *in_from, Region *in_to);

} // namespace nrb::closest
