// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_points.h"

#include "base/watch.h"
#include "fit/least_squares/data_distances.h"
#include "numeric/power_of_two.h"
#include "numeric/sum.h"

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

// The sums of the statistics tell the squares to 2^-60 of what there was.
void compare(const Data &data, const eval::AxisRules &rules, FittedPoints &found) {
    Misfit &misfit = found.fit.misfit;
    CompensatedSum squares;
    double largest = -1;
    for_each_distance(data, rules, misfit.weight_exponent, *found.fit.spline,
                      [&](int64_t first, std::span<const double> distances) {
                          for (size_t i = 0; i < distances.size(); ++i) {
                              const int64_t at = first + static_cast<int64_t>(i);
                              const double distance = distances[i];
                              if (std::isnan(distance)) {
                                  continue;
                              }
                              const double part = times_power_of_two(distance, -misfit.value_exponent),
                                           weight = times_power_of_two(weight_of(data, at),
                                                                       -misfit.weight_exponent);
                              squares.add(weight * part * part);
                              if (distance > largest) {
                                  largest = distance;
                                  found.largest_index = at;
                              }
                          }
                      });
    found.largest = std::max(largest, 0.0);
    misfit.squares = squares.value();
}

FittedPoints fit_points(const Data &data, const eval::AxisRules &rules,
                        const std::vector<KnotVectorPtr> &axes, const FitWishes &wishes, bool compared) {
    const Statistics statistics = [&] {
        const Phase phase(0.5);
        return gather(form_for(data, rules, axes), data, rules);
    }();
    FittedPoints found{{}, statistics.data_count(), 0, -1};
    {
        const Phase phase(0.7);
        found.fit = fit(statistics, axes, wishes);
    }
    if (compared) {
        compare(data, rules, found);
    }
    return found;
}

} // namespace nrb::fit
