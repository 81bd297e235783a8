// SPDX-License-Identifier: MIT
#include "eval/adjoint/knot_adjoint.h"

#include "basis/bspline.h"
#include "eval/adjoint/homogeneous_cotangents.h"
#include "eval/adjoint/net_gradients.h"
#include "eval/blocks.h"
#include "spline/at_origin.h"
#include "spline/axis_view.h"

#include <vector>

namespace nrb::eval {

namespace {

// The adjoint of evaluation with respect to the knots of one axis. Let A = sum of A_i N_i be a B-spline along
// the axis, s the span of the parameter, and n_i the basis functions over the knots into which t_k was
// inserted once more. Then (D. Jupp, "Approximation to data by splines with free knots", SIAM J. Numer. Anal.
// 15 (1978))
//   dA/dt_k = -(sum over i = k - p, ..., k of (A_i - A_(i-1)) / (t_(i+p) - t_i) n_i).
// On the span only the terms i = s - p + 1, ..., s differ from 0. For these t_i <= t_s < t_(s+1) <= t_(i+p),
// so that no divisor is 0, whatever the multiplicities of the knots.
class KnotAdjoint final : public BlockSink {
public:
    KnotAdjoint(const Spline &stored, int axis, const AxisRules &rules, int order, ConstRecords params,
                ConstRecords cotangents, bool accumulate, Records grad_knots)
        : spline_(at_origin(stored)), axis_(static_cast<size_t>(axis)), knots_(stored.axis(axis)),
          degree_(knots_.degree()), rules_(rules), order_(order), params_(params), accumulate_(accumulate),
          grad_knots_(grad_knots), active_(stored.knot_vectors(), rules, highest_orders(stored, order)),
          homogeneous_(spline_, active_, order, cotangents, stored.rational()),
          stride_(axis_view(stored, axis, 1).inner), slopes_(size_of_rows()), functions_(size_of_rows()),
          window_(2 * static_cast<size_t>(degree_) + 1) {}
    virtual ~KnotAdjoint() = default;

    // Points, relative to the origin of the moved spline, and derivatives are needed for the quotient rule
    // only.
    void run() {
        if (params_.count > 0 && spline_.rational()) {
            return evaluate_points(spline_, rules_, order_, params_, *this);
        }
        start();
        for (int64_t i = 0; i < params_.count; ++i) {
            add(i, {});
        }
    }

    void operator()(int64_t first, ConstRecords derivs) noexcept override {
        if (first == 0) {
            start();
        }
        for (int64_t i = 0; i < derivs.count; ++i) {
            add(first + i, {derivs, i});
        }
    }

private:
    [[nodiscard]] size_t size_of_rows() const noexcept {
        return static_cast<size_t>(order_ + 1) * static_cast<size_t>(degree_ + 1);
    }

    void start() const noexcept {
        if (!accumulate_) {
            clear(grad_knots_);
        }
    }

    // Adds the contributions of parameter i.
    void add(int64_t i, const PointDerivs &derivs) noexcept {
        if (degree_ == 0 || !active_.locate(params_, i)) {
            return;
        }
        find_slopes(homogeneous_(i, derivs));
        const double t = place(params_(i, static_cast<int64_t>(axis_)), rules_[axis_], knots_.domain());
        const int64_t span = active_.span(axis_);
        for (int64_t k = span - degree_ + 1; k <= span + degree_; ++k) {
            grad_knots_(k, 0) -= sum_of_knot(k, span, t);
        }
    }

    // Computes slopes_[a][j], j = 1, ..., p: the products of the cotangents with (A_i - A_(i-1)) / (t_(i+p) -
    // t_i) for layer i = s - p + j, summed over all derivatives whose order along the axis is a.
    void find_slopes(const double *cotangents) noexcept {
        std::fill(slopes_.begin(), slopes_.end(), 0.0);
        for_each_slot(spline_.axes(), order_, [&](int x, int y, int z) {
            const Orders orders{x, y, z};
            add_slopes(orders, cotangents + slot(spline_.axes(), orders) * homogeneous_.width(),
                       slopes_.data() + orders[axis_] * (degree_ + 1));
        });
        const double *knots = knots_.knots().data() + active_.span(axis_) - degree_;
        for (int a = 0; a <= order_; ++a) {
            for (int j = 1; j <= degree_; ++j) {
                slopes_[static_cast<size_t>(a * (degree_ + 1) + j)] /= knots[j + degree_] - knots[j];
            }
        }
    }

