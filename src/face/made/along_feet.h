// SPDX-License-Identifier: MIT
// How far two curves are apart that run along each other at different speeds.
#pragma once

#include "spline/spline.h"

namespace nrb::face {

// A proven bound on sup |a(t) - b(phi(t))|, where phi maps the domain of a onto that of b, from start to start, by cubics through
// the parameters of nearest points; so no point of either is farther from the other. There are as many cubics as the tolerance
// takes, up to a limit: the error falls with the fourth power of their length, where that of straight maps falls with the second.
// Infinite if nothing can be proven, as where the composition would have a degree above max_degree.
double distance_along_feet(const SplinePtr &a, const SplinePtr &b, double tolerance);

} // namespace nrb::face
