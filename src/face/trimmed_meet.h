// SPDX-License-Identifier: MIT
// What of the curves on a surface lies in a face.
#pragma once

#include "face/border_pieces.h"
#include "face/face.h"
#include "intersect/levels/level_meet.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::face {

// The parts of the branches of a meet of the face's surface that are inside of its loops, by where their curves in the parameter
// domain cross those of the loops (curve_curve()); they end in nodes on the border. A closed branch that is cut is cut where it
// begins as well, in a node of the kind seam. Touches whose middle is outside are left out; where crossings are undecided, and for
// what is undecided before, there are undecided nodes. Of a meet of two surfaces the face is one of the first surface.
// Precondition: both are of one surface.
intersect::Meet trimmed(const Face &face, const intersect::Meet &meet);

// How a branch runs: inside of the face, or along a curve of a loop, as that does or against it.
enum class Direction : int8_t { inside, with_loop, against_loop };
struct Course {
    Direction direction = Direction::inside;
    int32_t loop = -1, index = -1;
    bool operator==(const Course &) const = default;
};

struct BorderedMeet {
    intersect::Meet meet;
    // Of branches: where they begin and end on the border, the nearest place first.
    std::vector<std::array<std::vector<BorderPlace>, 2>> places;
    std::vector<Course> courses; // of branches
};

// The same, with what runs along the border in branches of its own, and where branches end on it.
BorderedMeet trimmed_with_places(const Face &face, const intersect::Meet &meet);

} // namespace nrb::face
