// SPDX-License-Identifier: MIT
// Which simple shape a curve or surface has.
#pragma once

#include "recognize/shape_model.h"
#include "spline/spline.h"

namespace nrb::recognize {

struct Recognition {
    Shape shape;
    double deviation = 0; // proven; 0 with shape_none
};

// The first shape from which no point is farther than the tolerance: of a curve a point, line, circle,
// parabola, ellipse, hyperbola, of a surface a point, line, plane, sphere, cylinder, cone, torus: a surface
// that is no larger than the tolerance, or no wider, has no normal that could be told. Parabolas come before
// ellipses, which come as near to a parabola as one likes. Throws Status::axes, dimension, not_representable.
// Cost: some hundred evaluations and, for each shape that the samples have to the tolerance, a few products
// of each Bezier piece.
Recognition recognize(const Spline &given, double tolerance);

} // namespace nrb::recognize
