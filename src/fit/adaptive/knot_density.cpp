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

// Of each knot inside the domain: the largest jump of the derivative of order p, divided by the mean of the spans beside it.
std::vector<double> slopes(const Spline &steps, int axis, int order, double extent,
                           const std::vector<double> &breaks) {
    const AxisView view = axis_view(steps, axis, steps.dim());
    // In units of the largest control point and of the domain: no power of two in a scale changes a bit.
    const double length = breaks.back() - breaks.front();
    std::vector<double> result(breaks.size(), 0.0);
    if (!(extent > 0)) {
        return result;
    }
    double unit = 1 / extent;
    for (int r = 0; r < order; ++r) {
        unit *= length;
    }
    std::vector<double> jump(static_cast<size_t>(steps.dim()));
    const double *const points = steps.points().data();
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 1; i < view.count; ++i) {
            const double step =
                (breaks[static_cast<size_t>(i) + 1] - breaks[static_cast<size_t>(i) - 1]) / 2 / length;
            for (int64_t inner = 0; inner < view.inner; inner += steps.dim()) {
                const double *const after = points + (o * view.count + i) * view.inner + inner;
                for (int64_t c = 0; c < steps.dim(); ++c) {
                    jump[static_cast<size_t>(c)] = (after[c] - after[c - view.inner]) * unit;
                }
                double &largest = result[static_cast<size_t>(i)];
                largest = std::max(largest, norm(jump.data(), steps.dim()) / step);
            }
        }
    }
    return result;
}

// At multiple knots, the larger one of the slopes beside them.
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
    const SplinePtr steps = p == 0 ? fine : refine::polynomial_derivative(fine, axis, p);
    std::vector<double> roots = slopes(*steps, axis, p, largest_magnitude(fine->points()), breaks_);
    leave_out_multiple_knots(fine->axis(axis), roots);
    for (double &root : roots) {
        root = std::pow(root, 1.0 / (p + 1));
    }
    const size_t spans = breaks_.size() - 1;
    if (spans > 1) { // beyond the ends as at the knots next to them
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
