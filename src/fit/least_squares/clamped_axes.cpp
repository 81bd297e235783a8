// SPDX-License-Identifier: MIT
#include "fit/least_squares/clamped_axes.h"

#include "refine/knots/axis_table.h"
#include "refine/parts/continuation.h"

#include <algorithm>

namespace nrb::fit {

namespace {

KnotVectorPtr clamped(const KnotVectorPtr &axis) {
    if (axis->periodic() || (axis->clamped_start() && axis->clamped_end())) {
        return axis;
    }
    const auto [first, end] = axis->active_layers();
    const int p = axis->degree();
    const auto [lower, upper] = axis->domain();
    std::vector<double> knots(axis->knots().begin() + first, axis->knots().begin() + end + p + 1);
    std::fill_n(knots.begin(), p, lower);
    std::fill(knots.end() - p, knots.end(), upper);
    return std::make_shared<const KnotVector>(p, std::move(knots));
}

// Adds the layers of the axis that have no influence on the domain.
SplinePtr with_inert_layers(const SplinePtr &spline, int k, const KnotVectorPtr &axis) {
    const auto [first, end] = axis->active_layers();
    if (spline->axis(k).knots().size() == axis->knots().size()) {
        return spline;
    }
    LayerTable table;
    table.reserve(axis->count());
    for (int64_t j = 0; j < axis->count(); ++j) {
        table.add_copy(std::clamp(j, first, end - 1) - first);
    }
    return refine::with_axis(*spline, k, {axis, std::move(table)});
}

} // namespace

std::vector<KnotVectorPtr> clamped_axes(const std::vector<KnotVectorPtr> &axes) {
    std::vector<KnotVectorPtr> result(axes.size());
    std::ranges::transform(axes, result.begin(), clamped);
    return result;
}

SplinePtr over_axes(SplinePtr spline, const std::vector<KnotVectorPtr> &axes) {
    for (size_t k = 0; k < axes.size(); ++k) {
        const KnotVectorPtr &axis = axes[k];
        const int at = static_cast<int>(k);
        if (spline->knot_vectors()[k] == axis) {
            continue;
        }
        const auto [first, end] = axis->active_layers();
        const auto p = static_cast<size_t>(axis->degree());
        const std::span<const double> knots = axis->knots();
        spline = refine::with_end_knots(spline, at, knots.subspan(static_cast<size_t>(first), p),
                                        knots.subspan(static_cast<size_t>(end) + 1, p));
        spline = with_inert_layers(spline, at, axis);
    }
    return spline;
}

} // namespace nrb::fit
