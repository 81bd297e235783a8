// SPDX-License-Identifier: MIT
// Cells: the parts of two curves that come near each other.
#pragma once

#include "basis/knot_vector.h"

#include <cstdint>
#include <vector>

namespace nrb::closest {
struct PairCell;
}

namespace nrb::intersect {

// Ranges of parameters on both curves. All places of these parts that are near each other lie in them.
struct NearCell {
    enum class Kind {
        meets,   // exactly once, for certain, in the interior of both
        touches, // near, in at most one place
        along,   // one is near the other all along
        tiny,    // no larger than the distance that counts as near
        unknown, // nothing is known
        // Of a curve with itself: parts that coincide or follow each other
        simple, // and do not meet except where they are joined
        fold,   // too small to tell whether they are simple
    };
    Kind kind;
    Interval a, b;     // where they may be near
    double at_a, at_b; // the nearest places found
    double gap = 0;    // their distance
    // Where exact arithmetic may find distance 0; for `along` the matched ends, which may descend on b.
    Interval core_a{}, core_b{};
    // For `along`: how far near places may be from the matched ones.
    double reach_a = 0, reach_b = 0;
    // For `along`: 1, or -1 if b runs against a. For others in the plane: the sign of A' x B'.
    int turn = 0;
    bool still = false;   // one of the curves is a point all along
    bool meetable = true; // false: they are proven apart by more than rounding
    // The segments between jumps in which the parts lie.
    int64_t segment_a = 0, segment_b = 0;
    size_t index = 0; // of a cell of an item: its index in the list of all cells
    closest::PairCell *of_a = nullptr, *of_b = nullptr;
};

struct NearCells {
    std::vector<NearCell> list;
    bool complete = true; // false: the limit of work was reached; what was not looked at is `unknown`
};

} // namespace nrb::intersect
