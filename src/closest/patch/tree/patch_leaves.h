// SPDX-License-Identifier: MIT
// The leaves of the tree: equal parts of each piece, with discs around them.
//
// These discs are by far the most, so that each of their numbers takes one byte: centres relative to the
// middle of those of a piece, radii and heights relative to the largest one. Normals take two bytes, because
// what they lose counts by the distance of the query. Centres and normals are rounded first, then the discs
// make room for all points, so that they hold them whatever the bytes lose.
#pragma once

#include "closest/patch/patch_names.h"
#include "pieces/tree/piece_tree.h"

#include <vector>

namespace nrb::closest {

class PatchLeaves {
public:
    // Of the pieces in the order of their nodes.
    explicit PatchLeaves(const pieces::PieceTree &tree);

    // Along each axis of the shape; with 1, pieces have no leaves of their own.
    [[nodiscard]] int parts() const noexcept { return parts_; }
    [[nodiscard]] int64_t count() const noexcept { return count_; } // of a piece
    // Gives part i of an axis of the shape.
    [[nodiscard]] const double *matrix(int axis, int part) const noexcept {
        const auto &matrices = matrices_[static_cast<size_t>(axis)];
        return matrices.data() + std::ssize(matrices) / parts_ * part;
    }
    // Bounds of the leaves of a node.
    void bound(int64_t node, int dim, const double *x, bool farthest,
               const pieces::DiscBounds &out) const noexcept;

private:
    [[nodiscard]] static int parts_of(const PieceGrid &pieces, bool normals) noexcept;
    void set_matrices(const PatchShape &shape);
    void split(const PatchShape &shape, const std::vector<double> &patch, std::vector<double> &parts) const;
    void write(int64_t node, int dim, double rounding, std::vector<pieces::Disc> &discs,
               const std::vector<double> &parts, const PieceGrid &pieces);
    static void round_centres(int dim, std::vector<pieces::Disc> &discs, float *frame, int8_t *out);
    void round_normals(std::vector<pieces::Disc> &discs, int16_t *out) const;
    void round_sizes(int dim, double rounding, const std::vector<pieces::Disc> &discs, float *frame,
                     int8_t *out) const;
    [[nodiscard]] int64_t byte_columns(int dim) const noexcept { return dim + (has_normals_ ? 3 : 1); }
    [[nodiscard]] float *frame(int64_t node, int dim) noexcept {
        return frames_.data() + node * pieces::disc_frame(dim);
    }
    [[nodiscard]] const float *frame(int64_t node, int dim) const noexcept {
        return frames_.data() + node * pieces::disc_frame(dim);
    }

    bool has_normals_ = false;
    int parts_ = 1;
    int64_t count_ = 1;
    std::array<std::vector<double>, max_axes> matrices_;
    std::vector<int8_t> discs_;    // [node][column][leaf]
    std::vector<int16_t> normals_; // [node][coordinate][leaf]
    std::vector<float> frames_;    // [node]: as ByteDiscs have it
    double off_ = 0;               // how far a centre is from the surface, relative to its scale
};

} // namespace nrb::closest
