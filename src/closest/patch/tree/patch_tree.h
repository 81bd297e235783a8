// SPDX-License-Identifier: MIT
// The bounding volume hierarchy of a surface or volume that a query descends first: the tree of the spline's
// pieces, extended by the leaves of the pieces.
//
// For a surface of several spans along both axes, the tree with the pieces, which are computed when they are
// needed, takes at most 1.5 (p + 1) (q + 1) times the memory of the control points, and at most 12 times.
#pragma once

#include "closest/patch/tree/patch_leaves.h"
#include "pieces/tree/piece_tree.h"

namespace nrb::closest {

class PatchTree {
public:
    explicit PatchTree(const pieces::PieceTree &tree) : tree_(tree), leaves_(tree) {}

    using Family = pieces::PieceTree::Family;
    using Extent = pieces::PieceTree::Extent;

    // Level 0 is the root, the last level holds the leaves. Family i of a level consists of the children of
    // node i; the last level has none.
    [[nodiscard]] int levels() const noexcept { return tree_.levels() + (parts() > 1 ? 1 : 0); }
    [[nodiscard]] Family family(int level, int64_t node) const noexcept {
        return level + 1 < tree_.levels()
                   ? tree_.family(level, node)
                   : Family{node * leaves_.count(), leaves_.count(), leaves_.count(), 0};
    }
    // Bounds for all children of a node; arrays of most_width each. Throws what PatchLeaves::bound() throws.
    void bound(int level, int64_t node, const double *x, bool farthest, const pieces::DiscBounds &out) const;
    [[nodiscard]] Extent extent(int level, int64_t node) const noexcept;

    // A leaf as a part of its piece: index part[k], less than parts(), along each axis of the shape.
    struct Leaf {
        int64_t piece;
        std::array<int, max_axes> part;
    };
    [[nodiscard]] Leaf leaf(int64_t node) const noexcept;
    [[nodiscard]] int parts() const noexcept { return leaves_.parts(); }
    // The centre of the disc of a node, as a place of a piece.
    struct Centre {
        int64_t piece;
        AxisValues at;
    };
    [[nodiscard]] Centre centre(int level, int64_t node) const noexcept;
    // The pieces::part_matrix() for part i of an axis of the shape.
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
