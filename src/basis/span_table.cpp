#include "basis/span_table.h"

#include <bit>
#include <cmath>

namespace nrb {

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

    // Two buckets a span leave most of them with at most one break. A domain too short for the scale gets one
    // bucket.
    size_t buckets = std::bit_ceil(2 * span_.size());
    lower_ = knots[first];
    scale_ = static_cast<double>(buckets) / (knots[last] - lower_);
    if (!std::isfinite(scale_)) {
        scale_ = 0;
        buckets = 1;
    }
    last_bucket_ = static_cast<double>(buckets - 1);
    first_.assign(buckets + 1, 0);
    for (size_t i = 1; i < span_.size(); ++i) {
        ++first_[static_cast<size_t>(bucket(breaks_[i])) + 1];
    }
    for (size_t b = 1; b <= buckets; ++b) {
        first_[b] += first_[b - 1];
    }
}

int64_t SpanTable::bucket(double t) const noexcept {
    const double x = (t - lower_) * scale_;
    if (!(x > 0)) {
        return 0;
    }
    return static_cast<int64_t>(x < last_bucket_ ? x : last_bucket_);
}

template <bool left>
int64_t SpanTable::rank(double t) const noexcept {
    const auto b = static_cast<size_t>(bucket(t));
    const double *inner = breaks_.data() + 1;
    int64_t rank = first_[b];
    int64_t remaining = first_[b + 1] - rank;
    while (remaining > 0) {
        const int64_t half = remaining / 2;
        const bool below = left ? inner[rank + half] < t : inner[rank + half] <= t;
        rank = below ? rank + half + 1 : rank;
        remaining = below ? remaining - half - 1 : half;
    }
    return rank;
}

int64_t SpanTable::find(double t, bool left) const noexcept {
    return span_[static_cast<size_t>(left ? rank<true>(t) : rank<false>(t))];
}

} // namespace nrb
