// SPDX-License-Identifier: MIT
// Triangles of sites with what is across their sides, and the steps that change them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nrb::mesh {

// Across a side that stays nothing is known, or the triangle of another copy of its points: at a seam, or a line at which the surface may
// have a kink.
struct NetSide {
    int32_t next = -1;    // the triangle across; -1: none
    int32_t back = 0;     // which side of that one
    int32_t border = -1;  // segment of the border
    bool stays = true;    // not flipped
    bool divides = false; // may have a new site inside
    int8_t halvings = 0;  // what the caller counts: halves have one more than the whole
};

struct NetTriangle {
    std::array<int32_t, 3> sites;
    std::array<NetSide, 3> sides{}; // opposite of these
    int32_t source = -1;            // what the caller knows it by; -1: it is new
};

class SiteNet {
public:
    // Triangles with their sources; sides with segments of the border.
    int32_t add(const NetTriangle &triangle);
    // Across sides of two equal sites, and then of two equal points. points: of each site.
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
    // Sources of triangles that are no more.
    [[nodiscard]] const std::vector<int32_t> &dropped() const noexcept { return dropped_; }
    void clear_dropped() noexcept { dropped_.clear(); }

    // The corner of the triangle across a side.
    [[nodiscard]] int32_t beyond(int32_t t, size_t k) const noexcept {
        const NetSide &side = (*this)[t].sides[k];
        return (*this)[side.next].sites[static_cast<size_t>(side.back)];
    }
    // Whether the steps below can be taken: not where a triangle is beside itself.
    [[nodiscard]] bool can_change(int32_t t, size_t k) const noexcept;
    // The other diagonal: (p, a, q) and (p, q, b) in place of (p, a, b) and (q, b, a), with p in front of side k.
    void flip(int32_t t, size_t k);
    // Three triangles at v; they are t and the last two.
    void split_triangle(int32_t t, int32_t v);
    // Two triangles at v in place of t, and two at w in place of what is across, if there is anything; they are these and the last
    // ones. Sites of one point; where they differ the halves stay as the side did.
    void split_side(int32_t t, size_t k, int32_t v, int32_t w);

    // Two triangles of the same three corners, which have this side in common, go, and what is beyond their other sides comes together.
    // The last triangles take their numbers. Returns whether these are such two.
    bool remove_fin(int32_t t, size_t k);

private:
    void erase(int32_t t);
    int32_t replace(int32_t t, const std::array<int32_t, 3> &sites);
    void set_side(int32_t t, size_t k, const NetSide &side) noexcept;
    void link(int32_t t, size_t k, int32_t u, size_t j, const NetSide &like) noexcept;

    std::vector<NetTriangle> triangles_;
    std::vector<int32_t> dropped_;
};

} // namespace nrb::mesh
