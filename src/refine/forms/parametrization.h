// SPDX-License-Identifier: MIT
// Changes of the parameter that keep the shape: reversal, and affine maps of the domain.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::refine {

// The knots of a reversed axis: -t for each knot t, in the opposite order.
std::vector<double> negated(std::span<const double> knots);

// The axis reversed: t becomes -t, or lower + upper - t with keep_domain. Throws Status::knots_merge and
// not_representable, both only with keep_domain. Cost: linear in the number of points.
SplinePtr reverse(const Spline &spline, int axis, bool keep_domain);

// The axis mapped to another domain by an affine map. Throws Status::parameter_not_finite, empty_domain,
// knots_merge, not_representable.
SplinePtr reparametrize(const SplinePtr &spline, int axis, Interval domain);

// Checks that the knots of an axis are still finite and in order after a map, and that no distinct knots have
// become equal. Throws Status::not_representable, knots_merge.
void check_distinct(std::span<const double> before, std::span<const double> after, int axis);

} // namespace nrb::refine
