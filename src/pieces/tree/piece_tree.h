// SPDX-License-Identifier: MIT
// A tree of discs around the pieces of a spline: what a query looks at before
// any polynomial.
//
// A disc is the set of points across a normal n that are within a radius of the line through the centre, and
// whose heights over the centre are in an interval; without normal, a ball. Centres are points of the spline
// but for their rounding, so that each distance of a centre bounds the smallest one from above.
//
// With the pieces, which are computed when they are looked at, the tree of a surface of several spans along
// both axes takes at most 1.5 (p + 1) (q + 1) times the memory of the control points, and at most 12 times
// for a bicubic one.
#pragma once

#include "closest/patch/patch_pieces.h"
#include "closest/patch/tree/patch_leaves.h"

#include <vector>

namespace nrb::closest {

class PatchTree {
public:
    explicit PatchTree(const PatchPieces &pieces);

    // The children of a node, side by side.
    struct Family {
        int64_t first;  // child
        int64_t count;  // of children
        int64_t width;  // of the columns of discs: count, of inner nodes rounded up for vectors
        int64_t offset; // of the discs of inner nodes
    };
    // The pieces in a node, [lower, upper) along each axis of the spline.
    struct Extent {
        PatchPieces::Index lower, upper;
    };

    // Level 0 is the root, the last level holds the leaves. Node i of a level but the last has family i.
    [[nodiscard]] int levels() const noexcept {
        return static_cast<int>(families_.size()) + (parts() > 1 ? 2 : 1);
    }
    [[nodiscard]] Family family(int level, int64_t node) const noexcept {
        if (level < static_cast<int>(families_.size())) {
            return families_[static_cast<size_t>(level)][static_cast<size_t>(node)];
        }
        return {node * leaves_.count(), leaves_.count(), leaves_.count(), 0};
    }
    // Bounds of all children of a node; [most_width] each.
    void bound(int level, int64_t node, const double *x, bool farthest, const DiscBounds &out) const noexcept;
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
    static constexpr int64_t most_width = 64;

private:
    class Builder;
    [[nodiscard]] PatchPieces::Index place_in_grid(int level, int64_t node) const noexcept;

    const PatchPieces &pieces_;
    bool normals_;
    std::vector<std::vector<Family>> families_;
    std::vector<std::vector<int32_t>> nodes_; // in the grids of the levels of pieces and their groups
    std::vector<PatchPieces::Index> grids_;   // nodes of such a level along each axis
    std::vector<PatchPieces::Index> blocks_;  // pieces in a node of it
    std::vector<float> discs_;
    double apart_ = 0; // a centre and the point of the surface that was rounded to it
    PatchLeaves leaves_;
};

} // namespace nrb::closest
