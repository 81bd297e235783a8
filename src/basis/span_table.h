// Span search in constant expected time: uniform buckets over the domain, each naming the few spans that it
// can meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nrb {

// Only non-empty spans are listed. A parameter's bucket is floor((t - lower) * scale); in floating point this
// is a monotone function of t, so that breaks in lower buckets are <= t and breaks in higher buckets are > t
// without any safety margin, and only the breaks of t's own bucket need a comparison.
class SpanTable {
public:
    // Precondition: knots are non-decreasing with knots[degree] < knots[size - degree - 1].
    SpanTable(int degree, std::span<const double> knots);

    // Index s of the non-empty span with knots[s] <= t < knots[s + 1]; outside the domain the first or the
    // last span. `left` takes knots[s] < t <= knots[s + 1] in place of it. Precondition: t is not NaN.
    [[nodiscard]] int64_t find(double t, bool left) const noexcept;
    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(span_.size()); }
    // Start of non-empty span number i, and its index in the knot vector; breaks()[size()] is the end of the
    // domain.
    [[nodiscard]] std::span<const double> breaks() const noexcept { return breaks_; }
    [[nodiscard]] std::span<const int64_t> indices() const noexcept { return span_; }

private:
    template <bool left>
    [[nodiscard]] int64_t rank(double t) const noexcept;
    [[nodiscard]] int64_t bucket(double t) const noexcept;

    std::vector<double> breaks_;
    std::vector<int64_t> span_;
    std::vector<int64_t> first_; // first_[b]: number of breaks between spans that lie in buckets below b
    double lower_ = 0;
    double scale_ = 0;
    double last_bucket_ = 0;
};

} // namespace nrb
