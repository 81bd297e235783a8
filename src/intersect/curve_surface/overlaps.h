// SPDX-License-Identifier: MIT
// Parts of a curve that lie on a surface.
#pragma once

#include "intersect/curve_surface/meet_groups.h"

namespace nrb::intersect {

struct SurfaceOverlap {
    MeetBox box; // t where the curve is near all along
    std::vector<size_t> cells;
};

// Of the cells of a group that are `along`, and what is tiny between them: parts that hold a whole span of the curve, or
// begin and end where one of both has a knot or an end: polynomial pieces that agree on an interval agree until one of them
// ends. Others are none.
std::vector<SurfaceOverlap> overlaps_of(const MeetGroup &group, const Seams &seams);

} // namespace nrb::intersect
