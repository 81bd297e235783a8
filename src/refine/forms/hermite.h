// SPDX-License-Identifier: MIT
// Hermite data of a C^1 piecewise cubic: its points and derivatives at the breaks.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::refine {

// Packed records of dim values for each break, that is, for each end of a non-empty span.
struct HermiteData {
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> tangents;
};

// The Hermite data of a curve. Points are as accurate as Bezier points. Tangents are taken on the longer one
// of the two adjacent spans; they lose 2 p times that error divided by its length, and 1.5 eps of themselves.
// Throws Status::rational, degree (above 3), and continuity if knots inside the domain allow a kink.
// Precondition: a curve. Cost: linear in the number of spans.
HermiteData hermite_data(const SplinePtr &curve);

} // namespace nrb::refine
