// SPDX-License-Identifier: MIT
// The ends of the domain that bound a face without a curve.
#pragma once

#include "face/face.h"

namespace nrb::face {

struct EndPart {
    Point2 from, to;
};

// The parts of the ends of axes that are not closed which a face reaches although no curve runs there:
// outside of holes if there is no outer loop, and around poles. Cost: linear in the number of pieces.
std::vector<EndPart> open_ends(const Face &face);

} // namespace nrb::face
