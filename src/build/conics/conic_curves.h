// SPDX-License-Identifier: MIT
// Ellipses, parabolas and hyperbolas in the frames of their principal axes.
#pragma once

#include "build/conics/arc.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// The curve with the control points origin + radius_x x X + radius_y y Y for the control points (x, y) of an
// arc of the unit circle or hyperbola. Weights that are all 1 are dropped.
SplinePtr placed_arc(const Placement &place, double radius_x, double radius_y, const Arc &arc);

// The following functions are described in nurbs.h. They throw Status::length, angle, form,
// parameter_not_finite, empty_domain, and what make_result() throws.
SplinePtr ellipse(const Placement &place, double radius_x, double radius_y, const Turn &turn, int32_t form);
SplinePtr parabola(const Placement &place, double focal_length, double start, double end);
SplinePtr hyperbola(const Placement &place, double radius_x, double radius_y, double start, double end);

} // namespace nrb::build
