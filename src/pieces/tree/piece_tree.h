// SPDX-License-Identifier: MIT
// A bounding volume hierarchy: the tree of the Bezier pieces of a spline, with bounding discs. Certified
// searches examine it before any polynomial. It is kept with the spline.
//
// The nodes of each level are blocks of the grid of pieces; those of the last level are the pieces, which are
// computed on request. Centres of discs are points of the spline up to their rounding, so that the distance
// of any centre bounds the smallest distance from above.
#pragma once

#include "base/lazy.h"
#include "pieces/tree/disc.h"
#include "pieces/tree/disc_kernel.h"
#include "pieces/tree/piece_grid.h"

#include <vector>

namespace nrb::pieces {

class PieceTree {
public:
    // The grid is kept with the spline and must live as long as the tree.
    explicit PieceTree(const PieceGrid &grid);

    [[nodiscard]] const PieceGrid &grid() const noexcept { return grid_; }
    // Whether the discs have normals: for surfaces in space.
    [[nodiscard]] bool normals() const noexcept { return normals_; }

    // The children of a node, stored contiguously.
    struct Family {
        int64_t first;  // first child
        int64_t count;  // number of children
        int64_t width;  // length of the columns of discs: count, rounded up for vectors
        int64_t offset; // of the discs
    };
    // The pieces in a node, [lower, upper) along each axis of the spline.
    struct Extent {
        PieceGrid::Index lower, upper;
    };

    // Level 0 is the root. Node i of any level but the last has family i.
    [[nodiscard]] int levels() const noexcept { return static_cast<int>(families_.size()) + 1; }
    [[nodiscard]] Family family(int level, int64_t node) const noexcept {
        return families_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    }
    // Bounds for all children of a node; [most_width] each.
    void bound(int level, int64_t node, const double *x, bool farthest, const DiscBounds &out) const noexcept;
    // A bounding box [2][dim] of a node with children, and of the disc of child i of a node, including the
    // rounding errors of the points; infinite where weights are not certainly positive.
    void box(int level, int64_t node, double *out) const;
    void disc_box(int level, int64_t node, int64_t i, double *out) const noexcept;
    [[nodiscard]] Extent extent(int level, int64_t node) const noexcept;
    // A piece in the middle of a node.
    [[nodiscard]] int64_t middle(int level, int64_t node) const noexcept;
    // The pieces, in the order of the nodes of the last level.
    [[nodiscard]] const std::vector<int32_t> &order() const noexcept { return nodes_.back(); }
    // The largest distance by which rounding moves points of the pieces, of their parts, and of bounds
    // derived from them.
    [[nodiscard]] double rounding() const noexcept {
        return grid_.moved() + 4 * grid_.value_error() * grid_.radius();
    }
    static constexpr int64_t most_width = 64;

private:
    class Builder;
    [[nodiscard]] PieceGrid::Index place_in_grid(int level, int64_t node) const noexcept;
    using Boxes = std::vector<std::vector<float>>; // [level]: [node][2][dim], without the pieces
    [[nodiscard]] Boxes make_boxes() const;
    void enclose_children(int level, int64_t node, const Boxes &boxes, double *out) const;

    const PieceGrid &grid_;
    bool normals_;
    std::vector<std::vector<Family>> families_;
    std::vector<std::vector<int32_t>> nodes_; // their indices in the grids of the levels
    std::vector<PieceGrid::Index> grids_;     // number of nodes of a level along each axis
    std::vector<PieceGrid::Index> blocks_;    // number of pieces in a node of the level
    std::vector<float> discs_;
    Lazy<Boxes> boxes_; // made by the first search that needs one
    double apart_ = 0;  // largest distance of a centre from the point of the spline that was rounded to it
};

// Built at first use.
const PieceTree &piece_tree_of(const Spline &spline);

} // namespace nrb::pieces
