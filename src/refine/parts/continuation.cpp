// SPDX-License-Identifier: MIT
#include "refine/parts/continuation.h"

#include "basis/bspline.h"
#include "numeric/binomial.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/continued_layers.h"
#include "refine/parts/cut.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

void add_continued_row(const KnotVector &axis, int64_t shared_first, int64_t shared_end,
                       std::span<const double> arguments, LayerTable &table) {
    const double *left = axis.knots().data() + shared_first, *right = axis.knots().data() + shared_end;
    double coefficients[max_basis] = {1};
    int d = 1;
    for (const double t : arguments) {
        append_argument(left, right, d++, t, coefficients);
    }
    table.add_row(shared_first - d, coefficients, d);
}

namespace {

// Adds the row of control point s > order of a piece of degree p over [b, e], whose control points tau_0,
// ..., tau_order are known (s is the number of arguments that are e). The piece is a polynomial of degree
// `order`, so the higher differences of the tau_s vanish. By Lagrange's formula tau_s = sum_j (-1)^(order-j)
// C(s, j) C(s - j - 1, order - j) tau_j.
void add_taylor_row(const LayerTable &known, int order, int s, int64_t count, LayerTable &table) {
    std::vector<double> sum(static_cast<size_t>(order) + 1, 0.0); // from layer count - 1 - order on
    for (int j = 0; j <= order; ++j) {
        const double factor =
            ((order - j) % 2 == 0 ? 1 : -1) * binomial(s, j) * binomial(s - j - 1, order - j);
        const LayerTable::Row &row = known.row(j);
        const auto offset = static_cast<size_t>(row.first - (count - 1 - order));
        if (row.size == 0) {
            sum[offset] += factor;
        }
        for (int i = 0; i < row.size; ++i) {
            sum[offset + static_cast<size_t>(i)] += factor * known.coefficients(row)[i];
        }
    }
    table.add_row(count - 1 - order, sum.data(), order + 1);
}

void check_longer(double amount, const KnotVector &knots, double end, int axis) {
    const Interval domain = knots.domain();
    if (!std::isfinite(amount)) {
        fail(Status::parameter_not_finite, "amount = %s is not finite", Number(amount).text);
    }
    if (!(end > domain.upper)) {
        fail(Status::empty_domain,
             "amount = %s does not make the domain of axis %d longer: its length is %s; expected more than 0 "
             "and "
             "its rounding",
             Number(amount).text, axis, Number(domain.upper - domain.lower).text);
    }
    if (!std::isfinite(end - knots[0])) {
        fail(Status::not_representable, "the knots of axis %d, longer by amount = %s, overflow", axis,
             Number(amount).text);
    }
}

void check_plain(const KnotVector &knots, int axis) {
    if (knots.periodic()) {
        fail(Status::periodic, "axis %d is periodic: it has no end that could be extended", axis);
    }
}

// Advice in messages about results that points with weights cannot represent.
constexpr const char *flag_advice = "NURBS_HOMOGENEOUS keeps it as homogeneous points";
constexpr const char *detour_advice =
    "nurbs_from_homogeneous() of the extended nurbs_to_homogeneous() has it as homogeneous points";

// Refuses weights that Form::rational does not allow. With `reversed`, the index in messages is that after
// the layers have been put into the opposite order.
void check_weights(const ContinuedNet &made, const AxisView &view, bool reversed, const char *advice) {
    const std::vector<double> &weights = made.net.weights;
    const auto negative = std::find_if(weights.begin(), weights.end(), [](double w) { return w < 0; });
    const int64_t bad = negative != weights.end() ? negative - weights.begin() : made.infinite;
    if (bad < 0) {
        return;
    }
    const int64_t layer = bad / view.inner % view.count;
    const int64_t index = reversed ? bad + (view.count - 1 - 2 * layer) * view.inner : bad;
    if (negative != weights.end()) {
        fail(Status::weight_negative, "weights[%lld] of the result would be %s, expected >= 0; %s",
             static_cast<long long>(index), Number(*negative).text, advice);
    }
    fail(Status::weights_vanish,
         "weights[%lld] of the result would be 0 with a control point at infinity, expected > 0; %s",
         static_cast<long long>(index), advice);
}

// As with_axis(), for continued polynomials, whose weights may become negative.
SplinePtr continued(const Spline &spline, int k, const AxisTable &made, bool reversed, const char *advice) {
    ContinuedNet result = continued_along(spline, k, made.table);
    AxisView view = axis_view(spline, k, 1);
    view.count = made.table.rows();
    check_weights(result, view, reversed, advice);
    return make_result(with_axis(spline, k, made.axis), spline.dim(), spline.form(),
                       std::move(result.net.points), std::move(result.net.weights));
}

// How many control points, `order` or 0, may have knots on both sides of the old end among their arguments.
// They are up to G = (1 + 2 amount / last span)^order times as large as the others, and so is the rounding
// error of evaluations that use them, on the old domain too. If G > 2^8 there are none, and the old end gets
// multiplicity `degree`.
int across(const KnotVector &axis, double end, int order) {
    constexpr double limit = 256;
    const int64_t n = axis.count();
    return std::pow(1 + 2 * ((end - axis[n]) / (axis[n] - axis[n - 1])), order) <= limit ? order : 0;
}

} // namespace

