// SPDX-License-Identifier: MIT
// The density of cells along both axes, where the border cuts them.
#pragma once

#include "mesh/cells/cell_tree.h"

#include <array>

namespace nrb::mesh {

// About how many cells there are on a step of 1 of the parameter along each axis. A cell of length s counts
// with the length 1 / sqrt(1/s^2 + 1/w^2), which is less than the width w, the shorter side of the domain in
// space. In the metric in which such cells are square, triangles between the border and the cells are best as
// fat as possible: on a cylinder they are then long along the rulings, on a plane they are fat in space. The
// result is NaN or infinite where the border cuts no cells, or where these are degenerate.
std::array<double, 2> cell_density(const CellTree &tree);

} // namespace nrb::mesh
