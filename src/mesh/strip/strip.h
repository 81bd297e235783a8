// SPDX-License-Identifier: MIT
// The triangles of the strip, which is what lies between the polygons that bound a face and the cells inside.
#pragma once

#include "mesh/delaunay/triangulation.h"
#include "mesh/proof/triangle_bound.h"

#include <vector>

namespace nrb::mesh {

// A constraint: a segment that has to be a side of triangles, or several.
struct Wall {
    int32_t from, to;       // points
    int32_t border = -1;    // the segment of the border that it is, -1: none
    bool passable = false;  // both sides belong to the same component
    bool divisible = false; // further points may be added on it
};

struct StripTriangle {
    std::array<int32_t, 3> corners; // points, counterclockwise
    std::array<int32_t, 3> border;  // segments of the border on the sides opposite of the corners, -1: none
    std::array<bool, 3> fixed;      // whether these sides are walls that are not divisible
};

// The constrained Delaunay triangulation of points of the domain. They are rounded to a grid of integers on
// which lengths are about as in space; circles are those of a metric in which cells are square. Points that
// fall on one place of the grid are replaced by the first of them.
class Strip {
public:
    // `lengths`: of the sides of the part of the domain, in space. `cells`: how many cells there are along
    // each side; only the ratio counts.
    Strip(const Rectangle &part, const std::array<double, 2> &lengths, const std::array<double, 2> &cells,
          const std::vector<std::array<double, 2>> &points, const std::vector<Wall> &walls);

    // A connected component of triangles, with no wall between them but passable ones. Components next to
    // each other form a group. Across a segment of the border `side` changes its sign, so that within a group
    // it separates inside from outside; which sign means inside is not known here.
    struct Component {
        std::vector<StripTriangle> triangles;
        int32_t group = -1;
        int32_t side = 1; // 1 or -1
    };
    [[nodiscard]] const std::vector<Component> &components() const noexcept { return components_; }
    // The point that replaces a point.
    [[nodiscard]] int32_t first(int32_t point) const noexcept {
        return first_[static_cast<size_t>(triangulation_.vertex_of(static_cast<size_t>(point)))];
    }
    // Pairs of walls that cross: the first one is left out, the second one is there.
    [[nodiscard]] const std::vector<std::array<int32_t, 2>> &crossings() const noexcept { return crossings_; }
    // Walls of the border that pass through points other than their ends, each with the point.
    [[nodiscard]] const std::vector<std::array<int32_t, 2>> &touches() const noexcept { return touches_; }

private:
    void add_walls(const std::vector<Wall> &walls);
    void set_components(const std::vector<Wall> &walls);
    void fill_component(TriangleId start, const std::vector<Wall> &walls);
    void note_touches(TriangleId t, int k, const std::vector<Wall> &walls);
    void set_sides();

    Triangulation triangulation_;
    std::vector<int32_t> first_; // of each vertex, the first point on it
    std::vector<std::array<int32_t, 2>> crossings_, touches_;
    std::vector<Component> components_;
    std::vector<int32_t> component_of_; // of each triangle, -1: none yet
    // A wall between two components.
    struct Passage {
        int32_t from, to;
        bool over_border;
    };
    std::vector<Passage> passages_;
};

} // namespace nrb::mesh
