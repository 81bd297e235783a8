// SPDX-License-Identifier: MIT
#include "mesh/domain/dropped_triangles.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

using Corners = std::array<int32_t, 3>;

// The segment that a degenerate triangle is: its least and its greatest point.
std::array<int32_t, 2> segment_of(const Corners &p) noexcept {
    const auto [least, greatest] = std::ranges::minmax(p);
    return {least, greatest};
}

// Marks the segments and points that are sides and corners of a triangle as found.
void strike(const Corners &p, std::vector<std::array<int32_t, 2>> &sought, std::vector<bool> &found) {
    const auto strike_one = [&](int32_t a, int32_t b) {
        const std::array<int32_t, 2> side{std::min(a, b), std::max(a, b)};
        const auto at = std::ranges::lower_bound(sought, side);
        if (at != sought.end() && *at == side) {
            found[static_cast<size_t>(at - sought.begin())] = true;
        }
    };
    for (size_t k = 0; k < 3; ++k) {
        strike_one(p[k], p[(k + 1) % 3]);
        strike_one(p[k], p[k]);
    }
}

} // namespace

bool have_all_dropped(const std::vector<Corners> &triangles) {
    std::vector<std::array<int32_t, 2>> sought;
    for (const Corners &p : triangles) {
        if (is_dropped(p)) {
            sought.push_back(segment_of(p));
        }
    }
    if (sought.empty()) {
        return true;
    }
    std::ranges::sort(sought);
    sought.erase(std::unique(sought.begin(), sought.end()), sought.end());
    std::vector<bool> found(sought.size(), false);
    for (const Corners &p : triangles) {
        if (!is_dropped(p)) {
            strike(p, sought, found);
        }
    }
    return std::ranges::find(found, false) == found.end();
}

} // namespace nrb::mesh
