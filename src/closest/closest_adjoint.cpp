// SPDX-License-Identifier: MIT
#include "closest/closest_adjoint.h"

#include "base/checked.h"
#include "base/numbers.h"
#include "eval/adjoint/adjoint.h"
#include "eval/blocks.h"
#include "eval/kernels/slots.h"
#include "numeric/norm.h"
#include "numeric/solvers/small_systems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nrb::closest {

namespace {

// Eigenvalues of the scaled equations below this are rounding.
constexpr double singular_eigenvalue = 256 * eps;

double dot(const double *a, const double *b, int dim) noexcept {
    double sum = 0;
    for (int c = 0; c < dim; ++c) {
        sum += a[c] * b[c];
    }
    return sum;
}

// The foot u of a query x solves F_a = <r, C_a> = 0 with r = C(u) - x, on the axes where it is free: not at
// an end of the domain, nor held by a kink. With H_ab = <C_a, C_b> + <r, C_ab>
//   H du = -(<dC - dx, C_a> + <r, dC_a>)_a,
// where dC is the change of the curve or surface at fixed parameters. The foot moves by dC + sum of C_a du_a,
// and the distance d by <r, dC - dx> / d. So, with H lambda = -(g_u + <g_f, C_a>)_a, the cotangents of C
// and C_a are
//   g_f + g_d r / d + sum of lambda_a C_a   and   lambda_a r,
// and dL/dx = -(g_d r / d + sum of lambda_a C_a).
class ClosestAdjoint final : public eval::BlockSink {
public:
    ClosestAdjoint(const Spline &spline, const FootCotangents &in)
        : spline_(spline), in_(in), axes_(spline.axes()), dim_(spline.dim()),
          width_(int64_t{1 + axes_} * dim_), residual_(static_cast<size_t>(dim_)),
          cotangents_(static_cast<size_t>(checked_product(in.queries.count, width_, "cotangents"))),
          queries_(static_cast<size_t>(checked_product(in.queries.count, dim_, "gradients"))),
          status_(static_cast<size_t>(in.queries.count)) {}
    virtual ~ClosestAdjoint() = default;

    [[nodiscard]] ConstRecords cotangents() const noexcept {
        return {cotangents_.data(), in_.queries.count, width_, width_, 1};
    }
    [[nodiscard]] double query(int64_t i, int c) const noexcept {
        return queries_[static_cast<size_t>(i * dim_ + c)];
    }
    [[nodiscard]] int32_t status(int64_t i) const noexcept { return status_[static_cast<size_t>(i)]; }

    [[nodiscard]] bool wants_points() const noexcept override { return true; }
    void operator()(int64_t first, ConstRecords derivs) noexcept override {
        for (int64_t i = 0; i < derivs.count; ++i) {
            solve(first + i, derivs.record(i));
        }
    }

private:
    [[nodiscard]] const double *slope(const double *derivs, int a) const noexcept {
        return derivs + (1 + a) * dim_;
    }
    [[nodiscard]] const double *second(const double *derivs, int a, int b) const noexcept {
        eval::Orders orders{};
        ++orders[static_cast<size_t>(a)];
        ++orders[static_cast<size_t>(b)];
        return derivs + eval::slot(axes_, orders) * dim_;
    }
    static double value(const ConstRecords &view, int64_t i, int c) noexcept {
        return view.data == nullptr ? 0 : view(i, c);
    }

    void solve(int64_t i, const double *derivs) noexcept {
        int32_t &status = status_[static_cast<size_t>(i)];
        if (!find_residual(i, derivs)) {
            status = closest_invalid;
            std::fill_n(queries_.begin() + i * dim_, dim_, std::numeric_limits<double>::quiet_NaN());
            return;
        }
        const double distance = norm(residual_.data(), dim_);
        const double of_distance = value(in_.distances, i, 0);
        AxisVector lambda{};
        if ((of_distance != 0 && distance == 0) || !find_lambda(i, derivs, distance, status, lambda)) {
            status |= closest_singular;
            return;
        }
        write(i, derivs, of_distance != 0 ? of_distance / distance : 0, lambda);
    }

    bool find_residual(int64_t i, const double *derivs) noexcept {
        bool finite = true;
        for (int c = 0; c < dim_; ++c) {
            residual_[static_cast<size_t>(c)] = derivs[c] - in_.queries(i, c);
            finite = finite && std::isfinite(residual_[static_cast<size_t>(c)]);
        }
        return finite;
    }

    [[nodiscard]] bool at_end(int64_t i, int a) const noexcept {
        const KnotVector &axis = spline_.axis(a);
        const Interval domain = axis.domain();
        const double t = in_.feet(i, a);
        return !axis.periodic() && (t == domain.lower || t == domain.upper);
    }

