// SPDX-License-Identifier: MIT
// How close cells follow each other along both axes, where the border cuts them.
#pragma once

#include "mesh/cells/cell_tree.h"

#include <array>

namespace nrb::mesh {

// Cells on a step of 1 along each axis, about, of those that are as small as the distance and the longest side want them (0: any), in the units
// of the grid. In the metric in which both are one length, triangles between the border and cells are best as fat as they can be: on a
// cylinder long along the straight lines, on a plane as in space.
std::array<double, 2> cell_density(const CellTree &tree, double chord, double longest);

} // namespace nrb::mesh
