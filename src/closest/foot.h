// SPDX-License-Identifier: MIT
// Queries for closest points, and their answers.
#pragma once

#include "basis/knot_vector.h"
#include "pieces/best_first.h"
#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <limits>

namespace nrb::closest {

// What gradual underflow may add to a distance: coordinates that small are rounded to a multiple of it.
inline constexpr double underflow_noise = 64 * std::numeric_limits<double>::denorm_min();

// How far an answer is proven, and where it lies.
enum ClosestStatus : int32_t {
    closest_certified = 0x01,  // the nearest, or farthest, point to the tolerance
    closest_boundary = 0x02,   // on an end or an edge of the domain, or of the range
    closest_not_unique = 0x04, // points elsewhere are as near, to the tolerance
    closest_budget = 0x08,     // the budget ended before a proof was found
    closest_invalid = 0x10,    // the query point is not finite
    closest_coarse = 0x20,     // proven, but rounding the parameters moves the point by more
    closest_singular = 0x40,   // of an adjoint: the equations do not determine the foot
    closest_left = 0x100,      // the limit from below is meant on axis 0; on the others the next bits
};

// The kinds of a place where the distance is critical.
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
    double noise = 0;     // the uncertainty of the distance by rounding
    uint32_t left = 0;    // bit k: at parameter k the limit from below is meant
    int64_t examined = 0; // number of pieces that were examined
};

// With the distance of the point at the parameters, as they are rounded, for which what was proven may hold or not.
inline void settle(Foot &foot, double distance, bool holds) noexcept {
    if ((foot.status & closest_certified) != 0 && !holds) {
        foot.status ^= closest_certified | closest_coarse;
    }
    foot.distance = distance;
    foot.status |= static_cast<int32_t>(foot.left) * closest_left;
}

// With a bound: nothing that counts is nearer, for certain.
struct BoundedFoot {
    Foot foot;
    double at_least = 0;
};

// A place where the distance is critical. Kind: a critical_ constant.
struct CriticalPoint {
    Foot foot;
    int32_t kind = 0;
};

// The common data of queries.
struct Query {
    const double *point;   // [dim], finite
    const Interval *range; // [axes], in the domain; or null for all of it
    double tolerance;      // how much nearer another point may be
    int64_t budget;        // most pieces examined; 0: the usual number
    bool farthest = false; // the farthest point instead of the nearest one
    bool alone = false;    // whether others are as near is not asked
    // Places of a surface or volume are told apart by their parameters, too: sheets may lie on each other. Among the minima there
    // may then be some that are so from one side only.
    bool sheets = false;

    [[nodiscard]] int64_t most_pieces() const noexcept {
        return budget > 0 ? budget : pieces::default_budget;
    }
};

} // namespace nrb::closest
