// SPDX-License-Identifier: MIT
// The shape factor of a conic segment.
#pragma once

#include "recognize/conic_type.h"
#include "spline/spline.h"

namespace nrb::recognize {

struct ShapeFactor {
    double factor; // w1^2 / (w0 w2) of the Bezier weights
    int32_t type;  // one of the conic_ constants
};

// Of a curve of degree 2 with 3 control points. Its kind is decided without rounding for the weights of its
// Bezier form, which are the stored ones unless the curve is unclamped; before that stands whether the
// control points are on a line to within 4 eps of the largest coordinate. Throws Status::axes, degree,
// count, weight_sign.
ShapeFactor shape_factor(const Spline &curve);

} // namespace nrb::recognize
