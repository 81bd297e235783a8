// SPDX-License-Identifier: MIT
// Where the inside of a face is.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// Places inside of a face, those with the most room in and beside their columns first, as shares of the domain.
std::vector<Point2> places_inside(const Face &face);

// Whether nothing of a face is in a part of the domain, which may run over its ends where the surface closes.
bool is_outside(const Face &face, const Point2 &lower, const Point2 &upper);

} // namespace nrb::face
