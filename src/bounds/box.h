// SPDX-License-Identifier: MIT
// Bounding boxes and extreme points of a spline.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::bounds {

struct Box {
    std::vector<double> lower;
    std::vector<double> upper;
    double gap = 0; // bound of the distance of each face from the spline
};

// Each face is the largest value of a coordinate or of its negative, to within the tolerance, by branch and
// bound. Faces are rounded outwards, so that evaluated points, with the rounding errors of evaluation, are
// inside, too (unless points are homogeneous). Faces are infinite where the weights cannot be shown to be
// positive. Cost: linear in the number of pieces, plus the subdivision of the pieces that reach the faces.
Box bounding_box(const Spline &spline, const Part &part, double tolerance);

// The largest side of the bounding box of the control points.
double extent(const Spline &spline) noexcept;

struct OrientedBox {
    std::vector<double> center;
    std::vector<double> axes; // row by row
    std::vector<double> half;
};

// A box along the principal axes of the control points, longest first; or along the coordinate axes if that
// box has no larger volume. Throws Status::dimension, not_representable.
inline constexpr int max_box_dimension = 16;
OrientedBox oriented_box(const Spline &spline, double tolerance);

struct ExtremePoint {
    std::array<double, max_axes> params{};
    double value = 0; // direction . C at params
    double bound = 0; // upper bound over all points
};

// The point farthest in a direction. Throws Status::not_representable if no value is known or if it
// overflows. Precondition: the direction is finite and not 0.
ExtremePoint extreme_point(const Spline &spline, const double *direction, const Part &part, double tolerance);

} // namespace nrb::bounds
