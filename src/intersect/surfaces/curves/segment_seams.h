// SPDX-License-Identifier: MIT
// Cuts sequences of segments of curves on two surfaces at seams.
#pragma once

#include "intersect/surfaces/cross_spot.h"
#include "intersect/surfaces/curves/cross_segment.h"

#include <vector>

namespace nrb::intersect {

// Whether parameters jump between segments, at the seam of an axis that closes but is not periodic.
bool is_seam(const CrossSurface &a, const CrossSurface &b, const CrossSegment &before,
             const CrossSegment &after) noexcept;

// The sequences of segments between seams. Those of a closed curve are rotated to begin at a seam, if there
// is any.
std::vector<std::vector<CrossSegment>> parts_between_seams(const CrossSurface &a, const CrossSurface &b,
                                                           std::vector<CrossSegment> segments, bool closed);

} // namespace nrb::intersect
