// SPDX-License-Identifier: MIT
// What is between the border of a face and the cells inside, as triangles.
#pragma once

#include "mesh/border/segment_index.h"
#include "mesh/domain/sites.h"
#include "mesh/strip/strip.h"

#include <map>
#include <set>

namespace nrb::mesh {

// Places nearer to the border than this share of a cell are left out, and cells that it comes nearer to are not inside.
inline constexpr double near_border = 0.2;

class BorderStrip {
public:
    // `extra`: further places of triangles.
    BorderStrip(const MeshDomain &domain, const SegmentIndex &index, const CellGrid &cells,
                const std::vector<std::array<double, 2>> &extra);

    struct Piece {
        std::array<int32_t, 3> sites;
        std::array<int32_t, 3> border;
        std::array<bool, 3> fixed;
    };
    [[nodiscard]] std::vector<Piece> triangles(Sites &sites) const;
    // Segments of the border that cross each other.
    [[nodiscard]] std::vector<int32_t> crossed() const;
    // Segments of the border on which other places are, and where: shares of them.
    [[nodiscard]] std::vector<std::pair<int32_t, double>> touched() const;
    // Points of the border that cannot be told apart in the domain.
    [[nodiscard]] std::vector<std::array<int32_t, 2>> united() const;

private:
    void add_point(const std::array<double, 2> &param, int32_t place);
    void add_border();
    void look_at_cells();
    void add_places();
    [[nodiscard]] bool is_wanted(int32_t place) const;
    void add_walls();
    void add_staircase();
    using Step = std::array<double, 3>; // an axis, and an interval
    [[nodiscard]] std::set<Step> steps_on_seams(size_t first) const;
    void add_line_walls(size_t k, double t, bool passable, const std::set<Step> &steps);
    [[nodiscard]] int32_t point_at(int32_t place) const;
    [[nodiscard]] bool is_shared(int32_t place) const;
    void make_strip();
    // Whether a component is inside; the negative if it is not.
    struct Vote {
        bool in_cell = false;
        double left = 0;   // the length of segments of the border that it is to the left of
        double inside = 0; // the area of the fattest triangle, by its middle
    };
    [[nodiscard]] Vote vote_of(const Strip::Component &component) const;
    [[nodiscard]] double left_of(const StripTriangle &triangle) const noexcept;
    [[nodiscard]] bool on_seam(const BorderSegment &segment) const noexcept;
    // Of components: by groups.
    [[nodiscard]] std::vector<bool> are_inside(const std::vector<Vote> &votes) const;
    // Of a place, -1: it is none of the border.
    [[nodiscard]] int32_t point_of_border(int32_t point) const noexcept;
    [[nodiscard]] int32_t site_of(int32_t point, int32_t block, Sites &sites) const;

    const MeshDomain &domain_;
    const SegmentIndex &index_;
    const CellGrid &cells_;
    std::vector<std::array<double, 2>> points_;
    std::vector<int32_t> places_; // of these, -1: of the border, or an extra one
    std::map<std::array<double, 2>, int32_t> of_param_;
    std::vector<Wall> walls_;
    std::vector<bool> needed_;                 // places that cells inside have
    std::vector<bool> touched_;                // places that cells at the border have
    std::vector<bool> shared_;                 // points in space of these
    std::vector<std::array<double, 2>> sides_; // the least of these cells
    std::unique_ptr<const Strip> strip_;
};

} // namespace nrb::mesh
