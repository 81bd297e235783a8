// SPDX-License-Identifier: MIT
#include "reduce/periodic_form.h"

#include "base/numbers.h"
#include "base/tolerance.h"
#include "reduce/layer_deviation.h"
#include "refine/parts/continuation.h"
#include "refine/parts/continued_layers.h"
#include "refine/parts/cut.h"
#include "refine/periodic/period.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace nrb::reduce {

namespace {

// `width`: number of values for each control point.
bool layers_repeat(const Spline &spline, int k, std::span<const double> values, int width) noexcept {
    const AxisView view = axis_view(spline, k, width);
    const int64_t repeated = int64_t{spline.axis(k).degree()} * view.inner, row = view.count * view.inner;
    for (int64_t o = 0; o < view.outer; ++o) {
        const double *first = values.data() + o * row, *copy = first + row - repeated;
        if (repeated > 0 && std::memcmp(first, copy, static_cast<size_t>(repeated) * sizeof *first) != 0) {
            return false;
        }
    }
    return true;
}

SplinePtr declared_periodic(const Spline &spline, int k) {
    const KnotVector &axis = spline.axis(k);
    auto knots = make_knot_vector(axis.degree(), {axis.knots().begin(), axis.knots().end()}, true, k);
    return make_result(refine::with_axis(spline, k, std::move(knots)), spline.dim(), spline.form(),
                       {spline.points().begin(), spline.points().end()},
                       {spline.weights().begin(), spline.weights().end()});
}

// The knots of the periodic axis with p - order copies of the seam, the last of them at index degree.
// Precondition: `axis` is clamped.
std::vector<double> periodic_knots(const KnotVector &axis, int order) {
    const auto p = static_cast<size_t>(axis.degree()), n = static_cast<size_t>(axis.count());
    const auto [lower, upper] = axis.domain();
    const size_t period = n - 1 - static_cast<size_t>(order); // knots inside, plus copies of the seam
    std::vector<double> knots(period + 2 * p + 1, upper);
    knots[p] = lower;
    std::copy(axis.knots().begin() + axis.degree() + 1, axis.knots().begin() + axis.count(),
              knots.begin() + axis.degree() + 1);
    refine::continue_knots(knots, p, p + period, period);
    return knots;
}

// The layer `ahead` places after the last one before the seam. The arguments of its polar form are order
// - ahead knots before the seam, all copies of the seam, and `ahead` knots after it.
void add_seam_row(const KnotVector &axis, std::span<const double> knots, int order, int ahead,
                  LayerTable &table) {
    const int64_t p = axis.degree(), n = axis.count(), copies = p - order;
    const auto at = static_cast<size_t>(p);
    const auto fresh = static_cast<size_t>(ahead), after = static_cast<size_t>(order - ahead);
    if (2 * ahead <= order) {
        const size_t upper = knots.size() - 1 - at;
        refine::add_continued_row(axis, n - order + ahead, n + copies, knots.subspan(upper + 1, fresh),
                                  table);
    } else {
        const size_t first = at + 1 - static_cast<size_t>(copies) - after;
        refine::add_continued_row(axis, p + 1 - copies, p + 1 + ahead, knots.subspan(first, after), table);
    }
}

// The layers of one period: the layer whose arguments end with the seam, those across it, and those after it.
refine::AxisTable periodic_table(const KnotVector &axis, int order, int k) {
    std::vector<double> knots = periodic_knots(axis, order);
    const int64_t n = axis.count(), period = n - 1 - order;
    LayerTable rows;
    for (int64_t i = 0; i < period + axis.degree(); ++i) {
        const int64_t layer = i % period;
        if (layer == 0 && order > 0) {
            rows.add_copy(n - 1 - order);
        } else if (layer < order) {
            add_seam_row(axis, knots, order, static_cast<int>(layer), rows);
        } else {
            rows.add_copy(layer);
        }
    }
    return {make_knot_vector(axis.degree(), std::move(knots), true, k), std::move(rows)};
}

// Empty if extrapolated weights become negative, or 0 for a point at infinity: the order is too high.
std::optional<PeriodicForm> form_of_order(const SplinePtr &spline, const Spline &whole, int k, int order) {
    const refine::AxisTable made = periodic_table(whole.axis(k), order, k);
    auto [net, infinite] = refine::continued_along(whole, k, made.table);
    if (infinite >= 0 ||
        std::any_of(net.weights.begin(), net.weights.end(), [](double w) { return w < 0; })) {
        return {};
    }
    SplinePtr periodic = make_result(refine::with_axis(whole, k, made.axis), whole.dim(), whole.form(),
                                     std::move(net.points), std::move(net.weights));
    const double deviation = deviation_bound(spline, periodic);
    return PeriodicForm{std::move(periodic), deviation, order};
}

} // namespace

bool wraps(const Spline &spline, int axis) noexcept {
    const KnotVector &knots = spline.axis(axis);
    return first_not_repeated(knots.degree(), knots.knots()) < 0 &&
           layers_repeat(spline, axis, spline.points(), spline.stored_width()) &&
           (spline.form() != Form::rational || layers_repeat(spline, axis, spline.weights(), 1));
}

PeriodicForm make_periodic(const SplinePtr &spline, int k, double tolerance) {
    const KnotVector &axis = spline->axis(k);
    const int p = axis.degree();
    check_tolerance(tolerance);
    if (axis.periodic() || wraps(*spline, k)) {
        const int order = p - multiplicity(axis.knots(), axis.domain().lower);
        return {axis.periodic() ? spline : declared_periodic(*spline, k), 0, order};
    }
    const SplinePtr whole = refine::clamp_ends(spline, k);
    double least = infinity;
    for (int order = static_cast<int>(std::min<int64_t>(p - 1, (whole->count(k) - 1) / 2)); order >= 0;
         --order) {
        std::optional<PeriodicForm> form = form_of_order(spline, *whole, k, order);
        if (form && form->deviation <= tolerance) {
            return std::move(*form);
        }
        least = form ? std::min(least, form->deviation) : least;
    }
    fail(Status::gap, "axis %d: to make its ends one moves the shape by up to %s, expected at most %s", k,
         Number(least).text, Number(tolerance).text);
}

} // namespace nrb::reduce
