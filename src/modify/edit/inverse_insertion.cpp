// SPDX-License-Identifier: MIT
#include "modify/edit/inverse_insertion.h"

#include "base/numbers.h"
#include "basis/bspline.h"
#include "numeric/norm.h"
#include "refine/knots/insert.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

void check_degree_of(const Spline &spline, int axis) {
    if (spline.axis(axis).degree() == 0) {
        fail(Status::degree, "degree 0 of axis %d, expected at least 1: no knot moves its control points",
             axis);
    }
}

bool at_infinity(const Spline &spline, int64_t point) noexcept {
    return spline.form() == Form::homogeneous && spline.weight(point) == 0;
}

// The layer of a control point along an axis.
int64_t layer_of(const AxisView &view, int64_t point) noexcept {
    return point / view.inner % view.count;
}

// The ratio in which the knot divides the knots of a leg, for the point Q at a ratio of the leg from P_i to
// P_j: w_i |Q - P_i| / (w_i |Q - P_i| + w_j |P_j - Q|). If both weights are 0, Cartesian points are combined,
// and it is the ratio itself.
double rational_ratio(const Spline &spline, int64_t from, int64_t to, double ratio) {
    const double before = spline.weight(from), after = spline.weight(to);
    if (ratio == 0 || ratio == 1 || (before == 0 && after == 0)) {
        return ratio;
    }
    if (before == 0 || after == 0 || std::signbit(before) != std::signbit(after)) {
        fail(
            Status::weight_sign,
            "the weights at the ends of the leg from control point %lld to %lld are %s and %s: no knot makes "
            "a point inside it a control point",
            static_cast<long long>(from), static_cast<long long>(to), Number(before).text,
            Number(after).text);
    }
    // Quotients, because products of weights might overflow.
    return ratio / (ratio + (1 - ratio) * (after / before));
}

// The knot at the ratio s between the knots t_(i+1) and t_(i+p+1) of leg i = `layer`.
double knot_at(const KnotVector &axis, int64_t layer, double s) noexcept {
    const double lower = axis[layer + 1], upper = axis[layer + axis.degree() + 1];
    const double length = upper - lower;
    const double knot = s <= 0.5 ? lower + s * length : upper - (1 - s) * length;
    return std::clamp(knot, lower, upper);
}

// The same on a periodic axis, with the copy of the leg in the period in which the knot is inside the domain;
// the end of the domain counts as its start. Only legs between copies of layers reach out of the domain, and
// one period away they are inside.
double periodic_knot(const KnotVector &axis, int64_t layer, double s) noexcept {
    const auto [lower, upper] = axis.domain();
    double knot = knot_at(axis, layer, s);
    if (knot < lower) {
        knot = knot_at(axis, layer + axis.distinct_layers(), s);
    } else if (knot > upper) {
        knot = knot_at(axis, layer - axis.distinct_layers(), s);
    }
    return knot >= lower && knot < upper ? knot : lower;
}

// If the knots of a leg reached over more than a period, copies of the new knot would be among them, and the
// new control point would not be the wanted point.
void check_period(const KnotVector &axis, int k) {
    if (axis.periodic() && axis.distinct_layers() < axis.degree()) {
        fail(Status::periodic,
             "axis %d is periodic with %lld different layers, fewer than its degree %d: the knots of a leg "
             "reach over "
             "more than a period",
             k, static_cast<long long>(axis.distinct_layers()), axis.degree());
    }
}

void check_room(const KnotVector &axis, int k, double knot) {
    const int present = multiplicity(axis.knots(), knot);
    if (present > axis.degree()) {
        fail(Status::multiplicity, "knot = %s occurs %d times on axis %d already, degree %d allows no more",
             Number(knot).text, present, k, axis.degree());
    }
}

