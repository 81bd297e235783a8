// SPDX-License-Identifier: MIT
#include "spline/scaled.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::inline spline {

namespace {

constexpr int64_t work_of_a_value = 8; // scaling by a power of two

KnotVectorPtr multiplied(const KnotVectorPtr &axis, int exponent) {
    if (exponent == 0) {
        return axis;
    }
    std::vector<double> knots(axis->knots().begin(), axis->knots().end());
    for (double &t : knots) {
        t = std::ldexp(t, exponent);
    }
    return std::make_shared<const KnotVector>(axis->degree(), std::move(knots), axis->periodic());
}

} // namespace

int kept_apart(std::span<const KnotVectorPtr> axes, int exponent) noexcept {
    constexpr int most = 1000;
    double largest = 0, least = std::numeric_limits<double>::max();
    for (const KnotVectorPtr &axis : axes) {
        const std::span<const double> knots = axis->knots();
        largest = std::max({largest, std::fabs(knots.front()), std::fabs(knots.back())});
        for (size_t i = 1; i < knots.size(); ++i) {
            const double apart = knots[i] - knots[i - 1];
            least = apart > 0 ? std::min(least, apart) : least;
        }
    }
    const int raised = std::max(exponent, std::min(-most - std::ilogb(least), 0));
    return std::min(raised, std::max(most - std::ilogb(largest), 0));
}

SplinePtr scaled(const Spline &spline, const Powers &powers) {
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        axes.push_back(multiplied(spline.knot_vectors()[at], powers.knots[at]));
    }
    std::vector<double> points = copied_watched(spline.points());
    const auto width = static_cast<size_t>(spline.stored_width()), dim = static_cast<size_t>(spline.dim());
    for (size_t i = 0; i < points.size(); ++i) {
        count_work(work_of_a_value);
        points[i] = std::ldexp(points[i], i % width < dim ? powers.coordinates : powers.weights);
    }
    std::vector<double> weights(spline.weights().begin(), spline.weights().end());
    for (double &w : weights) {
        w = std::ldexp(w, powers.weights);
    }
    return std::make_shared<const Spline>(std::move(axes), spline.dim(), spline.form(), std::move(points),
                                          std::move(weights));
}

} // namespace nrb::inline spline
