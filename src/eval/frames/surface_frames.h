// SPDX-License-Identifier: MIT
// Frames of surfaces in space: points, first derivatives and unit normals, at a list of parameters or on a
// grid.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

// The outputs. Arrays that are not wanted have data == nullptr; the others have a record of width 3 for each
// point.
struct SurfaceFrames {
    Records points;
    Records du;
    Records dv;
    Records normals;
    int32_t *status = nullptr;
};

// Preconditions: a surface of dimension 3, and parameters that have been checked. Otherwise as
// evaluate_points() and evaluate_grid().
void surface_frames(const Spline &spline, const AxisRules &rules, ConstRecords params,
                    const SurfaceFrames &out);
void surface_frames(const Spline &spline, const AxisRules &rules,
                    const std::array<ConstRecords, max_axes> &params, const SurfaceFrames &out);

} // namespace nrb::eval
