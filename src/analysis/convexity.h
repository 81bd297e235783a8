// SPDX-License-Identifier: MIT
// Whether a plane curve is convex.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb::analysis {

enum Convexity : int32_t {
    convexity_none = 0,  // turns both ways, or through more than a full turn, or has a cusp
    convexity_left,      // turns to the left only, by at most a full turn
    convexity_right,     // turns to the right only, by at most a full turn
    convexity_straight,  // a straight line that does not turn back, to rounding
    convexity_undecided, // double precision cannot decide
};

// One of the convexity_ constants, to rounding: from the sign of the curvature, the turns at knots, the
// zeros of the tangent, and the angle that it turns through, piece by piece. Throws
// Status::not_representable. Precondition: a curve of dimension 2.
int32_t convexity(const Spline &curve);

} // namespace nrb::analysis
