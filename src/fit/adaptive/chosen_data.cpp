// SPDX-License-Identifier: MIT
#include "fit/adaptive/chosen_data.h"

#include "fit/least_squares/fit_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::fit {

namespace {

void sort_by_parameter(const Data &all, std::vector<int64_t> &indices) {
    std::ranges::stable_sort(indices, {}, [&](int64_t i) { return all.params(i, 0); });
}

PackedData packed(const Data &all, const std::vector<int64_t> &indices) {
    PackedData result(all);
    for (const int64_t i : indices) {
        result.add(all, i);
    }
    return result;
}

} // namespace

PackedData::PackedData(const Data &kind)
    : axes_(kind.params.width), dim_(kind.values.width), weighted_(kind.weights.data != nullptr) {}

void PackedData::add(const Data &all, int64_t i) {
    std::array<double, max_axes> params{};
    for (int64_t k = 0; k < axes_; ++k) {
        params[static_cast<size_t>(k)] = all.params(i, k);
    }
    add(all, i, params.data());
}

void PackedData::add(const Data &all, int64_t i, const double *params) {
    params_.insert(params_.end(), params, params + axes_);
    for (int64_t c = 0; c < dim_; ++c) {
        values_.push_back(all.values(i, c));
    }
    if (weighted_) {
        weights_.push_back(all.weights(i, 0));
    }
    ++count_;
}

Data PackedData::data() const noexcept {
    const auto view = [&](const std::vector<double> &numbers, int64_t width) {
        return ConstRecords{numbers.data(), count_, width, width, 1};
    };
    return {view(params_, axes_), view(values_, dim_), weighted_ ? view(weights_, 1) : ConstRecords{}};
}

PackedData some_of(const Data &all, int64_t size) {
    constexpr double golden = 0.6180339887498949;
    const int64_t n = all.params.count;
    const double step = static_cast<double>(n) / static_cast<double>(size);
    std::vector<int64_t> chosen;
    for (int64_t j = 0; j < size; ++j) {
        const double shift = std::fmod(golden * static_cast<double>(j), 1);
        const auto i = static_cast<int64_t>((static_cast<double>(j) + shift) * step);
        chosen.push_back(j == 0 ? 0 : j + 1 == size ? n - 1 : std::min(i, n - 1));
    }
    if (all.params.width == 1) {
        sort_by_parameter(all, chosen);
    }
    return packed(all, chosen);
}

PackedData data_between(const Data &all, double lower, double upper) {
    std::vector<int64_t> chosen;
    for (int64_t i = 0; i < all.params.count; ++i) {
        const double t = all.params(i, 0);
        if (t >= lower && t <= upper && (all.weights.data == nullptr || all.weights(i, 0) > 0)) {
            chosen.push_back(i);
        }
    }
    sort_by_parameter(all, chosen);
    return packed(all, chosen);
}

bool is_clean(const Data &all, const eval::AxisRules &rules) noexcept {
    return all.weights.data == nullptr && std::ranges::all_of(rules, [](const eval::AxisRule &rule) {
               return !rule.nan && rule.outside == eval::Outside::refuse;
           });
}

CleanData::CleanData(const Data &all, const eval::AxisRules &rules, const std::vector<Interval> &domains)
    : packed(all) {
    const CountedData counts(all, rules, domains, exponent_above(largest_weight(all)));
    for (int64_t i = 0; i < all.params.count; ++i) {
        if (!counts(i)) {
            continue;
        }
        std::array<double, max_axes> params{};
        for (size_t k = 0; k < domains.size(); ++k) {
            params[k] = counts.place(i, k);
        }
        packed.add(all, i, params.data());
        indices.push_back(i);
    }
}

} // namespace nrb::fit
