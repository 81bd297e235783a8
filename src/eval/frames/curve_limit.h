// SPDX-License-Identifier: MIT
// Frames of curves, also where C' or C' x C'' vanishes and they are limits.
#pragma once

#include "eval/frames/frame_outputs.h"
#include "eval/frames/jet.h"

namespace nrb::eval {

struct CurveFrame {
    Vector3 tangent;
    Vector3 normal;
    Vector3 binormal; // in space only, like the torsion
    double curvature = 0;
    double torsion = 0;
    int32_t status = 0;
};

// The frame that stands for none: NaN, with the status frame_undefined.
CurveFrame undefined_frame() noexcept;

// The tangent, or its limit. `kind` is the order of the first derivative that does not vanish: 1 at regular
// points, 0 if there is none (or if the parameter gives NaN).
struct CurveTangent {
    int kind = 0;
    Vector3 direction;
};
CurveTangent curve_tangent(const Spline &spline, const AxisRules &rules, double t) noexcept;

// The frame at t, with the limits that nurbs_curve_eval_frames() defines. Its status is 0 if C' and, in
// space, C' x C'' exceed the bounds of their rounding errors. Precondition of curve_tangent() and
// limit_frame(): Jet::prepare() has been called for the curve.
CurveFrame limit_frame(const Spline &spline, const AxisRules &rules, double t) noexcept;

} // namespace nrb::eval
