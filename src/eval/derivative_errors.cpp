// SPDX-License-Identifier: MIT
#include "eval/derivative_errors.h"

#include "base/numbers.h"
#include "eval/frames/jet.h"
#include "spline/at_origin.h"

#include <cmath>

namespace nrb::eval {

namespace {

// Bounds for one axis of sum_i |terms of N_i'| and sum_i |terms of N_i''|, where a derivative is expanded by
// the difference formula down to the functions of the lowest degree, and the magnitudes of all terms are
// added. The functions of the lowest degree add up to 1. Each step from degree d - 1 to degree d multiplies
// the sum by at most 2 d / min(t_(i+d) - t_i), the minimum being taken over the functions of degree d - 1
// that do not vanish on the domain.
struct AxisSizes {
    double first = 0;
    double second = 0;
};

// The factor 2 d / min(t_(i+d) - t_i) of the step from degree d - 1 to degree d.
double step_size(const KnotVector &axis, int d) noexcept {
    const std::span<const double> knots = axis.knots();
    const auto [lower, upper] = axis.domain();
    double least = infinity;
    for (size_t i = 0; i + static_cast<size_t>(d) < knots.size(); ++i) {
        const double from = knots[i], to = knots[i + static_cast<size_t>(d)];
        least = from < upper && to > lower && from < to ? std::min(least, to - from) : least;
    }
    return 2 * d / least;
}

AxisSizes axis_sizes(const KnotVector &axis) noexcept {
    const int p = axis.degree();
    AxisSizes sizes;
    sizes.first = p >= 1 ? step_size(axis, p) : 0;
    sizes.second = p >= 2 ? sizes.first * step_size(axis, p - 1) : 0;
    return sizes;
}

// A bound of the Euclidean length of the coordinates of a record, and the range of the weights.
struct NetSizes {
    double point = 0;
    double heaviest = 0; // 0 for a polynomial spline
    double lightest = 1;
};

NetSizes net_sizes(const Spline &spline) {
    NetSizes sizes;
    const std::span<const double> records = spline.effective().records();
    const auto dim = static_cast<size_t>(spline.dim());
    const auto width = static_cast<size_t>(spline.width());
    sizes.lightest = spline.rational() ? infinity : 1;
    for (size_t at = 0; at < records.size(); at += width) {
        for (size_t c = 0; c < dim; ++c) {
            sizes.point = std::max(sizes.point, std::fabs(records[at + c]));
        }
        if (spline.rational()) {
            sizes.heaviest = std::max(sizes.heaviest, records[at + dim]);
            sizes.lightest = std::min(sizes.lightest, records[at + dim]);
        }
    }
    sizes.point *= std::sqrt(static_cast<double>(dim));
    return sizes;
}

// The sizes of the spline relative to O, the origin of the moved spline. The power spans of polynomial curves
// are made from the stored points instead, exact to about 2^-100 of these points; the term 2^-48 |P| covers
// this.
NetSizes sizes_seen_from_o(const Spline &spline) {
    const Spline &moved = at_origin(spline);
    NetSizes sizes = net_sizes(moved);
    sizes.point += &moved != &spline ? 0x1p-48 * net_sizes(spline).point : 0;
    return sizes;
}

constexpr DerivativeErrors unknown_errors{infinity, infinity, infinity, infinity, infinity};

bool extrapolates(const AxisRules &rules) noexcept {
    return rules[0].outside == Outside::extrapolate || rules[1].outside == Outside::extrapolate;
}

DerivativeErrors errors_everywhere(const Spline &spline) {
    const NetSizes net = sizes_seen_from_o(spline);
    if (!(net.lightest > 0)) {
        return unknown_errors;
    }
    const AxisSizes u = axis_sizes(spline.axis(0));
    const bool surface = spline.axes() == 2;
    const AxisSizes v = surface ? axis_sizes(spline.axis(1)) : AxisSizes{};
    const double c =
        accuracy_factor(spline.axis(0).degree()) + (surface ? accuracy_factor(spline.axis(1).degree()) : 0.0);
    // The quotient rule in magnitudes: E_a of the accuracy contract in nurbs.h, with all |w (P - O)| / w(t)
    // bounded by m, and all w_i / w(t) by w.
    const double m = net.point / net.lightest;
    const double w = net.heaviest / net.lightest;
    const double e_u = u.first * m * (1 + w);
    const double e_v = v.first * m * (1 + w);
    const double e_uu = u.second * m * (1 + w) + 2 * u.first * w * e_u;
    const double e_uv = u.first * v.first * m * (1 + w) + w * (u.first * e_v + v.first * e_u);
    const double e_vv = v.second * m * (1 + w) + 2 * v.first * w * e_v;
    // Twice the bound of the contract, to cover the rounding of the bounds themselves.
    const double first = 4 * (c + 2) * eps;
    const double second = 4 * (c + 4) * eps;
    return {first * e_u, first * e_v, second * e_uu, second * e_uv, second * e_vv};
}

} // namespace

DerivativeErrors derivative_errors(const Spline &spline, const AxisRules &rules, int64_t points) {
    if (extrapolates(rules)) {
        return unknown_errors;
    }
    // The bounds of a single point (Jet) cost about as much as reading 64 control points.
    constexpr auto slot = Spline::Cache::derivative_errors;
    if (spline.slot(slot).peek() == nullptr && !spline.pays(points, spline.point_count() / 64)) {
        return unknown_errors;
    }
    return spline.kept<DerivativeErrors>(
        slot, [&] { return std::make_shared<const DerivativeErrors>(errors_everywhere(spline)); });
}

} // namespace nrb::eval
