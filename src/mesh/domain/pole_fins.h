// SPDX-License-Identifier: MIT
// Triangles at a pole that lie on each other.
#pragma once

#include "mesh/domain/border_strip.h"

#include <vector>

namespace nrb::mesh {

// All places on the side of the domain that is a pole are one point. Where one beside it has no other neighbours than such places and one
// further place, its two triangles have the same corners, back to back: a flip gives it another neighbour. Where a border leads to the pole,
// sides from there to other vertices of it may be those of the face beyond, too: they are divided, at places that are appended to `divided`. Sites are those of `triangles`.
void open_fins(const CellGrid &cells, Sites &sites, std::vector<BorderStrip::Piece> &triangles,
               std::vector<std::array<double, 2>> &divided);

} // namespace nrb::mesh
