// SPDX-License-Identifier: MIT
// Parts of a curve that lie on a surface.
#pragma once

#include "intersect/curve_surface/meet_groups.h"

namespace nrb::intersect {

struct SurfaceOverlap {
    MeetBox box; // t: where the curve is near all along
    std::vector<size_t> cells;
};

// The overlaps that cells of kind `along`, and the tiny cells between them, make: stretches that hold a whole
// span of the curve, or begin and end where the curve or the surface has a knot or an end. Other stretches
// are no overlaps: polynomial pieces that agree on an interval agree until one of them ends.
std::vector<SurfaceOverlap> overlaps_of(const MeetGroup &group, const Seams &seams);

} // namespace nrb::intersect
