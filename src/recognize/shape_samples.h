// SPDX-License-Identifier: MIT
// Points and normals of a spline to which shapes are fitted.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::recognize {

// Spread evenly over the spline rather than over its parameters. Those that are not finite are left out; at
// most a few hundred.
struct ShapeSamples {
    Vector3 centre;               // of the box of the samples; all points are relative to it
    double size = 0;              // half the diagonal of the box
    std::vector<Vector3> points;  // of a curve in order
    std::vector<Vector3> feet;    // the points that have a normal: of a surface, where it is regular
    std::vector<Vector3> normals; // unit vectors
    Vector3 along;                // of a surface: the sum of its steps along axis 0
};

// Of a curve or surface of dimension 2 or 3.
ShapeSamples shape_samples(const Spline &spline);

} // namespace nrb::recognize
