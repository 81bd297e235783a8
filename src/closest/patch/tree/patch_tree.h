// SPDX-License-Identifier: MIT
// The tree of the pieces of a spline, whose pieces have leaves here: what a query looks at before any
// polynomial.
//
// With the pieces, which are computed when they are looked at, the tree of a surface of several spans along
// both axes takes at most 1.5 (p + 1) (q + 1) times the memory of the control points, and at most 12 times
// for a bicubic one.
#pragma once

#include "closest/patch/tree/patch_leaves.h"
#include "pieces/tree/piece_tree.h"

namespace nrb::closest {

class PatchTree {
public:
    explicit PatchTree(const pieces::PieceTree &tree) : tree_(tree), leaves_(tree) {}

    using Family = pieces::PieceTree::Family;
    using Extent = pieces::PieceTree::Extent;

    // Level 0 is the root, the last level holds the leaves. Node i of a level but the last has family i.
    [[nodiscard]] int levels() const noexcept { return tree_.levels() + (parts() > 1 ? 1 : 0); }
    [[nodiscard]] Family family(int level, int64_t node) const noexcept {
        return level + 1 < tree_.levels()
                   ? tree_.family(level, node)
                   : Family{node * leaves_.count(), leaves_.count(), leaves_.count(), 0};
    }
    // Bounds of all children of a node; [most_width] each. Throws what PatchLeaves::bound() throws.
    void bound(int level, int64_t node, const double *x, bool farthest, const pieces::DiscBounds &out) const;
    [[nodiscard]] Extent extent(int level, int64_t node) const noexcept;

    // The parts that a leaf is of its piece: part index [k] of parts() along each axis of the shape.
    struct Leaf {
        int64_t piece;
        std::array<int, max_axes> part;
    };
    [[nodiscard]] Leaf leaf(int64_t node) const noexcept;
    [[nodiscard]] int parts() const noexcept { return leaves_.parts(); }
    // Of the disc of a node, as a place of a piece.
    struct Centre {
        int64_t piece;
        AxisValues at;
    };
    [[nodiscard]] Centre centre(int level, int64_t node) const noexcept;
    // Gives part i of an axis of the shape.
    [[nodiscard]] const double *matrix(int axis, int part) const noexcept {
        return leaves_.matrix(axis, part);
    }
    static constexpr int64_t most_width = pieces::PieceTree::most_width;

private:
    [[nodiscard]] bool of_parts(int level) const noexcept { return level == tree_.levels(); }

    const pieces::PieceTree &tree_;
    PatchLeaves leaves_;
};

} // namespace nrb::closest
