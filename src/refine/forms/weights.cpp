// SPDX-License-Identifier: MIT
#include "refine/forms/weights.h"

#include "base/numbers.h"
#include "basis/bspline.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/knots/axis_table.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace nrb::refine {

namespace {

double dominant_weight(const Spline &spline) noexcept {
    double dominant = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double w = spline.weight(i);
        dominant = std::abs(w) > std::abs(dominant) ? w : dominant;
    }
    return dominant;
}

// The spline with weight i, or every component of homogeneous record i, replaced by map(value, i). Cartesian
// points stay.
template <class Map>
SplinePtr with_weights(const Spline &spline, Spline::Axes axes, Map &&map) {
    std::vector<double> points(spline.points().begin(), spline.points().end());
    std::vector<double> weights(spline.weights().begin(), spline.weights().end());
    if (spline.form() == Form::homogeneous) {
        const auto width = static_cast<size_t>(spline.stored_width());
        for (size_t i = 0; i < points.size(); ++i) {
            points[i] = map(points[i], static_cast<int64_t>(i / width));
        }
    }
    for (size_t i = 0; i < weights.size(); ++i) {
        weights[i] = map(weights[i], static_cast<int64_t>(i));
    }
    return make_result(std::move(axes), spline.dim(), spline.form(), std::move(points), std::move(weights));
}

// The rational linear map of [lower, upper] to itself whose derivative at the lower end is 1 / rho.
class Moebius {
public:
    Moebius(Interval domain, double rho) noexcept
        : domain_(domain), rho_(rho), exponent_(-1 - std::ilogb(length())) {}

    // Whether t lies on the same side of the pole as the domain.
    [[nodiscard]] bool reaches(double t) const noexcept { return terms(t).sum() > 0; }
    [[nodiscard]] double operator()(double t) const noexcept {
        const Terms at = terms(t);
        return at.after < at.ahead ? domain_.lower + length() * (at.after / at.sum())
                                   : domain_.upper - length() * (at.ahead / at.sum());
    }
    // The factor of the weights that belongs to a knot t: 1 at the lower end of the domain, rho at the upper
    // one.
    [[nodiscard]] double factor(double t) const noexcept {
        const Terms at = terms(t);
        return at.common * (std::ldexp(length(), exponent_) / at.sum());
    }

private:
    // The terms t - lower and rho (upper - t) of the denominator, divided by rho / common and by the power of
    // two that brings the length of the domain below 1. The larger term is the one that rho does not enter,
    // so that no rho makes it overflow or vanish, and both ends have exact factors.
    struct Terms {
        double after, ahead, common;
        [[nodiscard]] double sum() const noexcept { return after + ahead; }
    };
    [[nodiscard]] Terms terms(double t) const noexcept {
        const double after = std::ldexp(t - domain_.lower, exponent_);
        const double ahead = std::ldexp(domain_.upper - t, exponent_);
        return after < rho_ * ahead ? Terms{after / rho_, ahead, 1} : Terms{after, rho_ * ahead, rho_};
    }
    [[nodiscard]] double length() const noexcept { return domain_.upper - domain_.lower; }

    Interval domain_;
    double rho_;
    int exponent_;
};

std::vector<double> mapped_knots(const KnotVector &axis, int k, const Moebius &map) {
    std::vector<double> knots;
    for (size_t i = 0; i < axis.knots().size(); ++i) {
        const double t = axis.knots()[i];
        if (!map.reaches(t)) {
            fail(Status::knots_merge,
                 "knots[%zu] = %s of axis %d lies at or behind the pole of the map, which would change the "
                 "order of the knots",
                 i, Number(t).text, k);
        }
        knots.push_back(map(t));
    }
    check_distinct(axis.knots(), knots, k);
    return knots;
}

std::vector<double> layer_factors(const KnotVector &axis, const Moebius &map) {
    std::vector<double> of_knots(axis.knots().size());
    std::transform(axis.knots().begin(), axis.knots().end(), of_knots.begin(),
                   [&](double t) { return map.factor(t); });
    std::vector<double> factors;
    for (auto at = of_knots.begin(); std::ssize(factors) < axis.count(); ++at) {
        factors.push_back(std::accumulate(at + 1, at + 1 + axis.degree(), 1.0, std::multiplies<>()));
    }
    return factors;
}

