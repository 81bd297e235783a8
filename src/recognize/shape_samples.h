// SPDX-License-Identifier: MIT
// Sample points and normals of a spline, to which shapes are fitted.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::recognize {

// Samples are spread evenly over the spline rather than over its parameters. At most a few hundred; those
// that are not finite are left out.
struct ShapeSamples {
    Vector3 centre;               // of the box of the samples; all points are relative to it
    double size = 0;              // half the diagonal of the box
    std::vector<Vector3> points;  // in order of the parameter for a curve
    std::vector<Vector3> feet;    // for a surface: the points at which it is regular and has a normal
    std::vector<Vector3> normals; // unit vectors, one for each of feet
    Vector3 along;                // for a surface: the sum of its steps along axis 0
};

// Precondition: a curve or surface of dimension 2 or 3.
ShapeSamples shape_samples(const Spline &spline);

} // namespace nrb::recognize
