// SPDX-License-Identifier: MIT
// Distances of points from segments and triangles.
#pragma once

#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nrb::mesh {

inline double distance_from_segment(const Vector3 &x, const Vector3 &a, const Vector3 &b) noexcept {
    const Vector3 along = b - a;
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(x - a, along) / squared, 0.0, 1.0) : 0;
    return length(x - (a + t * along));
}

// The distance from the plane if the foot point is inside the triangle, else from the nearest side.
inline double distance_from_triangle(const Vector3 &x, const std::array<Vector3, 3> &corners) noexcept {
    const Vector3 product = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = length(product);
    bool inside = area > 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < 3; ++k) {
        const Vector3 &a = corners[k], &b = corners[(k + 1) % 3];
        inside = inside && dot(cross(b - a, x - a), product) >= 0;
        nearest = std::min(nearest, distance_from_segment(x, a, b));
    }
    return inside ? std::min(nearest, std::abs(dot(x - corners[0], product)) / area) : nearest;
}

} // namespace nrb::mesh
