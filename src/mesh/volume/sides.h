// SPDX-License-Identifier: MIT
// Where a spline meets itself at the ends of its axes, and where it is torn.
#pragma once

#include "mesh/volume/lattice.h"
#include "spline/spline.h"

namespace nrb::mesh {

// Throws Status::degree for an axis of degree 0, along which cells have no extent.
void check_cell_degrees(const Spline &spline);

// Of each span of an axis but the last whether the spline may jump at its end.
std::vector<bool> jumps_of(const KnotVector &axis);

// Whether the end of an axis is where it starts: it is periodic, or both ends have the same control points and weights bit for bit.
bool closes(const Spline &spline, int k);

// Sides of a volume, or of a surface, whose control points are the same bit for bit along an axis, and whose weights do not make them differ.
Collapses collapses_of(const Spline &spline);

} // namespace nrb::mesh