AxisTable extended_axis(const KnotVector &axis, double end, int order) {
    const int p = axis.degree(), shared = across(axis, end, order);
    const int64_t n = axis.count();
    const std::vector<double> ends(static_cast<size_t>(p) + 1, end);
    const std::span<const double> arguments(ends);
    LayerTable table;
    table.reserve(n + p - shared);
    for (int64_t j = 0; j < n - shared; ++j) {
        table.add_copy(j);
    }
    for (int s = 1; s <= shared; ++s) { // interior knots, the old end p - shared times, the new end s times
        add_continued_row(axis, n - shared + s, n + p - shared, arguments.first(static_cast<size_t>(s)),
                          table);
    }
    for (int s = shared + 1; s <= order; ++s) { // of the piece over [old end, new end]
        add_continued_row(axis, n, n + p - s, arguments.first(static_cast<size_t>(s)), table);
    }
    LayerTable known; // tau_s
    for (int s = 0; s <= order && order < p; ++s) {
        add_continued_row(axis, n, n + p - s, arguments.first(static_cast<size_t>(s)), known);
    }
    for (int s = order + 1; s <= p; ++s) {
        add_taylor_row(known, order, s, n, table);
    }
    std::vector<double> knots(axis.knots().begin(), axis.knots().begin() + n + p - shared);
    knots.insert(knots.end(), ends.begin(), ends.end());
    return {std::make_shared<const KnotVector>(p, std::move(knots)), std::move(table)};
}

namespace {

SplinePtr extend_upper(const SplinePtr &spline, int axis, double amount, int order, bool reversed) {
    const KnotVector &given = spline->axis(axis);
    const double end = given.domain().upper + amount;
    check_longer(amount, given, end, axis);
    const SplinePtr whole = clamp_ends(spline, axis, {false, true});
    const KnotVector &knots = whole->axis(axis);
    return continued(*whole, axis, extended_axis(knots, end, std::min(order, knots.degree())), reversed,
                     detour_advice);
}

} // namespace

SplinePtr extend(const SplinePtr &spline, int axis, bool upper, double amount, int order) {
    check_plain(spline->axis(axis), axis);
    return upper ? extend_upper(spline, axis, amount, order, false)
                 : reverse(*extend_upper(reverse(*spline, axis, false), axis, amount, order, true), axis,
                           false);
}

