// SPDX-License-Identifier: MIT
// Principal curvatures and directions of surfaces in space.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The outputs. Arrays that are not wanted have data == nullptr. Widths: 2 for principal, 6 for directions, 1
// for mean and Gaussian curvature.
struct SurfaceCurvatures {
    Records principal;
    Records directions;
    Records mean;
    Records gaussian;
    int32_t *status = nullptr;
};

// Preconditions: a surface of dimension 3, and parameters that have been checked. Otherwise as
// evaluate_points().
void surface_curvatures(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const SurfaceCurvatures &out);

} // namespace nrb::eval
