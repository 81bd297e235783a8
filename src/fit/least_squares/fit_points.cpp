// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_points.h"

#include "base/finite.h"
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
    domains.reserve(axes.size());
    for (const KnotVectorPtr &axis : axes) {
        domains.push_back(axis->domain());
    }
    return domains;
}

// The largest magnitude among the finite values of one datum, if it is above what is known and the datum
// counts.
double larger_value(const Data &data, const CountedData &counts, int64_t i, double known) noexcept {
    for (int64_t c = 0; c < data.values.width; ++c) {
        const double value = std::abs(data.values(i, c));
        if (value > known && std::isfinite(value) && counts(i)) {
            known = value;
        }
    }
    return known;
}

// Looks at single data only in blocks that exceed all before, which few blocks of packed values do.
double largest_value(const Data &data, const CountedData &counts) noexcept {
    constexpr int64_t block = 256;
    const ConstRecords &values = data.values;
    const bool packed = values.component_stride == 1 && values.stride == values.width;
    double largest = 0;
    for (int64_t first = 0; first < values.count; first += block) {
        const int64_t count = std::min(block, values.count - first);
        if (packed && !(largest_magnitude({values.record(first), static_cast<size_t>(count * values.width)}) >
                        largest)) {
            continue;
        }
        for (int64_t i = first; i < first + count; ++i) {
            largest = larger_value(data, counts, i, largest);
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

namespace {

// The sum of squares and the largest distance of the data that count.
struct Comparison {
    CompensatedSum squares;
    double largest = -1;
    int64_t largest_index = -1;

    // Adds distances, in units of the misfit.
    void add(const Data &data, const Misfit &units, int64_t first,
             std::span<const double> distances) noexcept {
        const int of_values = -units.value_exponent, of_weights = -units.weight_exponent;
        for (size_t i = 0; i < distances.size(); ++i) {
            const double distance = distances[i];
            if (std::isnan(distance)) {
                continue;
            }
            const int64_t at = first + static_cast<int64_t>(i);
            const double part = times_power_of_two(distance, of_values),
                         weight = times_power_of_two(weight_of(data, at), of_weights);
            squares.add(weight * part * part);
            if (distance > largest) {
                largest = distance;
                largest_index = at;
            }
        }
    }
};

} // namespace

// Compares with the data themselves, because the statistics give the remaining squares only to within 2^-60
// of the squares of the data.
void compare(const Data &data, const eval::AxisRules &rules, FittedPoints &found) {
    Misfit &misfit = found.fit.misfit;
    Comparison all;
    for_each_distance(data, rules, misfit.weight_exponent, *found.fit.spline,
                      [&](int64_t first, std::span<const double> distances) {
                          Comparison next = all; // kept in registers
                          next.add(data, misfit, first, distances);
                          all = next;
                      });
    found.largest = std::max(all.largest, 0.0);
    found.largest_index = all.largest_index;
    misfit.squares = all.squares.value();
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
