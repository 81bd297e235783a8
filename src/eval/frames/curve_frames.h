// SPDX-License-Identifier: MIT
// Frenet frames, curvature and torsion of curves in the plane and in space.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The outputs. Arrays that are not wanted have data == nullptr. Widths: dim for points, tangents and normals,
// 3 for binormals, 1 for curvatures and torsions.
struct CurveFrames {
    Records points;
    Records tangents;
    Records normals;
    Records binormals;
    Records curvatures;
    Records torsions;
    int32_t *status = nullptr;
};

// Preconditions: a curve of dimension 2 or 3, parameters that have been checked, and no binormals or torsions
// in the plane. Otherwise as evaluate_points().
void curve_frames(const Spline &spline, const AxisRules &rules, ConstRecords params, const CurveFrames &out);

} // namespace nrb::eval
