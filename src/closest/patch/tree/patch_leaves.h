// SPDX-License-Identifier: MIT
// The leaves of the tree: equal parts of each piece with their bounding discs, made when a query first
// examines the piece.
//
// Most of the tree's discs are these, so that each of their numbers takes one byte: centres are stored
// relative to the middle of the centres of a piece, radii and heights relative to the largest one. Normals
// take two bytes per number, because their error is multiplied by the distance of the query point. Centres
// and normals are rounded first; radii and heights are then computed from the rounded ones and rounded
// outwards, so that the discs contain all points whatever the rounding.
#pragma once

#include "closest/patch/patch_names.h"
#include "pieces/tree/disc_kernel.h"
#include "pieces/tree/piece_tree.h"

#include <atomic>
#include <memory>
#include <vector>

namespace nrb::closest {

class PatchLeaves {
public:
    // The leaves of the pieces in the order of their nodes. The tree must outlive this object.
    explicit PatchLeaves(const pieces::PieceTree &tree);

    // The number of parts along each axis of the shape; 1: pieces have no leaves of their own.
    [[nodiscard]] int parts() const noexcept { return parts_; }
    [[nodiscard]] int64_t count() const noexcept { return count_; } // leaves per piece
    // The pieces::part_matrix() for part i of an axis of the shape.
    [[nodiscard]] const double *matrix(int axis, int part) const noexcept {
        const auto &matrices = matrices_[static_cast<size_t>(axis)];
        return matrices.data() + std::ssize(matrices) / parts_ * part;
    }
    // Bounds for the leaves of a node, which are made if necessary. Throws std::bad_alloc, CallEnded.
    void bound(int64_t node, const double *x, bool farthest, const pieces::DiscBounds &out) const;

private:
    // The discs of one node. Each array has readable numbers after its last disc.
    struct Discs {
        int8_t *columns;  // [column][leaf]
        int16_t *normals; // [coordinate][leaf]
        float *frame;     // laid out as in pieces::ByteDiscs
    };
    enum class State : uint8_t { missing, written, ready };

    [[nodiscard]] static int parts_of(const PieceGrid &pieces, bool normals) noexcept;
    void set_matrices(const PatchShape &shape);
    // The length of each array for one node.
    [[nodiscard]] int64_t columns_size() const noexcept {
        return count_ * (dim_ + (has_normals_ ? 3 : 1)) + read_over_;
    }
    [[nodiscard]] int64_t normals_size() const noexcept { return has_normals_ ? count_ * 3 + read_over_ : 0; }
    [[nodiscard]] int64_t frame_size() const noexcept { return pieces::disc_frame(dim_); }
    [[nodiscard]] Discs kept(int64_t node) const noexcept;
    void keep(int64_t node, const Discs &made) const noexcept;
    void bound_made(const Discs &discs, const double *x, bool farthest,
                    const pieces::DiscBounds &out) const noexcept;

    void make(int64_t node, const Discs &out) const;
    void split(const std::vector<double> &patch, std::vector<double> &parts) const;
    void round_centres(std::vector<pieces::Disc> &discs, const Discs &out) const;
    void round_normals(std::vector<pieces::Disc> &discs, int16_t *out) const;
    void round_sizes(const std::vector<pieces::Disc> &discs, const Discs &out) const;

    const pieces::PieceTree &tree_;
    bool has_normals_ = false;
    int dim_ = 0;
    int parts_ = 1;
    int64_t count_ = 1;
    int64_t read_over_ = 0;
    double off_ = 0; // bound on how far rounding moves a centre, relative to the scale of the centres
    std::array<std::vector<double>, max_axes> matrices_;
    // Data of all nodes. The data of a node are written once, by the thread that sets its state to `written`,
    // and are read once the state is `ready`.
    std::unique_ptr<std::atomic<State>[]> states_;
    std::unique_ptr<int8_t[]> columns_;
    std::unique_ptr<int16_t[]> normals_;
    std::unique_ptr<float[]> frames_;
};

} // namespace nrb::closest
