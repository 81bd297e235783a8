// SPDX-License-Identifier: MIT
// How far a spline is from a straight line and from a plane, and balls that contain points.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::analysis {

struct Flatness {
    std::vector<double> origin;
    std::vector<double> direction; // of the line, or the normal of the plane
    double bound = 0;              // no point is farther
};

// The line along which points of the spline spread most, moved so that it is near their middle. Throws
// Status::not_representable.
Flatness straightness(const Spline &spline);

// The plane across the direction in which the control points spread least, in the middle of the spline.
// Throws Status::not_representable. Precondition: dimension 3.
Flatness planarity(const Spline &spline);

// Some thousand points of a spline, one after the other.
std::vector<double> sample_points(const Spline &spline);

// The centre of a ball of nearly the least radius that contains the points (M. Badoiu, K. Clarkson, "Smaller
// core-sets for balls", SODA 2003); points that are not finite are left out.
std::vector<double> ball_centre(const std::vector<double> &points, int dim);

// No point of the spline is farther from a point than this; it is nearly the least such number.
double farthest_from(const Spline &spline, const std::vector<double> &centre);

} // namespace nrb::analysis
