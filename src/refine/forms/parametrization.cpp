// SPDX-License-Identifier: MIT
#include "refine/forms/parametrization.h"

#include "refine/periodic/period.h"
#include "spline/layer_table.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

void check_distinct(std::span<const double> before, std::span<const double> after, int axis) {
    if (!std::all_of(after.begin(), after.end(), [](double t) { return std::isfinite(t); }) ||
        !std::isfinite(after.back() - after.front())) {
        fail(Status::not_representable, "knots of axis %d overflow when they are mapped", axis);
    }
    for (size_t i = 1; i < before.size(); ++i) {
        if (before[i - 1] == before[i] ? after[i - 1] > after[i] : after[i - 1] >= after[i]) {
            fail(Status::knots_merge,
                 "knots[%zu] = %s and knots[%zu] = %s of axis %d would be mapped to %s and %s", i - 1,
                 Number(before[i - 1]).text, i, Number(before[i]).text, axis, Number(after[i - 1]).text,
                 Number(after[i]).text);
        }
    }
}

namespace {

// The affine map of one interval to another. It is computed from the nearer end, so that both ends are exact
// and small distances from an end stay accurate.
class AffineMap {
public:
    AffineMap(Interval from, Interval to) noexcept : from_(from), to_(to) {
        const double before = from.upper - from.lower, after = to.upper - to.lower;
        factor_ = after / before;
        if (!std::isnormal(factor_)) {
            const int of_before = std::ilogb(before), of_after = std::ilogb(after);
            factor_ = std::ldexp(after, -of_after) / std::ldexp(before, -of_before);
            exponent_ = of_after - of_before;
        }
    }

    [[nodiscard]] double operator()(double t) const noexcept {
        const double behind = t - from_.lower;
        const double ahead = from_.upper - t;
        return behind < ahead ? to_.lower + stretched(behind) : to_.upper - stretched(ahead);
    }

private:
    [[nodiscard]] double stretched(double length) const noexcept {
        return std::ldexp(length * factor_, exponent_);
    }

    Interval from_;
    Interval to_;
    double factor_; // times 2^exponent_, which is 1 unless the factor leaves the range of normal doubles
    int exponent_ = 0;
};

std::vector<double> mapped(const KnotVector &axis, int k, std::span<const double> knots, Interval to) {
    const auto p = static_cast<size_t>(axis.degree());
    const auto count = static_cast<size_t>(axis.count());
    const AffineMap map({knots[p], knots[count]}, to);
    std::vector<double> result(knots.size());
    std::transform(knots.begin(), knots.end(), result.begin(), map);
    if (axis.periodic()) {
        continue_knots(result, p, count, count - p);
    }
    check_distinct(knots, result, k);
    return result;
}

Spline::Axes with_knots(const Spline &spline, int k, std::vector<double> knots) {
    const KnotVector &axis = spline.axis(k);
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] =
        std::make_shared<const KnotVector>(axis.degree(), std::move(knots), axis.periodic());
    return axes;
}

void check_domain(Interval domain) {
    if (!std::isfinite(domain.lower) || !std::isfinite(domain.upper)) {
        fail(Status::parameter_not_finite, "[lower, upper] = [%s, %s] is not finite",
             Number(domain.lower).text, Number(domain.upper).text);
    }
    if (domain.lower >= domain.upper) {
        fail(Status::empty_domain, "lower = %s, expected less than upper = %s", Number(domain.lower).text,
             Number(domain.upper).text);
    }
}

} // namespace

std::vector<double> negated(std::span<const double> knots) {
    std::vector<double> result(knots.rbegin(), knots.rend());
    std::transform(result.begin(), result.end(), result.begin(), [](double t) { return -t; });
    return result;
}

SplinePtr reverse(const Spline &spline, int axis, bool keep_domain) {
    const KnotVector &old = spline.axis(axis);
    std::vector<double> knots = negated(old.knots());
    if (keep_domain) {
        knots = mapped(old, axis, knots, old.domain());
    }
    LayerTable table;
    table.reserve(old.count());
    for (int64_t layer = old.count(); layer-- > 0;) {
        table.add_copy(layer);
    }
    Net net = apply_along(spline, axis, table);
    return std::make_shared<const Spline>(with_knots(spline, axis, std::move(knots)), spline.dim(),
                                          spline.form(), std::move(net.points), std::move(net.weights));
}

SplinePtr reparametrize(const SplinePtr &spline, int axis, Interval domain) {
    check_domain(domain);
    const KnotVector &old = spline->axis(axis);
    if (domain.lower == old.domain().lower && domain.upper == old.domain().upper) {
        return spline;
    }
    if (!std::isfinite(domain.upper - domain.lower)) {
        fail(Status::not_representable, "[lower, upper] = [%s, %s] of axis %d is too long",
             Number(domain.lower).text, Number(domain.upper).text, axis);
    }
    std::vector<double> knots = mapped(old, axis, old.knots(), domain);
    return std::make_shared<const Spline>(
        with_knots(*spline, axis, std::move(knots)), spline->dim(), spline->form(),
        std::vector<double>(spline->points().begin(), spline->points().end()),
        std::vector<double>(spline->weights().begin(), spline->weights().end()));
}

} // namespace nrb::refine
