// SPDX-License-Identifier: MIT
// Boxes around parts of faces.
#pragma once

#include "bounds/box.h"
#include "face/face.h"
#include "intersect/rays/box_tree.h"

namespace nrb::model {

// Finite.
intersect::Box3 box3_of(const bounds::Box &box) noexcept;

// Of the surface between two places of the domain, and as far around as rounding moves places.
intersect::Box3 box_between(const face::Face &face, const face::Point2 &a, const face::Point2 &b);

// Of the surface over the smallest rectangle of the domain that holds the face.
intersect::Box3 face_box(const face::Face &face);

} // namespace nrb::model
