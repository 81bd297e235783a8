// SPDX-License-Identifier: MIT
// Sites: the places of a domain that vertices of a mesh are made for, with the points in space at which they
// are.
#pragma once

#include "mesh/domain/cell_grid.h"

#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace nrb::mesh {

// A place as seen from a block, the part of the domain between lines at which the surface may have kinks:
// beside such a line one place has a site for each block, with limits and normals of its own.
struct Site {
    std::array<double, 2> param;
    std::array<bool, 2> from_left{}; // along each axis: evaluated as a limit from below
    int32_t point = -1;
};

// Points are points of the border, or own points, which are made here; they are numbered in the order in
// which they are needed. Sites keep their numbers while cells and the border are divided.
class Sites {
public:
    Sites(const MeshDomain &domain, const CellGrid &cells);

    [[nodiscard]] int32_t of_place(int32_t place);
    // The site of a place that is not a corner of cells, as seen from the block of this number. border: its
    // point among those of the domain; -1: none.
    [[nodiscard]] int32_t of_param(const std::array<double, 2> &param, int32_t number, int32_t border);
    // Takes over new numbers of the places of cells.
    void renumber(const std::vector<int32_t> &places);
    // Takes over further points of the border. Returns false if one of them lies where there is an own point
    // already.
    [[nodiscard]] bool take_border();
    // Computes the positions and normals of new sites.
    void evaluate();

    [[nodiscard]] const std::vector<Site> &all() const noexcept { return sites_; }
    [[nodiscard]] const Site &operator[](int32_t site) const noexcept {
        return sites_[static_cast<size_t>(site)];
    }
    [[nodiscard]] int32_t point_count() const noexcept { return static_cast<int32_t>(points_.size()); }
    // The number that a point has among those of the domain; -1: it is an own point.
    [[nodiscard]] int32_t border_of(int32_t number) const noexcept {
        return points_[static_cast<size_t>(number)].border;
    }
    [[nodiscard]] const Vector3 &point(int32_t number) const noexcept {
        const Point &own = points_[static_cast<size_t>(number)];
        return own.border < 0 ? position(own.site) : (*domain_.points)[static_cast<size_t>(own.border)];
    }
    // A lower bound of the length of the surface over the segment between two sites of a block: that of the
    // way through the point at its midpoint.
    [[nodiscard]] double way(int32_t from, int32_t to) const;
    // The position of a site on the surface, from which a point of the border may differ, and its normal.
    [[nodiscard]] const Vector3 &position(int32_t site) const noexcept {
        return positions_[static_cast<size_t>(site)];
    }
    [[nodiscard]] const Vector3 &normal(int32_t site) const noexcept {
        return normals_[static_cast<size_t>(site)];
    }

private:
    struct Point {
        int32_t border = -1; // its number among the points of the domain; -1: an own point
        int32_t site = -1;   // the first one at it
    };
    int32_t add_point(int32_t border);
    [[nodiscard]] int32_t point_of_border(int32_t border);
    bool set_border_points();
    void make_room();
    bool set_point(int32_t place, int32_t border);
    [[nodiscard]] std::array<double, 2> before_seams(std::array<double, 2> param) const noexcept;
    void evaluate(size_t first, size_t last);
    void evaluate_group(const std::array<bool, 2> &from_left, const std::vector<size_t> &members);

    const MeshDomain &domain_;
    const CellGrid &cells_;
    std::vector<Site> sites_;
    std::vector<int32_t> place_sites_;  // -1: none yet
    std::vector<int32_t> place_points_; // by the first of the places that are one in space; -1: none yet
    using Key = std::array<double, 3>;  // parameters and block
    std::map<Key, int32_t> param_sites_;
    std::map<std::array<double, 2>, int32_t> param_points_;  // of other places than those of the border
    std::map<std::array<double, 2>, int32_t> border_points_; // numbers among the points of the domain
    std::unordered_map<int32_t, int32_t> of_border_;         // from these to the numbers here
    std::vector<Point> points_;
    std::vector<Vector3> positions_, normals_;
};

} // namespace nrb::mesh
