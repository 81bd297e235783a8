// What a query for the nearest points is given, and what it answers.
#pragma once

#include "spline/spline.h"

#include <array>
#include <cstdint>

namespace nrb {

// The answer to one query.
struct Foot {
    std::array<double, max_axes> params{};
    double distance = 0;
    int32_t status = 0; // NURBS_CLOSEST_ bits
};

// What every query asks for.
struct Query {
    const double *point;   // [dim]
    const Interval *range; // [axes], or null
    double tolerance;
    int64_t budget;
    bool farthest = false;
};

// A critical point of the distance.
struct CriticalPoint {
    Foot foot;
    int32_t kind = 0; // NURBS_CRITICAL_ constant
};

} // namespace nrb
