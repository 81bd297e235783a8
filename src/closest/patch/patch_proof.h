// SPDX-License-Identifier: MIT
// Proofs that no point of a patch is nearer, or farther, than a distance.
//
// With the exact polynomials of an item, F = sign (|Q|^2 - rho^2 w^2) >= 0 over the box says so. First the
// axes along which F rises (or falls) throughout are dropped: its least value is on that face. On the rest F
// is shown to be convex, by a matrix C below its second derivatives in the sense that
//     F(t + y) >= F(t) + g y + 1/2 |y|^T C |y|,
// so that F is at least F(t) - 1/2 |g|^T C^-1 |g|; t is a minimum that was found, where g is rounding only.
#pragma once

#include "closest/patch/patch_descent.h"

namespace nrb::closest {

struct PatchGoal {
    double sign = 1;   // -1: farther
    double rho = 0;    // >= 0
    double margin = 0; // of F at the minimum that rounding may use up, in units of w^2
    double worth = 0;  // sign * distance below which a point is new
};

// The coefficients of F, and of what it is made.
struct PatchGap {
    const double *squares = nullptr;
    const double *weights = nullptr; // null: 1
    double *values = nullptr;
};

class PatchProof {
public:
    PatchProof(const PieceGrid &pieces, const PatchDescent &descent, const PatchItem &item,
               const PatchGoal &goal, const PatchGap &gap);

    // Whether all coefficients of F are >= 0 beyond rounding; fills in gap.values.
    [[nodiscard]] bool positive() noexcept;
    // Whether F >= 0 by its shape; after positive(). `guess`: a minimum that is known, or null.
    [[nodiscard]] bool convex(const AxisValues *guess);
    // The minimum of the distance on what convex() left of the box, and whether that of F is the only one.
    [[nodiscard]] bool found() const noexcept { return found_; }
    [[nodiscard]] double distance() const noexcept { return distance_; }
    [[nodiscard]] const AxisValues &at() const noexcept { return at_; }
    [[nodiscard]] bool strict() const noexcept { return strict_; }
    // Whether no point differs in its distance from rho by more than `by`.
    [[nodiscard]] bool flat(double by) const noexcept;

    // The axis along which F bends most, of those that convex() did not drop; -1 without axes. The last call.
    [[nodiscard]] int widest_axis() noexcept;

private:
    struct Range {
        double low, high;
    };
    template <class Visit>
    void for_face(const std::array<int, max_axes> &shrink, Visit &&visit) const noexcept;
    [[nodiscard]] Range first_differences(int k) const noexcept;
    [[nodiscard]] Range second_differences(int k, int l) const noexcept;
    bool drop_axes(double allowed) noexcept;
    bool convex_on_face(const AxisValues *guess);
    void set_matrix() noexcept;
    struct Corner {
        double gap;     // F
        bool is_better; // it is a point that is new
    };
    [[nodiscard]] Corner least_corner() const noexcept;
    [[nodiscard]] AxisValues lowest() const noexcept;
    [[nodiscard]] double value_error(const AxisValues &at) const noexcept;
    [[nodiscard]] bool holds_at(const AxisValues &at);
    // 1/2 g^T (C + diag(more))^-1 g; negative if that matrix is not positive definite.
    [[nodiscard]] double loss(const AxisValues &gradient, double more) const noexcept;

    const PieceGrid &pieces_;
    const PatchShape &shape_;
    const PatchDescent &descent_;
    const PatchItem &item_;
    PatchGoal goal_;
    PatchGap gap_;
    double error_;                         // of a coefficient of F
    std::array<int, max_axes> face_{};     // -1: all of the axis; 0, 1: the end that is left
    std::array<int64_t, max_axes> step_{}; // between coefficients along an axis
    double lost_ = 0;                      // by dropping axes
    std::array<AxisValues, max_axes> matrix_{};
    bool strict_ = true;
    bool found_ = false;
    double distance_ = 0;
    AxisValues at_{};
};

} // namespace nrb::closest
