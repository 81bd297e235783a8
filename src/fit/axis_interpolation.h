// SPDX-License-Identifier: MIT
// Interpolation along one axis: collocation with as many conditions as there are layers of control points.
#pragma once

#include "basis/knot_vector.h"
#include "numeric/solvers/banded/banded_lu.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nrb::fit {

// The conditions along an axis ("sites"): derivatives of the given orders at parameters; no orders: values
// only. At a knot, a derivative is that of the span after it; at the end of the domain, that of the last
// span.
struct Sites {
    std::span<const double> params;
    std::span<const int32_t> orders;

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(params); }
    [[nodiscard]] double param(int64_t i) const noexcept { return params[static_cast<size_t>(i)]; }
    [[nodiscard]] int order(int64_t i) const noexcept {
        return orders.empty() ? 0 : orders[static_cast<size_t>(i)];
    }
};

class AxisInterpolation {
public:
    // `sites`: as many conditions as the axis has distinct layers, in ascending order of their parameters,
    // which lie in the domain; the orders are at most the degree; the arrays have to outlive this object.
    // `axis` is the number of the axis in messages.
    // Values alone are solved by LU factorisation without row exchanges, for which condition i has to lie in
    // the support of basis function i (Schoenberg-Whitney condition: I. Schoenberg, A. Whitney, Trans. Amer.
    // Math. Soc. 74 (1953)); otherwise Status::schoenberg_whitney is thrown. Derivatives are solved in the
    // same way where the factors show that this is as accurate as rotations. Everything else, and every
    // periodic axis, is solved by Givens rotations, which take several times as long.
    AxisInterpolation(KnotVectorPtr knots, const Sites &sites, int axis);

    [[nodiscard]] const KnotVectorPtr &knots() const noexcept { return knots_; }
    [[nodiscard]] const Sites &sites() const noexcept { return sites_; }
    [[nodiscard]] int64_t conditions() const noexcept { return sites_.count(); }
    // The number of right-hand sides to solve for at once with the least effort.
    [[nodiscard]] int64_t best_width() const noexcept;
    // values: the right-hand sides, [conditions][width], replaced by the layers of control points. A value at
    // a clamped end becomes its control point bit for bit. Throws Status::rank if the conditions do not
    // determine the control points.
    void solve(std::vector<double> &values, int64_t width) const;
    // Solves with the transposed matrix: turns the gradient of a function with respect to the layers of
    // control points, [conditions][width], into its gradient with respect to the right-hand sides of solve(),
    // the multipliers of the conditions.
    void solve_transposed(std::vector<double> &values, int64_t width) const;

private:
    // The first of the degree + 1 functions that are active at condition i, where `first` is that of the
    // condition before; read() gives the values or derivatives of these functions that enter the condition.
    [[nodiscard]] int64_t next_function(int64_t i, int64_t first) const noexcept;
    void read(int64_t i, int64_t first, double *values) const noexcept;
    // The same divided by the largest magnitude, because derivatives of high order would outweigh values;
    // returns the factor.
    double read_scaled(int64_t i, int64_t first, double *values) const noexcept;
    void factor_values();
    [[nodiscard]] bool factor_derivatives();
    [[noreturn]] void fail_outside_support(int64_t i) const;
    void rotate(std::vector<double> &values, int64_t width) const;
    void rotate_transposed(std::vector<double> &values, int64_t width) const;

    KnotVectorPtr knots_;
    Sites sites_;
    int axis_;
    std::optional<BandedLu> direct_;
    std::vector<double> scales_; // of the rows of direct_, if there are derivatives
};

} // namespace nrb::fit
