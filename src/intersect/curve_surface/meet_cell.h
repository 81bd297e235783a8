// SPDX-License-Identifier: MIT
// Cells: the parts of a curve and a surface that come near each other.
#pragma once

#include "intersect/contraction.h"

#include <cstdint>
#include <vector>

namespace nrb::closest {
struct PairCell;
}

namespace nrb::intersect {

// Parameters of a curve and a surface: (t, u, v).
using MeetBox = Box<3>;
using MeetPlace = Place<3>;

// A box of parameters. All places of these parts that are near each other lie in it.
struct MeetCell {
    enum class Kind {
        meets,   // exactly once, for certain, in the interior of both
        touches, // near, in at most one place
        along,   // the curve is near the surface all along
        tiny,    // no larger than the distance that counts as near
        unknown, // nothing is known
    };
    Kind kind;
    MeetBox box;  // where they may be near
    MeetPlace at; // the nearest places found
    double gap = 0;
    MeetBox core{};       // where exact arithmetic may find 0; for `along`: the t at which the curve is near
    int turn = 0;         // of charts: the side to which the curve goes
    bool still = false;   // the curve is a point
    bool meetable = true; // false: they are proven apart by more than rounding
    // For `along`: isoparametric lines of the surface at which the core begins and ends.
    struct Line {
        int axis = -1; // -1: none
        double at = 0;
    };
    Line first{}, last{};
    std::array<int64_t, 3> segments{}; // the segments between jumps in which the parts lie
    size_t index = 0;                  // of a cell in a group: its index in the list of all cells
    closest::PairCell *of_curve = nullptr, *of_surface = nullptr;
};

struct MeetCells {
    std::vector<MeetCell> list;
    bool complete = true; // false: the limit of work was reached; what was not looked at is `unknown`
};

} // namespace nrb::intersect
