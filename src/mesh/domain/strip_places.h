// SPDX-License-Identifier: MIT
// The input for triangulating the strip between the border of a face and the cells inside: places of the
// domain, and walls, the segments between places that have to be sides of triangles.
#pragma once

#include "mesh/border/segment_index.h"
#include "mesh/domain/sites.h"
#include "mesh/strip/strip.h"

#include <map>
#include <set>

namespace nrb::mesh {

// Distance from the border, as a share of the sides of a cell: nearer corners of cells are left out of the
// strip, and cells to which the border comes nearer do not count as inside.
inline constexpr double near_border = 0.2;

class StripPlaces {
public:
    // `extra`: further places for vertices.
    StripPlaces(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                const std::set<std::array<double, 2>> &extra);

    // Places of the border come first, in their order; others are added only where the border has none.
    [[nodiscard]] const std::vector<std::array<double, 2>> &points() const noexcept { return points_; }
    [[nodiscard]] const std::array<double, 2> &point(int32_t i) const noexcept {
        return points_[static_cast<size_t>(i)];
    }
    // The number of a place as a corner of cells; -1: it is one of the border, or an extra one.
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
    using Step = std::array<double, 3>; // an axis across the seam, and an interval along it
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
    std::vector<int32_t> corners_; // of each of these: its number as a corner of cells
    std::map<std::array<double, 2>, int32_t> of_param_;
    std::vector<Wall> walls_;
    // Indexed by places of cells:
    std::vector<bool> needed_;  // whether a cell inside has it
    std::vector<bool> touched_; // whether a cell at the border has it
    std::vector<bool> shared_;  // by the first place of a point: whether any at the point is touched
    std::vector<std::array<double, 2>> sides_; // the shortest sides of cells at the border that have it
};

} // namespace nrb::mesh
