// SPDX-License-Identifier: MIT
// B-spline curves and surfaces with and without stated knots.
#pragma once

#include "io/step/geometry/placements.h"
#include "spline/spline.h"

namespace nrb::io::step {

// Bezier forms have a break at every degree-th control point, uniform ones knots at the integers, quasi-uniform ones
// the same between clamped ends. Flags for closed and self-intersecting shapes, and names of forms, are information
// only. Weights that are all equal are dropped. Throw Status::syntax, count, degree, and what make_spline() throws:
// counts are compared with what is there before anything is allocated.
SplinePtr read_b_spline_curve(Entities &entities, const Instance &instance, double length);
SplinePtr read_b_spline_surface(Entities &entities, const Instance &instance, double length);

} // namespace nrb::io::step
