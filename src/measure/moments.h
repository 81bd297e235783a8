// SPDX-License-Identifier: MIT
// Content, centroid and inertia of shapes and of the regions that they enclose.
#pragma once

#include "measure/tensor_integral.h"

#include <vector>

namespace nrb::measure {

// The highest moments that are wanted.
enum class MomentOrder { content, centroid, inertia };

struct Moments {
    double content = 0;
    double error = 0;             // estimated error of the content
    std::vector<double> centroid; // [dim]
    std::vector<double> inertia;  // [dim][dim], about the centroid
    double openness = 0;          // length of the vector area; 0 if the boundary is closed
};

// Moments of the shape itself over a part of its domain. Precondition: a volume has dimension 3. Throws
// Status::length, not_converged, not_representable.
Moments moments(const Spline &spline, const Part &part, MomentOrder order, double relative_tolerance);

// Moments of the region that curves of dimension 2 or surfaces of dimension 3 enclose. Throws as moments().
Moments enclosed_moments(const std::vector<SplinePtr> &boundary, MomentOrder order,
                         double relative_tolerance);

} // namespace nrb::measure
