// SPDX-License-Identifier: MIT
// Span search in constant expected time: uniform buckets over the domain, each of which refers to the few
// spans that meet it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace nrb::inline basis {

// Only non-empty spans are listed; they are numbered from 0. The bucket of a parameter t is floor((t - lower)
// * scale). In floating point this is still a monotone function of t. So breaks in lower buckets are <= t and
// breaks in higher buckets are > t without any safety margin, and only the breaks in the bucket of t need a
// comparison. Most buckets contain at most one break.
class SpanTable {
public:
    // The search itself: a small value that loops keep in registers.
    class Finder {
    public:
        // Number of the non-empty span with breaks[i] <= t < breaks[i + 1], or, with `left`, breaks[i] < t
        // <= breaks[i + 1]; outside the domain the first or the last one. Precondition: t is not NaN.
        template <bool left>
        [[nodiscard]] int64_t number(double t) const noexcept {
            return number_in<left>(buckets_ + bucket(t), std::min(t, std::numeric_limits<double>::max()));
        }
        // The same for a parameter inside the domain.
        [[nodiscard]] int64_t number_inside(double t) const noexcept {
            return number_in<false>(buckets_ + static_cast<int64_t>((t - lower_) * scale_), t);
        }

    private:
        friend class SpanTable;
        struct Bucket {
            double inner;   // the only break in the bucket; infinity: none; NaN: several
            int64_t before; // number of breaks in lower buckets
        };
        template <bool left>
        [[nodiscard]] int64_t number_in(const Bucket *bucket, double t) const noexcept {
            if (bucket->inner != bucket->inner) {
                return search<left>(t, bucket[0].before, bucket[1].before);
            }
            return bucket->before + ((left ? bucket->inner < t : bucket->inner <= t) ? 1 : 0);
        }
        template <bool left>
        [[nodiscard]] int64_t search(double t, int64_t rank, int64_t end) const noexcept;

        [[nodiscard]] int64_t bucket(double t) const noexcept {
            const double x = (t - lower_) * scale_;
            return x > 0 ? static_cast<int64_t>(x < last_bucket_ ? x : last_bucket_) : 0;
        }

        double lower_ = 0;
        double scale_ = 0;
        double last_bucket_ = 0;
        const Bucket *buckets_ = nullptr; // and one sentinel after the last
        const double *breaks_ = nullptr;
    };

    // Precondition: the knots do not decrease, and knots[degree] < knots[size - degree - 1].
    SpanTable(int degree, std::span<const double> knots);
    SpanTable(SpanTable &&) noexcept = default;
    SpanTable(const SpanTable &) = delete;
    SpanTable &operator=(const SpanTable &) = delete;

    [[nodiscard]] const Finder &finder() const noexcept { return finder_; }
    [[nodiscard]] int64_t number(double t, bool left) const noexcept {
        return left ? finder_.number<true>(t) : finder_.number<false>(t);
    }
    // The index of that span in the knot vector.
    [[nodiscard]] int64_t find(double t, bool left) const noexcept {
        return span_[static_cast<size_t>(number(t, left))];
    }
    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(span_.size()); }
    // Start of non-empty span number i, and its index in the knot vector; breaks()[size()] is the end of the
    // domain.
    [[nodiscard]] std::span<const double> breaks() const noexcept { return breaks_; }
    [[nodiscard]] std::span<const int64_t> indices() const noexcept { return span_; }

private:
    // Fills `buckets` buckets; returns whether no bucket contains more than one break.
    bool fill(size_t buckets);

    std::vector<double> breaks_;
    std::vector<int64_t> span_;
    std::vector<Finder::Bucket> buckets_;
    Finder finder_; // points into the vectors
};

// As SpanTable::find(), but without a table: by binary search.
int64_t find_span(int degree, std::span<const double> knots, double t, bool left) noexcept;

} // namespace nrb::inline basis
