// SPDX-License-Identifier: MIT
// Boxes that contain a face.
#pragma once

#include "bounds/box.h"
#include "face/face.h"

#include <array>

namespace nrb::face {

// Of the edges, and of the cells of the domain in which a coordinate may be extreme inside the face: those that reach farthest are
// halved until no side is farther from a point of the face than the tolerance, or 20000 were. The gap is proven.
bounds::Box bounding_box(const Face &face, double tolerance);

// The smallest rectangle of the domain that holds the face; on axes that close all of the domain.
std::array<Interval, 2> smallest_rectangle(const Face &face);

} // namespace nrb::face
