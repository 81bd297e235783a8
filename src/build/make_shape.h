// SPDX-License-Identifier: MIT
// Constructed splines from their control points.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// A spline of Cartesian points and weights; weights that are all 1 are dropped. Throws
// Status::not_representable if a coordinate is not finite, and what make_result() throws.
SplinePtr make_shape(Spline::Axes axes, int dim, std::vector<double> points, std::vector<double> weights);

} // namespace nrb::build
