// SPDX-License-Identifier: MIT
#include "refine/periodic/period.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// Fills in the knots before `begin` and from `end` on, by copies a period (`step` knots) away.
void continue_both_ways(std::vector<double> &knots, size_t begin, size_t end, size_t step,
                        double period) noexcept {
    for (size_t i = begin; i-- > 0;) {
        const bool repeated = knots[i + step] == knots[i + step + 1];
        knots[i] = repeated ? knots[i + 1] : std::min(knots[i + step] - period, knots[i + 1]);
    }
    for (size_t i = end; i < knots.size(); ++i) {
        const bool repeated = knots[i - step] == knots[i - step - 1];
        knots[i] = repeated ? knots[i - 1] : std::max(knots[i - step] + period, knots[i - 1]);
    }
}

void check_range(const std::vector<double> &knots) {
    if (!std::isfinite(knots.back() - knots.front())) {
        fail(Status::not_representable, "knots: those of the periods beside the domain overflow");
    }
}

} // namespace

void continue_knots(std::vector<double> &knots, size_t first, size_t last, size_t step) {
    continue_both_ways(knots, first, last + 1, step, knots[last] - knots[first]);
    check_range(knots);
}

std::vector<double> extended_knots(const KnotVector &axis, int64_t lead) {
    const std::span<const double> stored = axis.knots();
    const auto first = static_cast<size_t>(lead);
    std::vector<double> knots(stored.size() + 2 * first);
    std::copy(stored.begin(), stored.end(), knots.begin() + lead);
    continue_both_ways(knots, first, first + stored.size(), static_cast<size_t>(axis.distinct_layers()),
                       axis.domain().upper - axis.domain().lower);
    check_range(knots);
    return knots;
}

} // namespace nrb::refine
