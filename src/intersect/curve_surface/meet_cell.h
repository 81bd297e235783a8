// SPDX-License-Identifier: MIT
// The parts of a curve and a surface that come near each other.
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

// All places of the parts that are near each other are in the box.
struct MeetCell {
    enum class Kind {
        meets,   // once, for certain, inside of both
        touches, // near, in one place at most
        along,   // the curve is near the surface all along
        tiny,    // no larger than what near means
        unknown, // nothing is known
    };
    Kind kind;
    MeetBox box;  // where they may be near
    MeetPlace at; // the nearest places found
    double gap = 0;
    MeetBox core{};       // where exact arithmetic may have distance 0; of `along` t is where it is near
    int turn = 0;         // of charts: to which side the curve goes
    bool still = false;   // the curve is a point
    bool meetable = true; // false: they are proven apart by more than rounding
    // Of `along`: lines of parameters of the surface on which the core begins and ends.
    struct Line {
        int axis = -1; // none
        double at = 0;
    };
    Line first{}, last{};
    std::array<int64_t, 3> segments{}; // the parts, which jumps are not in
    size_t index = 0;                  // of a cell in a group: in the list that it is of
    closest::PairCell *of_curve = nullptr, *of_surface = nullptr;
};

struct MeetCells {
    std::vector<MeetCell> list;
    bool complete = true; // false: the limit of work was reached; what was not looked at is `unknown`
};

} // namespace nrb::intersect
