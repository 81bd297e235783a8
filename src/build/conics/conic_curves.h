// SPDX-License-Identifier: MIT
// Conics in their principal axes.
#pragma once

#include "build/conics/arc.h"
#include "build/placement.h"
#include "spline/spline.h"

#include <cstdint>

namespace nrb::build {

// origin + radius_x x X + radius_y y Y for the points (x, y) of an arc. Equal weights are dropped.
SplinePtr placed_arc(const Placement &place, double radius_x, double radius_y, const Arc &arc);

// These three are described in nurbs.h. They throw Status::length, angle, form, parameter_not_finite,
// empty_domain, and what make_result() throws.
SplinePtr ellipse(const Placement &place, double radius_x, double radius_y, const Turn &turn, int32_t form);
SplinePtr parabola(const Placement &place, double focal_length, double start, double end);
SplinePtr hyperbola(const Placement &place, double radius_x, double radius_y, double start, double end);

} // namespace nrb::build
