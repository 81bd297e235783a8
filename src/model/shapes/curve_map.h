// SPDX-License-Identifier: MIT
// The map between the parameters of a curve and those of its spline. They agree at the breaks of the spline
// and, except on circles, ellipses and hyperbolas, everywhere.
#pragma once

#include "model/shapes/curve_shape.h"

namespace nrb::model {

enum class ParameterLaw { linear, angle, hyperbolic };

// The law that holds at a parameter of a curve. Each piece of a composite curve has its own.
ParameterLaw law_at(const CurveShape &curve, double t) noexcept;

// On a piece of the spline, of length d around the middle m, let s go from 0 to 1 with the parameter of the
// spline. With x = (2 s - 1) k the parameter of the curve is
//     angle       t = m + 2 atan x,   k = tan(d / 4)
//     hyperbolic  t = m + 2 artanh x, k = tanh(d / 4)
// `knots` are those of the spline. Parameters outside the domain are the same on both.
double to_spline_parameter(ParameterLaw law, const KnotVector &knots, double t) noexcept;
double from_spline_parameter(ParameterLaw law, const KnotVector &knots, double s) noexcept;

// The same for a spline made by curve_spline() or piece_spline().
double to_spline_parameter(const CurveShape &curve, const Spline &spline, double t);
double from_spline_parameter(const CurveShape &curve, const Spline &spline, double s);

} // namespace nrb::model
