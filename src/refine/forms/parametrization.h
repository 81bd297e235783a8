// SPDX-License-Identifier: MIT
// Changes of the parameter that keep the shape: reversal and affine maps of the domain.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::refine {

// Knots reversed: -t of each, from the last to the first.
std::vector<double> negated(std::span<const double> knots);

// The axis reversed: t becomes -t, or with keep_domain lower + upper - t. Throws Status::knots_merge and
// not_representable, both only with keep_domain. Cost: linear in the number of points.
SplinePtr reverse(const Spline &spline, int axis, bool keep_domain);

// The axis over another domain. Throws Status::parameter_not_finite, empty_domain, knots_merge,
// not_representable.
SplinePtr reparametrize(const SplinePtr &spline, int axis, Interval domain);

// Checks the knots of an axis after a map: finite, and distinct knots still distinct and in order. Throws
// Status::not_representable, knots_merge.
void check_distinct(std::span<const double> before, std::span<const double> after, int axis);

} // namespace nrb::refine
