// SPDX-License-Identifier: MIT
#include "reduce/layer_deviation.h"

#include "base/numbers.h"
#include "bounds/deviation.h"
#include "numeric/norm.h"
#include "reduce/layers.h"
#include "refine/knots/axis_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace nrb::reduce {

namespace {

// The knots of the closed domain, its ends repeated degree + 1 times.
std::vector<double> clamped_knots(const KnotVector &axis) {
    const double lower = axis.domain().lower,
                 upper = axis.domain().upper; // a lambda captures them, so no structured bindings
    const size_t times = static_cast<size_t>(axis.degree()) + 1;
    std::vector<double> knots(times, lower);
    std::copy_if(axis.knots().begin(), axis.knots().end(), std::back_inserter(knots),
                 [&](double t) { return t > lower && t < upper; });
    knots.insert(knots.end(), times, upper);
    return knots;
}

// The axis over clamped knots that include its own. On a periodic axis, the stored layers and knots are
// sufficient.
refine::AxisTable clamped_axis(const KnotVector &axis, const std::vector<double> &wanted) {
    const auto [lower, upper] = axis.domain();
    std::vector<double> fine;
    std::set_union(wanted.begin(), wanted.end(), axis.knots().begin(), axis.knots().end(),
                   std::back_inserter(fine));
    const auto layer_at = [&](double t) {
        return std::lower_bound(fine.begin(), fine.end(), t) - fine.begin();
    };
    const refine::Refinement refinement(axis.degree(), axis.knots(), fine);
    return {std::make_shared<const KnotVector>(axis.degree(), wanted),
            refine::rows_of(refinement, layer_at(lower), layer_at(upper))};
}

struct Pair {
    SplinePtr a;
    SplinePtr b;
    double steps = 0; // rounding steps, on axes whose layers are not only copied
};

Pair over_common_knots(const SplinePtr &a, const SplinePtr &b) {
    Pair pair{a, b};
    for (int k = 0; k < a->axes(); ++k) {
        const std::vector<double> first = clamped_knots(a->axis(k)), second = clamped_knots(b->axis(k));
        std::vector<double> both;
        std::set_union(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(both));
        const refine::AxisTable of_a = clamped_axis(a->axis(k), both), of_b = clamped_axis(b->axis(k), both);
        pair.a = refine::with_axis(*pair.a, k, of_a);
        pair.b = refine::with_axis(*pair.b, k, of_b);
        pair.steps +=
            of_a.table.copies_only() && of_b.table.copies_only() ? 0 : 7.0 * a->axis(k).degree() + 2;
    }
    return pair;
}

// 1 or -1 if all weights have that sign, else 0.
int sign_of_weights(const Spline &spline) noexcept {
    const int sign = spline.weight(0) > 0 ? 1 : -1;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        if (!(sign * spline.weight(i) > 0)) {
            return 0;
        }
    }
    return sign;
}

double distance(const Spline &a, int64_t i, const Spline &b, int64_t j) noexcept {
    return norm_of(a.dim(), [&](int c) { return a.coordinate(i, c) - b.coordinate(j, c); });
}

double size_of(const Spline &spline, int64_t i) noexcept {
    return norm_of(spline.dim(), [&](int c) { return spline.coordinate(i, c); });
}

// Distance from control point i to the farthest one that is active together with it.
double reach(const Spline &spline, int64_t i) noexcept {
    std::array<int64_t, max_axes> first{}, end{1, 1, 1}, stride{};
    int64_t rest = i, step = 1;
    for (int k = spline.axes(); k-- > 0;) {
        const auto at = static_cast<size_t>(k);
        const int64_t layer = rest % spline.count(k);
        first[at] = std::max<int64_t>(layer - spline.axis(k).degree(), 0);
        end[at] = std::min(layer + spline.axis(k).degree() + 1, spline.count(k));
        stride[at] = step;
        step *= spline.count(k);
        rest /= spline.count(k);
    }
    double largest = 0;
    for (int64_t u = first[0]; u < end[0]; ++u) {
        for (int64_t v = first[1]; v < end[1]; ++v) {
            for (int64_t w = first[2]; w < end[2]; ++w) {
                const int64_t j = u * stride[0] + v * stride[1] + w * stride[2];
                largest = std::max(largest, distance(spline, i, spline, j));
            }
        }
    }
    return largest;
}

// Distance from `centre` to the farthest control point. Homogeneous ones must have nonzero weights.
double radius_about(const Spline &spline, const double *centre) noexcept {
    double largest = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        largest = std::max(largest,
                           norm_of(spline.dim(), [&](int c) { return spline.coordinate(i, c) - centre[c]; }));
    }
    return largest;
}

} // namespace

double speed_bound(const Spline &given, int axis) {
    const Spline &spline = given.effective();
    if (!(spline.all_weights().smallest > 0)) {
        return infinity;
    }
    const KnotVector &knots = spline.axis(axis);
    const int dim = spline.dim(), width = spline.width();
    std::vector<double> centre(static_cast<size_t>(dim));
    for (int c = 0; c < dim; ++c) {
        centre[static_cast<size_t>(c)] = spline.coordinate(0, c);
    }
    const double radius = spline.rational() ? radius_about(spline, centre.data()) : 0;
    const std::vector<double> records = layer_records(spline, axis);
    const int64_t length = layer_length(spline, axis);
    double largest = 0;
    for (int64_t i = 0; i + 1 < knots.count(); ++i) {
        const double extent = knots[i + knots.degree() + 1] - knots[i + 1];
        for (int64_t at = i * length; at < (i + 1) * length; at += width) {
            const double *from = records.data() + at, *to = from + length;
            const double turned = spline.rational() ? to[dim] - from[dim] : 0;
            const double moved =
                norm_of(dim,
                        [&](int c) { return to[c] - from[c] - centre[static_cast<size_t>(c)] * turned; }) +
                radius * std::abs(turned);
            const double speed = moved == 0 ? 0 : knots.degree() * moved / extent;
            largest = std::max(largest, extent > 0 || moved == 0 ? speed : infinity);
        }
    }
    return 1.01 * largest / spline.all_weights().smallest;
}

double deviation_bound(const SplinePtr &a, const SplinePtr &b) {
    const auto [p, q, steps] = over_common_knots(a, b);
    if (p->rational() && (sign_of_weights(*p) == 0 || sign_of_weights(*p) != sign_of_weights(*q))) {
        return bounds::deviation(*a, *b).upper;
    }
    double bound = 0, largest = 0;
    for (int64_t i = 0; i < p->point_count(); ++i) {
        const double change = std::abs(1 - q->weight(i) / p->weight(i));
        const double turned = change == 0 ? 0 : change * reach(*q, i);
        bound = std::max(bound, distance(*p, i, *q, i) + turned);
        largest = std::max({largest, size_of(*p, i), size_of(*q, i)});
    }
    const double rounding = (p->rational() ? 4 : 1) * steps * eps * largest;
    return bound * (1 + (p->dim() + 8) * eps) + rounding;
}

} // namespace nrb::reduce
