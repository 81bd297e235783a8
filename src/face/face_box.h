// SPDX-License-Identifier: MIT
// Bounding boxes of faces.
#pragma once

#include "bounds/box.h"
#include "face/face.h"

#include <array>

namespace nrb::face {

// A box of the face, by branch and bound. The candidates for its extreme points are the curves of the
// boundary, and the cells of the domain in which a coordinate may be extreme inside the face. The cells that
// reach farthest are divided until no side of the box is farther from a point of the face than the tolerance,
// or 20000 cells were examined. The gap of the box is proven.
bounds::Box bounding_box(const Face &face, double tolerance);

// The smallest rectangle of the domain that contains the face; on closed axes, the whole domain.
std::array<Interval, 2> smallest_rectangle(const Face &face);

} // namespace nrb::face