// Boehm's knot insertion for t_span <= knot < t_(span + 1) outside the domain. Below it the new layer 0 is
// dropped, and so i counts from 1.
refine::AxisTable table_outside(const KnotVector &axis, double knot) {
    const bool below = knot < axis.domain().lower;
    const int p = axis.degree();
    const auto after = std::upper_bound(axis.knots().begin(), axis.knots().end(), knot);
    const int64_t span = after - axis.knots().begin() - 1;
    std::vector<double> knots(axis.knots().begin(), axis.knots().end());
    knots.insert(knots.begin() + span + 1, knot);
    knots.erase(below ? knots.begin() : knots.end() - 1);
    LayerTable table;
    for (int64_t i = below ? 1 : 0; i < axis.count() + (below ? 1 : 0); ++i) {
        if (i <= span - p) {
            table.add_copy(i);
        } else if (i > span) {
            table.add_copy(i - 1);
        } else {
            const auto [alpha, beta] = divide_in_ratio(1, axis[i], knot, axis[i + p]);
            const double coefficients[] = {beta, alpha};
            table.add_row(i - 1, coefficients, 2);
        }
    }
    return {std::make_shared<const KnotVector>(p, std::move(knots)), std::move(table)};
}

} // namespace

LegInsertion insert_on_leg(const SplinePtr &spline, int axis, int64_t point, double ratio) {
    check_degree_of(*spline, axis);
    const AxisView view = axis_view(*spline, axis, 1);
    const KnotVector &knots = spline->axis(axis);
    const int64_t layer = layer_of(view, point), next = point + view.inner;
    if (layer + 1 == view.count) {
        fail(Status::index, "index = %lld is the last control point along axis %d, where no leg begins",
             static_cast<long long>(point), axis);
    }
    for (const int64_t end : {point, next}) {
        if (at_infinity(*spline, end)) {
            fail(Status::point_not_finite, "g: control point %lld is at infinity",
                 static_cast<long long>(end));
        }
    }
    check_period(knots, axis);
    const double s = rational_ratio(*spline, point, next, ratio);
    const double knot = knots.periodic() ? periodic_knot(knots, layer, s) : knot_at(knots, layer, s);
    check_room(knots, axis, knot);
    const auto [lower, upper] = knots.domain();
    if (knot < lower || knot > upper) {
        return {knot, refine::with_axis(*spline, axis, table_outside(knots, knot))};
    }
    return {knot, refine::insert_knot(spline, axis, knot, 1)};
}

namespace {

// The leg between two control points, with its place nearest to the point.
Leg leg_at(const Spline &spline, int64_t from, int64_t to, const double *point) noexcept {
    const int dim = spline.dim();
    const auto along = [&](int c) { return spline.coordinate(to, c) - spline.coordinate(from, c); };
    const auto offset = [&](int c) { return point[c] - spline.coordinate(from, c); };
    const double length = norm_of(dim, along);
    double place = 0;
    for (int c = 0; c < dim && length > 0; ++c) {
        place += offset(c) * (along(c) / length);
    }
    const double ratio = length > 0 ? std::clamp(place / length, 0.0, 1.0) : 0;
    const double gap = ratio == 1 ? norm_of(dim, [&](int c) { return point[c] - spline.coordinate(to, c); })
                                  : norm_of(dim, [&](int c) { return offset(c) - ratio * along(c); });
    return {from, ratio, gap};
}

} // namespace

Leg nearest_leg(const Spline &spline, int axis, const double *point) {
    check_degree_of(spline, axis);
    const AxisView view = axis_view(spline, axis, 1);
    Leg nearest{-1, 0, infinity};
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const int64_t next = i + view.inner;
        if (layer_of(view, i) + 1 == view.count || at_infinity(spline, i) || at_infinity(spline, next)) {
            continue;
        }
        const Leg leg = leg_at(spline, i, next, point);
        nearest = leg.distance < nearest.distance ? leg : nearest;
    }
    return nearest;
}

} // namespace nrb::modify
