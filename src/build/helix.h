// SPDX-License-Identifier: MIT
// Circular and conical helices and spirals, approximated to a tolerance.
#pragma once

#include "build/conics/angle.h"
#include "build/placement.h"
#include "spline/spline.h"

namespace nrb::build {

struct Helix {
    double radius; // at the start
    double growth; // change of the radius per turn
    double pitch;
    double start; // angle at the start
    double turns;
};

struct HelixCurve {
    SplinePtr spline;
    double error; // proven
};

// The curve consists of equal rational pieces. On these the angle about the axis is exact, as on an arc; the
// height and the radius, which ought to be linear in the angle, are linear in a rational function of the
// parameter that approximates the angle. For a piece of angle d, let k = tan(d / 4) and x = k (2 t - 1),
// where t runs from 0 to 1. The angle from the middle of the piece is 2 atan(x), and the function is
//
//     x q(x^2) / (1 + x^2)^3,
//
// where q is the quadratic polynomial that agrees with g(y) = 2 (1 + y)^3 atan(sqrt y) / sqrt y at y = k^2 up
// to the second derivative. So points, tangents and curvatures agree at the ends of the pieces. Because g'''
// / 2 is the integral of 6 (1 - u^2)^3 / (1 + y u^2)^4 over [0, 1], which is at most 96 / 35, the function
// differs from the angle by at most 32 / 35 x (k^2 - x^2)^3, and this by at most 32 / 35 (6/7)^3 / sqrt(7)
// k^7. Throws Status::length, angle, factor, tolerance, overflow, not_representable.
HelixCurve helix(const Placement &place, const Helix &shape, double tolerance);

} // namespace nrb::build
