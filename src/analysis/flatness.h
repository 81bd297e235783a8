// SPDX-License-Identifier: MIT
// How far a spline is from a straight line and from a plane; nearly smallest enclosing balls.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::analysis {

struct Flatness {
    std::vector<double> origin;
    std::vector<double> direction; // of the line, or the normal of the plane
    double bound = 0;              // no point of the spline is farther away
};

// The line in the direction in which points of the spline spread most, moved to the middle of the spline.
// Throws Status::not_representable.
Flatness straightness(const Spline &spline);

// The plane orthogonal to the direction in which the control points spread least, in the middle of the
// spline. Throws Status::not_representable. Precondition: dimension 3.
Flatness planarity(const Spline &spline);

// Some thousand points of a spline, stored consecutively.
std::vector<double> sample_points(const Spline &spline);

// The centre of a ball of nearly the smallest radius that contains the points (M. Badoiu, K. Clarkson,
// "Smaller core-sets for balls", SODA 2003). Points that are not finite are ignored.
std::vector<double> ball_centre(const std::vector<double> &points, int dim);

// An upper bound on the distance of the points of the spline from a point; it is nearly the largest distance.
double farthest_from(const Spline &spline, const std::vector<double> &centre);

} // namespace nrb::analysis
