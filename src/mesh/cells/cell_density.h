// SPDX-License-Identifier: MIT
// How close cells follow each other along both axes, where the border cuts them.
#pragma once

#include "mesh/cells/cell_tree.h"

#include <array>

namespace nrb::mesh {

// How many cells there are on a step of 1 along each axis, about; as if the domain were no longer than wide. In the metric in which both are
// one length, triangles between the border and cells are best as fat as they can be: on a cylinder they are long along the
// straight lines, on a plane as in space. No numbers, or infinite ones, where there are no such cells or these are degenerate.
std::array<double, 2> cell_density(const CellTree &tree);

} // namespace nrb::mesh
