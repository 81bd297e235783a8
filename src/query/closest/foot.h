// What queries for closest points ask, and what they answer.
#pragma once

#include "basis/knot_vector.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <limits>

namespace nrb {

// What gradual underflow may add to a distance, since coordinates that small are rounded to a multiple of it.
inline constexpr double underflow_noise = 64 * std::numeric_limits<double>::denorm_min();

// The answer to one query. Status: NURBS_CLOSEST_ bits.
struct Foot {
    std::array<double, max_axes> params{};
    double distance = 0;
    int32_t status = 0;
    double noise = 0;   // what rounding leaves open in the distance
    uint32_t left = 0;  // bit k: at parameter k the limit from below is meant
    int64_t looked = 0; // pieces that were looked at for it
};

// A place where the distance is critical. Kind: a NURBS_CRITICAL_ constant.
struct CriticalPoint {
    Foot foot;
    int32_t kind = 0;
};

// What every query asks for.
struct Query {
    const double *point;   // [dim], finite
    const Interval *range; // [axes], in the domain; or null for all of it
    double tolerance;      // how much nearer another point may be
    int64_t budget;        // most pieces looked at
    bool farthest = false; // the farthest point in place of the nearest one
};

} // namespace nrb
