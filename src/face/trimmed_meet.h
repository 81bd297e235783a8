// SPDX-License-Identifier: MIT
// Trims curves on a surface to the part that lies in a face.
#pragma once

#include "face/border_pieces.h"
#include "face/face.h"
#include "intersect/levels/level_meet.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::face {

// The parts of the branches of a meet that are inside of the loops of a face. They are cut where their curves
// in the domain cross those of the loops (curve_curve()), and end in border nodes there. A closed branch that
// is cut is also cut at its start, in nodes of kind seam. Touches whose middle is outside are dropped, and
// undecided nodes whose box is entirely outside. An undecided crossing leaves an undecided node, and so does
// a region of overlap that is not entirely outside.
// surface: whether the face is on the first (0) or the second surface (1) of the meet. left_out: for each
// branch, or empty for all, the parts that are dropped although they are inside; branches end there in nodes
// of kind edge. Precondition: the meet is on the surface of the face, which may be continued beyond the
// domain of the face.
using PartsOfBranches = std::vector<std::vector<Interval>>;
intersect::Meet trimmed(const Face &face, const intersect::Meet &meet, size_t surface = 0,
                        const PartsOfBranches &left_out = {});

// How a branch runs: inside of the face, or along a curve of a loop, in its direction or against it.
enum class Direction : int8_t { inside, with_loop, against_loop };
struct Course {
    Direction direction = Direction::inside;
    int32_t loop = -1, index = -1;
    bool operator==(const Course &) const = default;
};

struct BorderedMeet {
    intersect::Meet meet;
    // For each branch, where its two ends are on the border, the nearest place first.
    std::vector<std::array<std::vector<BorderPlace>, 2>> places;
    std::vector<Course> courses; // for each branch
};

// The same; what runs along the border is in branches of its own, and for the ends of branches it is reported
// where they are on the border.
BorderedMeet trimmed_with_places(const Face &face, const intersect::Meet &meet);

} // namespace nrb::face
