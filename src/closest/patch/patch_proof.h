// SPDX-License-Identifier: MIT
// Proofs that no point of a patch is nearer (or farther) than a given distance rho.
//
// With the exact polynomials Q and w of an item, the claim is F = sign (|Q|^2 - rho^2 w^2) >= 0 over the box.
// It holds if all Bernstein coefficients of F are >= 0. Otherwise, axes along which F increases
// (or decreases) throughout are dropped first, because F is least on the corresponding face. On this face F
// is shown to be convex by a matrix C that bounds its second derivatives from below, in the sense that
//   F(t + y) >= F(t) + g . y + 1/2 |y|^T C |y|,
// where g is the gradient of F at t, and |y| the vector of magnitudes. If C is positive definite, then
// F >= F(t) - 1/2 |g|^T C^-1 |g| everywhere. For t, a minimum found by a descent is taken, where g is
// rounding only.
#pragma once

#include "closest/patch/patch_descent.h"

namespace nrb::closest {

struct PatchGoal {
    double sign = 1;   // -1: no point is farther
    double rho = 0;    // >= 0
    double margin = 0; // how much of F at the minimum rounding may consume, in units of w^2
    double worth = 0;  // value, sign * distance, below which a point improves the best one
};

// The Bernstein coefficients of F and of the squares that it is made of.
struct PatchGap {
    const double *squares = nullptr;
    const double *weights = nullptr; // of w^2; null: all 1
    double *values = nullptr;
};

class PatchProof {
public:
    PatchProof(const PieceGrid &pieces, const PatchDescent &descent, const PatchItem &item,
               const PatchGoal &goal, const PatchGap &gap);

    // Whether all coefficients of F are >= 0 beyond rounding; computes gap.values.
    [[nodiscard]] bool positive() noexcept;
    // Whether F >= 0 by convexity; to be called after positive(). `guess`: a known minimum, or null.
    [[nodiscard]] bool convex(const AxisValues *guess);
    // After convex(): whether a minimum of the distance was computed on the face that is left of the box, its
    // distance and place, and whether the minimum of F is known to be unique.
    [[nodiscard]] bool found() const noexcept { return found_; }
    [[nodiscard]] double distance() const noexcept { return distance_; }
    [[nodiscard]] const AxisValues &at() const noexcept { return at_; }
    [[nodiscard]] bool strict() const noexcept { return strict_; }
    // Whether the distance of every point differs from rho by at most `by`.
    [[nodiscard]] bool flat(double by) const noexcept;

    // The axis along which the second derivative of F is largest, among those that convex() did not drop; -1
    // if there are no axes. Must be the last call.
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
        double gap;     // value of F
        bool is_better; // the point would improve the best one
    };
    [[nodiscard]] Corner least_corner() const noexcept;
    [[nodiscard]] AxisValues lowest() const noexcept;
    [[nodiscard]] double value_error(const AxisValues &at) const noexcept;
    [[nodiscard]] bool holds_at(const AxisValues &at);
    // 1/2 g^T (C + more I)^-1 g on the free axes, rounded up; negative if that matrix is not positive
    // definite.
    [[nodiscard]] double loss(const AxisValues &gradient, double more) const noexcept;

    const PieceGrid &pieces_;
    const PatchShape &shape_;
    const PatchDescent &descent_;
    const PatchItem &item_;
    PatchGoal goal_;
    PatchGap gap_;
    double error_;                         // bound on the error of a coefficient of F
    std::array<int, max_axes> face_{};     // -1: the axis is free; 0, 1: only this end is left
    std::array<int64_t, max_axes> step_{}; // stride of the coefficients along an axis
    double lost_ = 0;                      // how far F may fall below its face, by dropped axes
    std::array<AxisValues, max_axes> matrix_{};
    bool strict_ = true;
    bool found_ = false;
    double distance_ = 0;
    AxisValues at_{};
};

} // namespace nrb::closest
