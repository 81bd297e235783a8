// SPDX-License-Identifier: MIT
#include "mesh/domain/pole_fins.h"

#include "mesh/domain/dropped_triangles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace nrb::mesh {

namespace {

using Piece = BorderStrip::Piece;

// Passes over all fins, since a flip may make another one.
constexpr int most_passes = 8;

// Opens fins by flips.
class FinFlips {
public:
    FinFlips(const Sites &sites, std::vector<Piece> &triangles) : sites_(sites), triangles_(triangles) {
        for (size_t i = 0; i < triangles_.size(); ++i) {
            add_sides(i);
        }
    }

    // Returns whether any fin could be opened.
    bool open(const std::vector<std::array<size_t, 2>> &fins) {
        bool any = false;
        for (const auto &[one, other] : fins) {
            for (size_t k = 0; k < 6; ++k) {
                if (flip_beyond(k < 3 ? one : other, k % 3)) {
                    any = true;
                    break;
                }
            }
        }
        return any;
    }

private:
    // Flips the side opposite a corner, unless the apex of the triangle beyond it is one of the points of the
    // triangle. Returns whether it did.
    bool flip_beyond(size_t triangle, size_t corner);
    void add_sides(size_t i) {
        for (size_t k = 0; k < 3; ++k) {
            opposite_[{triangles_[i].sites[(k + 1) % 3], triangles_[i].sites[(k + 2) % 3]}] = {i, k};
        }
    }
    [[nodiscard]] double area(int32_t a, int32_t b, int32_t c) const noexcept {
        const auto &x = sites_[a].param, &y = sites_[b].param, &z = sites_[c].param;
        return (y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0]);
    }

    const Sites &sites_;
    std::vector<Piece> &triangles_;
    // Of each directed side: its triangle, and the corner opposite it.
    std::map<std::array<int32_t, 2>, std::pair<size_t, size_t>> opposite_;
};

bool FinFlips::flip_beyond(size_t triangle, size_t corner) {
    Piece &one = triangles_[triangle];
    const int32_t x = one.sites[corner], a = one.sites[(corner + 1) % 3], b = one.sites[(corner + 2) % 3];
    const auto found = opposite_.find({b, a});
    if (one.fixed[corner] || one.border[corner] >= 0 || found == opposite_.end()) {
        return false;
    }
    const size_t j = found->second.second;
    Piece &other = triangles_[found->second.first];
    const int32_t z = other.sites[j];
    const auto is_z = [&](int32_t site) { return sites_[site].point == sites_[z].point; };
    if (std::ranges::any_of(one.sites, is_z) || !(area(x, a, z) > 0 && area(x, z, b) > 0)) {
        return false;
    }
    const size_t next = (corner + 1) % 3, previous = (corner + 2) % 3, first = (j + 1) % 3,
                 last = (j + 2) % 3;
    const Piece low{{x, a, z},
                    {other.border[first], -1, one.border[previous]},
                    {other.fixed[first], false, one.fixed[previous]}},
        high{{x, z, b},
             {other.border[last], one.border[next], -1},
             {other.fixed[last], one.fixed[next], false}};
    one = low;
    other = high;
    add_sides(triangle);
    add_sides(found->second.first);
    return true;
}

std::array<int32_t, 3> points_of(const Sites &sites, const Piece &triangle) noexcept {
    return {sites[triangle.sites[0]].point, sites[triangle.sites[1]].point, sites[triangle.sites[2]].point};
}

// Fins: pairs of triangles with the same three points.
std::vector<std::array<size_t, 2>> fins_of(const Sites &sites, const std::vector<Piece> &triangles) {
    std::map<std::array<int32_t, 3>, size_t> known;
    std::vector<std::array<size_t, 2>> fins;
    for (size_t i = 0; i < triangles.size(); ++i) {
        std::array<int32_t, 3> points = points_of(sites, triangles[i]);
        std::ranges::sort(points);
        if (is_dropped(points)) {
            continue;
        }
        if (const auto [at, fresh] = known.try_emplace(points, i); !fresh) {
            fins.push_back({at->second, i});
        }
    }
    return fins;
}

