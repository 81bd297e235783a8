// SPDX-License-Identifier: MIT
// Triangles between the polygons that bound a face and the cells inside.
#pragma once

#include "mesh/delaunay/triangulation.h"
#include "mesh/proof/triangle_bound.h"

#include <vector>

namespace nrb::mesh {

// A segment that is to be a side of triangles.
struct Wall {
    int32_t from, to;       // points
    int32_t border = -1;    // segment of a border that it is
    bool passable = false;  // what is on both sides belongs together
    bool divisible = false; // further points may come on it
};

struct StripTriangle {
    std::array<int32_t, 3> corners; // points, counterclockwise
    std::array<int32_t, 3> border;  // on the sides opposite of these, -1: none
    std::array<bool, 3> fixed;      // sides that are walls, and not divisible
};

// The constrained Delaunay triangulation of places of the domain, on a grid of integers in which lengths are about as in space, in a metric in
// which cells are square. Points that fall on one place of the grid are one, the first of them.
class Strip {
public:
    // `lengths`: of the sides of the part of the domain, in space. `cells`: how many cells there are along each of them, in proportion.
    Strip(const Rectangle &part, const std::array<double, 2> &lengths, const std::array<double, 2> &cells,
          const std::vector<std::array<double, 2>> &points, const std::vector<Wall> &walls);

    // Triangles that hang together without a wall between them. Of a group the sides are known but for which is which: on the way from one
    // component to another each segment of a border leads to the other side.
    struct Component {
        std::vector<StripTriangle> triangles;
        int32_t group = -1;
        int32_t side = 1; // 1 or -1
    };
    [[nodiscard]] const std::vector<Component> &components() const noexcept { return components_; }
    // The one that stands for a point.
    [[nodiscard]] int32_t first(int32_t point) const noexcept {
        return first_[static_cast<size_t>(triangulation_.vertex_of(static_cast<size_t>(point)))];
    }
    // Walls that cross others, and are missing, with those.
    [[nodiscard]] const std::vector<std::array<int32_t, 2>> &crossings() const noexcept { return crossings_; }
    // Walls of a border that go through other points, with those.
    [[nodiscard]] const std::vector<std::array<int32_t, 2>> &touches() const noexcept { return touches_; }

private:
    void add_walls(const std::vector<Wall> &walls);
    void set_components(const std::vector<Wall> &walls);
    void fill_component(TriangleId start, const std::vector<Wall> &walls);
    void note_touches(TriangleId t, int k, const std::vector<Wall> &walls);
    void set_sides();

    Triangulation triangulation_;
    std::vector<int32_t> first_; // points of the vertices
    std::vector<std::array<int32_t, 2>> crossings_, touches_;
    std::vector<Component> components_;
    std::vector<int32_t> component_of_; // triangles, -1: none yet
    struct Passage {
        int32_t from, to;
        bool over_border;
    };
    std::vector<Passage> passages_;
};

} // namespace nrb::mesh
