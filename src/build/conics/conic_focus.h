// SPDX-License-Identifier: MIT
// Conics by focus, directrix and eccentricity.
#pragma once

#include "build/conics/arc.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// A placement with the focus at its origin; the directrix is perpendicular to x, at a distance.
struct FocalFrame {
    Placement place;
    double distance;
};

// The frame for a focus and the foot, the point of the directrix nearest to the focus. The axis, null for (0,
// 0, 1) and always in dimension 2, is the normal of the plane; only its part perpendicular to foot - focus
// counts. Throws what make_placement() throws, and Status::direction if the foot is the focus or the axis is
// parallel to the line between them.
FocalFrame focal_frame(int32_t dim, const double *focus, const double *axis, const double *foot);

// Throws Status::form, factor, conic, and what conic_curve() throws.
SplinePtr conic_focus(const FocalFrame &frame, double eccentricity, const Turn &turn, int32_t form);

} // namespace nrb::build
