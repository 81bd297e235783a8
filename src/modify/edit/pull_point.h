// SPDX-License-Identifier: MIT
// Control points moved so that a point of the shape moves (Piegl & Tiller 11.2).
#pragma once

#include "spline/spline.h"

namespace nrb::modify {

struct PointEdit {
    double moved; // how far, with the sign of the distance
    SplinePtr spline;
};

// Moves the control point P_i to P_i + alpha V with alpha = d / (|V| R_i(t)), so that the point at t moves by
// d along V. Throws Status::influence, not_representable. Preconditions: the parameter has been checked, the
// direction V is not 0, `original` is an original (net_editor.h).
PointEdit pull_point(const Spline &spline, int64_t original, const double *param, const double *direction,
                     double distance);

} // namespace nrb::modify
