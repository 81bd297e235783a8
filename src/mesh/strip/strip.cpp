// SPDX-License-Identifier: MIT
#include "mesh/strip/strip.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// The least ratio of the sides of the grid, so that enough of its places remain across a long and narrow
// face.
constexpr double narrowest = 0x1p-10;
// Cells that are wider than this share of their length are taken as squares: where the surface bends along
// both axes, triangles are best fat in space.
constexpr double nearly_round = 0.125;

// The lengths of the sides on the grid.
std::array<double, 2> grid_lengths(const std::array<double, 2> &lengths) noexcept {
    const double longest = std::max(lengths[0], lengths[1]);
    std::array<double, 2> result{};
    for (size_t k = 0; k < 2; ++k) {
        const double share = longest > 0 ? lengths[k] / longest : 1;
        result[k] = grid_end * std::clamp(share, narrowest, 1.0);
    }
    return result;
}

GridMetric grid_metric(const std::array<double, 2> &lengths, const std::array<double, 2> &cells) noexcept {
    const std::array<double, 2> on_grid = grid_lengths(lengths);
    const double u = cells[0] / on_grid[0], v = cells[1] / on_grid[1], most = std::max(u, v);
    if (!(most > 0) || !(most < infinity) || std::min(u, v) > most * nearly_round) {
        return {};
    }
    const auto square = [&](double x) {
        return static_cast<int32_t>(std::max(1.0, std::round(x / most * (x / most) * GridMetric::most)));
    };
    return {square(u), square(v)};
}

std::vector<GridPoint> on_grid(const Rectangle &part, const std::array<double, 2> &lengths,
                               const std::vector<std::array<double, 2>> &points) {
    const std::array<double, 2> sides = grid_lengths(lengths);
    const std::array<double, 2> steps{sides[0] / part.side(0), sides[1] / part.side(1)};
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

// The walls along one of the axes of the grid that are fixed: no further point may come on them.
class FixedWalls {
public:
    FixedWalls(const std::vector<GridPoint> &points, const std::vector<Wall> &walls) {
        for (const Wall &wall : walls) {
            const GridPoint &a = points[static_cast<size_t>(wall.from)],
                            &b = points[static_cast<size_t>(wall.to)];
            if (wall.border >= 0 || wall.divisible || a == b) {
                continue;
            }
            if (a.u == b.u) {
                walls_[0].push_back({a.u, std::min(a.v, b.v), std::max(a.v, b.v), wall.from});
            } else if (a.v == b.v) {
                walls_[1].push_back({a.v, std::min(a.u, b.u), std::max(a.u, b.u), wall.from});
            }
        }
        std::ranges::sort(walls_[0]);
        std::ranges::sort(walls_[1]);
    }

    // An end of a wall that has a place strictly between its ends; -1: there is no such wall.
    [[nodiscard]] int32_t end_at(const GridPoint &place) const {
        const int32_t end = end_among(walls_[0], place.u, place.v);
        return end >= 0 ? end : end_among(walls_[1], place.v, place.u);
    }

private:
    using Along = std::array<int32_t, 4>; // the line, the interval of the wall on it, and a point at an end
    static int32_t end_among(const std::vector<Along> &walls, int32_t line, int32_t at) {
        const auto next = std::ranges::lower_bound(walls, Along{line, at, 0, 0});
        if (next == walls.begin()) {
            return -1;
        }
        const auto &[own, lower, upper, end] = *std::prev(next);
        return own == line && lower < at && at < upper ? end : -1;
    }

    std::array<std::vector<Along>, 2> walls_;
};

// What lies beyond a fixed wall is not divided, so that no point may be on it. A point that rounding to the
// grid puts there is moved to an end of the wall, unless it is an end of a wall itself.
std::vector<GridPoint> beside_walls(std::vector<GridPoint> points, const std::vector<Wall> &walls) {
    std::vector<bool> free(points.size(), true);
    for (const Wall &wall : walls) {
        free[static_cast<size_t>(wall.from)] = free[static_cast<size_t>(wall.to)] = false;
    }
    const FixedWalls fixed(points, walls);
    for (size_t i = 0; i < points.size(); ++i) {
        if (const int32_t end = free[i] ? fixed.end_at(points[i]) : -1; end >= 0) {
            points[i] = points[static_cast<size_t>(end)];
        }
    }
    return points;
}

} // namespace

