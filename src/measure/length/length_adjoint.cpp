// SPDX-License-Identifier: MIT
#include "measure/length/length_adjoint.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/adjoint/adjoint.h"
#include "eval/evaluate.h"
#include "numeric/nested_rule.h"
#include "numeric/norm.h"
#include "spline/active_part.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

constexpr int low_level = 2, high_level = 3; // 15 and 31 nodes
constexpr int most_halvings = 60;
constexpr int64_t halvings_for_a_span = 2; // per span, in addition to as many as take a second
constexpr double rounding = 64 * eps;
// The largest error that is accepted for a tolerance below rounding, which requests the best that can be had.
constexpr double loosest = 1e-3;

// The result of a rule on a part of a span.
struct RuleGradient {
    std::vector<double> points;
    std::vector<double> weights;
    double length = 0;
    double least_cosine = 1; // of the angles between tangents at neighbouring nodes
};

// The largest magnitudes in a result, or in the difference of two, for dL/dP_i and for w_i dL/dw_i.
struct Scale {
    double points = 0;
    double weights = 0;
};

class SpanGradients {
public:
    SpanGradients(const Spline &curve, int64_t span, bool weights)
        : curve_(active_part(curve, {span})), count_(curve_->point_count()), dim_(curve_->dim()),
          weights_(weights) {}

    [[nodiscard]] int64_t count() const noexcept { return count_; }
    [[nodiscard]] double weight(int64_t i) const noexcept { return curve_->weight(i); }
    // The work of both rules on one part.
    [[nodiscard]] int64_t work_of_a_part() const noexcept {
        return work_of(rule_size(low_level) + rule_size(high_level) + 4);
    }

    // The integral over a part by the nodes of a level.
    [[nodiscard]] RuleGradient rule(Interval part, int level) const {
        const int n = rule_size(level), all = n + 2; // with the ends, whose tangents are compared, too
        count_work(work_of(all));
        std::vector<double> params(static_cast<size_t>(all), part.lower);
        params.back() = part.upper;
        for (int i = 0; i < n; ++i) {
            params[static_cast<size_t>(i) + 1] = std::clamp(
                part.lower * rule_rests()[i] + part.upper * rule_places()[i], part.lower, part.upper);
        }
        const int64_t width = 2 * int64_t{dim_};
        const ConstRecords at{params.data(), all, 1, 1, 1};
        std::vector<double> derivs(static_cast<size_t>(all * width));
        eval::evaluate_points(*curve_, {}, 1, at, {derivs.data(), all, width, width, 1});
        RuleGradient result{std::vector<double>(static_cast<size_t>(count_ * dim_)),
                            std::vector<double>(static_cast<size_t>(weights_ ? count_ : 0))};
        result.least_cosine = least_cosine(derivs);
        for (int i = 0; i < all; ++i) {
            const double weight = i == 0 || i > n ? 0 : rule_weights(level)[i - 1];
            result.length += make_cotangent(derivs.data() + i * width, weight * (part.upper - part.lower));
        }
        const Records weights = weights_ ? Records{result.weights.data(), count_, 1, 1, 1} : Records{};
        eval::evaluate_adjoint(*curve_, {}, 1, at, {derivs.data(), all, width, width, 1}, false,
                               {{result.points.data(), count_, dim_, dim_, 1}, weights, {}});
        return result;
    }

    [[nodiscard]] Scale size(const RuleGradient &a, const RuleGradient *minus = nullptr) const noexcept {
        Scale scale;
        for (size_t i = 0; i < a.points.size(); ++i) {
            const double other = minus == nullptr ? 0 : minus->points[i];
            scale.points = std::max(scale.points, std::abs(a.points[i] - other));
        }
        for (size_t i = 0; i < a.weights.size(); ++i) {
            const double other = minus == nullptr ? 0 : minus->weights[i];
            const double w = std::abs(weight(static_cast<int64_t>(i)));
            scale.weights = std::max(scale.weights, w * std::abs(a.weights[i] - other));
        }
        return scale;
    }

private:
    [[nodiscard]] int64_t work_of(int64_t places) const noexcept {
        return places * (400 + count_ * ((dim_ + 1) * 24 + 12 * count_));
    }
    // The smallest cosine between derivatives at neighbouring nodes; a derivative that vanishes has no
    // direction and does not count.
    [[nodiscard]] double least_cosine(const std::vector<double> &derivs) const noexcept {
        double least = 1;
        const double *before = derivs.data() + dim_;
        for (const double *next = before + 2 * dim_; next < derivs.data() + derivs.size(); next += 2 * dim_) {
            const double size = norm(next, dim_), other = norm(before, dim_);
            double cosine = 0;
            for (int c = 0; c < dim_; ++c) {
                cosine += next[c] / size * (before[c] / other);
            }
            least = size > 0 && other > 0 ? std::min(least, cosine) : least;
            before = next;
        }
        return least;
    }
    // Replaces the point by the cotangent 0 and the derivative by `factor` T; returns the contribution to the
    // length.
    double make_cotangent(double *derivs, double factor) const noexcept {
        double *derivative = derivs + dim_;
        const double speed = norm(derivative, dim_);
        for (int c = 0; c < dim_; ++c) {
            derivs[c] = 0;
            derivative[c] = speed > 0 ? factor * (derivative[c] / speed) : 0;
        }
        return factor * speed;
    }

    SplinePtr curve_;
    int64_t count_;
    int dim_;
    bool weights_;
};

