// SPDX-License-Identifier: MIT
// Frames of curves where C' or C' x C'' may vanish.
#pragma once

#include "eval/frames/frame_outputs.h"
#include "eval/frames/jet.h"

namespace nrb::eval {

struct CurveFrame {
    Vector3 tangent;
    Vector3 normal;
    Vector3 binormal; // of a curve in space, as is the torsion
    double curvature = 0;
    double torsion = 0;
    int32_t status = 0;
};

// A frame that does not exist.
CurveFrame undefined_frame() noexcept;

// The limit of the tangent; kind is the order of the first derivative that does not vanish: 1 at regular
// points, 0 if there is none (or the parameter gives NaN).
struct CurveTangent {
    int kind = 0;
    Vector3 direction;
};
CurveTangent curve_tangent(const Spline &spline, const AxisRules &rules, double t) noexcept;

// The frame by the limits of nurbs_curve_eval_frames(). Its status is 0 if C' and, in space, C' x C'' exceed
// the bounds of their rounding errors. Precondition of both: Jet::prepare().
CurveFrame limit_frame(const Spline &spline, const AxisRules &rules, double t) noexcept;

} // namespace nrb::eval
