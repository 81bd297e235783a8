// SPDX-License-Identifier: MIT
// Parameters of a curve, and those of its spline: they agree at the breaks of the spline, and everywhere but on conics.
#pragma once

#include "model/shapes/curve_shape.h"

namespace nrb::model {

enum class ParameterLaw { linear, angle, hyperbolic };

// With x = (2 s - 1) k, where s goes from 0 to 1 over a piece of length d around the middle m:
//     angle       t = m + 2 atan x,   k = tan(d / 4)
//     hyperbolic  t = m + 2 artanh x, k = tanh(d / 4)
// `knots` are those of the axis of the spline. Parameters outside the domain are continued from its end.
double to_spline_parameter(ParameterLaw law, const KnotVector &knots, double t) noexcept;
double from_spline_parameter(ParameterLaw law, const KnotVector &knots, double s) noexcept;

// For a spline made by curve_spline() or piece_spline().
double to_spline_parameter(const CurveShape &curve, const Spline &spline, double t);
double from_spline_parameter(const CurveShape &curve, const Spline &spline, double s);

} // namespace nrb::model
