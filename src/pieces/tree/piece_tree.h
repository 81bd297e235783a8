// SPDX-License-Identifier: MIT
// The tree of the Bezier pieces of a spline, with discs around them: what a search with proof looks at before
// any polynomial. It is kept with the spline.
//
// The nodes of each level are blocks of the grid of pieces; those of the last level are the pieces, which are
// computed when they are looked at. Centres of discs are points of the spline but for their rounding, so that
// each distance of a centre bounds the smallest one from above.
#pragma once

#include "base/lazy.h"
#include "pieces/tree/disc.h"
#include "pieces/tree/disc_kernel.h"
#include "pieces/tree/piece_grid.h"

#include <vector>

namespace nrb::pieces {

class PieceTree {
public:
    // The grid is kept with the spline, as long as the tree.
    explicit PieceTree(const PieceGrid &grid);

    [[nodiscard]] const PieceGrid &grid() const noexcept { return grid_; }
    // Whether the discs have normals: those of surfaces in space.
    [[nodiscard]] bool normals() const noexcept { return normals_; }

    // The children of a node, side by side.
    struct Family {
        int64_t first;  // child
        int64_t count;  // of children
        int64_t width;  // of the columns of discs: count, rounded up for vectors
        int64_t offset; // of the discs
    };
    // The pieces in a node, [lower, upper) along each axis of the spline.
    struct Extent {
        PieceGrid::Index lower, upper;
    };

    // Level 0 is the root. Node i of a level but the last has family i.
    [[nodiscard]] int levels() const noexcept { return static_cast<int>(families_.size()) + 1; }
    [[nodiscard]] Family family(int level, int64_t node) const noexcept {
        return families_[static_cast<size_t>(level)][static_cast<size_t>(node)];
    }
    // Bounds of all children of a node; [most_width] each.
    void bound(int level, int64_t node, const double *x, bool farthest, const DiscBounds &out) const noexcept;
    // A box [2][dim] around a node with children, and around the disc of child i of a node, with what rounding
    // may have made of the points; infinite where weights are not positive for certain.
    void box(int level, int64_t node, double *out) const;
    void disc_box(int level, int64_t node, int64_t i, double *out) const noexcept;
    [[nodiscard]] Extent extent(int level, int64_t node) const noexcept;
    // The piece in the midst of a node.
    [[nodiscard]] int64_t middle(int level, int64_t node) const noexcept;
    // The pieces, in the order of the nodes of the last level.
    [[nodiscard]] const std::vector<int32_t> &order() const noexcept { return nodes_.back(); }
    // The most that rounding moves points of the pieces, of their parts and of bounds made with them.
    [[nodiscard]] double rounding() const noexcept {
        return grid_.moved() + 4 * grid_.value_error() * grid_.radius();
    }
    static constexpr int64_t most_width = 64;

private:
    class Builder;
    [[nodiscard]] PieceGrid::Index place_in_grid(int level, int64_t node) const noexcept;
    using Boxes = std::vector<std::vector<float>>; // [level], of the nodes that are no pieces [node][2][dim]
    [[nodiscard]] Boxes make_boxes() const;
    void enclose_children(int level, int64_t node, const Boxes &boxes, double *out) const;

    const PieceGrid &grid_;
    bool normals_;
    std::vector<std::vector<Family>> families_;
    std::vector<std::vector<int32_t>> nodes_; // in the grids of the levels
    std::vector<PieceGrid::Index> grids_;     // nodes of a level along each axis
    std::vector<PieceGrid::Index> blocks_;    // pieces in a node of it
    std::vector<float> discs_;
    Lazy<Boxes> boxes_; // at the first search that asks for one
    double apart_ = 0;  // a centre and the point of the spline that was rounded to it
};

// Built at the first use.
const PieceTree &piece_tree_of(const Spline &spline);

} // namespace nrb::pieces