Strip::Strip(const Rectangle &part, const std::array<double, 2> &lengths, const std::array<double, 2> &cells,
             const std::vector<std::array<double, 2>> &points, const std::vector<Wall> &walls)
    : triangulation_(beside_walls(on_grid(part, lengths, points), walls), grid_metric(lengths, cells)),
      first_(triangulation_.vertices().size(), -1) {
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
            segments.push_back({from, to, static_cast<int32_t>(i), walls[i].border >= 0});
            numbers.push_back(static_cast<int32_t>(i));
        }
    }
    for (const Triangulation::Crossing &crossing : triangulation_.constrain(segments)) {
        crossings_.push_back({numbers[crossing.segment], crossing.label});
    }
}

void Strip::set_components(const std::vector<Wall> &walls) {
    component_of_.assign(static_cast<size_t>(triangulation_.size()), -1);
    for (TriangleId start = 0; start < triangulation_.size(); ++start) {
        if (component_of_[static_cast<size_t>(start)] < 0 && !triangulation_.ghost(start)) {
            fill_component(start, walls);
        }
    }
    set_sides();
}

void Strip::fill_component(TriangleId start, const std::vector<Wall> &walls) {
    const auto number = static_cast<int32_t>(components_.size());
    components_.emplace_back();
    std::vector<TriangleId> waiting;
    const auto visit = [&](TriangleId t) {
        int32_t &own = component_of_[static_cast<size_t>(t)];
        if (own < 0 && !triangulation_.ghost(t)) {
            own = number;
            waiting.push_back(t);
        }
    };
    visit(start);
    while (!waiting.empty()) {
        const TriangleId t = waiting.back();
        waiting.pop_back();
        const auto corners = triangulation_.corners(t);
        StripTriangle triangle{};
        for (int k = 0; k < 3; ++k) {
            const auto at = static_cast<size_t>(k);
            const TriangleId next = triangulation_.neighbour(t, k);
            triangle.corners[at] = first_[static_cast<size_t>(corners[at])];
            triangle.fixed[at] = triangulation_.constrained(t, k);
            triangle.border[at] = -1;
            if (!triangle.fixed[at]) {
                visit(next);
                continue;
            }
            const Wall &wall = walls[static_cast<size_t>(triangulation_.label(t, k))];
            triangle.border[at] = wall.border;
            triangle.fixed[at] = !wall.divisible;
            if (wall.border >= 0) {
                note_touches(t, k, walls);
            }
            if (wall.passable) {
                visit(next);
            } else if (const int32_t other = component_of_[static_cast<size_t>(next)];
                       other >= 0 && other != number) {
                passages_.push_back({number, other, triangulation_.border(t, k)});
            }
        }
        components_.back().triangles.push_back(triangle);
    }
}

// Notes the ends of an edge that are not ends of its wall.
void Strip::note_touches(TriangleId t, int k, const std::vector<Wall> &walls) {
    const int32_t label = triangulation_.label(t, k);
    const Wall &wall = walls[static_cast<size_t>(label)];
    for (const int next : {1, 2}) {
        const VertexId v = triangulation_.corners(t)[static_cast<size_t>((k + next) % 3)];
        if (v != triangulation_.vertex_of(static_cast<size_t>(wall.from)) &&
            v != triangulation_.vertex_of(static_cast<size_t>(wall.to))) {
            touches_.push_back({label, first_[static_cast<size_t>(v)]});
        }
    }
}

// Sets groups and sides of the components, by a search over passages. These were noted from the later
// component to the earlier one only.
void Strip::set_sides() {
    std::vector<std::vector<std::pair<int32_t, bool>>> beside(components_.size());
    for (const Passage &passage : passages_) {
        beside[static_cast<size_t>(passage.from)].emplace_back(passage.to, passage.over_border);
        beside[static_cast<size_t>(passage.to)].emplace_back(passage.from, passage.over_border);
    }
    std::vector<int32_t> waiting;
    for (int32_t start = 0; start < static_cast<int32_t>(components_.size()); ++start) {
        if (components_[static_cast<size_t>(start)].group >= 0) {
            continue;
        }
        components_[static_cast<size_t>(start)].group = start;
        waiting.push_back(start);
        while (!waiting.empty()) {
            const int32_t from = waiting.back();
            waiting.pop_back();
            for (const auto &[to, over_border] : beside[static_cast<size_t>(from)]) {
                Component &next = components_[static_cast<size_t>(to)];
                if (next.group < 0) {
                    next.group = start;
                    next.side = over_border ? -components_[static_cast<size_t>(from)].side
                                            : components_[static_cast<size_t>(from)].side;
                    waiting.push_back(to);
                }
            }
        }
    }
}

} // namespace nrb::mesh
