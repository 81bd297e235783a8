// SPDX-License-Identifier: MIT
// The triangles around points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace nrb::mesh {

// By its points; without any it is no triangle. border[k]: side k, opposite of corner k, is at the border of the mesh.
struct MeshTriangle {
    std::array<int32_t, 3> points{-1, -1, -1};
    std::array<bool, 3> border{};

    [[nodiscard]] bool is_empty() const noexcept { return points[0] < 0; }
};

class PointFans {
public:
    // Of the corners of the wanted ones of the triangles.
    PointFans(size_t points, std::span<const MeshTriangle> triangles, std::span<const int32_t> wanted);

    // Rising; a triangle is there as often as it has corners at the point. None around points that are not wanted.
    [[nodiscard]] std::span<const int32_t> of(int32_t point) const noexcept {
        const auto at = static_cast<size_t>(point);
        return std::span(triangles_)
            .subspan(static_cast<size_t>(first_[at]), static_cast<size_t>(first_[at + 1] - first_[at]));
    }

private:
    std::vector<int32_t> first_, triangles_;
};

} // namespace nrb::mesh
