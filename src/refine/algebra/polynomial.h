// SPDX-License-Identifier: MIT
// Polynomial splines as functions: made with or without the checks of results, and multiplied.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// A polynomial spline, checked by make_result(). Throws what that throws.
SplinePtr polynomial_result(Spline::Axes axes, int dim, std::vector<double> points);

// The same without checks. Precondition: the sizes agree and all values are finite.
SplinePtr polynomial_spline(Spline::Axes axes, int dim, std::vector<double> points);

// The componentwise product; null stands for the constant function 1. Throws what product() throws.
SplinePtr times(const SplinePtr &a, const SplinePtr &factor);

} // namespace nrb::refine
