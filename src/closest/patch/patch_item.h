// SPDX-License-Identifier: MIT
// A box of a piece, relative to a query point: the item that the branch-and-bound search divides.
#pragma once

#include "closest/patch/patch_memory.h"
#include "closest/patch/patch_names.h"

namespace nrb::closest {

// The homogeneous control points (Q_i, w_i) over a box of the piece, with Q = A - w x for the query point x.
struct PatchItem {
    double *values = nullptr;
    int64_t piece = 0;
    AxisValues lower{};         // in [0, 1] of the piece, along the axes of the shape
    AxisValues length{1, 1, 1}; // side lengths of the box
    double moved = 0;           // how far rounding may have moved its points
    double reach = 0;           // |Q_i| <= reach * w_i
    double least_weight = 1, most_weight = 1;
    bool sound = false; // every weight is > 0, or is 0 with Q_i = 0 exactly; the members above presume it
    int depth = 0;

    [[nodiscard]] double to_piece(int k, double s) const noexcept {
        const auto at = static_cast<size_t>(k);
        return lower[at] + length[at] * s;
    }
};

// Makes the items of one query point.
class PatchItems {
public:
    PatchItems(const PieceGrid &pieces, const double *point, PatchMemory &memory);

    // The query point in the frame of the pieces.
    [[nodiscard]] const double *x() const noexcept { return x_; }
    // Whether all points of the spline are equally far away to rounding.
    [[nodiscard]] bool far_away() const noexcept;
    // The values of a whole piece, which stay valid only until those of other pieces are requested; and how
    // far rounding may have moved the points of any piece.
    [[nodiscard]] const double *values(int64_t piece) const;
    [[nodiscard]] double moved() const noexcept { return moved_; }
    // The item of a whole piece.
    [[nodiscard]] PatchItem whole(int64_t piece) const;
    // The part [lower, upper] of an item along an axis. `matrix` is its pieces::part_matrix().
    [[nodiscard]] PatchItem part(const PatchItem &item, int axis, double lower, double upper,
                                 const double *matrix) const;
    [[nodiscard]] PatchItem part(const PatchItem &item, int axis, double lower, double upper) const;
    // Halves an item along an axis: returns the lower half; `item` becomes the upper one.
    [[nodiscard]] PatchItem halve_item(PatchItem &item, int axis) const;
    // Computes sound, reach and the extreme weights.
    void measure(PatchItem &item) const noexcept;

private:
    template <int kDim>
    void measure(PatchItem &item) const noexcept;

    const PieceGrid &pieces_;
    PatchMemory &memory_;
    double *x_;
    // A small cache of pieces, as a query mostly requests those that it used last.
    static constexpr int most_kept = 4;
    static constexpr int64_t small_piece = 512; // number of doubles
    int kept_;
    double *values_; // [kept_][values()]
    double moved_ = 0;
    mutable std::array<int64_t, most_kept> made_{-1, -1, -1, -1};
    mutable int next_ = 0;
};

// The axis along which the control points spread most; -1 if there are no axes.
int longest_axis(const PatchShape &shape, const PatchItem &item) noexcept;

} // namespace nrb::closest
