// SPDX-License-Identifier: MIT
// Curves on a surface that its normals and curvatures make.
#pragma once

#include "intersect/levels/level_meet.h"

#include <span>

namespace nrb::intersect {

enum class ContourKind : int32_t {
    silhouette = 1,  // N . d = 0: seen along d
    perspective = 2, // N . (S - d) = 0: seen from the point d
    isophote = 3,    // N . d = c |N| |d|: under a constant angle, of cosine c, to d
    parabolic = 4,   // where the Gaussian curvature is 0
};

// For isophotes one after the other of the cosines; the other kinds have one level, 0. tolerance > 0, d not 0.
// Precondition: a surface in space.
Meet surface_contours(const Spline &surface, ContourKind kind, const std::array<double, 3> &d,
                      std::span<const double> cosines, double tolerance);

} // namespace nrb::intersect
