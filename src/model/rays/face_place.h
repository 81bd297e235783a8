// SPDX-License-Identifier: MIT
// Boxes in space around parts of faces.
#pragma once

#include "bounds/box.h"
#include "face/face.h"
#include "intersect/rays/box_tree.h"

namespace nrb::model {

// The box with its sides made finite.
intersect::Box3 box3_of(const bounds::Box &box) noexcept;

// A box of the surface over the rectangle with corners a and b, which is enlarged by the rounding of places.
intersect::Box3 box_between(const face::Face &face, const face::Point2 &a, const face::Point2 &b);

// A box of the surface over the smallest rectangle of the domain that contains the face.
intersect::Box3 face_box(const face::Face &face);

} // namespace nrb::model
