// SPDX-License-Identifier: MIT
// Closest-point queries and their answers.
#pragma once

#include "basis/knot_vector.h"
#include "pieces/best_first.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <limits>

namespace nrb::closest {

// What gradual underflow may add to a distance: coordinates of that size are rounded to multiples of the
// smallest subnormal.
inline constexpr double underflow_noise = 64 * std::numeric_limits<double>::denorm_min();

// Status bits of an answer: how much of it is proven, and where the foot lies.
enum ClosestStatus : int32_t {
    closest_certified = 0x01,  // proven: the nearest (or farthest) point to the tolerance
    closest_boundary = 0x02,   // at an end or on an edge of the domain or of the range
    closest_not_unique = 0x04, // points elsewhere are as near, to the tolerance
    closest_budget = 0x08,     // the budget ended before a proof was found
    closest_invalid = 0x10,    // the query point is not finite
    closest_coarse = 0x20,     // proven, but the rounding of the parameters moves the point by more
    closest_singular = 0x40,   // adjoints only: the equations do not determine the foot
    closest_left = 0x100,      // axis 0: the limit from below is meant; the next bits are for the other axes
};

// The kinds of critical points of the distance.
enum CriticalKind : int32_t {
    critical_minimum = 1,
    critical_maximum = 2,
    critical_saddle = 3,
    critical_undecided = 4, // rounding leaves the kind open
};

// The answer to one query. Status: closest_ bits.
struct Foot {
    std::array<double, max_axes> params{};
    double distance = 0;
    int32_t status = 0;
    double noise = 0;     // the uncertainty of the distance due to rounding
    uint32_t left = 0;    // bit k: the limit from below is meant along axis k
    int64_t examined = 0; // number of pieces examined
};

// Replaces the distance by that of the point at the rounded parameters. `holds`: whether what was proven is
// true of that distance; if it is not, certified becomes coarse.
inline void settle(Foot &foot, double distance, bool holds) noexcept {
    if ((foot.status & closest_certified) != 0 && !holds) {
        foot.status ^= closest_certified | closest_coarse;
    }
    foot.distance = distance;
    foot.status |= static_cast<int32_t>(foot.left) * closest_left;
}

// A foot with a proven lower bound: no point that counts is nearer than at_least.
struct BoundedFoot {
    Foot foot;
    double at_least = 0;
};

// A critical point of the distance. Kind: a critical_ constant.
struct CriticalPoint {
    Foot foot;
    int32_t kind = 0;
};

// The data of a query.
struct Query {
    const double *point;   // [dim], finite
    const Interval *range; // [axes], within the domain; null: the whole domain
    double tolerance;      // another point may be nearer by this much
    int64_t budget;        // most pieces examined; 0: pieces::default_budget
    bool farthest = false; // find the farthest point instead of the nearest one
    bool alone = false;    // do not test whether other points are as near
    // Whether places of a surface or volume are also told apart by their parameters, for shapes whose sheets
    // may coincide. The minima may then include some that are minima from one side only.
    bool sheets = false;

    [[nodiscard]] int64_t most_pieces() const noexcept {
        return budget > 0 ? budget : pieces::default_budget;
    }
};

} // namespace nrb::closest
