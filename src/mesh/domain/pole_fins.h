// SPDX-License-Identifier: MIT
// Removes fins at poles: pairs of triangles that lie on each other.
#pragma once

#include "mesh/domain/border_strip.h"

#include <vector>

namespace nrb::mesh {

// All places on the side of the domain that is a pole are one point. Where a place beside it has no other
// neighbours than such places and one further place, two of its triangles have the same three corners, back
// to back: a fin. A flip gives the place another neighbour. Where a border leads to the pole, a side from
// there to another vertex of this border may be a side in the mesh of the face beyond as well; such sides are
// divided, at places that are appended to `divided`. `sites`: of the triangles.
void open_fins(const CellGrid &cells, Sites &sites, std::vector<BorderStrip::Piece> &triangles,
               std::vector<std::array<double, 2>> &divided);

} // namespace nrb::mesh
