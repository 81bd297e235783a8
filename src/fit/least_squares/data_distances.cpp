// SPDX-License-Identifier: MIT
#include "fit/least_squares/data_distances.h"

#include "base/small_width.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"

#include <algorithm>
#include <limits>

namespace nrb::fit {

namespace {

constexpr int64_t block_size = 256;

std::vector<Interval> domains_of(const Spline &spline) {
    std::vector<Interval> domains;
    for (const KnotVectorPtr &axis : spline.knot_vectors()) {
        domains.push_back(axis->domain());
    }
    return domains;
}

// The rules with NaN instead of errors: a datum that is left out because of its parameter has no distance.
eval::AxisRules missing_as_nan(eval::AxisRules rules) noexcept {
    for (eval::AxisRule &rule : rules) {
        rule.nan = true;
    }
    return rules;
}

} // namespace

void for_each_distance(const Data &data, const eval::AxisRules &given, int weight_exponent,
                       const Spline &spline,
                       const std::function<void(int64_t, std::span<const double>)> &visit) {
    const eval::AxisRules rules = missing_as_nan(given);
    const int64_t dim = spline.dim(), n = data.params.count;
    const CountedData counts(data, rules, domains_of(spline), weight_exponent);
    std::vector<double> points(static_cast<size_t>(block_size * dim)), distances(block_size);
    Steps steps(n / block_size + 1);
    for (int64_t first = 0; first < n; first += block_size) {
        const int64_t count = std::min(block_size, n - first);
        ConstRecords params = data.params;
        params.data += first * params.stride;
        params.count = count;
        eval::evaluate_points(spline, rules, 0, params, {points.data(), count, dim, dim});
        const std::span<double> own = std::span(distances).first(static_cast<size_t>(count));
        with_width(dim, [&](auto width) {
            norms_of(
                width,
                [&](size_t i, int c) {
                    const auto at = static_cast<int64_t>(i);
                    return points[i * static_cast<size_t>(width) + static_cast<size_t>(c)] -
                           data.values(first + at, c);
                },
                own);
        });
        const bool all = counts.surely_all(first, count);
        for (int64_t i = 0; i < count && !all; ++i) {
            if (!counts(first + i)) {
                own[static_cast<size_t>(i)] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        visit(first, own);
        steps.next(8 * count * dim);
    }
}

} // namespace nrb::fit
