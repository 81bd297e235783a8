// SPDX-License-Identifier: MIT
// Conics by focus, directrix and eccentricity.
#pragma once

#include "build/conics/arc.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// A focus at the origin, and a directrix across x at a distance.
struct FocalFrame {
    Placement place;
    double distance;
};

// From the point of the directrix that is nearest to the focus. Throws what make_placement() throws, and
// Status::direction if foot is the focus, or the axis is not perpendicular to the line between them.
FocalFrame focal_frame(int32_t dim, const double *focus, const double *axis, const double *foot);

// Throws Status::factor, conic, and what conic_curve() throws.
SplinePtr conic_focus(const FocalFrame &frame, double eccentricity, const Turn &turn, int32_t form);

} // namespace nrb::build
