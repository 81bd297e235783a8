// SPDX-License-Identifier: MIT
// The sources of the basis functions of one axis: the tables of spans and power spans if they exist;
// otherwise the same power spans made anew for each parameter; or the Cox-de Boor recurrence where a span has
// no power span.
#pragma once

#include "base/scratch.h"
#include "basis/bspline.h"
#include "eval/parameters.h"

#include <algorithm>

namespace nrb::eval {

// The layers that are active at a parameter: `first` is the first of them, or negative if the parameter gives
// NaN. `sole` is the index, relative to `first`, of the one layer whose function is 1 while all others are 0;
// -1 if there is none.
struct AxisPoint {
    int64_t first;
    int sole;

    [[nodiscard]] bool valid() const noexcept { return first >= 0; }
};

// The largest number of parameters for which the functions are computed together.
inline constexpr int64_t axis_block_size = 32;

// The data of one axis of a spline that a batch looks up once, and working memory.
struct AxisSource {
    AxisSource() noexcept = default;
    AxisSource(const Spline &spline, int k, const AxisRule &axis_rule, int order, int64_t uses)
        : axis(&spline.axis(k)), rule(axis_rule), domain(axis->domain()), degree(axis->degree()),
          lanes(PowerSpan::lanes(degree + 1)), has_power_spans(spline.has_power_spans(k)),
          spans(axis->spans_after(uses)),
          power_spans(has_power_spans ? axis->power_spans_after(uses) : nullptr),
          work_size(size_of_work(order)) {
        spans = power_spans != nullptr ? &axis->spans() : spans;
    }

    [[nodiscard]] int64_t values_size(int order) const noexcept {
        return static_cast<int64_t>(order + 1) * lanes;
    }
    void take_work(Scratch &scratch) noexcept { work = scratch.take(work_size); }

    const KnotVector *axis = nullptr;
    AxisRule rule;
    Interval domain{};
    int degree = 0;
    int lanes = 0;
    bool has_power_spans = false;
    const SpanTable *spans = nullptr;
    const PowerSpans *power_spans = nullptr; // null while there is no table
    size_t work_size = 0;
    double *work = nullptr;

private:
    [[nodiscard]] size_t size_of_work(int order) const noexcept {
        const auto recurrence = static_cast<size_t>(order + 1) * static_cast<size_t>(degree + 1);
        return std::max(recurrence,
                        has_power_spans ? static_cast<size_t>(PowerSpan::size(degree, degree + 1)) : 0);
    }
};

using AxisSources = std::array<AxisSource, max_axes>;

inline AxisSources axis_sources(const Spline &spline, const AxisRules &rules, int order,
                                const std::array<int64_t, max_axes> &uses) {
    AxisSources sources;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        sources[at] = AxisSource(spline, k, rules[at], order, uses[at]);
    }
    return sources;
}

} // namespace nrb::eval
