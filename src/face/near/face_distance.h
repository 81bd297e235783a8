// SPDX-License-Identifier: MIT
// Distances of faces.
#pragma once

#include "face/face.h"

namespace nrb::face {

struct FaceDistance {
    double at_least = 0;
    double at_most = 0; // for a smallest distance that of the points at the places
    Point2 a{}, b{};    // for a largest one only a, which is at_least away
    bool certified = false;
};

// The smallest distance of two faces. Nearest points lie on curves of the boundaries, or inside of one face or both: curves with
// curves, curves with surfaces, and surfaces with each other are searched, each as far as it may hold something nearer. Throws
// Status::incompatible, not_representable.
FaceDistance smallest_distance(const Face &a, const Face &b, double tolerance);

// How far the point of a face that is farthest from another one is from it. Throws as above.
FaceDistance largest_distance(const Face &from, const Face &to, double tolerance);

} // namespace nrb::face
