// SPDX-License-Identifier: MIT
// Where segments of curves on two surfaces come to a seam.
#pragma once

#include "intersect/surfaces/cross_spot.h"
#include "intersect/surfaces/curves/cross_segment.h"

#include <vector>

namespace nrb::intersect {

// Whether parameters do not go on between segments, as an axis closes that is not periodic.
bool is_seam(const CrossSurface &a, const CrossSurface &b, const CrossSegment &before,
             const CrossSegment &after) noexcept;

// What is between seams; of a closed curve from one of them on, if there is any.
std::vector<std::vector<CrossSegment>> parts_between_seams(const CrossSurface &a, const CrossSurface &b,
                                                           std::vector<CrossSegment> segments, bool closed);

} // namespace nrb::intersect
