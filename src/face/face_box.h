// SPDX-License-Identifier: MIT
// Boxes that contain a face.
#pragma once

#include "bounds/box.h"
#include "face/face.h"

namespace nrb::face {

// Of the edges, and of the cells of the domain in which a coordinate may be extreme inside the face: those that reach farthest are
// halved until no side is farther from a point of the face than the tolerance, or 20000 were. The gap is proven.
bounds::Box bounding_box(const Face &face, double tolerance);

} // namespace nrb::face
