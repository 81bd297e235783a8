// SPDX-License-Identifier: MIT
// A bounding volume hierarchy of the Bezier pieces of a surface or curve, for rays. It is kept with the
// spline.
#pragma once

#include "intersect/rays/ray.h"
#include "pieces/tree/piece_grid.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// The grid of pieces is halved along its longer side down to single pieces. The children of node i are i + 1
// and right(i). The boxes include the rounding of the pieces.
class RayTree {
public:
    explicit RayTree(const pieces::PieceGrid &grid);

    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return grid_; }
    [[nodiscard]] bool is_piece(int32_t node) const noexcept { return at(node).right < 0; }
    [[nodiscard]] int64_t piece(int32_t node) const noexcept { return -1 - int64_t{at(node).right}; }
    [[nodiscard]] int32_t right(int32_t node) const noexcept { return at(node).right; }
    // Where a ray is inside the box of a node, enlarged by `room`; lower > upper: nowhere.
    [[nodiscard]] Interval meets(int32_t node, const Ray &ray, double room) const noexcept;

private:
    struct Node {
        std::array<float, 3> lower, upper;
        int32_t right; // of a leaf: -1 - piece
    };
    [[nodiscard]] const Node &at(int32_t node) const noexcept { return nodes_[static_cast<size_t>(node)]; }
    int32_t build(std::array<int64_t, 2> lower, std::array<int64_t, 2> upper);
    void set_box(Node &node, int64_t piece);

    const pieces::PieceGrid &grid_;
    std::vector<Node> nodes_;
    std::vector<double> work_, values_;
};

// Built at the first use. Precondition: a surface or curve in space.
const RayTree &ray_tree_of(const Spline &spline);

} // namespace nrb::intersect
