// SPDX-License-Identifier: MIT
// Which triangles of a mesh are next to each other.
#pragma once

#include "mesh/proof/point_fans.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// A triangle across a side of another one, with the number of that side in it; -1: there is none.
struct Neighbour {
    int32_t triangle = -1;
    size_t side = 0;
};

// A triangle of the star of another one, that is, of those that share a corner with it. It may share one corner or
// two, which form a side. corner: the number in it of the common corner, or of the one that is not common.
struct StarTriangle {
    int32_t triangle;
    size_t corner;
    bool shares_side;
};

class Neighbours {
public:
    // Around the corners of wanted triangles.
    Neighbours(size_t points, std::span<const MeshTriangle> triangles, std::span<const int32_t> wanted)
        : triangles_(triangles), fans_(points, triangles, wanted) {}

    [[nodiscard]] const MeshTriangle &operator[](size_t triangle) const noexcept {
        return triangles_[triangle];
    }
    [[nodiscard]] std::span<const int32_t> fan(int32_t point) const noexcept { return fans_.of(point); }
    [[nodiscard]] Neighbour across(size_t triangle, size_t side) const noexcept;
    // The star of a wanted triangle, without itself; triangles that share a side come twice. Empty if a corner has
    // very many triangles, as at a pole, or if another triangle has the same corners.
    [[nodiscard]] std::vector<StarTriangle> star(size_t triangle) const;

private:
    std::span<const MeshTriangle> triangles_;
    PointFans fans_;
};

} // namespace nrb::mesh
