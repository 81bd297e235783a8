// SPDX-License-Identifier: MIT
// What the triangles between the border of a face and the cells inside are made of: places of the domain, and walls between them.
#pragma once

#include "mesh/border/segment_index.h"
#include "mesh/domain/sites.h"
#include "mesh/strip/strip.h"

#include <map>
#include <set>

namespace nrb::mesh {

// Places nearer to the border than this share of a cell are left out, and cells that it comes nearer to are not inside.
inline constexpr double near_border = 0.2;

class StripPlaces {
public:
    // `extra`: further places of triangles.
    StripPlaces(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                const std::set<std::array<double, 2>> &extra);

    // Those of the border come first, in their order; others only where none of the border is.
    [[nodiscard]] const std::vector<std::array<double, 2>> &points() const noexcept { return points_; }
    [[nodiscard]] const std::array<double, 2> &point(int32_t i) const noexcept {
        return points_[static_cast<size_t>(i)];
    }
    // The corner of cells that one is, -1: of the border, or an extra one.
    [[nodiscard]] int32_t corner(int32_t i) const noexcept { return corners_[static_cast<size_t>(i)]; }
    [[nodiscard]] const std::vector<Wall> &walls() const noexcept { return walls_; }
    [[nodiscard]] const Wall &wall(int32_t i) const noexcept { return walls_[static_cast<size_t>(i)]; }

private:
    void add_point(const std::array<double, 2> &param, int32_t place);
    void add_border();
    void look_at_cells();
    void add_places();
    [[nodiscard]] bool is_wanted(int32_t place) const;
    void add_walls();
    void add_staircase();
    using Step = std::array<double, 3>; // an axis, and an interval
    [[nodiscard]] std::set<Step> steps_on_seams() const;
    [[nodiscard]] bool is_on_seam(size_t k, double t) const noexcept;
    [[nodiscard]] bool touches_seam(const Rectangle &part) const noexcept;
    void add_line_walls(size_t k, double t, bool passable, const std::set<Step> &steps);
    [[nodiscard]] int32_t point_at(int32_t place) const;
    [[nodiscard]] bool is_shared(int32_t place) const;

    const MeshDomain &domain_;
    const SegmentIndex &index_;
    const CellGrid &cells_;
    std::vector<std::array<double, 2>> points_;
    std::vector<int32_t> corners_; // of cells, that these are
    std::map<std::array<double, 2>, int32_t> of_param_;
    std::vector<Wall> walls_;
    std::vector<bool> needed_;                 // corners that cells inside have
    std::vector<bool> touched_;                // corners that cells at the border have
    std::vector<bool> shared_;                 // points in space of these
    std::vector<std::array<double, 2>> sides_; // the least of these cells
};

} // namespace nrb::mesh
