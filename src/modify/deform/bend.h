// SPDX-License-Identifier: MIT
// Shapes bent about an axis (A. Barr, "Global and local deformations of solid primitives", SIGGRAPH 1984).
#pragma once

#include "fit/fit_image.h"

namespace nrb::modify {

// A bend F of curvature k: perpendicular unit vectors e (along) and n (across), and the bent part, the points
// whose coordinate along e is between lower and upper.
struct Bend {
    const double *origin;
    std::vector<double> along;
    std::vector<double> across;
    double curvature;
    double lower;
    double upper;
};

// Makes `across` perpendicular to `along`, and both unit vectors. Throws Status::direction if they are
// parallel. Precondition: neither is 0.
Bend make_bend(int dim, const double *origin, const double *along, const double *across, double curvature,
               double lower, double upper);

// The parts of space; F has a different formula on each.
enum class BendPart { before, bent, after };

// The image x + (a' - a) e + (b' - b) n of a point x with the coordinates a along e and b along n. The first
// function uses the formula of one part, whether x lies in that part or not; the second one that of the part
// in which x lies.
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
