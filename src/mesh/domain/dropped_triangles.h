// SPDX-License-Identifier: MIT
// Degenerate triangles: those with two corners at one point, which are left out of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::mesh {

// Whether two corners are one point.
inline bool is_dropped(const std::array<int32_t, 3> &p) noexcept {
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

// A degenerate triangle is a segment or a point in space, and the bounds that are proven of it hold for that.
// Returns whether every such segment is a side of other triangles that are kept, as at a pole, and every such
// point a corner of one. Otherwise a part of the surface would have nothing near it, as where a closed axis
// has a single cell around it, all of whose triangles are left out. Triangles are given by their points.
bool have_all_dropped(const std::vector<std::array<int32_t, 3>> &triangles);

} // namespace nrb::mesh