    // Whether the foot is at a knot where the tangent may jump, and is no place where the derivative of the distance vanishes:
    // then it stays there.
    [[nodiscard]] bool held_by_kink(int64_t i, const double *derivs, double distance, int a) const noexcept {
        constexpr double stationary = 0x1p-30;
        const KnotVector &axis = spline_.axis(a);
        const auto [first, last] = std::equal_range(axis.knots().begin(), axis.knots().end(), in_.feet(i, a));
        const double *tangent = slope(derivs, a);
        return last - first >= axis.degree() && axis.degree() > 0 &&
               std::abs(dot(residual_.data(), tangent, dim_)) > stationary * distance * norm(tangent, dim_);
    }

    // False if the equations are singular to rounding. Each axis is measured by the size of its terms.
    bool find_lambda(int64_t i, const double *derivs, double distance, int32_t &status,
                     AxisVector &lambda) const noexcept {
        std::array<int, max_axes> free{};
        int n = 0;
        for (int a = 0; a < axes_; ++a) {
            const bool held = at_end(i, a) || held_by_kink(i, derivs, distance, a);
            status |= held ? closest_boundary : 0;
            if (!held) {
                free[static_cast<size_t>(n++)] = a;
            }
        }
        AxisMatrix matrix{};
        AxisVector right{}, size{};
        for (size_t r = 0; r < static_cast<size_t>(n); ++r) {
            const double *own = slope(derivs, free[r]);
            size[r] =
                std::sqrt(dot(own, own, dim_) + distance * norm(second(derivs, free[r], free[r]), dim_));
        }
        for (size_t r = 0; r < static_cast<size_t>(n); ++r) {
            if (!(size[r] > 0)) {
                return false;
            }
            right[r] = -cotangent_of(i, derivs, free[r]) / size[r];
            for (size_t c = 0; c < static_cast<size_t>(n); ++c) {
                matrix[r][c] = (dot(slope(derivs, free[r]), slope(derivs, free[c]), dim_) +
                                dot(residual_.data(), second(derivs, free[r], free[c]), dim_)) /
                               size[r] / size[c];
            }
        }
        return solve(n, matrix, right, size, free, lambda);
    }

    // g_u + <g_f, C_a>
    [[nodiscard]] double cotangent_of(int64_t i, const double *derivs, int a) const noexcept {
        double sum = value(in_.params, i, a);
        for (int c = 0; c < dim_; ++c) {
            sum += value(in_.points, i, c) * slope(derivs, a)[c];
        }
        return sum;
    }

    static bool solve(int n, const AxisMatrix &matrix, const AxisVector &right, const AxisVector &size,
                      const std::array<int, max_axes> &free, AxisVector &lambda) noexcept {
        if (n == 0) {
            return true;
        }
        const AxisVector values = symmetric_eigenvalues(n, matrix);
        const auto below = [](double x) { return !(std::abs(x) > singular_eigenvalue); };
        const std::optional<AxisMatrix> solved = inverse(n, matrix);
        if (std::any_of(values.begin(), values.begin() + n, below) || !solved) {
            return false;
        }
        for (size_t r = 0; r < static_cast<size_t>(n); ++r) {
            double sum = 0;
            for (size_t c = 0; c < static_cast<size_t>(n); ++c) {
                sum += (*solved)[r][c] * right[c];
            }
            lambda[static_cast<size_t>(free[r])] = sum / size[r];
        }
        return true;
    }

    // of_distance: g_d / d.
    void write(int64_t i, const double *derivs, double of_distance, const AxisVector &lambda) noexcept {
        double *out = cotangents_.data() + i * width_;
        for (int c = 0; c < dim_; ++c) {
            const double rest = residual_[static_cast<size_t>(c)];
            double moved = of_distance * rest;
            for (int a = 0; a < axes_; ++a) {
                moved += lambda[static_cast<size_t>(a)] * slope(derivs, a)[c];
                out[(1 + a) * dim_ + c] = lambda[static_cast<size_t>(a)] * rest;
            }
            out[c] = value(in_.points, i, c) + moved;
            queries_[static_cast<size_t>(i * dim_ + c)] = -moved;
        }
    }

    const Spline &spline_;
    const FootCotangents &in_;
    int axes_;
    int dim_;
    int64_t width_;
    std::vector<double> residual_;
    std::vector<double> cotangents_; // [count][1 + axes][dim]; 0 for a foot that is not determined
    std::vector<double> queries_;    // [count][dim]
    std::vector<int32_t> status_;
};

} // namespace

void closest_adjoint(const Spline &spline, const eval::AxisRules &rules, const FootCotangents &in,
                     const FootGradients &out) {
    ClosestAdjoint adjoint(spline, in);
    eval::evaluate_points(spline, rules, 2, in.feet, adjoint);
    eval::evaluate_adjoint(spline, rules, 1, in.feet, adjoint.cotangents(), false,
                           {out.points, out.weights, {}});
    for (int64_t i = 0; i < in.queries.count; ++i) {
        for (int c = 0; c < spline.dim() && out.queries.data != nullptr; ++c) {
            out.queries(i, c) = adjoint.query(i, c);
        }
        if (out.status != nullptr) {
            out.status[i] = adjoint.status(i);
        }
    }
}

} // namespace nrb::closest
