// SPDX-License-Identifier: MIT
// Surfaces that are affine maps of their domain.
#pragma once

#include "spline/spline.h"

#include <optional>
#include <vector>

namespace nrb::face {

// x = matrix (u, v) + move, rows of the matrix one after the other.
struct PlaneMap {
    std::vector<double> matrix, move;

    // What becomes of a curve of the domain, of the same degree.
    [[nodiscard]] SplinePtr image(const Spline &curve) const;
};

// Of a parallelogram of degree 1, to rounding; none for other surfaces.
std::optional<PlaneMap> plane_map(const Spline &surface);

} // namespace nrb::face
