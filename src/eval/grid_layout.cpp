// SPDX-License-Identifier: MIT
#include "eval/grid_layout.h"

#include <algorithm>

namespace nrb::eval {

std::vector<int64_t> needed_layers(const GridAxis &table, int degree) {
    std::vector<int64_t> firsts;
    firsts.reserve(table.points.size());
    for (const AxisPoint &point : table.points) {
        if (point.valid()) {
            firsts.push_back(point.first);
        }
    }
    std::sort(firsts.begin(), firsts.end());
    std::vector<int64_t> layers;
    if (!firsts.empty()) {
        const int64_t range = firsts.back() - firsts.front() + degree + 1;
        layers.reserve(static_cast<size_t>(std::min(range, std::ssize(firsts) * (degree + 1))));
    }
    for (const int64_t first : firsts) {
        const int64_t begin = layers.empty() ? first : std::max(first, layers.back() + 1);
        for (int64_t layer = begin; layer <= first + degree; ++layer) {
            layers.push_back(layer);
        }
    }
    return layers;
}

std::vector<GridGroup> group_by_layers(const GridAxis &table) {
    std::vector<int64_t> positions;
    positions.reserve(table.points.size());
    for (int64_t i = 0; i < table.size(); ++i) {
        if (table.points[static_cast<size_t>(i)].valid()) {
            positions.push_back(i);
        }
    }
    const auto first = [&](int64_t position) { return table.points[static_cast<size_t>(position)].first; };
    const auto earlier = [&](int64_t a, int64_t b) {
        return first(a) < first(b) || (first(a) == first(b) && a < b);
    };
    if (!std::is_sorted(positions.begin(), positions.end(), earlier)) {
        std::sort(positions.begin(), positions.end(), earlier);
    }
    int64_t different = 0;
    for (size_t i = 0; i < positions.size(); ++i) {
        different += i == 0 || first(positions[i]) != first(positions[i - 1]) ? 1 : 0;
    }
    std::vector<GridGroup> groups;
    groups.reserve(static_cast<size_t>(different) + positions.size() / grid_group);
    for (const int64_t position : positions) {
        if (groups.empty() || groups.back().first != first(position) || groups.back().count == grid_group) {
            groups.push_back({first(position), 0, true, {position}});
        }
        GridGroup &group = groups.back();
        group.consecutive = group.consecutive && position == group.position[0] + group.count;
        group.position[group.count++] = position;
    }
    return groups;
}

void transpose_values(const GridAxis &table, const AxisSource &source, int order,
                      const std::vector<GridGroup> &groups, double *values) noexcept {
    for (const GridGroup &group : groups) {
        for (int a = 0; a <= order; ++a) {
            for (int j = 0; j <= source.degree; ++j) {
                for (int i = 0; i < grid_group; ++i) {
                    const int64_t position = group.position[std::min(i, group.count - 1)];
                    *values++ = table.values[static_cast<size_t>(position * source.values_size(order) +
                                                                 static_cast<int64_t>(a) * source.lanes + j)];
                }
            }
        }
    }
}

} // namespace nrb::eval
