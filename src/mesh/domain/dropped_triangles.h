// SPDX-License-Identifier: MIT
// Triangles with two corners at one point, which are left out of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::mesh {

// Whether two corners are one point.
inline bool is_dropped(const std::array<int32_t, 3> &p) noexcept {
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

// A triangle with two corners at one point is a segment, or a point, and what is proven of it is about that. Whether each such one is
// a side of other triangles, as at a pole, or lies in one: else a part of the surface would have nothing near it, as where a strip
// around a closed axis has a single cell, all of whose triangles are left out. By points.
bool have_all_dropped(const std::vector<std::array<int32_t, 3>> &triangles);

} // namespace nrb::mesh
