// SPDX-License-Identifier: MIT
// Plane parallelograms as affine maps of their domain.
#pragma once

#include "spline/spline.h"

#include <optional>
#include <vector>

namespace nrb::face {

// x = matrix (u, v) + move, rows of the matrix one after the other.
struct PlaneMap {
    std::vector<double> matrix, move;

    // The image of a curve in the domain, which has the same degree.
    [[nodiscard]] SplinePtr image(const Spline &curve) const;
};

// Of a polynomial surface of degree 1 with 2 x 2 control points that form a parallelogram to rounding; none
// for other surfaces.
std::optional<PlaneMap> plane_map(const Spline &surface);

} // namespace nrb::face