    void add_slopes(const Orders &orders, const double *cotangent, double *slopes) const noexcept {
        std::array<int, max_axes> place{};
        active_.for_each(orders, [&](int64_t point, double) {
            if (place[axis_] > 0) {
                slopes[place[axis_]] += factor(orders, place) * difference(point, cotangent);
            }
            advance(place);
        });
    }
    // The product of the functions of the other axes at an active control point.
    [[nodiscard]] double factor(const Orders &orders, const std::array<int, max_axes> &place) const noexcept {
        double product = 1;
        for (size_t k = 0; k < max_axes; ++k) {
            product *= k == axis_ ? 1 : active_.functions(k, orders[k])[place[k]];
        }
        return product;
    }
    // Advances to the next active control point, the last axis fastest.
    void advance(std::array<int, max_axes> &place) const noexcept {
        for (size_t k = max_axes; k-- > 0;) {
            if (++place[k] <= active_.degree(k)) {
                return;
            }
            place[k] = 0;
        }
    }
    // <cotangent, A_i - A_(i-1)> for control point i and its predecessor along the axis.
    [[nodiscard]] double difference(int64_t point, const double *cotangent) const noexcept {
        double sum = 0;
        for (int c = 0; c < spline_.dim(); ++c) {
            sum += cotangent[c] * (component(point, c) - component(point - stride_, c));
        }
        if (spline_.rational()) {
            sum -= cotangent[spline_.dim()] * (spline_.weight(point) - spline_.weight(point - stride_));
        }
        return sum;
    }
    [[nodiscard]] double component(int64_t point, int c) const noexcept {
        const double stored = spline_.points()[static_cast<size_t>(point * spline_.stored_width() + c)];
        return spline_.form() == Form::rational ? spline_.weight(point) * stored : stored;
    }

    // The sum over i of slope i times n_i and its derivatives, for the knot t_k. If t_k precedes the
    // parameter, the inserted copy shifts the span by one.
    [[nodiscard]] double sum_of_knot(int64_t k, int64_t span, double t) noexcept {
        const int64_t first = span - degree_ + (k <= span ? 1 : 0); // the first of p + 1 functions
        for (int64_t j = 0; j <= 2 * degree_; ++j) {
            window_[static_cast<size_t>(j)] = knots_[first + j <= k ? first + j : first + j - 1];
        }
        basis_derivs(window_.data(), degree_, degree_, t, order_, functions_.data());
        double sum = 0;
        for (int a = 0; a <= order_; ++a) {
            const auto row = static_cast<size_t>(a * (degree_ + 1));
            for (int64_t i = std::max(k - degree_, span - degree_ + 1); i <= std::min(k, span); ++i) {
                sum += slopes_[row + static_cast<size_t>(i - (span - degree_))] *
                       functions_[row + static_cast<size_t>(i - first)];
            }
        }
        return sum;
    }

    const Spline &spline_; // moved to the origin: gradients do not depend on the position
    size_t axis_;
    const KnotVector &knots_;
    int degree_;
    const AxisRules &rules_;
    int order_;
    ConstRecords params_;
    bool accumulate_;
    Records grad_knots_;
    ActivePoints active_;
    HomogeneousCotangents homogeneous_;
    int64_t stride_;                // between neighbouring control points along the axis
    std::vector<double> slopes_;    // [order + 1][p + 1]
    std::vector<double> functions_; // [order + 1][p + 1]
    std::vector<double> window_;    // the knots that functions_ depends on
};

} // namespace

void evaluate_knot_adjoint(const Spline &spline, int axis, const AxisRules &rules, int order,
                           ConstRecords params, ConstRecords cotangents, bool accumulate,
                           Records grad_knots) {
    KnotAdjoint(spline, axis, rules, order, params, cotangents, accumulate, grad_knots).run();
}

} // namespace nrb::eval
