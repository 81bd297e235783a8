// SPDX-License-Identifier: MIT
#include "fit/largest_miss.h"

#include "base/watch.h"
#include "basis/bspline.h"
#include "eval/evaluate.h"
#include "eval/parameters.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>

namespace nrb::fit {

namespace {

// Evaluates one parameter at a time: there is about one in each span, and tables that speed up further ones
// in the same span would cost ten times as much.
double miss_of_curve(const Spline &curve, std::span<const double> params, const std::vector<double> &points) {
    const KnotVector &axis = curve.axis(0);
    const double *const knots = axis.knots().data();
    const int p = axis.degree(), dim = curve.dim();
    const Interval domain = axis.domain();
    const auto at_end = axis.find_span(domain.upper, true);
    const eval::AxisRule wraps{.outside = eval::Outside::wrap}; // parameters of periodic curves
    std::vector<double> point(static_cast<size_t>(dim));
    double largest = 0;
    int64_t span = p;
    for (size_t i = 0; i < params.size(); ++i) {
        const double t = axis.periodic() ? eval::place(params[i], wraps, domain) : params[i];
        span = t < knots[span] ? p : span;
        while (span < at_end && knots[span + 1] <= t) {
            ++span;
        }
        double values[max_basis];
        basis_values(knots, p, span, t, values);
        const double *const active = curve.points().data() + (span - p) * dim;
        for (int c = 0; c < dim; ++c) {
            double sum = 0;
            for (int j = 0; j <= p; ++j) {
                sum += values[j] * active[j * dim + c];
            }
            point[static_cast<size_t>(c)] = sum;
        }
        largest = std::max(largest, distance(point.data(), points.data() + i * point.size(), dim));
        count_work(int64_t{p + 1} * (p + 1 + dim));
    }
    return largest;
}

double miss_of_grid(const Spline &spline, std::span<const double> params, const PointGrid &grid) {
    std::array<ConstRecords, max_axes> axes{};
    eval::AxisRules rules{};
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        axes[k] = {params.data(), grid.counts[k]};
        params = params.subspan(static_cast<size_t>(grid.counts[k]));
        rules[k].outside =
            spline.axis(static_cast<int>(k)).periodic() ? eval::Outside::wrap : eval::Outside::refuse;
    }
    std::vector<double> values(grid.points.size());
    const int64_t dim = grid.dim, count = std::ssize(values) / dim;
    eval::evaluate_grid(spline, rules, 0, axes, {values.data(), count, dim, dim});
    double largest = 0;
    for (int64_t i = 0; i < count; ++i) {
        largest =
            std::max(largest, distance(values.data() + i * dim, grid.points.data() + i * dim, grid.dim));
    }
    return largest;
}

} // namespace

double largest_miss(const Spline &spline, std::span<const double> params, const PointGrid &grid) {
    return spline.axes() == 1 ? miss_of_curve(spline, params, grid.points)
                              : miss_of_grid(spline, params, grid);
}

} // namespace nrb::fit
