// SPDX-License-Identifier: MIT
#include "basis/power_spans.h"

#include "base/numbers.h"
#include "basis/knot_vector.h"

#include <algorithm>

namespace nrb::inline basis {

PowerSpans::PowerSpans(int64_t count, int64_t size) : size_(size) {
    constexpr size_t line = 64 / sizeof(double);
    storage_.resize(static_cast<size_t>(count * size) + line - 1);
    const size_t offset = reinterpret_cast<uintptr_t>(storage_.data()) / sizeof(double) % line;
    first_ = storage_.data() + (line - offset) % line;
}

PowerSpans basis_power_spans(const KnotVector &axis) {
    const SpanTable &spans = axis.spans();
    PowerSpans power_spans(spans.size(), PowerSpan::size(axis.degree(), axis.degree() + 1));
    for (int64_t first = 0; first < spans.size(); first += power_spans_together()) {
        const auto count = static_cast<int>(std::min<int64_t>(power_spans_together(), spans.size() - first));
        double *together[most_power_spans_together];
        for (int l = 0; l < count; ++l) {
            together[l] = power_spans[first + l];
        }
        basis_power_spans(axis.knots().data(), axis.degree(), spans.indices().data() + first, count, together,
                          nullptr);
        for (int l = 0; l < count; ++l) {
            if (!axis.has_power_span(spans.indices()[static_cast<size_t>(first + l)])) {
                std::fill_n(together[l], static_cast<int>(PowerSpan::head_size), nan_value);
            }
        }
    }
    return power_spans;
}

} // namespace nrb::inline basis
