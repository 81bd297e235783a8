// SPDX-License-Identifier: MIT
// The control points and weights that constraints change, and how derivatives of the spline depend on them.
#pragma once

#include "eval/active_points.h"
#include "eval/kernels/leibniz.h"
#include "modify/constrain/condition.h"

#include <optional>
#include <vector>

namespace nrb::modify {

// What may change, and at what cost. A null pointer means the default.
struct ChangeRule {
    const int32_t *keep;        // [axes][2] orders of derivatives that stay at the ends, -1 for none
    const double *costs;        // of moves; by default 1
    const double *weight_costs; // of relative changes; by default weights stay
};

// The unknowns: a column for each control point that may move, and for each weight that may change, if it
// acts on a condition; -1 for all others. Copies on periodic axes have the column of their original.
struct Columns {
    std::vector<int64_t> points;
    std::vector<int64_t> weights;
    std::vector<double> point_costs; // by column
    std::vector<double> weight_costs;
};
Columns make_columns(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule);

// The Cartesian control points and weights at a step of the iteration.
class NetState {
public:
    // The spline must outlive this. Throws Status::point_not_finite if there is a control point at
    // infinity.
    NetState(const Spline &spline, const Columns &columns);

    [[nodiscard]] const Spline &start() const noexcept { return spline_; }
    [[nodiscard]] const Columns &columns() const noexcept { return columns_; }
    [[nodiscard]] const double *point(int64_t i) const noexcept { return points_.data() + i * spline_.dim(); }
    [[nodiscard]] double weight(int64_t i) const noexcept {
        return weights_.empty() ? 1 : weights_[static_cast<size_t>(i)];
    }
    [[nodiscard]] bool rational() const noexcept { return !weights_.empty(); }
    // Sets the control points to those of the start moved by moves[column][dim], and the weights to those of
    // the start times 1 + changes[column].
    void set(const std::vector<double> &moves, const std::vector<double> &changes) noexcept;
    // Throws what make_result() throws.
    [[nodiscard]] SplinePtr spline() const;

private:
    const Spline &spline_;
    const Columns &columns_;
    std::vector<double> start_;
    std::vector<double> points_;
    std::vector<double> weights_; // empty: polynomial
};

// The rational basis functions R_i at one parameter, for the weights of a state.
class LocalBasis {
public:
    LocalBasis(const NetState &state, const Condition &condition);

    [[nodiscard]] const std::vector<int64_t> &points() const noexcept { return points_; }
    // The derivatives R_i^(a) of the active control points. On each axis, a is at most the highest order of a
    // derivative of the condition.
    [[nodiscard]] std::vector<double> functions(const eval::Orders &a) const;
    // sum R_i^(a) P_i, computed from differences to the control point with the largest |R_i^(a)|.
    [[nodiscard]] std::vector<double> value(const eval::Orders &a,
                                            const std::vector<double> &functions) const;
    // sum |R_i^(a)| |P_i|.
    [[nodiscard]] double magnitude(const std::vector<double> &functions) const noexcept;
    // The derivative of S^(a) by the relative change r of each weight, [active][dim], where w_i = w_i* (1 +
    // r) and w_i* is the weight at the start. Because w S = sum w_j N_j P_j, the derivative of S by r is w_i*
    // / w_i R_i (P_i - S), and that of S^(a) is w_i* / w_i times
    //
    //     R_i^(a) P_i - sum over b <= a of binomial(a, b) R_i^(b) S^(a-b).
    [[nodiscard]] std::vector<double> weight_slopes(const eval::Orders &a) const;

private:
    const NetState &state_;
    eval::ActivePoints active_;
    std::vector<int64_t> points_;
    std::optional<eval::Reciprocal> reciprocal_; // of w(t), if rational
};

} // namespace nrb::modify
