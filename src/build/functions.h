// Polynomial splines as functions of which blends are made; a null one is the function 1.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb {

// Without the checks of make_result(). Precondition: the sizes agree and all values are finite.
SplinePtr polynomial_spline(Spline::Axes axes, int dim, std::vector<double> points);

// Whether two functions have the same control points over common knots, bit for bit. Precondition: neither is null.
bool same_function(const SplinePtr &a, const SplinePtr &b);

// Throws what product() throws.
SplinePtr times(const SplinePtr &a, const SplinePtr &factor);

} // namespace nrb
