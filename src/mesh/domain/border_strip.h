// SPDX-License-Identifier: MIT
// What is between the border of a face and the cells inside, as triangles.
#pragma once

#include "mesh/domain/strip_places.h"

#include <memory>

namespace nrb::mesh {

class BorderStrip {
public:
    // `extra`: further places of triangles. `density`: how many cells there are on a step along each axis, in proportion.
    BorderStrip(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                const std::set<std::array<double, 2>> &extra, const std::array<double, 2> &density);

    struct Piece {
        std::array<int32_t, 3> sites;
        std::array<int32_t, 3> border;
        std::array<bool, 3> fixed;
    };
    // Appends places that it has besides, which the next strip should have, too.
    [[nodiscard]] std::vector<Piece> triangles(Sites &sites,
                                               std::vector<std::array<double, 2>> &divided) const;
    // Segments of the border that cross each other.
    [[nodiscard]] std::vector<int32_t> crossed() const;
    // Segments of the border on which other places are, and where: shares of them.
    [[nodiscard]] std::vector<std::pair<int32_t, double>> touched() const;
    // Points of the border that cannot be told apart in the domain, or are at one pole.
    [[nodiscard]] std::vector<std::array<int32_t, 2>> united() const;

private:
    void make_strip();
    // Whether a component is inside; the negative if it is not.
    struct Vote {
        bool in_cell = false;
        double left = 0;   // the length of segments of the border that it is to the left of
        double inside = 0; // the area of the fattest triangle, by its middle
    };
    [[nodiscard]] Vote vote_of(const Strip::Component &component) const;
    void unite_at_poles(std::vector<std::array<int32_t, 2>> &united) const;
    [[nodiscard]] double along(const std::array<double, 2> &one,
                               const std::array<double, 2> &other) const noexcept;
    [[nodiscard]] double left_of(const StripTriangle &triangle) const noexcept;
    [[nodiscard]] bool on_seam(const BorderSegment &segment) const noexcept;
    // Of components: by groups.
    [[nodiscard]] std::vector<bool> are_inside(const std::vector<Vote> &votes) const;
    // Of a place, -1: it is none of the border.
    [[nodiscard]] int32_t point_of_border(int32_t point) const noexcept;
    [[nodiscard]] Piece piece_of(const StripTriangle &triangle, Sites &sites) const;
    [[nodiscard]] int32_t site_of(int32_t point, int32_t block, Sites &sites) const;

    const MeshDomain &domain_;
    const CellGrid &cells_;
    std::array<double, 2> density_;
    StripPlaces places_;
    std::unique_ptr<const Strip> strip_;
};

} // namespace nrb::mesh
