// SPDX-License-Identifier: MIT
// Triangles at a pole that lie on each other.
#pragma once

#include "mesh/domain/border_strip.h"

#include <vector>

namespace nrb::mesh {

// All places on the side of the domain that is a pole are one point. Where one beside it has no other neighbours than such places and one
// further place, its two triangles have the same corners, back to back. So have the triangles of two faces at a border that leads to a pole, if each
// has the last two segments of it. A flip gives the place another neighbour. Sites are those of `triangles`.
void open_fins(const Sites &sites, std::vector<BorderStrip::Piece> &triangles);

} // namespace nrb::mesh
