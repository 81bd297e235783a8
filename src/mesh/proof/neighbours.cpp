// SPDX-License-Identifier: MIT
#include "mesh/proof/neighbours.h"

#include <algorithm>
#include <array>

namespace nrb::mesh {

// Searches the smaller of the fans at the two ends: at a pole a fan may be large.
Neighbour Neighbours::across(size_t triangle, size_t side) const noexcept {
    const int32_t from = triangles_[triangle].points[(side + 1) % 3],
                  to = triangles_[triangle].points[(side + 2) % 3];
    const std::span<const int32_t> a = fans_.of(from), b = fans_.of(to);
    for (const int32_t other : a.size() <= b.size() ? a : b) {
        const auto &p = triangles_[static_cast<size_t>(other)].points;
        for (size_t k = 0; k < 3; ++k) {
            if (p[(k + 1) % 3] == to && p[(k + 2) % 3] == from) {
                return {other, k};
            }
        }
    }
    return {};
}

std::vector<StarTriangle> Neighbours::star(size_t triangle) const {
    constexpr size_t most_around = 32;
    const auto &own = triangles_[triangle].points;
    std::vector<StarTriangle> star;
    for (const int32_t point : own) {
        const std::span<const int32_t> fan = fans_.of(point);
        if (fan.size() > most_around) {
            return {};
        }
        for (const int32_t number : fan) {
            const auto &points = triangles_[static_cast<size_t>(number)].points;
            std::array<bool, 3> common{};
            std::ranges::transform(points, common.begin(),
                                   [&](int32_t x) { return std::ranges::find(own, x) != own.end(); });
            const auto count = std::ranges::count(common, true);
            if (count == 3 && static_cast<size_t>(number) != triangle) {
                return {};
            }
            if (count < 3) {
                const auto corner = std::ranges::find(common, count == 1) - common.begin();
                star.push_back({number, static_cast<size_t>(corner), count == 2});
            }
        }
    }
    return star;
}

} // namespace nrb::mesh
