// SPDX-License-Identifier: MIT
// Points and derivatives of a C^1 piecewise cubic: the data that it was made of.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// Packed records of dim values at the breaks, which are the ends of the non-empty spans.
struct HermiteData {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> tangents;
};

// Throws Status::rational, degree above 3, and continuity if knots inside the domain allow a kink.
// Precondition: a curve. Points lose no more than Bezier points do; tangents lose 2 p of that and 1.5 eps of
// themselves, over the longer one of the two spans. Cost: linear in the number of spans.
HermiteData hermite_data(const SplinePtr &curve);

} // namespace nrb::refine
