// SPDX-License-Identifier: MIT
#include "mesh/strip/strip.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// However long and narrow a face is, so many places across remain.
constexpr double narrowest = 0x1p-10;

std::vector<GridPoint> on_grid(const Rectangle &part, const std::array<double, 2> &lengths,
                               const std::vector<std::array<double, 2>> &points) {
    const double longest = std::max(lengths[0], lengths[1]);
    std::array<double, 2> steps{};
    for (size_t k = 0; k < 2; ++k) {
        const double share = longest > 0 ? lengths[k] / longest : 1;
        steps[k] = grid_end * std::clamp(share, narrowest, 1.0) / part.side(k);
    }
    std::vector<GridPoint> result;
    for (const auto &point : points) {
        std::array<int32_t, 2> place{};
        for (size_t k = 0; k < 2; ++k) {
            place[k] = static_cast<int32_t>(
                std::clamp(std::round((point[k] - part.lower[k]) * steps[k]), 0.0, double{grid_end}));
        }
        result.push_back({place[0], place[1]});
    }
    return result;
}

} // namespace

Strip::Strip(const Rectangle &part, const std::array<double, 2> &lengths,
             const std::vector<std::array<double, 2>> &points, const std::vector<Wall> &walls)
    : triangulation_(on_grid(part, lengths, points)), first_(triangulation_.vertices().size(), -1) {
    for (size_t i = points.size(); i-- > 0;) {
        first_[static_cast<size_t>(triangulation_.vertex_of(i))] = static_cast<int32_t>(i);
    }
    add_walls(walls);
    set_components(walls);
}

void Strip::add_walls(const std::vector<Wall> &walls) {
    std::vector<Triangulation::Segment> segments;
    std::vector<int32_t> numbers;
    for (size_t i = 0; i < walls.size(); ++i) {
        const VertexId from = triangulation_.vertex_of(static_cast<size_t>(walls[i].from)),
                       to = triangulation_.vertex_of(static_cast<size_t>(walls[i].to));
        if (from != to) {
            segments.push_back({from, to, static_cast<int32_t>(i), false});
            numbers.push_back(static_cast<int32_t>(i));
        }
    }
    for (const Triangulation::Crossing &crossing : triangulation_.constrain(segments)) {
        crossings_.push_back({numbers[crossing.segment], crossing.label});
    }
}

void Strip::set_components(const std::vector<Wall> &walls) {
    std::vector<bool> seen(static_cast<size_t>(triangulation_.size()), false);
    std::vector<TriangleId> waiting;
    const auto visit = [&](TriangleId t) {
        if (!seen[static_cast<size_t>(t)] && !triangulation_.ghost(t)) {
            seen[static_cast<size_t>(t)] = true;
            waiting.push_back(t);
        }
    };
    for (TriangleId start = 0; start < triangulation_.size(); ++start) {
        visit(start);
        if (waiting.empty()) {
            continue;
        }
        components_.emplace_back();
        while (!waiting.empty()) {
            const TriangleId t = waiting.back();
            waiting.pop_back();
            const auto corners = triangulation_.corners(t);
            StripTriangle triangle{};
            for (int k = 0; k < 3; ++k) {
                const auto at = static_cast<size_t>(k);
                triangle.corners[at] = first_[static_cast<size_t>(corners[at])];
                triangle.fixed[at] = triangulation_.constrained(t, k);
                triangle.border[at] = -1;
                if (!triangle.fixed[at]) {
                    visit(triangulation_.neighbour(t, k));
                    continue;
                }
                const Wall &wall = walls[static_cast<size_t>(triangulation_.label(t, k))];
                triangle.border[at] = wall.border;
                if (wall.passable) {
                    visit(triangulation_.neighbour(t, k));
                }
            }
            components_.back().push_back(triangle);
        }
    }
}

} // namespace nrb::mesh
