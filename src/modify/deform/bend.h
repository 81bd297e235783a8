// SPDX-License-Identifier: MIT
// Shapes bent about an axis (A. Barr, "Global and local deformations of solid primitives", SIGGRAPH 1984).
#pragma once

#include "fit/fit_image.h"

namespace nrb::modify {

// Unit vectors along and across, at right angles, and the part between lower and upper that is bent.
struct Bend {
    const double *origin;
    std::vector<double> along;
    std::vector<double> across;
    double curvature;
    double lower;
    double upper;
};

// `across` made perpendicular, both made unit vectors. Throws Status::direction if they are parallel.
// Precondition: neither is 0.
Bend make_bend(int dim, const double *origin, const double *along, const double *across, double curvature,
               double lower, double upper);

// Where a point is: F is a different formula on each part.
enum class BendPart { before, bent, after };

// The formula of one part, x + (a' - a) e + (b' - b) n, whether the point lies in that part or not; and the
// formula of the point's own part.
void bend_point(const Bend &bend, BendPart part, const double *point, double *image) noexcept;
void bend_point(const Bend &bend, const double *point, double *image) noexcept;

struct DeformedShape {
    SplinePtr spline;
    double deviation;
    bool proven;
};

// The deviation is proven (bend_bound.h) if the weights are shown to be positive. Throws what fit_image()
// throws.
DeformedShape bend(const SplinePtr &spline, const Bend &bend, double tolerance);

} // namespace nrb::modify
