// SPDX-License-Identifier: MIT
// The fans of triangles around the points of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// A triangle by its points; where these are -1 there is none. border[k]: side k, opposite corner k, is on the
// border of the mesh.
struct MeshTriangle {
    std::array<int32_t, 3> points{-1, -1, -1};
    std::array<bool, 3> border{};

    [[nodiscard]] bool is_empty() const noexcept { return points[0] < 0; }
};

class PointFans {
public:
    // The fans around all corners of the wanted triangles.
    PointFans(size_t points, std::span<const MeshTriangle> triangles, std::span<const int32_t> wanted);

    // Ascending. A triangle occurs once for each corner that it has at the point. Empty at points that are
    // not corners of wanted triangles.
    [[nodiscard]] std::span<const int32_t> of(int32_t point) const noexcept {
        const auto at = static_cast<size_t>(point);
        return std::span(triangles_)
            .subspan(static_cast<size_t>(first_[at]), static_cast<size_t>(first_[at + 1] - first_[at]));
    }

private:
    std::vector<int64_t> first_; // up to three for each triangle
    std::vector<int32_t> triangles_;
};

} // namespace nrb::mesh
