// SPDX-License-Identifier: MIT
#include "basis/span_table.h"

#include "base/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace nrb::inline basis {

SpanTable::SpanTable(int degree, std::span<const double> knots) {
    const auto first = static_cast<size_t>(degree);
    const size_t last = knots.size() - first - 1;
    for (size_t i = first; i < last; ++i) {
        if (knots[i] < knots[i + 1]) {
            breaks_.push_back(knots[i]);
            span_.push_back(static_cast<int64_t>(i));
        }
    }
    breaks_.push_back(knots[last]);
    finder_.lower_ = breaks_.front();
    finder_.breaks_ = breaks_.data();

    // More buckets make it rarer that a bucket contains several breaks, but enlarge the table. With eight
    // buckets per span, about one percent of unevenly spaced breaks share a bucket; evenly spaced ones never
    // do.
    const size_t most = std::bit_ceil(8 * span_.size());
    size_t buckets = std::bit_ceil(2 * span_.size());
    while (!fill(buckets) && buckets < most && finder_.scale_ > 0) {
        buckets *= 2;
    }
}

bool SpanTable::fill(size_t buckets) {
    using Bucket = Finder::Bucket;
    const double length = breaks_.back() - breaks_.front();
    finder_.scale_ = static_cast<double>(buckets) / length;
    if (!std::isfinite(finder_.scale_)) { // a domain too short for the scale gets one bucket
        finder_.scale_ = 0;
        buckets = 1;
    }
    while (length * finder_.scale_ >= static_cast<double>(buckets)) { // saves number_inside() a comparison
        finder_.scale_ = std::nextafter(finder_.scale_, 0.0);
    }
    finder_.last_bucket_ = static_cast<double>(buckets - 1);
    buckets_.assign(buckets + 1, Bucket{infinity, 0});
    finder_.buckets_ = buckets_.data();
    bool single = true;
    for (size_t i = 1; i < span_.size(); ++i) {
        Bucket &own = buckets_[static_cast<size_t>(finder_.bucket(breaks_[i]))];
        const bool alone = own.before == 0;
        own.inner = alone ? breaks_[i] : nan_value;
        ++own.before;
        single = single && alone;
    }
    int64_t before = 0;
    for (Bucket &bucket : buckets_) {
        before += std::exchange(bucket.before, before);
    }
    return single;
}

template <bool left>
int64_t SpanTable::Finder::search(double t, int64_t rank, int64_t end) const noexcept {
    const double *inner = breaks_ + 1;
    int64_t remaining = end - rank;
    while (remaining > 0) {
        const int64_t half = remaining / 2;
        const bool below = left ? inner[rank + half] < t : inner[rank + half] <= t;
        rank = below ? rank + half + 1 : rank;
        remaining = below ? remaining - half - 1 : half;
    }
    return rank;
}

template int64_t SpanTable::Finder::search<true>(double, int64_t, int64_t) const noexcept;
template int64_t SpanTable::Finder::search<false>(double, int64_t, int64_t) const noexcept;

int64_t find_span(int degree, std::span<const double> knots, double t, bool left) noexcept {
    const auto p = static_cast<std::ptrdiff_t>(degree);
    const auto begin = knots.begin() + p;
    const auto end = knots.end() - p - 1; // the end of the domain
    // The break that ends the span: the first one beyond t, inside the domain.
    const double clamped = std::clamp(t, *begin, *end);
    auto after = left ? std::lower_bound(begin, end, clamped) : std::upper_bound(begin, end, clamped);
    after = *after == *begin ? std::upper_bound(begin, end, *begin) : after;
    after = *after == *end ? std::lower_bound(begin, end, *end) : after;
    return after - knots.begin() - 1;
}

} // namespace nrb::inline basis
