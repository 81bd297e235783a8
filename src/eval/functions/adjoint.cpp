// SPDX-License-Identifier: MIT
#include "eval/functions/adjoint.h"

#include "eval/blocks.h"
#include "eval/evaluate.h"
#include "eval/functions/spread.h"
#include "eval/kernels/leibniz.h"
#include "spline/at_origin.h"

#include <cmath>

namespace nrb::eval {

namespace {

Orders highest_orders(const Spline &spline, int order) noexcept {
    Orders orders{};
    std::fill_n(orders.begin(), spline.axes(), order);
    return orders;
}

// A point and its derivatives up to `order` come from the homogeneous ones A^(b) = sum of N_i^(b) w_i P_i and
// w^(b) = sum of N_i^(b) w_i by the quotient rule. In reverse, with q = 1 / w(t) and cotangents g_s:
//   dL/dA^(b) = sum over s >= b of binomial(s, b) q^(s-b) g_s,
//   dL/dw^(b) = -(sum over s >= b of binomial(s, b) q^(s-b) h_s),
//   h_b       = sum over s >= b of binomial(s, b) <g_s, C^(s-b)>,
// because dC = q (dA - C dw), differentiated by Leibniz' rule. The sums over the active points transposed
// give X_i = dL/d(w_i P_i) and Y_i = -dL/dw_i at fixed w_i P_i, hence dL/dP_i = w_i X_i and dL/dw_i = <P_i,
// X_i> - Y_i.
class Adjoint final : public BlockSink {
public:
    Adjoint(const Spline &stored, const AxisRules &rules, int order, ConstRecords params,
            ConstRecords cotangents, bool accumulate, const Gradients &gradients)
        : stored_(stored), spline_(at_origin(stored)), rules_(rules), order_(order), params_(params),
          cotangents_(cotangents), accumulate_(accumulate), gradients_(gradients),
          weighted_(gradients.weights.data != nullptr), width_(stored.dim() + (weighted_ ? 1 : 0)),
          active_(stored.knot_vectors(), rules, highest_orders(stored, order)),
          reciprocal_(stored.axes(), order), spread_(active_, stored.axes(), order, width_),
          products_(static_cast<size_t>(slot_count(stored.axes(), order))),
          homogeneous_(products_.size() * static_cast<size_t>(width_)) {}
    virtual ~Adjoint() = default;

    void run() {
        if (params_.count == 0) {
            return start();
        }
        if (weighted_ || gradients_.params.data != nullptr) {
            const int order = order_ + (gradients_.params.data != nullptr ? 1 : 0);
            find_local_points();
            return evaluate_points(stored_, rules_, order, params_, *this);
        }
        start();
        for (int64_t i = 0; i < params_.count; ++i) {
            add_to_net(i, {}, 0);
        }
    }

    void operator()(int64_t first, ConstRecords derivs) noexcept override {
        if (first == 0) {
            start();
        }
        for (int64_t i = 0; i < derivs.count; ++i) {
            add_to_params(first + i, derivs, i);
            add_to_net(first + i, derivs, i);
        }
    }

private:
    [[nodiscard]] double cotangent(int64_t i, int64_t slot, int c) const noexcept {
        return cotangents_(i, slot * spline_.dim() + c);
    }
    // <cotangent of a slot of parameter i, derivative in another slot of record `row`>
    [[nodiscard]] double product(int64_t i, int64_t slot, ConstRecords derivs, int64_t row,
                                 int64_t other) const noexcept {
        double sum = 0;
        for (int c = 0; c < spline_.dim(); ++c) {
            const double derivative = other == 0 && !local_points_.empty()
                                          ? local_points_[static_cast<size_t>(i * spline_.dim() + c)]
                                          : derivs(row, other * spline_.dim() + c);
            sum += cotangent(i, slot, c) * derivative;
        }
        return sum;
    }

    // Derivatives are those of nurbs_eval_derivs(); the products of weights need points relative to the
    // origin of the moved spline.
    void find_local_points() {
        if (weighted_ && &spline_ != &stored_) {
            const int dim = spline_.dim();
            local_points_.resize(static_cast<size_t>(params_.count * dim));
            evaluate_points(spline_, rules_, 0, params_,
                            Records{local_points_.data(), params_.count, dim, dim, 1});
        }
    }

    void start() const noexcept {
        for (const Records &out : {gradients_.points, gradients_.weights, gradients_.params}) {
            for (int64_t i = 0; i < out.count && !accumulate_; ++i) {
                for (int64_t c = 0; c < out.width; ++c) {
                    out(i, c) = 0;
                }
            }
        }
    }

    // Whether the value does not depend on parameter (i, k), because that was moved to an end of the domain.
    [[nodiscard]] bool clamped(int64_t i, int k) const noexcept {
        const Interval domain = spline_.axis(k).domain();
        const double t = params_(i, k);
        return rules_[static_cast<size_t>(k)].outside == Outside::clamp &&
               (t < domain.lower || t > domain.upper);
    }
    [[nodiscard]] bool has_value(int64_t i) const noexcept {
        bool valid = true;
        for (int k = 0; k < spline_.axes(); ++k) {
            const AxisRule &rule = rules_[static_cast<size_t>(k)];
            valid = valid && !std::isnan(place(params_(i, k), rule, spline_.axis(k).domain()));
        }
        return valid;
    }

