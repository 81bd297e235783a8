// SPDX-License-Identifier: MIT
// The kinds of solutions that intersections and level sets report, and those on one curve.
#pragma once

#include "basis/knot_vector.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace nrb::intersect {

enum class HitKind : int32_t {
    crossing = 1,  // from one side to the other, or an end that is reached
    tangent = 2,   // a touch, as far as rounding can tell
    contact = 3,   // proven apart, but by no more than the tolerance
    overlap = 4,   // within the tolerance over a whole range
    jump = 5,      // the curve jumps from one side to the other
    undecided = 6, // a range whose contents are left open
};

// A solution on one curve. Every solution lies in the range of some hit, and an overlap holds in all of its
// range. On periodic axes a range may end in the next period.
struct CurveHit {
    double at;
    Interval range;
    HitKind kind;
};

struct CurveHits {
    std::vector<CurveHit> list; // ascending
    [[nodiscard]] bool complete() const noexcept {
        return std::ranges::none_of(list, [](const CurveHit &hit) { return hit.kind == HitKind::undecided; });
    }
};

} // namespace nrb::intersect
