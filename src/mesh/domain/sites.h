// SPDX-License-Identifier: MIT
// The places of a domain that vertices of a mesh are made for, with the points of space at which they are.
#pragma once

#include "mesh/domain/cell_grid.h"

#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace nrb::mesh {

// A place as seen from a block.
struct Site {
    std::array<double, 2> param;
    std::array<bool, 2> from_left{};
    int32_t point = -1;
};

// Points are those of the border and own ones, numbered as they come. Sites stay while cells and the border are divided.
class Sites {
public:
    Sites(const MeshDomain &domain, const CellGrid &cells);

    [[nodiscard]] int32_t of_place(int32_t place);
    // Of a place of the domain that is none of the cells, in the block of a number; border: its point of the domain, -1: none.
    [[nodiscard]] int32_t of_param(const std::array<double, 2> &param, int32_t number, int32_t border);
    // Where places have new numbers.
    void renumber(const std::vector<int32_t> &places);
    // Where the border has more points than before. Returns whether they are apart from all sites.
    [[nodiscard]] bool take_border();
    // Points and normals of those that are new.
    void evaluate();

    [[nodiscard]] const std::vector<Site> &all() const noexcept { return sites_; }
    [[nodiscard]] const Site &operator[](int32_t site) const noexcept {
        return sites_[static_cast<size_t>(site)];
    }
    [[nodiscard]] int32_t point_count() const noexcept { return static_cast<int32_t>(points_.size()); }
    // That of the domain which a point is, -1: an own one.
    [[nodiscard]] int32_t border_of(int32_t number) const noexcept {
        return points_[static_cast<size_t>(number)].border;
    }
    [[nodiscard]] const Vector3 &point(int32_t number) const noexcept {
        const Point &own = points_[static_cast<size_t>(number)];
        return own.border < 0 ? position(own.site) : (*domain_.points)[static_cast<size_t>(own.border)];
    }
    // How long the surface is from one site to another of a block, at least: by way of the place in the middle.
    [[nodiscard]] double way(int32_t from, int32_t to) const;
    // Of a site by itself, and its normal.
    [[nodiscard]] const Vector3 &position(int32_t site) const noexcept {
        return positions_[static_cast<size_t>(site)];
    }
    [[nodiscard]] const Vector3 &normal(int32_t site) const noexcept {
        return normals_[static_cast<size_t>(site)];
    }

private:
    struct Point {
        int32_t border = -1; // of the domain
        int32_t site = -1;   // the first one there
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
    std::vector<int32_t> place_points_; // of the first of those that are one in space; -1: none yet
    using Key = std::array<double, 3>;  // parameters and block
    std::map<Key, int32_t> param_sites_;
    std::map<std::array<double, 2>, int32_t> param_points_;  // of places that are none of the border
    std::map<std::array<double, 2>, int32_t> border_points_; // of the domain
    std::unordered_map<int32_t, int32_t> of_border_;         // their numbers here
    std::vector<Point> points_;
    std::vector<Vector3> positions_, normals_;
};

} // namespace nrb::mesh
