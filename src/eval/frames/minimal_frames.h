// SPDX-License-Identifier: MIT
// Rotation-minimizing frames along a sequence of points of a curve in space, by double reflection.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The outputs. Arrays that are not wanted have data == nullptr; the others have width 3.
struct MinimalFrames {
    Records points;
    Records tangents;
    Records normals;
    Records binormals;
    int32_t *status = nullptr;
};

// Double reflection (Wang, Juttler, Zheng & Liu 2008, "Computation of rotation minimizing frames", ACM TOG
// 27). first_normal: three finite numbers, or null for a default. Throws Status::direction, before anything
// is written, if the first normal is zero or parallel to the first tangent. Preconditions: a curve of
// dimension 3, and parameters that have been checked. Otherwise as evaluate_points().
void minimal_frames(const Spline &spline, const AxisRules &rules, ConstRecords params,
                    const double *first_normal, const MinimalFrames &out);

} // namespace nrb::eval
