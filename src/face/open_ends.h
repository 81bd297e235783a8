// SPDX-License-Identifier: MIT
// Where a face reaches the ends of the domain though no curve bounds it there.
#pragma once

#include "face/face.h"

namespace nrb::face {

struct EndPart {
    Point2 from, to;
};

// Parts of the ends of axes that are not closed: outside of a hole without an outer loop, and around poles.
// Cost: linear in the number of pieces.
std::vector<EndPart> open_ends(const Face &face);

} // namespace nrb::face