// Sums the gradients of the spans in the range to those of the whole curve.
class LengthAdjoint {
public:
    LengthAdjoint(const Spline &curve, Interval range, double tolerance, bool weights)
        : curve_(curve), range_(range), tolerance_(std::max(tolerance, rounding)), weights_(weights),
          errors_(static_cast<size_t>(curve.point_count())) {
        result_.points.resize(static_cast<size_t>(curve.point_count() * curve.dim()));
        result_.weights.resize(weights ? errors_.size() : 0);
    }

    LengthGradient run() {
        find_sizes();
        for_each_span([&](int64_t span, Interval part) { run_span(span, part); });
        for (const double error : errors_) {
            result_.error = std::max(result_.error, error);
        }
        result_.error += rounding;
        return std::move(result_);
    }

private:
    template <class Visit>
    void for_each_span(Visit &&visit) const {
        const KnotVector &axis = curve_.axis(0);
        for (const int64_t span : axis.spans().indices()) {
            const Interval part{std::max(axis[span], range_.lower), std::min(axis[span + 1], range_.upper)};
            if (part.lower < part.upper) {
                visit(span, part);
            }
        }
    }

    // Rough values of the sizes that errors are relative to, and the budget.
    void find_sizes() {
        std::vector<double> points(result_.points.size());
        int64_t work_of_a_part = 1;
        for_each_span([&](int64_t span, Interval part) {
            const SpanGradients gradients(curve_, span, weights_);
            const RuleGradient found = gradients.rule(part, low_level);
            add(found.points, (span - curve_.axis(0).degree()) * curve_.dim(), points);
            length_ += found.length;
            budget_ += halvings_for_a_span;
            work_of_a_part = gradients.work_of_a_part();
        });
        for (int64_t i = 0; i < curve_.point_count(); ++i) {
            longest_ = std::max(longest_, norm(points.data() + i * curve_.dim(), curve_.dim()));
        }
        budget_ += usual_work(0) / work_of_a_part;
    }

    static void add(const std::vector<double> &from, int64_t first, std::vector<double> &to) noexcept {
        for (size_t i = 0; i < from.size(); ++i) {
            to[static_cast<size_t>(first) + i] += from[i];
        }
    }

    [[nodiscard]] double relative(Scale scale) const noexcept {
        return std::max(longest_ > 0 ? scale.points / longest_ : 0,
                        length_ > 0 ? scale.weights / length_ : 0);
    }

    struct GradientPart {
        Interval part;
        int halvings;
    };

    // The doubt about a rule: no rule detects a near cusp between two nodes, but the tangents on its two
    // sides differ. The error may then be as large as the contribution of the part itself.
    [[nodiscard]] double doubt(const SpanGradients &gradients, const RuleGradient &found) const noexcept {
        constexpr double calm = 0.75;
        return found.least_cosine >= calm ? 0 : 2 * relative(gradients.size(found));
    }

    // The error in one span affects the gradients of p + 1 control points, each of which has p + 1 spans.
    void run_span(int64_t span, Interval whole) {
        const SpanGradients gradients(curve_, span, weights_);
        const double allowed = tolerance_ / (2 * static_cast<double>(gradients.count()));
        std::vector<GradientPart> parts{{whole, 0}};
        while (!parts.empty()) {
            const GradientPart next = parts.back();
            parts.pop_back();
            const RuleGradient low = gradients.rule(next.part, low_level);
            const RuleGradient high = gradients.rule(next.part, high_level);
            const double differ = relative(gradients.size(high, &low)), doubtful = doubt(gradients, high);
            const double error = std::max(differ, doubtful);
            const double middle = next.part.lower / 2 + next.part.upper / 2;
            const bool good =
                error <= allowed || (doubtful == 0 && differ <= rounding * relative(gradients.size(high)));
            const bool may_halve = next.halvings < most_halvings && middle > next.part.lower &&
                                   middle < next.part.upper && --budget_ >= 0;
            if (good || !may_halve) {
                accept(span, high, good && doubtful == 0 ? std::min(error, allowed / 16) : error);
            } else {
                parts.push_back({{middle, next.part.upper}, next.halvings + 1});
                parts.push_back({{next.part.lower, middle}, next.halvings + 1});
            }
        }
    }

    void accept(int64_t span, const RuleGradient &found, double error) {
        const int64_t first = span - curve_.axis(0).degree();
        add(found.points, first * curve_.dim(), result_.points);
        add(found.weights, first, result_.weights);
        for (int64_t i = first; i <= span; ++i) {
            errors_[static_cast<size_t>(i)] += error;
        }
    }

    const Spline &curve_;
    Interval range_;
    double tolerance_;
    bool weights_;
    std::vector<double> errors_; // of the gradient for each control point
    LengthGradient result_;
    double longest_ = 0;
    double length_ = 0;
    int64_t budget_ = 0; // halvings that are left
};

} // namespace

LengthGradient length_gradient(const Spline &curve, Interval range, double relative_tolerance, bool weights) {
    LengthGradient result = LengthAdjoint(curve, range, relative_tolerance, weights).run();
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::all_of(result.points.begin(), result.points.end(), finite) ||
        !std::all_of(result.weights.begin(), result.weights.end(), finite)) {
        fail(Status::not_representable, "the gradient of the length overflows");
    }
    const double asked = relative_tolerance < rounding ? loosest : relative_tolerance;
    if (!(result.error <= 2 * asked + 2 * rounding)) {
        fail(Status::not_converged,
             "gradient of the length: the error reached is %s, expected relative_tolerance = %s",
             Number(result.error).text, Number(relative_tolerance).text);
    }
    return result;
}

} // namespace nrb::measure
