// SPDX-License-Identifier: MIT
#include "eval/adjoint/homogeneous_cotangents.h"
#include "eval/adjoint/net_gradients.h"
#include "eval/adjoint/spread.h"
#include "eval/blocks.h"
#include "eval/evaluate.h"
#include "spline/at_origin.h"

#include <cmath>
#include <vector>

namespace nrb::eval {

namespace {

// The adjoint for derivatives of any order. The transposed sums over the active control points give X_i =
// dL/d(w_i P_i) and Y_i = -dL/dw_i at fixed w_i P_i. Hence dL/dP_i = w_i X_i and, at fixed P_i, dL/dw_i =
// <P_i, X_i> - Y_i.
class DerivativesAdjoint final : public BlockSink {
public:
    DerivativesAdjoint(const Cotangents &from, const Gradients &gradients)
        : from_(from), spline_(at_origin(from.spline)), gradients_(gradients),
          weighted_(gradients.weights.data != nullptr),
          active_(from.spline.knot_vectors(), from.rules, highest_orders(from.spline, from.order)),
          homogeneous_(spline_, active_, from.order, from.values, weighted_),
          spread_(active_, spline_.axes(), from.order, homogeneous_.width()) {}
    virtual ~DerivativesAdjoint() = default;

    void run() {
        const bool slopes = gradients_.params.data != nullptr;
        if (from_.params.count > 0 && (weighted_ || slopes)) {
            find_local_points();
            return evaluate_points(from_.spline, from_.rules, from_.order + (slopes ? 1 : 0), from_.params,
                                   *this);
        }
        start();
        for (int64_t i = 0; i < from_.params.count; ++i) {
            add_to_net(i, {});
        }
    }

    void operator()(int64_t first, ConstRecords derivs) noexcept override {
        if (first == 0) {
            start();
        }
        for (int64_t i = 0; i < derivs.count; ++i) {
            add_to_params(first + i, derivs, i);
            add_to_net(first + i, {derivs, i, local_point(first + i)});
        }
    }

private:
    // The sink receives the derivatives that nurbs_eval_derivs() returns, with points of the stored spline.
    // Gradients of weights need points relative to the origin of the moved spline instead.
    void find_local_points() {
        if (weighted_ && &spline_ != &from_.spline) {
            const int dim = spline_.dim();
            local_points_.resize(static_cast<size_t>(from_.params.count * dim));
            evaluate_points(spline_, from_.rules, 0, from_.params,
                            Records{local_points_.data(), from_.params.count, dim, dim, 1});
        }
    }
    [[nodiscard]] const double *local_point(int64_t i) const noexcept {
        return local_points_.empty() ? nullptr : local_points_.data() + i * spline_.dim();
    }

    // Clears the outputs unless gradients are accumulated. Nothing fails after this.
    void start() const noexcept {
        if (!from_.accumulate) {
            clear(gradients_.points);
            clear(gradients_.weights);
            clear(gradients_.params);
        }
    }

    [[nodiscard]] bool has_value(int64_t i) const noexcept {
        bool valid = true;
        for (int k = 0; k < spline_.axes(); ++k) {
            const AxisRule &rule = from_.rules[static_cast<size_t>(k)];
            valid = valid && !std::isnan(place(from_.params(i, k), rule, spline_.axis(k).domain()));
        }
        return valid;
    }

    // Adds <cotangents, derivatives one order higher along axis k> to the gradient of parameter (i, k).
    void add_to_params(int64_t i, ConstRecords derivs, int64_t row) const noexcept {
        for (int k = 0; k < spline_.axes() && gradients_.params.data != nullptr; ++k) {
            if (!clamped(from_, i, k) || !has_value(i)) {
                gradients_.params(i, k) += slope(i, k, derivs, row);
            }
        }
    }
    [[nodiscard]] double slope(int64_t i, int k, ConstRecords derivs, int64_t row) const noexcept {
        const int axes = spline_.axes(), dim = spline_.dim();
        double sum = 0;
        for_each_slot(axes, from_.order, [&](int x, int y, int z) {
            Orders next{x, y, z};
            const int64_t own = slot(axes, next);
            ++next[static_cast<size_t>(k)];
            const int64_t other = slot(axes, next);
            double product = 0;
            for (int c = 0; c < dim; ++c) {
                product += from_.values(i, own * dim + c) * derivs(row, other * dim + c);
            }
            sum += product;
        });
        return sum;
    }

    void add_to_net(int64_t i, const PointDerivs &derivs) noexcept {
        const bool wanted = weighted_ || gradients_.points.data != nullptr;
        if (wanted && active_.locate(from_.params, i)) {
            scatter(spread_(homogeneous_(i, derivs)));
        }
    }

    // Adds the contributions of one parameter to the gradients of its active control points.
    void scatter(const double *window) const noexcept {
        const Records &points = gradients_.points;
        const int dim = spline_.dim();
        active_.for_each([&](int64_t point, double) {
            if (points.data != nullptr) {
                const double weight = spline_.weight(point);
                double *out = points.record(point);
                for (int c = 0; c < dim; ++c) {
                    *out += weight * window[c];
                    out += points.component_stride;
                }
            }
            if (weighted_) {
                gradients_.weights(point, 0) += weight_gradient(point, window);
            }
            window += homogeneous_.width();
        });
    }

    [[nodiscard]] double weight_gradient(int64_t point, const double *window) const noexcept {
        double sum = -window[spline_.dim()];
        for (int c = 0; c < spline_.dim(); ++c) {
            sum += spline_.coordinate(point, c) * window[c];
        }
        return sum;
    }

    Cotangents from_;
    const Spline &spline_; // moved to the origin: gradients do not depend on the position
    Gradients gradients_;
    bool weighted_;
    ActivePoints active_;
    HomogeneousCotangents homogeneous_;
    Spread spread_;
    std::vector<double> local_points_; // of the moved spline; empty if it is the stored one
};

} // namespace

void derivatives_adjoint(const Cotangents &from, const Gradients &out) {
    DerivativesAdjoint(from, out).run();
}

} // namespace nrb::eval
