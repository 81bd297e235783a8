// SPDX-License-Identifier: MIT
// Whether faces may be parts of one surface.
#pragma once

#include "face/meets/common_edges.h"

#include <array>
#include <span>

namespace nrb::face {

// Whether, at some common edge along which both faces have a tangent plane in common, a place of the surface
// of a close to the middle of the edge is on the other surface. False for surfaces of many pieces. grounds:
// those of the faces, continued beyond the domains.
bool may_be_one(const std::array<SplinePtr, 2> &grounds, const Face &a, std::span<const CommonEdge> edges,
                double tolerance);

} // namespace nrb::face
