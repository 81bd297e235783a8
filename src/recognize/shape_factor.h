// SPDX-License-Identifier: MIT
// The shape factor of a conic segment.
#pragma once

#include "recognize/conic_type.h"
#include "spline/spline.h"

namespace nrb::recognize {

struct ShapeFactor {
    double factor; // w1^2 / (w0 w2) of the Bezier weights
    int32_t type;  // a conic_ constant
};

// The shape factor of a curve of degree 2 with 3 control points. Whether the control points are collinear is
// decided first, to within 4 eps of the largest coordinate. Otherwise the type follows from the exact sign of
// w1^2 - w0 w2 for the Bezier weights, which are the stored ones unless the curve is unclamped. Throws
// Status::axes, degree, count, weight_sign.
ShapeFactor shape_factor(const Spline &curve);

} // namespace nrb::recognize
