// SPDX-License-Identifier: MIT
// A triangulation of sites, in which each triangle knows its neighbour across each side, and the local
// operations that change it: flips, splits, and the removal of fins.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::mesh {

// A side of a triangle. Across a side that stays there is no triangle, or one with other sites of the same
// two points: at a seam, or at a line at which the surface may have a kink.
struct NetSide {
    int32_t next = -1;    // the triangle across; -1: none
    int32_t back = 0;     // which side of that triangle this is
    int32_t border = -1;  // segment of the border
    bool stays = true;    // is not flipped
    bool divides = false; // may have a new site inside
    int8_t halvings = 0;  // for the caller: halves have one more than the whole side
};

struct NetTriangle {
    std::array<int32_t, 3> sites;
    std::array<NetSide, 3> sides{}; // opposite the sites
    int32_t source = -1;            // by which the caller knows it; -1: it is new
};

class SiteNet {
public:
    // Takes the sites and the source of a triangle, and the segments of the border of its sides.
    int32_t add(const NetTriangle &triangle);
    // Makes triangles neighbours across sides with the same two sites, and then across sides with the same
    // two points, which stay. points: of each site.
    void join(const std::vector<int32_t> &points);

    [[nodiscard]] int32_t size() const noexcept { return static_cast<int32_t>(triangles_.size()); }
    [[nodiscard]] const NetTriangle &operator[](int32_t t) const noexcept {
        return triangles_[static_cast<size_t>(t)];
    }
    [[nodiscard]] NetSide &side(int32_t t, size_t k) noexcept {
        return triangles_[static_cast<size_t>(t)].sides[k];
    }
    void set_source(int32_t t, int32_t source) noexcept {
        triangles_[static_cast<size_t>(t)].source = source;
    }
    // Sources of triangles that are gone.
    [[nodiscard]] const std::vector<int32_t> &dropped() const noexcept { return dropped_; }
    void clear_dropped() noexcept { dropped_.clear(); }

    // The apex of the triangle across a side.
    [[nodiscard]] int32_t beyond(int32_t t, size_t k) const noexcept {
        const NetSide &side = (*this)[t].sides[k];
        return (*this)[side.next].sites[static_cast<size_t>(side.back)];
    }
    // Whether side k can be flipped or split: not where a triangle is its own neighbour, or the two at the
    // side have another side in common.
    [[nodiscard]] bool can_change(int32_t t, size_t k) const noexcept;
    // Replaces side k by the other diagonal: t, (p, a, b), and its neighbour, (q, b, a), become (p, a, q) and
    // (p, q, b), where p is opposite side k.
    void flip(int32_t t, size_t k);
    // Replaces t by three triangles at v: t and the last two.
    void split_triangle(int32_t t, int32_t v);
    // Replaces t by two triangles at v, and its neighbour across side k, if it has one, by two at w: the two
    // keep their numbers, the other halves are the last triangles. v and w are sites of one point; they
    // differ only if the side stays, and then its halves stay, too.
    void split_side(int32_t t, size_t k, int32_t v, int32_t w);

    // A fin: two triangles with the same three corners, back to back. Removes t and its neighbour across side
    // k if they are one, and joins what is beyond their other sides; the last triangles take their numbers.
    // Returns whether it did.
    bool remove_fin(int32_t t, size_t k);

private:
    void erase(int32_t t);
    int32_t replace(int32_t t, const std::array<int32_t, 3> &sites);
    void set_side(int32_t t, size_t k, const NetSide &own) noexcept;
    void link(int32_t t, size_t k, int32_t u, size_t j, const NetSide &like) noexcept;

    std::vector<NetTriangle> triangles_;
    std::vector<int32_t> dropped_;
};

} // namespace nrb::mesh
