// SPDX-License-Identifier: MIT
// Cones that contain the directions of derivatives (tangent cone) or of normals (normal cone).
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::bounds {

// The cone { v : angle(v, direction) <= angle }.
struct Cone {
    std::vector<double> direction; // a unit vector
    double angle = 0;
};

// The directions of the derivative along an axis. On each piece they lie in the convex cone of the
// coefficients of the numerator of the derivative. If the coefficients lie in a half space about `direction`,
// their largest angle from it bounds that of the convex cone; other pieces are bounded about an axis of their
// own. Subdivision ends when the angle is within the tolerance of the angle of a derivative that occurs.
// Boundaries on which all coefficients vanish up to rounding are divided out. The angle is pi if the cone is
// the whole space.
Cone tangent_cone(const Spline &spline, int axis, const Part &part, double tolerance);
// The directions of S_u x S_v. Precondition: a surface of dimension 3.
Cone normal_cone(const Spline &spline, const Part &part, double tolerance);

} // namespace nrb::bounds
