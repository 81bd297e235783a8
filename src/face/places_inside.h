// SPDX-License-Identifier: MIT
// Where the inside of a face is.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// Places inside of a face, those with the most room in and beside their columns first, as shares of the domain.
std::vector<Point2> places_inside(const Face &face);

} // namespace nrb::face