void check_moebius(const KnotVector &axis, int k, double ratio) {
    if (!(ratio > 0) || std::isinf(ratio)) {
        fail(Status::factor, "ratio = %s, expected positive and finite", Number(ratio).text);
    }
    if (axis.periodic()) {
        fail(Status::periodic, "axis %d is periodic, and no period survives a map with a pole", k);
    }
    if (axis.degree() == 0 && ratio != 1) {
        fail(Status::degree, "degree 0 of axis %d: a Moebius map changes no weight there", k);
    }
}

// The weights of the spline at an end of the domain of an axis, for all positions across the axis.
std::vector<double> end_weights(const Spline &spline, int axis, bool upper) {
    const KnotVector &knots = spline.axis(axis);
    const AxisView view = axis_view(spline, axis, 1);
    const double end = upper ? knots.domain().upper : knots.domain().lower;
    const int64_t span = knots.find_span(end, upper);
    double values[max_basis];
    basis_values(knots.knots().data(), knots.degree(), span, end, values);
    std::vector<double> layer;
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 0; i < view.inner; ++i) {
            double sum = 0;
            for (int j = 0; j <= knots.degree(); ++j) {
                const int64_t from = (o * view.count + span - knots.degree() + j) * view.inner + i;
                sum += values[j] == 0 ? 0 : values[j] * spline.weight(from);
            }
            layer.push_back(sum);
        }
    }
    return layer;
}

// The factor by which every weight at the upper end would become the one at the lower end.
double common_ratio(const std::vector<double> &lower, const std::vector<double> &upper, int axis) {
    constexpr double rounding = 8 * eps;
    double ratio = 0;
    for (size_t i = 0; i < lower.size(); ++i) {
        if (lower[i] == 0 && upper[i] == 0) {
            continue;
        }
        const double here = lower[i] / upper[i];
        ratio = ratio == 0 ? here : ratio;
        if (!(here > 0) || std::isinf(here) || !(std::abs(here - ratio) <= rounding * ratio)) {
            fail(Status::end_weights,
                 "the weights at the ends of axis %d are %s and %s, expected a positive ratio, the same "
                 "across "
                 "the axis",
                 axis, Number(lower[i]).text, Number(upper[i]).text);
        }
    }
    return ratio == 0 ? 1 : ratio;
}

} // namespace

bool equal_weights(const Spline &spline) noexcept {
    bool equal = true;
    for (int64_t i = 1; equal && i < spline.point_count(); ++i) {
        equal = spline.weight(i) == spline.weight(0);
    }
    return equal;
}

bool same_weights(const Spline &a, const Spline &b) noexcept {
    bool same = a.form() == b.form();
    for (int64_t i = 0; same && i < a.point_count(); ++i) {
        same = a.weight(i) == b.weight(i);
    }
    return same;
}

SplinePtr normalize_weights(const SplinePtr &spline) {
    if (!spline->rational()) {
        return spline;
    }
    if (equal_weights(*spline)) {
        return make_result(spline->knot_vectors(), spline->dim(), Form::polynomial,
                           cartesian_points(*spline));
    }
    const double dominant = dominant_weight(*spline);
    return dominant == 1 ? spline
                         : with_weights(*spline, spline->knot_vectors(),
                                        [dominant](double value, int64_t) { return value / dominant; });
}

SplinePtr reparametrize_moebius(const SplinePtr &spline, int axis, double ratio) {
    const KnotVector &old = spline->axis(axis);
    check_moebius(old, axis, ratio);
    if (ratio == 1) {
        return spline;
    }
    const Moebius map(old.domain(), std::pow(ratio, 1.0 / old.degree()));
    auto knots = std::make_shared<const KnotVector>(old.degree(), mapped_knots(old, axis, map));
    const std::vector<double> factors = layer_factors(old, map);
    const AxisView view = axis_view(*spline, axis, 1);
    return with_weights(*make_rational(spline), with_axis(*spline, axis, std::move(knots)),
                        [&](double value, int64_t i) {
                            return value * factors[static_cast<size_t>(i / view.inner % view.count)];
                        });
}

SplinePtr equalize_end_weights(const SplinePtr &spline, int axis) {
    const double ratio =
        equal_weights(*spline) // whose sums at the ends may differ by rounding
            ? 1
            : common_ratio(end_weights(*spline, axis, false), end_weights(*spline, axis, true), axis);
    return reparametrize_moebius(spline, axis, ratio);
}

} // namespace nrb::refine
