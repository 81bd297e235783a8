// SPDX-License-Identifier: MIT
// Helices and spirals to a tolerance.
#pragma once

#include "build/conics/angle.h"
#include "build/placement.h"
#include "spline/spline.h"

namespace nrb::build {

struct Helix {
    double radius; // at the start
    double growth; // of the radius, in a turn
    double pitch;
    double start; // angle
    double turns;
};

struct HelixCurve {
    SplinePtr spline;
    double error; // proven
};

// Equal pieces, on which the angle is met exactly as on an arc, and the way along the axis and the radius go
// with a rational function of the parameter instead of the angle. With k = tan(d / 4) for a piece of angle
// d, the angle from its middle is 2 atan(x) where x = k (2 t - 1); the function is
//
//     x q(x^2) / (1 + x^2)^3,
//
// where q is the parabola that agrees with g(y) = 2 (1 + y)^3 atan(sqrt y) / sqrt y at y = k^2 to the second
// derivative. So values, tangents and curvatures agree at the ends of the pieces. Because g'''
// / 2 is the integral of 6 (1 - u^2)^3 / (1 + y u^2)^4 over [0, 1], at most 96 / 35, the two differ by at
// most 32 / 35 x (k^2 - x^2)^3, which is at most 32 / 35 (6/7)^3 / sqrt(7) k^7: the error as an angle. Throws
// Status::length, angle, factor, tolerance, overflow, not_representable.
HelixCurve helix(const Placement &place, const Helix &shape, double tolerance);

} // namespace nrb::build
