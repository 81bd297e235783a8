// SPDX-License-Identifier: MIT
// The parts of two curves that come near each other.
#pragma once

#include "basis/knot_vector.h"

#include <cstdint>
#include <vector>

namespace nrb::closest {
struct PairCell;
}

namespace nrb::intersect {

// Parameters of parts of both curves. All places of the parts that are near each other are here.
struct NearCell {
    enum class Kind {
        meets,   // once, for certain, inside of both
        touches, // near, in one place at most
        along,   // the one is near the other all along
        tiny,    // no larger than what near means
        unknown, // nothing is known
        // Of a curve with itself: parts that are one or follow each other
        simple, // and do not meet but where they are joined
        fold,   // as above, if that can be told, but too small for it
    };
    Kind kind;
    Interval a, b;     // where they may be near
    double at_a, at_b; // the nearest places found
    double gap = 0;    // their distance
    // Where exact arithmetic may have distance 0; of `along` the matched ends, which on b may fall.
    Interval core_a{}, core_b{};
    // Of `along`: how far from matched places what is near may be.
    double reach_a = 0, reach_b = 0;
    // Of `along`: 1, or -1 if b runs against a; of others in the plane: the sign of A' x B'.
    int turn = 0;
    bool still = false;   // one of them is a point all along
    bool meetable = true; // false: they are proven apart by more than rounding
    // The parts, which jumps of the curves are not in.
    int64_t segment_a = 0, segment_b = 0;
    size_t index = 0; // of a cell of an item: in the list that it is of
    closest::PairCell *of_a = nullptr, *of_b = nullptr;
};

struct NearCells {
    std::vector<NearCell> list;
    bool complete = true; // false: the limit of work was reached; what was not looked at is `unknown`
};

} // namespace nrb::intersect
