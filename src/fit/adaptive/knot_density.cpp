// SPDX-License-Identifier: MIT
#include "fit/adaptive/knot_density.h"

#include "base/finite.h"
#include "numeric/norm.h"
#include "refine/algebra/derivative.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::fit {

namespace {

// The spline over the domain [0, 1] with a largest coordinate of 1: a scale that is a power of two does not
// change a bit of the result, and derivatives do not overflow.
SplinePtr normalised(const Spline &fine, int axis) {
    const double extent = largest_magnitude(fine.points());
    const auto [lower, upper] = fine.axis(axis).domain();
    std::vector<double> knots, points;
    for (const double knot : fine.axis(axis).knots()) {
        knots.push_back((knot - lower) / (upper - lower));
    }
    for (const double x : fine.points()) {
        points.push_back(extent > 0 ? x / extent : 0);
    }
    Spline::Axes axes = fine.knot_vectors();
    axes[static_cast<size_t>(axis)] =
        std::make_shared<const KnotVector>(fine.axis(axis).degree(), std::move(knots));
    for (KnotVectorPtr &other : axes) {
        other = other->periodic()
                    ? std::make_shared<const KnotVector>(
                          other->degree(), std::vector<double>(other->knots().begin(), other->knots().end()))
                    : other;
    }
    return make_result(std::move(axes), fine.dim(), Form::polynomial, std::move(points));
}

// For each knot inside the domain: the largest jump of the derivative of order p, divided by the mean of the
// spans beside the knot.
std::vector<double> slopes(const Spline &steps, int axis, const std::vector<double> &breaks) {
    const AxisView view = axis_view(steps, axis, steps.dim());
    std::vector<double> result(breaks.size(), 0.0);
    std::vector<double> jump(static_cast<size_t>(steps.dim()));
    const double *const points = steps.points().data();
    const double length = breaks.back() - breaks.front();
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 1; i < std::min<int64_t>(view.count, std::ssize(breaks) - 1); ++i) {
            const auto at = static_cast<size_t>(i);
            const double step = (breaks[at + 1] - breaks[at - 1]) / 2 / length;
            for (int64_t inner = 0; inner < view.inner; inner += steps.dim()) {
                const double *const after = points + (o * view.count + i) * view.inner + inner;
                for (int64_t c = 0; c < steps.dim(); ++c) {
                    jump[static_cast<size_t>(c)] = after[c] - after[c - view.inner];
                }
                result[at] = std::max(result[at], norm(jump.data(), steps.dim()) / step);
            }
        }
    }
    return result;
}

// Replaces the slope at a multiple knot by the larger one of those beside it.
void leave_out_multiple_knots(const KnotVector &axis, std::vector<double> &slopes) {
    const auto groups = distinct_knots(axis.knots());
    const Interval domain = axis.domain();
    size_t i = 0;
    for (const KnotGroup &group : groups) {
        if (group.knot <= domain.lower || group.knot >= domain.upper) {
            continue;
        }
        ++i;
        if (group.multiplicity > 1) {
            slopes[i] = std::max(i > 1 ? slopes[i - 1] : 0, i + 2 < slopes.size() ? slopes[i + 1] : 0);
        }
    }
}

} // namespace

KnotDensity::KnotDensity(const SplinePtr &fine, int axis) {
    constexpr double everywhere = 0.02; // of the mean, so that no interval is empty
    const int p = fine->axis(axis).degree();
    const auto breaks = fine->axis(axis).spans().breaks();
    breaks_.assign(breaks.begin(), breaks.end());
    const SplinePtr unit = normalised(*fine, axis);
    const SplinePtr steps = p == 0 ? unit : refine::polynomial_derivative(unit, axis, p);
    std::vector<double> roots = slopes(*steps, axis, breaks_);
    leave_out_multiple_knots(fine->axis(axis), roots);
    for (double &root : roots) {
        root = std::pow(root, 1.0 / (p + 1));
    }
    const size_t spans = breaks_.size() - 1;
    if (spans > 1) { // at the ends as at the knots next to them
        roots.front() = roots[1];
        roots.back() = roots[spans - 1];
    }
    const double length = breaks_.back() - breaks_.front();
    double mean = 0;
    for (size_t i = 0; i < spans; ++i) {
        mean += (roots[i] + roots[i + 1]) / 2 * ((breaks_[i + 1] - breaks_[i]) / length);
    }
    sums_.push_back(0);
    for (size_t i = 0; i < spans; ++i) {
        const double density = (roots[i] + roots[i + 1]) / 2 + (mean > 0 ? everywhere * mean : 1);
        sums_.push_back(sums_.back() + density * ((breaks_[i + 1] - breaks_[i]) / length));
    }
}

std::vector<double> KnotDensity::knots(int64_t count) const {
    std::vector<double> knots;
    size_t span = 0;
    for (int64_t i = 1; i <= count; ++i) {
        const double sum = content() * (static_cast<double>(i) / static_cast<double>(count + 1));
        while (sums_[span + 1] < sum) {
            ++span;
        }
        const double part = (sum - sums_[span]) / (sums_[span + 1] - sums_[span]);
        const double knot = breaks_[span] + part * (breaks_[span + 1] - breaks_[span]);
        const double before = knots.empty() ? breaks_.front() : knots.back();
        if (knot > before && knot < breaks_.back()) {
            knots.push_back(knot);
        }
    }
    return knots;
}

} // namespace nrb::fit
