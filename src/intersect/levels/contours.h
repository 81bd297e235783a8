// SPDX-License-Identifier: MIT
// Curves on a surface that depend on its normals and curvatures: silhouettes, isophotes and parabolic curves.
#pragma once

#include "intersect/levels/level_meet.h"

#include <span>

namespace nrb::intersect {

enum class ContourKind : int32_t {
    silhouette = 1,  // N . d = 0: the outline as seen along d
    perspective = 2, // N . (S - d) = 0: the outline as seen from the point d
    isophote = 3,    // N . d = c |N| |d|: normals at a constant angle, of cosine c, to d
    parabolic = 4,   // the Gaussian curvature is 0
};

// Isophotes have one level for each of the cosines; the other kinds have one level, 0. Directions d must not
// be 0, and for isophotes they must be unit vectors. tolerance > 0. Precondition: a surface in space.
Meet surface_contours(const Spline &surface, ContourKind kind, const std::array<double, 3> &d,
                      std::span<const double> cosines, double tolerance);

} // namespace nrb::intersect
