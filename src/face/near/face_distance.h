// SPDX-License-Identifier: MIT
// The smallest and the largest distance of two faces.
#pragma once

#include "face/face.h"

namespace nrb::face {

// Bounds on a distance.
struct FaceDistance {
    double at_least = 0;
    double at_most = 0; // of a smallest distance: that of the points at the places
    Point2 a{}, b{};    // of a largest distance: only a, a place that is at_least away
    bool certified = false;
};

// The smallest distance of two faces. Each of the two nearest points lies on a curve of the boundary or
// inside of its face. So curves are searched with curves, curves with surfaces, and the surfaces with each
// other, each pair as far as it may contain something nearer. Throws Status::incompatible, not_representable.
FaceDistance smallest_distance(const Face &a, const Face &b, double tolerance);

// How far the point of `from` that is farthest from `to` is from it (one-sided Hausdorff distance). Throws as
// above.
FaceDistance largest_distance(const Face &from, const Face &to, double tolerance);

} // namespace nrb::face
