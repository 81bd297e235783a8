// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_points.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit {

namespace {

std::vector<Interval> domains_of(const std::vector<KnotVectorPtr> &axes) {
    std::vector<Interval> domains;
    for (const KnotVectorPtr &axis : axes) {
        domains.push_back(axis->domain());
    }
    return domains;
}

// Of the numbers among the values of data that count.
double largest_value(const Data &data, const CountedData &counts) noexcept {
    double largest = 0;
    for (int64_t i = 0; i < data.values.count; ++i) {
        for (int64_t c = 0; c < data.values.width; ++c) {
            const double value = std::abs(data.values(i, c));
            if (value > largest && std::isfinite(value) && counts(i)) {
                largest = value;
            }
        }
    }
    return largest;
}

// The squares that are left, of the spline as it is stored, and the largest one. The sums of the statistics tell the former
// to 2^-60 of what there was.
void compare(const Data &data, const eval::AxisRules &rules, int weight_exponent, FittedPoints &found) {
    constexpr int64_t block = 256;
    const Spline &spline = *found.fit.spline;
    const int64_t dim = spline.dim(), n = data.params.count;
    std::vector<double> points(static_cast<size_t>(block * dim)), difference(static_cast<size_t>(dim));
    const CountedData counts(data, rules, domains_of(spline.knot_vectors()), weight_exponent);
    DoubleDouble squares;
    bool overflows = false;
    Steps steps(n / block + 1);
    for (int64_t first = 0; first < n; first += block) {
        const int64_t count = std::min(block, n - first);
        ConstRecords params = data.params;
        params.data += first * params.stride;
        params.count = count;
        eval::evaluate_points(spline, rules, 0, params, {points.data(), count, dim, dim});
        for (int64_t i = 0; i < count; ++i) {
            for (int64_t c = 0; c < dim; ++c) {
                difference[static_cast<size_t>(c)] =
                    points[static_cast<size_t>(i * dim + c)] - data.values(first + i, c);
            }
            const double distance = norm(difference.data(), static_cast<int>(dim));
            const double weight = data.weights.data == nullptr ? 1 : data.weights(first + i, 0);
            if (!counts(first + i)) {
                continue;
            }
            overflows = overflows || !std::isfinite(weight * distance * distance);
            squares = squares + DoubleDouble(overflows ? 0 : weight * distance * distance);
            if (distance > found.largest) {
                found.largest = distance;
                found.largest_index = first + i;
            }
        }
        steps.next(8 * count * dim);
    }
    found.fit.squares = overflows ? INFINITY : squares.high;
}

} // namespace

std::shared_ptr<const StatisticsForm> form_for(const Data &data, const eval::AxisRules &rules,
                                               const std::vector<KnotVectorPtr> &axes) {
    StatisticsForm form{{}, {}, static_cast<int>(data.values.width), 0, 0};
    for (const KnotVectorPtr &axis : axes) {
        const auto breaks = axis->spans().breaks();
        form.degrees.push_back(axis->degree());
        form.breaks.push_back(
            std::make_shared<const KnotVector>(0, std::vector<double>(breaks.begin(), breaks.end())));
    }
    form.weight_exponent = exponent_above(largest_weight(data));
    const CountedData counts(data, rules, domains_of(axes), form.weight_exponent);
    form.value_exponent = exponent_above(largest_value(data, counts));
    return std::make_shared<const StatisticsForm>(std::move(form));
}

int exponent_above(double value) noexcept {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return mantissa == 0.5 ? exponent - 1 : exponent;
}

FittedPoints fit_points(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes, bool compared) {
    const Statistics statistics = [&] {
        const Phase phase(0.5);
        return gather(form_for(data, rules, axes), data, rules);
    }();
    FittedPoints found{{}, statistics.data_count(), -1, -1};
    {
        const Phase phase(0.7);
        found.fit = fit(statistics, axes, wishes);
    }
    if (compared) {
        eval::AxisRules missing = rules; // what was left out has no distance
        for (eval::AxisRule &rule : missing) {
            rule.nan = true;
        }
        compare(data, missing, statistics.form().weight_exponent, found);
    }
    found.largest = std::max(found.largest, 0.0);
    return found;
}

} // namespace nrb::fit
