// SPDX-License-Identifier: MIT
// The places of a domain that vertices of a mesh are made for, with the points of space at which they are.
#pragma once

#include "mesh/domain/cell_grid.h"

#include <map>
#include <span>
#include <vector>

namespace nrb::mesh {

// A place as seen from a block.
struct Site {
    std::array<double, 2> param;
    std::array<bool, 2> from_left{};
    int32_t point = -1;
};

// Points are those of the border, by their numbers, and own ones behind them. Sites stay while cells are divided.
class Sites {
public:
    Sites(const MeshDomain &domain, const CellGrid &cells);

    [[nodiscard]] int32_t of_place(int32_t place);
    // Of a place of the domain that is none of the cells, in the block of a number; point: of the border, -1: none.
    [[nodiscard]] int32_t of_param(const std::array<double, 2> &param, int32_t number, int32_t point);
    // Where places have new numbers.
    void renumber(const std::vector<int32_t> &places);
    // Points and normals of those that are new.
    void evaluate();

    [[nodiscard]] const std::vector<Site> &all() const noexcept { return sites_; }
    [[nodiscard]] const Site &operator[](int32_t site) const noexcept {
        return sites_[static_cast<size_t>(site)];
    }
    [[nodiscard]] int32_t point_count() const noexcept { return next_point_; }
    [[nodiscard]] int32_t first_point() const noexcept { return first_point_; }
    [[nodiscard]] const Vector3 &point(int32_t number) const noexcept {
        return number < first_point_ ? (*domain_.points)[static_cast<size_t>(number)]
                                     : position(point_sites_[static_cast<size_t>(number - first_point_)]);
    }
    // Of a site by itself, and its normal.
    [[nodiscard]] const Vector3 &position(int32_t site) const noexcept {
        return positions_[static_cast<size_t>(site)];
    }
    [[nodiscard]] const Vector3 &normal(int32_t site) const noexcept {
        return normals_[static_cast<size_t>(site)];
    }

private:
    void set_border_points();
    void make_room();
    void set_point(int32_t place, int32_t point);
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
    std::map<std::array<double, 2>, int32_t> param_points_; // of places that are none of the border
    std::map<std::array<double, 2>, int32_t> border_points_;
    int32_t first_point_, next_point_;
    std::vector<int32_t> point_sites_; // the first one at each of the own points; -1: none yet
    std::vector<Vector3> positions_, normals_;
};

} // namespace nrb::mesh
