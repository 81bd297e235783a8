// SPDX-License-Identifier: MIT
// Cones that contain the directions of derivatives and of normals.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::bounds {

// { v : angle(v, direction) <= angle }.
struct Cone {
    std::vector<double> direction; // a unit vector
    double angle = 0;
};

// The directions of the derivative along an axis. On each piece the coefficients of its numerator are vectors
// whose convex cone contains the direction. If they lie in a half space about `direction`, their convex cone
// is as near to it as they are; other pieces are bounded about an axis of their own. Halving ends when the
// angle is within the tolerance of the angle of a derivative that occurs. Boundaries on which all
// coefficients vanish to rounding are divided out. The angle is pi if the cone is the whole space.
Cone tangent_cone(const Spline &spline, int axis, const Part &part, double tolerance);
// The directions of S_u x S_v. Precondition: a surface of dimension 3.
Cone normal_cone(const Spline &spline, const Part &part, double tolerance);

} // namespace nrb::bounds