    void add_to_params(int64_t i, ConstRecords derivs, int64_t row) const noexcept {
        const int axes = spline_.axes();
        for (int k = 0; k < axes && gradients_.params.data != nullptr; ++k) {
            if (clamped(i, k) && has_value(i)) {
                continue;
            }
            double sum = 0;
            for_each_slot(axes, order_, [&](int x, int y, int z) {
                Orders next{x, y, z};
                const int64_t own = slot(axes, next);
                ++next[static_cast<size_t>(k)];
                sum += product(i, own, derivs, row, slot(axes, next));
            });
            gradients_.params(i, k) += sum;
        }
    }

    void add_to_net(int64_t i, ConstRecords derivs, int64_t row) noexcept {
        const bool wanted = weighted_ || gradients_.points.data != nullptr;
        if (!wanted || !active_.locate(params_, i)) {
            return;
        }
        if (weighted_) {
            find_products(i, derivs, row);
        }
        if (spline_.rational()) {
            find_reciprocal();
            divide_cotangents(i);
        } else {
            copy_cotangents(i);
        }
        scatter(spread_(homogeneous_.data()));
    }

    // h_b for all slots b.
    void find_products(int64_t i, ConstRecords derivs, int64_t row) noexcept {
        const int axes = spline_.axes();
        std::fill(products_.begin(), products_.end(), 0.0);
        for_each_slot(axes, order_, [&](int x, int y, int z) {
            const Orders s{x, y, z};
            const int64_t own = slot(axes, s);
            reciprocal_.leibniz().for_each(s, [&](const Orders &b, const Orders &rest, double factor) {
                products_[static_cast<size_t>(slot(axes, b))] +=
                    factor * product(i, own, derivs, row, slot(axes, rest));
            });
        });
    }

    void find_reciprocal() noexcept {
        for_each_slot(spline_.axes(), order_, [&](int x, int y, int z) {
            double weight = 0;
            active_.for_each({x, y, z},
                             [&](int64_t point, double value) { weight += value * spline_.weight(point); });
            reciprocal_.add({x, y, z}, weight);
        });
    }

    void divide_cotangents(int64_t i) noexcept {
        const int axes = spline_.axes();
        std::fill(homogeneous_.begin(), homogeneous_.end(), 0.0);
        for_each_slot(axes, order_, [&](int x, int y, int z) {
            const Orders s{x, y, z};
            const int64_t own = slot(axes, s);
            reciprocal_.leibniz().for_each(s, [&](const Orders &b, const Orders &rest, double binomial) {
                add_cotangent(i, own, binomial * reciprocal_[rest],
                              homogeneous_.data() + slot(axes, b) * width_);
            });
        });
    }

    // Weights of 1 need no division.
    void copy_cotangents(int64_t i) noexcept {
        double *out = homogeneous_.data();
        for (int64_t s = 0; s < std::ssize(products_); ++s) {
            for (int c = 0; c < spline_.dim(); ++c) {
                *out++ = cotangent(i, s, c);
            }
            if (weighted_) {
                *out++ = products_[static_cast<size_t>(s)];
            }
        }
    }

    void add_cotangent(int64_t i, int64_t slot, double factor, double *out) const noexcept {
        const int dim = spline_.dim();
        for (int c = 0; c < dim; ++c) {
            out[c] += factor * cotangent(i, slot, c);
        }
        if (weighted_) {
            out[dim] += factor * products_[static_cast<size_t>(slot)];
        }
    }

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
            window += width_;
        });
    }

    [[nodiscard]] double weight_gradient(int64_t point, const double *window) const noexcept {
        double sum = -window[spline_.dim()];
        for (int c = 0; c < spline_.dim(); ++c) {
            sum += spline_.coordinate(point, c) * window[c];
        }
        return sum;
    }

    const Spline &stored_;
    const Spline &spline_; // at the origin: a gradient does not depend on where the shape lies
    const AxisRules &rules_;
    int order_;
    ConstRecords params_;
    ConstRecords cotangents_;
    bool accumulate_;
    Gradients gradients_;
    bool weighted_;
    int64_t width_;
    ActivePoints active_;
    Reciprocal reciprocal_;
    Spread spread_;
    std::vector<double> local_points_; // of the moved spline, empty if it is the stored one
    std::vector<double> products_;     // h_b, [slots]
    std::vector<double> homogeneous_;  // [slots][width]: dL/dA^(b), and -dL/dw^(b) if weights are wanted
};

} // namespace

void evaluate_adjoint(const Spline &spline, const AxisRules &rules, int order, ConstRecords params,
                      ConstRecords cotangents, bool accumulate, const Gradients &gradients) {
    Adjoint(spline, rules, order, params, cotangents, accumulate, gradients).run();
}

} // namespace nrb::eval
