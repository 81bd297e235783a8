// SPDX-License-Identifier: MIT
// Faces that may be parts of one surface.
#pragma once

#include "face/meets/common_edges.h"

#include <array>
#include <span>

namespace nrb::face {

// Whether, a little beside the middle of a common edge at which both are smooth, the surface of a is on the other one; not for
// surfaces of many pieces. grounds: of the faces, continued beyond these.
bool may_be_one(const std::array<SplinePtr, 2> &grounds, const Face &a, std::span<const CommonEdge> edges,
                double tolerance);

} // namespace nrb::face
