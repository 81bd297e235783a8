// SPDX-License-Identifier: MIT
// Decides whether a plane curve is convex.
#pragma once

#include "spline/spline.h"

#include <cstdint>

namespace nrb::analysis {

enum Convexity : int32_t {
    convexity_none = 0,  // turns both ways, by more than a full turn, or has a cusp
    convexity_left,      // turns to the left only, by at most a full turn
    convexity_right,     // turns to the right only, by at most a full turn
    convexity_straight,  // straight to rounding, without turning back
    convexity_undecided, // double precision cannot decide
};

// One of the convexity_ constants, decided to rounding. For each piece, the test examines the sign of the
// curvature, the turn at the knot, the zeros of the tangent, and the angle by which the tangent turns. Throws
// Status::not_representable. Precondition: a curve of dimension 2.
int32_t convexity(const Spline &curve);

} // namespace nrb::analysis
