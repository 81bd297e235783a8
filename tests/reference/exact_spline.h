// Points and partial derivatives of splines of any number of axes without rounding.
#pragma once

#include "reference/number.h"
#include "support/spline_data.h"

#include <array>
#include <vector>

namespace reference {

using Sides = std::array<bool, 3>; // per axis: the limit from below

// derivs[slot][c]: coordinate c of the derivative of that slot in the order of nurbs_eval_derivs().
// Parameters outside the domain continue the first or last piece. Precondition: w(t) != 0.
std::vector<std::vector<Fraction>> exact_derivatives(const support::SplineData &data, int order,
                                                     const double *param, Sides left = {});

// The point alone.
std::vector<Fraction> exact_point(const support::SplineData &data, const double *param, Sides left = {});

// Index of the first active control point on each axis, span - degree.
std::vector<int64_t> first_active(const support::SplineData &data, const double *param, Sides left = {});

// Indices of all active control points, last axis fastest.
std::vector<int64_t> active_points(const support::SplineData &data, const std::vector<int64_t> &first);

// The `hull` of the accuracy contract: largest |coordinate| of an active control point of positive weight.
double exact_hull(const support::SplineData &data, const double *param, Sides left = {});

// Whether w(t) > 0 at both ends of every span on every axis, which with weights >= 0 means on the whole
// closed domain.
bool weights_suit(const support::SplineData &data);

} // namespace reference
