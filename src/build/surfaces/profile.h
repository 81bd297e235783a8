// SPDX-License-Identifier: MIT
// Surfaces of revolution from profile curves, also scaled along x and y.
#pragma once

#include "build/conics/arc.h"
#include "build/placement.h"
#include "numeric/double_double.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::build {

struct ProfilePoint {
    DoubleDouble radius;
    DoubleDouble height;
    double weight = 1;
};

// A curve in the half plane of radius and height.
struct Profile {
    KnotVectorPtr axis;
    std::vector<ProfilePoint> points;
};

// A polynomial Bezier profile; the number of points determines the degree.
Profile bezier_profile(std::vector<ProfilePoint> points);

// The arc (offset + radius cos b, radius sin b).
Profile arc_profile(const Turn &turn, int32_t form, double offset, double radius);

// The arc of the hyperbola radius^2 - (height / size)^2 = 1, or with two sheets (height / size)^2 - radius^2
// = 1, from the height `bottom` to the height `top`, which are exactly the heights of its ends. The heights
// are size sinh u, or size cosh u with two sheets, and the pieces have lengths of at most 2 in u. A piece
// with the ends a and b has the middle control point (a + b) / (1 + cosh d) with the weight cosh(d / 2),
// where d is the difference in u and tanh(d / 2) = (b_h - a_h) / (size (a_r + b_r)), with the radii a_r, b_r
// and the heights a_h, b_h of the ends. Nothing cancels, so short and distant arcs are as accurate as any.
// Throws Status::not_representable. Precondition: with two sheets, both heights are on one of them.
Profile hyperbola_profile(double size, double bottom, double top, bool two_sheets);

// The surface with an arc (x_j, y_j) as axis 0 and a profile (r_k, h_k) as axis 1: control points (scale_x
// x_j r_k, scale_y y_j r_k, h_k) in the frame of the placement, with the weights w_j w_k. Every coordinate is
// rounded once. Throws Status::not_representable.
SplinePtr turned(const Placement &place, const Arc &arc, const Profile &profile, double scale_x = 1,
                 double scale_y = 1);

} // namespace nrb::build
