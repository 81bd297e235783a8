// SPDX-License-Identifier: MIT
#include "mesh/domain/pole_fins.h"

#include <algorithm>
#include <map>

namespace nrb::mesh {

namespace {

using Piece = BorderStrip::Piece;

class FinFlips {
public:
    FinFlips(const Sites &sites, std::vector<Piece> &triangles) : sites_(sites), triangles_(triangles) {
        for (size_t i = 0; i < triangles_.size(); ++i) {
            add_sides(i);
        }
    }

    // The side opposite of a corner, if what is beyond it is none of the points of the triangle.
    bool flip_beyond(size_t triangle, size_t corner);

private:
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
    std::map<std::array<int32_t, 2>, std::pair<size_t, size_t>> opposite_; // triangle and corner
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

// Pairs of triangles of the same three points.
std::vector<std::array<size_t, 2>> fins_of(const Sites &sites, const std::vector<Piece> &triangles) {
    std::map<std::array<int32_t, 3>, size_t> known;
    std::vector<std::array<size_t, 2>> fins;
    for (size_t i = 0; i < triangles.size(); ++i) {
        std::array<int32_t, 3> points{};
        for (size_t k = 0; k < 3; ++k) {
            points[k] = sites[triangles[i].sites[k]].point;
        }
        std::ranges::sort(points);
        if (points[0] == points[1] || points[1] == points[2]) {
            continue;
        }
        if (const auto [at, fresh] = known.try_emplace(points, i); !fresh) {
            fins.push_back({at->second, i});
        }
    }
    return fins;
}

} // namespace

void open_fins(const Sites &sites, std::vector<Piece> &triangles) {
    const auto fins = fins_of(sites, triangles);
    if (fins.empty()) {
        return;
    }
    FinFlips flips(sites, triangles);
    for (const auto &[one, other] : fins) {
        bool done = false;
        for (size_t k = 0; k < 6 && !done; ++k) {
            done = flips.flip_beyond(k < 3 ? one : other, k % 3);
        }
    }
}

} // namespace nrb::mesh
