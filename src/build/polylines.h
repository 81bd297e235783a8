// SPDX-License-Identifier: MIT
// Polylines, regular polygons, and rectangles with rounded corners.
#pragma once

#include "base/records.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>
#include <vector>

namespace nrb::build {

// The polyline through packed points of `dim` coordinates, at as many parameters. Throws
// Status::too_few_points, parameter_not_finite, knots_decreasing, and what make_spline() throws.
SplinePtr polyline(int dim, std::vector<double> points, std::vector<double> params);

// 0, 1 / (n - 1), ..., 1.
std::vector<double> even_params(int64_t n);

// A closed regular polygon over [0, 1] with its corners on a circle, the first one in the direction x. Throws
// Status::count, length, overflow.
SplinePtr regular_polygon(const Placement &place, double radius, int64_t sides);

// A closed rectangle with sides along x and y, whose corners are rounded by quarter circles. Throws
// Status::length.
SplinePtr rounded_rectangle(const Placement &place, double width, double height, double corner_radius);

} // namespace nrb::build
