// SPDX-License-Identifier: MIT
#include "refine/forms/power.h"

#include "base/finite.h"
#include "base/representable.h"
#include "numeric/binomial.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"
#include "refine/parts/piece_order.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

PieceOrder order_of(const PowerForm &form) {
    std::array<PieceOrder::Axis, max_axes> axes{};
    for (size_t k = 0; k < form.degrees.size(); ++k) {
        axes[k] = {std::ssize(form.breaks[k]) - 1, form.degrees[k] + 1};
    }
    return PieceOrder({axes.data(), form.degrees.size()});
}

// h^k as fraction * 2^exponent. The power of a short or long span may leave the range of doubles although the
// coefficients do not.
struct ScaledPower {
    double fraction;
    int exponent;
};
ScaledPower scaled_power(double h, int k) noexcept {
    int exponent = 0;
    const double m = std::frexp(h, &exponent);
    double fraction = 1;
    for (int i = 0; i < k; ++i) {
        fraction *= m;
    }
    return {fraction, k * exponent};
}

// In place: forward differences of degree + 1 values.
void differences(double *values, int degree) noexcept {
    for (int r = 1; r <= degree; ++r) {
        for (int i = degree; i >= r; --i) {
            values[i] -= values[i - 1];
        }
    }
}

// In place: the inverse, of degree + 1 layers of `inner` values each.
void sums(double *layers, int degree, int64_t inner) noexcept {
    for (int r = degree; r >= 1; --r) {
        for (int64_t i = r * inner; i < (degree + 1) * inner; ++i) {
            layers[i] += layers[i - inner];
        }
    }
}

// Differences times binomials over fractions are below 2^92 times the largest value. They may overflow where
// the coefficients do not, unless the values are lowered by a power of two before.
void bezier_to_power(double *layers, int degree, int64_t inner, double h) noexcept {
    constexpr int room = 128;
    constexpr double limit = 0x1p895;
    double values[max_degree + 1];
    for (int64_t j = 0; j < inner; ++j) {
        for (int k = 0; k <= degree; ++k) {
            values[k] = layers[k * inner + j];
        }
        const auto size = static_cast<size_t>(degree) + 1;
        const int lowered = largest_magnitude({values, size}) < limit ? 0 : room;
        std::for_each_n(values, size, [lowered](double &x) { x = std::ldexp(x, -lowered); });
        differences(values, degree);
        for (int k = 1; k <= degree; ++k) {
            const auto [fraction, exponent] = scaled_power(h, k);
            layers[k * inner + j] =
                std::ldexp(binomial(degree, k) * values[k] / fraction, lowered - exponent);
        }
    }
}

void power_to_bezier(double *layers, int degree, int64_t inner, double h) noexcept {
    for (int k = 1; k <= degree; ++k) {
        const auto [fraction, exponent] = scaled_power(h, k);
        const double parts = binomial(degree, k);
        std::for_each_n(layers + k * inner, inner,
                        [fraction = fraction, exponent = exponent, parts](double &x) {
                            x = std::ldexp(x * fraction / parts, exponent);
                        });
    }
    sums(layers, degree, inner);
}

// Applies a change of basis, one of the two functions above, to every piece of a net along one axis.
template <class Change>
void along(std::vector<double> &net, const AxisView &view, int degree, const std::vector<double> &breaks,
           Change change) {
    const int64_t size = (degree + 1) * view.inner;
    double *layers = net.data();
    for (int64_t o = 0; o < view.outer; ++o) {
        for (size_t e = 0; e + 1 < breaks.size(); ++e, layers += size) {
            change(layers, degree, view.inner, breaks[e + 1] - breaks[e]);
        }
    }
}

template <class Change>
void along_all(std::vector<double> &net, const PowerForm &form, Change change) {
    int64_t outer = 1, inner = std::ssize(net);
    for (size_t k = 0; k < form.degrees.size(); ++k) {
        const int64_t count = (form.degrees[k] + 1) * (std::ssize(form.breaks[k]) - 1);
        inner /= count;
        along(net, {outer, count, inner}, form.degrees[k], form.breaks[k], change);
        outer *= count;
    }
}

// The polynomial spline of the homogeneous records; a polynomial spline is returned as it is.
SplinePtr of_records(const SplinePtr &spline) {
    if (!spline->rational()) {
        return spline;
    }
    std::vector<double> records = homogeneous_points(*spline);
    require_representable(records, "homogeneous points");
    return std::make_shared<const Spline>(spline->knot_vectors(), spline->width(), Form::polynomial,
                                          std::move(records), std::vector<double>());
}

void check_finite(const PowerForm &form, bool rational) {
    if (all_finite(form.coefficients)) {
        return;
    }
    const auto bad = std::ranges::find_if_not(form.coefficients, [](double x) { return std::isfinite(x); });
    const auto place = bad - form.coefficients.begin(), record = place / form.width, c = place % form.width;
    fail(rational && c + 1 == form.width ? Status::weight_not_finite : Status::point_not_finite,
         "coefficients[%lld][%lld] = %s is not finite", static_cast<long long>(record),
         static_cast<long long>(c), Number(*bad).text);
}

} // namespace

PowerForm to_power(const SplinePtr &spline) {
    const PartedSpline pieces = bezier_pieces(of_records(spline));
    const Spline &whole = pieces.whole();
    PowerForm form{{}, {}, spline->width(), {}};
    for (int k = 0; k < whole.axes(); ++k) {
        const KnotVector &axis = whole.axis(k);
        form.degrees.push_back(axis.degree());
        std::vector<double> &breaks = form.breaks.emplace_back();
        for (int64_t i = 0; i < std::ssize(axis.knots()); i += axis.degree() + 1) {
            breaks.push_back(axis[i]);
        }
    }
    std::vector<double> net(whole.points().begin(), whole.points().end());
    along_all(net, form, bezier_to_power);
    form.coefficients.resize(net.size());
    order_of(form).take_apart(form.width, net.data(), form.coefficients.data());
    require_representable(form.coefficients, "coefficients");
    return form;
}

SplinePtr from_power(PowerForm form, bool rational) {
    check_finite(form, rational);
    std::vector<double> net;
    net.reserve(form.coefficients.size() + Spline::padding);
    net.resize(form.coefficients.size());
    order_of(form).put_together(form.width, form.coefficients.data(), net.data());
    along_all(net, form, power_to_bezier);
    require_representable(net, "points");
    Spline::Axes axes;
    for (size_t k = 0; k < form.degrees.size(); ++k) {
        std::vector<double> knots;
        for (const double knot : form.breaks[k]) {
            knots.insert(knots.end(), static_cast<size_t>(form.degrees[k]) + 1, knot);
        }
        axes.push_back(make_knot_vector(form.degrees[k], std::move(knots), false, static_cast<int>(k)));
    }
    return make_spline(std::move(axes), form.width - (rational ? 1 : 0),
                       rational ? Form::homogeneous : Form::polynomial, std::move(net));
}

} // namespace nrb::refine
