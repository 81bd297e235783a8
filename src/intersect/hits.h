// SPDX-License-Identifier: MIT
// What is found where shapes meet.
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
    overlap = 4,   // no farther apart than the tolerance over a whole range
    jump = 5,      // from one side to the other where the curve jumps
    undecided = 6, // a range in which it is left open what there is
};

// On one curve. Every solution lies in the range of a hit. The range of an overlap is all of it; on periodic
// axes it may end in the next period.
struct CurveHit {
    double at;
    Interval range;
    HitKind kind;
};

struct CurveHits {
    std::vector<CurveHit> list; // rising
    [[nodiscard]] bool complete() const noexcept {
        return std::ranges::none_of(list, [](const CurveHit &hit) { return hit.kind == HitKind::undecided; });
    }
};

} // namespace nrb::intersect