// The segments of the border by the points at their ends, the lower one first.
std::set<std::array<int32_t, 2>> border_sides(const Sites &sites, const std::vector<Piece> &triangles) {
    std::set<std::array<int32_t, 2>> sides;
    for (const Piece &triangle : triangles) {
        const std::array<int32_t, 3> p = points_of(sites, triangle);
        for (size_t k = 0; k < 3; ++k) {
            if (triangle.border[k] >= 0) {
                sides.insert(
                    {std::min(p[(k + 1) % 3], p[(k + 2) % 3]), std::max(p[(k + 1) % 3], p[(k + 2) % 3])});
            }
        }
    }
    return sides;
}

// Divides triangles at doubtful sides, which the mesh of another face may have as well. Both triangles at
// such a side are divided at the same place.
class SideSplits {
public:
    SideSplits(const CellGrid &cells, Sites &sites, std::vector<Piece> &triangles,
               std::vector<std::array<double, 2>> &divided)
        : cells_(cells), sites_(sites), triangles_(triangles), divided_(divided),
          border_(border_sides(sites, triangles)) {
        for (const auto &side : border_) {
            on_border_.insert(side.begin(), side.end());
        }
    }

    void split_all() {
        for (size_t i = 0; i < triangles_.size(); ++i) { // parts are appended
            while (const std::optional<size_t> side = doubtful_side(triangles_[i])) {
                split(i, *side);
            }
        }
    }

private:
    // Whether a side leads from a pole on the border to another vertex of the border, and is none of its
    // segments.
    [[nodiscard]] bool is_doubtful(const Piece &triangle, size_t k) const {
        const int32_t from = triangle.sites[(k + 1) % 3], to = triangle.sites[(k + 2) % 3];
        const int32_t a = sites_[from].point, b = sites_[to].point;
        return a != b && triangle.border[k] < 0 && !triangle.fixed[k] && on_border_.contains(a) &&
               on_border_.contains(b) && is_pole(from) != is_pole(to) &&
               !border_.contains({std::min(a, b), std::max(a, b)});
    }
    [[nodiscard]] std::optional<size_t> doubtful_side(const Piece &triangle) const {
        const std::array<size_t, 3> sides{0, 1, 2};
        const auto *const found =
            std::ranges::find_if(sides, [&](size_t k) { return is_doubtful(triangle, k); });
        return found == sides.end() ? std::nullopt : std::optional(*found);
    }
    [[nodiscard]] bool is_pole(int32_t site) const { return cells_.pole_at(sites_[site].param) >= 0; }
    void split(size_t i, size_t k) {
        const Piece old = triangles_[i];
        const size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const int32_t x = old.sites[k], a = old.sites[next], b = old.sites[last];
        const auto &from = sites_[a].param, &to = sites_[b].param, &third = sites_[x].param;
        const std::array<double, 2> place{from[0] / 2 + to[0] / 2, from[1] / 2 + to[1] / 2};
        const int32_t block =
            cells_.tree().block_at({(from[0] + to[0] + third[0]) / 3, (from[1] + to[1] + third[1]) / 3});
        const int32_t middle = sites_.of_param(place, block, -1);
        divided_.push_back(place);
        triangles_[i] = {{x, a, middle}, {-1, -1, old.border[last]}, {false, false, old.fixed[last]}};
        triangles_.push_back({{x, middle, b}, {-1, old.border[next], -1}, {false, old.fixed[next], false}});
    }

    const CellGrid &cells_;
    Sites &sites_;
    std::vector<Piece> &triangles_;
    std::vector<std::array<double, 2>> &divided_;
    std::set<std::array<int32_t, 2>> border_; // segments, by their points
    std::set<int32_t> on_border_;             // points of these
};

} // namespace

void open_fins(const CellGrid &cells, Sites &sites, std::vector<Piece> &triangles,
               std::vector<std::array<double, 2>> &divided) {
    SideSplits(cells, sites, triangles, divided).split_all();
    FinFlips flips(sites, triangles);
    for (int i = 0; i < most_passes && flips.open(fins_of(sites, triangles)); ++i) {
    }
}

} // namespace nrb::mesh
