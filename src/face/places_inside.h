// SPDX-License-Identifier: MIT
// Places in the interior of a face, and whether a rectangle lies outside of it.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

// Places inside of a face, those with the most room first. The room is the smaller of two shares of the
// domain: the length of the part of the column that is inside, and the width of the interval of axis 0 around
// the column in which no piece begins or ends.
std::vector<Point2> places_inside(const Face &face);

// Whether no part of a face is in a rectangle, which may extend beyond the domain on closed axes.
bool is_outside(const Face &face, const Point2 &lower, const Point2 &upper);

} // namespace nrb::face
