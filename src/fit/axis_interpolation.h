// SPDX-License-Identifier: MIT
// Interpolation along one axis: as many conditions as there are layers of control points.
#pragma once

#include "basis/knot_vector.h"
#include "numeric/solvers/banded/banded_lu.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nrb::fit {

// What is known along an axis: derivatives of orders (empty: values) at parameters. On a knot, that of the span after it; at
// the end of the domain, of the last one.
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
    // As many conditions as the axis has distinct layers, by rising parameters in the domain, the orders not above the
    // degree, in arrays that outlive this; `axis` is for messages. Values alone are solved without an exchange of rows, for
    // which condition i has to lie in the support of function i (I. Schoenberg, A. Whitney, Trans. Amer. Math. Soc. 74 (1953)),
    // else Status::schoenberg_whitney. So are derivatives where that turns out to be as accurate. All else, and what belongs
    // to a periodic axis, goes by rotations, which take several times as long.
    AxisInterpolation(KnotVectorPtr knots, const Sites &sites, int axis);

    [[nodiscard]] const KnotVectorPtr &knots() const noexcept { return knots_; }
    [[nodiscard]] const Sites &sites() const noexcept { return sites_; }
    [[nodiscard]] int64_t conditions() const noexcept { return sites_.count(); }
    // How many right sides are solved for at once with the least effort.
    [[nodiscard]] int64_t best_width() const noexcept;
    // values: [conditions][width], replaced by the layers of control points; a value at a clamped end is its control
    // point bit for bit. Throws Status::rank if the conditions do not determine them.
    void solve(std::vector<double> &values, int64_t width) const;
    // Multipliers of the conditions from derivatives of something by the layers of control points, [conditions][width]:
    // its derivatives by the right sides of the conditions, through solve().
    void solve_transposed(std::vector<double> &values, int64_t width) const;

private:
    // The first of the degree + 1 functions that are active at a condition, if that of the one before is known; and
    // what they contribute to it.
    [[nodiscard]] int64_t next_function(int64_t i, int64_t first) const noexcept;
    void read(int64_t i, int64_t first, double *values) const noexcept;
    // Divided by the largest entry, because derivatives of high order would outweigh the values; returns the factor.
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
