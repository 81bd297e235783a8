// SPDX-License-Identifier: MIT
#include "closest/closest_adjoint.h"

#include "base/checked.h"
#include "base/numbers.h"
#include "closest/stops.h"
#include "eval/active.h"
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

// Where the scaled matrix below has an eigenvalue of at most this magnitude, it counts as singular: the
// eigenvalue is rounding.
constexpr double singular_eigenvalue = 256 * eps;

// The foot u of a query point x satisfies F_a = <r, C_a> = 0 with r = C(u) - x, for every axis a on which the
// foot is free, that is, held neither by an end of the domain nor by a kink. Differentiating gives, with
// H_ab = <C_a, C_b> + <r, C_ab>,
//   H du = -(<dC - dx, C_a> + <r, dC_a>)_a,
// where dC is the change of the curve or surface at fixed parameters. The foot moves by dC + sum_a C_a du_a,
// and the distance d changes by <r, dC - dx> / d. Let g_u, g_f and g_d be the derivatives of L with respect
// to the parameters, the point and the distance of the foot. With lambda defined by
//   H lambda = -(g_u + <g_f, C_a>)_a,
// the cotangents of C and C_a are
//   g_f + g_d r / d + sum_a lambda_a C_a   and   lambda_a r,
// and dL/dx = -(g_d r / d + sum_a lambda_a C_a). Where r is no larger than its rounding, the direction r / d
// is meaningless; it is replaced by 0, the subgradient of the distance of least norm.
//
// The computation forms no product of two lengths, so that it neither overflows nor underflows for shapes of
// any size: the unknowns are lambda_a s_a, and the tangents are C_a / s_a, where
// s_a^2 = |C_a|^2 + |r| |C_aa|.
class ClosestAdjoint final : public eval::BlockSink {
public:
    ClosestAdjoint(const Spline &spline, const eval::AxisRules &rules, const FootCotangents &in)
        : spline_(spline), in_(in), axes_(spline.axes()), dim_(spline.dim()),
          width_(int64_t{1 + axes_} * dim_), direction_(static_cast<size_t>(dim_)),
          tangents_(static_cast<size_t>(axes_ * dim_)), hulls_(static_cast<size_t>(in.queries.count)),
          cotangents_(static_cast<size_t>(checked_product(in.queries.count, width_, "cotangents"))),
          queries_(static_cast<size_t>(checked_product(in.queries.count, dim_, "gradients"))),
          status_(static_cast<size_t>(in.queries.count)) {
        eval::hull_sizes(spline, rules, in.feet, {hulls_.data(), in.queries.count, 1, 1, 1});
    }
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
        if (!find_direction(i, derivs)) {
            status = closest_invalid;
            std::fill_n(queries_.begin() + i * dim_, dim_, std::numeric_limits<double>::quiet_NaN());
            return;
        }
        double of_distance = value(in_.distances, i, 0);
        const bool meets = !(distance_ > noise(i, derivs));
        if (meets && of_distance != 0) {
            status |= closest_singular;
            of_distance = 0;
        }
        status |= find_free(i, derivs, meets) < axes_ ? closest_boundary : 0;
        find_tangents(derivs);
        AxisVector lambda{};
        if (!find_lambda(i, derivs, lambda)) {
            status |= closest_singular;
            return;
        }
        write(i, of_distance, lambda);
    }

    // Sets direction_ and distance_ so that r = distance_ direction_; false if r is not finite.
    bool find_direction(int64_t i, const double *derivs) noexcept {
        for (int c = 0; c < dim_; ++c) {
            direction_[static_cast<size_t>(c)] = derivs[c] - in_.queries(i, c);
        }
        distance_ = norm(direction_.data(), dim_);
        for (double &x : direction_) {
            x = distance_ > 0 ? x / distance_ : 0;
        }
        return std::isfinite(distance_);
    }

    // The uncertainty of r: the bound for the evaluation of C(u), see axis-inl.h, and the effect of the
    // rounding of u.
    [[nodiscard]] double noise(int64_t i, const double *derivs) const noexcept {
        double roundings = 0, moved = 0;
        for (int a = 0; a < axes_; ++a) {
            roundings += 7 * spline_.axis(a).degree() + 2;
            moved += std::abs(in_.feet(i, a)) * norm(slope(derivs, a), dim_);
        }
        return eps * roundings * std::sqrt(dim_) * hulls_[static_cast<size_t>(i)] + eps * moved +
               underflow_noise;
    }

    // Finds the axes on which the foot is free; returns their number. An axis holds the foot if <r, C_a> need
    // not vanish there (at an end, a kink, or for degree 0) and does not.
    int find_free(int64_t i, const double *derivs, bool meets) noexcept {
        constexpr double stationary = 0x1p-30;
        free_count_ = 0;
        for (int a = 0; a < axes_; ++a) {
            const KnotVector &axis = spline_.axis(a);
            const double t = in_.feet(i, a);
            const auto vanishes = [&] {
                const double *tangent = slope(derivs, a);
                const double length = norm(tangent, dim_);
                return meets || !(std::abs(along(direction_.data(), tangent, length)) > stationary);
            };
            const bool stays = axis.degree() == 0 || is_end(axis, t);
            if (!stays && (!may_hold_foot(axis, t) || vanishes())) {
                free_[static_cast<size_t>(free_count_++)] = a;
            }
        }
        return free_count_;
    }

    // <x, y / length>; 0 if length is 0.
    [[nodiscard]] double along(const double *x, const double *y, double length) const noexcept {
        double sum = 0;
        for (int c = 0; c < dim_ && length > 0; ++c) {
            sum += x[c] * (y[c] / length);
        }
        return sum;
    }

    // Computes s_a and C_a / s_a for the free axes.
    void find_tangents(const double *derivs) noexcept {
        for (size_t f = 0; f < static_cast<size_t>(free_count_); ++f) {
            const double *own = slope(derivs, free_[f]);
            sizes_[f] = std::hypot(norm(own, dim_), mean(norm(second(derivs, free_[f], free_[f]), dim_)));
            for (int c = 0; c < dim_; ++c) {
                tangent(f)[c] = own[c] / sizes_[f];
            }
        }
    }
    [[nodiscard]] double *tangent(size_t f) noexcept {
        return tangents_.data() + f * static_cast<size_t>(dim_);
    }
    // The geometric mean of the distance and another length.
    [[nodiscard]] double mean(double length) const noexcept {
        return std::sqrt(distance_) * std::sqrt(length);
    }

    // H_ab / (s_a s_b).
    [[nodiscard]] double entry(const double *derivs, size_t f, size_t g) noexcept {
        const double *both = second(derivs, free_[f], free_[g]);
        const double length = norm(both, dim_), size = mean(length);
        return dot(tangent(f), tangent(g), dim_) +
               along(direction_.data(), both, length) * (size / sizes_[f]) * (size / sizes_[g]);
    }

    // Solves for lambda_a s_a; false if the equations are singular to rounding.
    bool find_lambda(int64_t i, const double *derivs, AxisVector &lambda) noexcept {
        const auto n = static_cast<size_t>(free_count_);
        AxisMatrix matrix{};
        AxisVector right{};
        for (size_t f = 0; f < n; ++f) {
            if (!(sizes_[f] > 0)) {
                return false;
            }
            right[f] = -cotangent_of(i, f);
            for (size_t g = 0; g < n; ++g) {
                matrix[f][g] = entry(derivs, f, g);
            }
        }
        return solve(free_count_, matrix, right, lambda);
    }

    // (g_u + <g_f, C_a>) / s_a.
    [[nodiscard]] double cotangent_of(int64_t i, size_t f) noexcept {
        double sum = value(in_.params, i, free_[f]) / sizes_[f];
        for (int c = 0; c < dim_; ++c) {
            sum += value(in_.points, i, c) * tangent(f)[c];
        }
        return sum;
    }

    static bool solve(int n, const AxisMatrix &matrix, const AxisVector &right, AxisVector &lambda) noexcept {
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
            for (size_t c = 0; c < static_cast<size_t>(n); ++c) {
                lambda[r] += (*solved)[r][c] * right[c];
            }
        }
        return true;
    }

    void write(int64_t i, double of_distance, const AxisVector &lambda) noexcept {
        double *out = cotangents_.data() + i * width_;
        for (int c = 0; c < dim_; ++c) {
            const double unit = direction_[static_cast<size_t>(c)];
            double moved = of_distance * unit;
            for (size_t f = 0; f < static_cast<size_t>(free_count_); ++f) {
                moved += lambda[f] * tangent(f)[c];
                out[(1 + free_[f]) * dim_ + c] = lambda[f] * (distance_ / sizes_[f]) * unit;
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
    std::vector<double> direction_; // r / |r|, with |r| in distance_
    double distance_ = 0;
    int free_count_ = 0;
    std::array<int, max_axes> free_{}; // the first free_count_ entries are the free axes
    AxisVector sizes_{};               // s_a of each free axis
    std::vector<double> tangents_;     // C_a / s_a of each free axis, [dim]
    std::vector<double> hulls_;        // sizes of the control points that are active at each foot
    std::vector<double> cotangents_;   // [count][1 + axes][dim]; 0 where the foot is not determined
    std::vector<double> queries_;      // [count][dim]
    std::vector<int32_t> status_;
};

} // namespace

void closest_adjoint(const Spline &spline, const eval::AxisRules &rules, const FootCotangents &in,
                     const FootGradients &out) {
    ClosestAdjoint adjoint(spline, rules, in);
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
