// Cones that contain the directions of derivatives and of normals.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::bounds {

// { v : angle(v, direction) <= angle }.
struct Cone {
    std::vector<double> direction; // a unit vector
    double angle = 0;
};

// The directions of the derivative along an axis. On each piece coefficients of its numerator are vectors
// whose convex cone contains it; where they lie in a half space about `direction` so does that cone in
// theirs, others are bounded about an axis of their own. Halving ends when the angle is within the tolerance
// of that of a derivative which occurs. Boundaries on which all coefficients vanish to rounding are divided
// out. Angle pi where the cone is the whole space.
Cone tangent_cone(const Spline &spline, int axis, const Part &part, double tolerance);
// The directions of S_u x S_v. Precondition: a surface of dimension 3.
Cone normal_cone(const Spline &spline, const Part &part, double tolerance);

} // namespace nrb::bounds
