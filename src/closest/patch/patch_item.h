// SPDX-License-Identifier: MIT
// A part of a piece about a query point.
#pragma once

#include "closest/patch/patch_memory.h"
#include "closest/patch/patch_names.h"

namespace nrb::closest {

// Q = A - w x over a box in the piece: point i of the control net is Q_i / w_i.
struct PatchItem {
    double *values = nullptr;
    int64_t piece = 0;
    AxisValues lower{};         // in [0, 1] of the piece, along the axes of the shape
    AxisValues length{1, 1, 1}; // of its sides
    double moved = 0;           // how far rounding may have moved its points
    double reach = 0;           // |Q_i| <= reach w_i
    double least_weight = 1, most_weight = 1;
    bool sound = false; // all weights are > 0, or 0 with Q_i = 0 exactly: the above hold
    int depth = 0;

    [[nodiscard]] double to_piece(int k, double s) const noexcept {
        const auto at = static_cast<size_t>(k);
        return lower[at] + length[at] * s;
    }
};

// What makes items from pieces for one query point.
class PatchItems {
public:
    PatchItems(const PieceGrid &pieces, const double *point, PatchMemory &memory);

    // The query point as the pieces place it.
    [[nodiscard]] const double *x() const noexcept { return x_; }
    // Whether all points of the spline are equally far from it to rounding.
    [[nodiscard]] bool far_away() const noexcept;
    // The values of a whole piece until those of other pieces are asked for, and how far rounding may have
    // moved the points of any.
    [[nodiscard]] const double *values(int64_t piece) const;
    [[nodiscard]] double moved() const noexcept { return moved_; }
    // The whole piece.
    [[nodiscard]] PatchItem whole(int64_t piece) const;
    // The part [lower, upper] in the box of an item along an axis; matrix: pieces::part_matrix() of it.
    [[nodiscard]] PatchItem part(const PatchItem &item, int axis, double lower, double upper,
                                 const double *matrix) const;
    [[nodiscard]] PatchItem part(const PatchItem &item, int axis, double lower, double upper) const;
    // The halves along an axis; item becomes the upper one.
    [[nodiscard]] PatchItem halve_item(PatchItem &item, int axis) const;
    // Fills in sound, reach and the weights.
    void measure(PatchItem &item) const noexcept;

private:
    template <int kDim>
    void measure(PatchItem &item) const noexcept;

    const PieceGrid &pieces_;
    PatchMemory &memory_;
    double *x_;
    // The pieces that were made last, for which a query mostly asks again.
    static constexpr int most_kept = 4;
    static constexpr int64_t small_piece = 512; // doubles
    int kept_;
    double *values_; // [kept_][values()]
    double moved_ = 0;
    mutable std::array<int64_t, most_kept> made_{-1, -1, -1, -1};
    mutable int next_ = 0;
};

// The axis along which the control points spread most; -1 without axes.
int longest_axis(const PatchShape &shape, const PatchItem &item) noexcept;

} // namespace nrb::closest
