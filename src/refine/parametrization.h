// Changes of the parameter that keep the shape: reversal and affine maps of the domain.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb {

// Knots turned round: -t of each, from the last to the first.
std::vector<double> negated(std::span<const double> knots);

// The axis turned round: t becomes -t, or with keep_domain lower + upper - t. Throws NURBS_ERROR_KNOTS_MERGE
// and _NOT_REPRESENTABLE, both only with keep_domain. Cost: linear in the number of points.
SplinePtr reverse(const Spline &spline, int axis, bool keep_domain);

// The axis over another domain. Throws NURBS_ERROR_PARAMETER_NOT_FINITE, _EMPTY_DOMAIN, _KNOTS_MERGE,
// _NOT_REPRESENTABLE.
SplinePtr reparametrize(const SplinePtr &spline, int axis, Interval domain);

// Knots of an axis as a map left them: finite, and distinct ones still distinct and in order. Throws
// NURBS_ERROR_NOT_REPRESENTABLE, _KNOTS_MERGE.
void check_distinct(std::span<const double> before, std::span<const double> after, int axis);

} // namespace nrb
