// SPDX-License-Identifier: MIT
#include "mesh/proof/point_fans.h"

namespace nrb::mesh {

PointFans::PointFans(size_t points, std::span<const MeshTriangle> triangles, std::span<const int32_t> wanted)
    : first_(points + 1) {
    constexpr int64_t unwanted = -1;
    std::vector<int64_t> next(points, unwanted); // number of triangles, then where the next one goes
    for (const int32_t triangle : wanted) {
        for (const int32_t point : triangles[static_cast<size_t>(triangle)].points) {
            next[static_cast<size_t>(point)] = 0;
        }
    }
    const auto for_each_corner = [&](auto &&visit) {
        for (size_t i = 0; i < triangles.size(); ++i) {
            for (size_t k = 0; k < 3 && !triangles[i].is_empty(); ++k) {
                int64_t &own = next[static_cast<size_t>(triangles[i].points[k])];
                if (own != unwanted) {
                    visit(static_cast<int32_t>(i), own);
                }
            }
        }
    };
    for_each_corner([](int32_t, int64_t &own) { ++own; });
    int64_t all = 0;
    for (size_t i = 0; i < points; ++i) {
        first_[i] = all;
        if (next[i] != unwanted) {
            all += next[i];
            next[i] = first_[i];
        }
    }
    first_[points] = all;
    triangles_.resize(static_cast<size_t>(all));
    for_each_corner(
        [&](int32_t triangle, int64_t &own) { triangles_[static_cast<size_t>(own++)] = triangle; });
}

} // namespace nrb::mesh
