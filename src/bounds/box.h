// SPDX-License-Identifier: MIT
// Boxes that contain a spline, and its extreme points.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::bounds {

struct Box {
    std::vector<double> lower;
    std::vector<double> upper;
    double gap = 0; // no face is farther than this from the spline
};

// Each face is the largest value of a coordinate or of its negative, to the tolerance. Faces are rounded
// outwards, so that evaluated points, with the rounding of evaluation, are inside too (unless points are
// homogeneous). Faces are infinite where weights cannot be shown to be positive. Cost: linear in the number
// of pieces, and the halvings of the pieces that reach the faces.
Box bounding_box(const Spline &spline, const Part &part, double tolerance);

// The largest side of the box of the control points.
double extent(const Spline &spline) noexcept;

struct OrientedBox {
    std::vector<double> center;
    std::vector<double> axes; // row by row
    std::vector<double> half;
};

// A box along the principal axes of the control points, longest first, or along the coordinate axes if that
// box has no larger content. Throws Status::dimension, not_representable.
inline constexpr int max_box_dimension = 16;
OrientedBox oriented_box(const Spline &spline, double tolerance);

struct ExtremePoint {
    std::array<double, max_axes> params{};
    double value = 0; // direction . C there
    double bound = 0; // no point has more
};

// Throws Status::not_representable if no value is known or it overflows. Precondition: the direction is
// finite and not 0.
ExtremePoint extreme_point(const Spline &spline, const double *direction, const Part &part, double tolerance);

} // namespace nrb::bounds
