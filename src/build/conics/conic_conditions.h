// SPDX-License-Identifier: MIT
// Circular and conic arcs with given points and tangents.
#pragma once

#include "build/conics/conic_arc.h"

#include <cstdint>
#include <span>

namespace nrb::build {

using Coordinates = std::span<const double>; // of one point or direction, equally many in all arguments

// These functions are described in nurbs.h. They throw Status::collinear, conic, direction and what
// conic_curve() throws. Preconditions: finite coordinates, at least two; directions are not 0.
SplinePtr arc_through(Coordinates a, Coordinates b, Coordinates c, int32_t form);
SplinePtr arc_tangent(Coordinates a, Coordinates tangent, Coordinates b, int32_t form);
SplinePtr conic_shoulder(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                         double rho);
SplinePtr conic_point(Coordinates a, Coordinates tangent_a, Coordinates b, Coordinates tangent_b,
                      Coordinates point, int32_t form);
// `points` holds five of dim coordinates.
SplinePtr conic_through(Coordinates points, int dim, int32_t form);

} // namespace nrb::build