namespace {

// Unclamps the upper end: the last control points get knots of `beyond` as arguments.
AxisTable unclamped_upper(const KnotVector &axis, std::span<const double> beyond) {
    const int p = axis.degree();
    const int64_t n = axis.count();
    AxisTable made;
    made.table.reserve(n);
    for (int64_t j = 0; j < n; ++j) {
        const auto fresh = static_cast<size_t>(std::max<int64_t>(j - (n - p), 0));
        if (fresh == 0) {
            made.table.add_copy(j);
        } else {
            add_continued_row(axis, j + 1, n + 1, beyond.first(fresh), made.table);
        }
    }
    std::vector<double> knots(axis.knots().begin(), axis.knots().begin() + n + 1);
    knots.insert(knots.end(), beyond.begin(), beyond.end());
    made.axis = make_knot_vector(p, std::move(knots));
    return made;
}

SplinePtr unclamp_upper(const SplinePtr &spline, int axis, std::span<const double> beyond, bool reversed) {
    return continued(*spline, axis, unclamped_upper(spline->axis(axis), beyond), reversed, flag_advice);
}

SplinePtr unclamp_lower(const SplinePtr &spline, int axis, std::span<const double> below) {
    return reverse(*unclamp_upper(reverse(*spline, axis, false), axis, negated(below), true), axis, false);
}

// The knots of the domain, its ends once, and on either side `degree` copies of them a period away.
std::vector<double> repeated_knots(const KnotVector &axis) {
    const auto [lower, upper] = axis.domain();
    const auto p = static_cast<size_t>(axis.degree());
    const auto first = std::upper_bound(axis.knots().begin(), axis.knots().end(), lower);
    const auto last = std::lower_bound(first, axis.knots().end(), upper);
    const size_t period = static_cast<size_t>(last - first) + 1;
    std::vector<double> knots(period + 2 * p + 1, upper);
    knots[p] = lower;
    std::copy(first, last, knots.begin() + axis.degree() + 1);
    continue_knots(knots, p, p + period, period);
    return knots;
}

// Checks that copies a period away are distinct if their originals are.
void check_copies(std::span<const double> knots, size_t first, size_t end, size_t step, bool above,
                  int axis) {
    for (size_t i = first; i < end; ++i) {
        const size_t from = above ? i - step : i + step;
        if (knots[i] == knots[i + 1] && knots[from] != knots[from + 1]) {
            fail(Status::knots_merge,
                 "knots %s and %s of axis %d, repeated beyond the domain, would both be %s",
                 Number(knots[from]).text, Number(knots[from + 1]).text, axis, Number(knots[i]).text);
        }
    }
}

} // namespace

SplinePtr unclamp(const SplinePtr &spline, int axis, AxisEnds ends) {
    const KnotVector &old = spline->axis(axis);
    const auto p = static_cast<size_t>(old.degree());
    ends = {ends.lower && old.clamped_start() && p > 0, ends.upper && old.clamped_end() && p > 0};
    if (old.periodic() || (!ends.lower && !ends.upper)) {
        return spline;
    }
    const std::vector<double> knots = repeated_knots(old);
    const size_t upper = knots.size() - 1 - p, period = upper - p;
    SplinePtr result = spline;
    if (ends.upper) {
        check_copies(knots, upper, upper + p, period, true, axis);
        result = unclamp_upper(result, axis, std::span<const double>(knots).last(p), false);
    }
    if (ends.lower) {
        check_copies(knots, 0, p, period, false, axis);
        result = unclamp_lower(result, axis, std::span<const double>(knots).first(p));
    }
    return result;
}

SplinePtr with_end_knots(const SplinePtr &spline, int axis, std::span<const double> below,
                         std::span<const double> above) {
    const Interval domain = spline->axis(axis).domain();
    SplinePtr result = spline;
    if (std::ranges::any_of(above, [domain](double knot) { return knot != domain.upper; })) {
        result = unclamp_upper(result, axis, above, false);
    }
    if (std::ranges::any_of(below, [domain](double knot) { return knot != domain.lower; })) {
        result = unclamp_lower(result, axis, below);
    }
    return result;
}

} // namespace nrb::refine
