// SPDX-License-Identifier: MIT
// The distance of two curves that run along each other at different speeds.
#pragma once

#include "spline/spline.h"

namespace nrb::face {

// A proven bound on sup |a(t) - b(phi(t))|, and so on the Hausdorff distance of the two curves. phi maps the
// domain of a onto that of b, start to start and end to end, by cubics through the parameters of foot points.
// There are as many cubics as the tolerance takes, up to a limit: the error falls with the fourth power of
// their length, while that of piecewise linear maps falls with the second. Infinite if nothing can be proven,
// as where the composition b(phi) would have a degree above max_degree.
double distance_along_feet(const SplinePtr &a, const SplinePtr &b, double tolerance);

} // namespace nrb::face
