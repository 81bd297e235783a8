// SPDX-License-Identifier: MIT
// Polynomial splines as functions, made without the checks of results and multiplied.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// With the checks of make_result(), and what it throws.
SplinePtr polynomial_result(Spline::Axes axes, int dim, std::vector<double> points);

// Without them. Precondition: the sizes agree and all values are finite.
SplinePtr polynomial_spline(Spline::Axes axes, int dim, std::vector<double> points);

// The product, by components; null stands for the function 1. Throws what product() throws.
SplinePtr times(const SplinePtr &a, const SplinePtr &factor);

} // namespace nrb::refine
