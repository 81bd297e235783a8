// Shapes bent about an axis (A. Barr, "Global and local deformations of solid primitives", SIGGRAPH 1984).
#pragma once

#include "modify/deform/fit_image.h"

namespace nrb {

// Unit vectors along and across, at right angles, and the part between lower and upper that is bent.
struct Bend {
    const double *origin;
    std::vector<double> along;
    std::vector<double> across;
    double curvature;
    double lower;
    double upper;
};

// `across` made perpendicular, both made unit vectors. Throws NURBS_ERROR_DIRECTION if they are parallel. Precondition:
// neither is 0.
Bend make_bend(int dim, const double *origin, const double *along, const double *across, double curvature,
               double lower, double upper);

// The point x + (a' - a) e + (b' - b) n.
void bend_point(const Bend &bend, const double *point, double *image) noexcept;

struct DeformedShape {
    SplinePtr spline;
    double deviation;
    bool proven;
};

// Throws what fit_image() throws.
DeformedShape bend(const SplinePtr &spline, const Bend &bend, double tolerance);

} // namespace nrb
