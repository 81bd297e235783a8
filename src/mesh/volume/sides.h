// SPDX-License-Identifier: MIT
// Where the two ends of an axis of a spline meet, where the spline is torn, and which of its sides collapse.
#pragma once

#include "mesh/volume/lattice.h"
#include "spline/spline.h"

namespace nrb::mesh {

// Throws Status::degree for an axis of degree 0, along which cells have no extent.
void check_cell_degrees(const Spline &spline);

// For each span of an axis except the last, whether the spline may jump at its end.
std::vector<bool> jumps_of(const KnotVector &axis);

// Whether the end of an axis meets its start: it is periodic without a jump, or both ends have the same
// control points and weights, bit for bit.
bool closes(const Spline &spline, int k);

// The sides of a surface or volume that collapse along an axis: their control points are the same along it,
// bit for bit, and their weights do not make points differ.
Collapses collapses_of(const Spline &spline);

} // namespace nrb::mesh
