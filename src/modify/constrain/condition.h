// SPDX-License-Identifier: MIT
// The equations that constraints impose on a point and its derivatives, and their Jacobian.
#pragma once

#include "eval/kernels/slots.h"

#include <span>
#include <vector>

namespace nrb::modify {

enum ConstraintKind : int32_t {
    constrain_value = 0, // the derivative of the given orders is the target
    constrain_direction, // the derivative is parallel to the target, either way
    constrain_normal,    // all first derivatives are perpendicular to the target
    constrain_curvature, // the curvature vector of a curve is the target
};

// One constraint at a parameter. Its equations are functions of some derivatives of the spline there.
class Condition {
public:
    // Preconditions: kind, orders and target have been checked; `param` and `target` outlive this.
    Condition(int32_t kind, const eval::Orders &orders, const double *param, const double *target, int axes,
              int dim);

    [[nodiscard]] int32_t kind() const noexcept { return kind_; }
    [[nodiscard]] const double *param() const noexcept { return param_; }
    [[nodiscard]] const double *target() const noexcept { return target_; }
    [[nodiscard]] std::span<const eval::Orders> derivatives() const noexcept { return derivatives_; }
    [[nodiscard]] int equations() const noexcept { return equations_; }
    // Whether every equation is linear in a single derivative, so that its coefficients do not change.
    [[nodiscard]] bool linear() const noexcept;

    // From the derivatives, `values` [derivatives][dim]: the residuals, which are the left sides minus the
    // right sides, and their derivatives, `jacobian` [equations][derivatives][dim]. target_size() is the size
    // of the right sides, for bounds of rounding.
    void evaluate(const double *values, double *residual, double *jacobian) const noexcept;
    [[nodiscard]] double target_size() const noexcept { return target_size_; }

private:
    void add_complement(const double *direction);
    void curvature(const double *values, double *residual, double *jacobian) const noexcept;

    int32_t kind_;
    int dim_;
    int equations_ = 0;
    const double *param_;
    const double *target_;
    double target_size_ = 0;
    std::vector<eval::Orders> derivatives_;
    std::vector<double> rows_; // unit vectors along which derivatives vanish, [..][dim]
};

} // namespace nrb::modify
