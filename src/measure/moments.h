// SPDX-License-Identifier: MIT
// Content, centroid and inertia of shapes and of what they enclose.
#pragma once

#include "measure/tensor_integral.h"

#include <vector>

namespace nrb::measure {

// How far the moments go.
enum class MomentOrder { content, centroid, inertia };

struct Moments {
    double content = 0;
    double error = 0;             // estimate, of content
    std::vector<double> centroid; // [dim]
    std::vector<double> inertia;  // [dim][dim], about the centroid
    double openness = 0;          // length of the vector area
};

// Of the shape itself, or of the part over `ranges`. Precondition: a volume has dimension 3. Throws
// Status::length, not_converged, not_representable.
Moments moments(const Spline &spline, const Part &part, MomentOrder order, double relative_tolerance);

// Of what curves of dimension 2 or surfaces of dimension 3 enclose. Throws as moments().
Moments enclosed_moments(const std::vector<SplinePtr> &boundary, MomentOrder order,
                         double relative_tolerance);

// Throws Status::gap unless an end of curves, and every limit at a jump inside one, has a start within
// the tolerance.
void check_closed(const std::vector<SplinePtr> &curves, double tolerance);

} // namespace nrb::measure
