// SPDX-License-Identifier: MIT
// The strip: the triangulated region between the border of a face and the cells inside.
#pragma once

#include "mesh/domain/strip_places.h"

#include <memory>

namespace nrb::mesh {

class BorderStrip {
public:
    // `extra`: further places for vertices. `density`: how many cells there are on a unit step along each
    // axis, in proportion.
    BorderStrip(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                const std::set<std::array<double, 2>> &extra, const std::array<double, 2> &density);

    // A triangle, like StripTriangle, but of sites.
    struct Piece {
        std::array<int32_t, 3> sites;
        std::array<int32_t, 3> border; // segments on the sides opposite the sites, -1: none
        std::array<bool, 3> fixed;     // sides that may not be divided
    };
    // Appends to `divided` the places that it adds by itself, which the next strip should have as well.
    [[nodiscard]] std::vector<Piece> triangles(Sites &sites,
                                               std::vector<std::array<double, 2>> &divided) const;
    // Segments of the border that cross each other.
    [[nodiscard]] std::vector<int32_t> crossed() const;
    // Segments of the border that pass through other places, and where: as shares of their lengths.
    [[nodiscard]] std::vector<std::pair<int32_t, double>> touched() const;
    // Pairs of points of the border that cannot be told apart in the domain, or are at one pole.
    [[nodiscard]] std::vector<std::array<int32_t, 2>> united() const;

private:
    void make_strip();
    // The evidence for a component being inside the face; negative numbers are evidence against it. The
    // middle of its largest triangle is tested in place of the component.
    struct Vote {
        bool in_cell = false; // a cell inside covers it, so that it is not part of the strip
        // The lengths of segments of the border that have it to their left, less those of others.
        double left = 0;
        // Twice the area of the largest triangle, negative if the middle of that is outside.
        double inside = 0;
    };
    [[nodiscard]] Vote vote_of(const Strip::Component &component) const;
    void unite_at_poles(std::vector<std::array<int32_t, 2>> &united) const;
    [[nodiscard]] double along(const std::array<double, 2> &one,
                               const std::array<double, 2> &other) const noexcept;
    [[nodiscard]] double left_of(const StripTriangle &triangle) const noexcept;
    [[nodiscard]] bool on_seam(const BorderSegment &segment) const noexcept;
    // Whether each component is inside: decided for groups of them.
    [[nodiscard]] std::vector<bool> are_inside(const std::vector<Vote> &votes) const;
    // The point of the border that a place is; -1: none.
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
