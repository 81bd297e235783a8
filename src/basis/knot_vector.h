// SPDX-License-Identifier: MIT
// Knot vectors: an immutable value shared by the axes of splines, with its validation and simple queries.
#pragma once

#include "base/lazy.h"
#include "basis/power_spans.h"
#include "basis/span_table.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace nrb::inline basis {

struct Interval {
    double lower;
    double upper;
};

class KnotVector {
public:
    // Takes a full vector of count + degree + 1 knots. Precondition: check_knots() accepts it.
    KnotVector(int degree, std::vector<double> knots, bool periodic = false) noexcept;

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] bool periodic() const noexcept { return periodic_; }
    [[nodiscard]] std::span<const double> knots() const noexcept { return knots_; }
    [[nodiscard]] double operator[](int64_t i) const noexcept { return knots_[static_cast<size_t>(i)]; }
    [[nodiscard]] int64_t count() const noexcept { return static_cast<int64_t>(knots_.size()) - degree_ - 1; }
    [[nodiscard]] Interval domain() const noexcept { return {(*this)[degree_], (*this)[count()]}; }
    // The layers [first, end) of control points whose basis functions are not identically zero on the domain.
    // These are all layers, unless knots outside the domain repeat its start or its end. On a periodic axis,
    // layers whose functions vanish are copies of others, and all layers count.
    struct Layers {
        int64_t first;
        int64_t end;
    };
    [[nodiscard]] Layers active_layers() const noexcept;
    // The number of distinct layers of control points: count() - degree() on a periodic axis, count() on any
    // other.
    [[nodiscard]] int64_t distinct_layers() const noexcept { return periodic_ ? count() - degree_ : count(); }
    [[nodiscard]] bool clamped_start() const noexcept { return knots_.front() == (*this)[degree_]; }
    [[nodiscard]] bool clamped_end() const noexcept { return knots_.back() == (*this)[count()]; }

    // The search structure over the non-empty spans of the domain, built at first use.
    [[nodiscard]] const SpanTable &spans() const;
    // The search structure, if it exists or if `uses` further searches make it worth building; else null.
    [[nodiscard]] const SpanTable *spans_after(int64_t uses) const;
    // The power spans of the basis functions on every non-empty span, if they exist or if `uses` further
    // evaluations make them worth building; else null. A span without a power span has NaN bounds.
    // Precondition: power_span_degree(degree()).
    [[nodiscard]] const PowerSpans *power_spans_after(int64_t uses) const;
    // Whether a span can be evaluated from a power span: the degree is at most max_power_span_degree (and not
    // 0), and neither the length of the span nor its ratio to the neighbouring spans or to its position is
    // near the limits of double precision.
    [[nodiscard]] bool has_power_span(int64_t span) const noexcept;
    // Index of the span that contains t, as by SpanTable::find(); uses the table if it exists.
    [[nodiscard]] int64_t find_span(double t, bool left) const noexcept;

private:
    int degree_;
    bool periodic_;
    std::vector<double> knots_;
    Lazy<SpanTable> spans_;
    Lazy<PowerSpans> power_spans_;
    Uses searches_;
    Uses evaluations_;
};

using KnotVectorPtr = std::shared_ptr<const KnotVector>;

// Check degree, count and knots; throw Error that names the first offender. `axis` is used in the message
// only (-1: no axis); `offset` is the position of the vector in the caller's array.
void check_degree(int degree, int axis);
void check_count(int degree, int64_t count, int axis);
// Throws Status::size unless knot_count == count + degree + 1. Precondition: degree and count have been
// checked.
void check_knot_total(int64_t knot_count, int degree, int64_t count);
void check_finite_and_sorted(std::span<const double> knots, int axis, int64_t offset);
void check_knots(int degree, std::span<const double> knots, int axis, int64_t offset);
// The index of the first knot whose copy one period later is not at knot + period up to rounding, or -1.
// Precondition: check_knots() accepts the vector.
int64_t first_not_repeated(int degree, std::span<const double> knots) noexcept;
// Throws Status::periodic_knots if there is such a knot.
void check_periodic_knots(int degree, std::span<const double> knots, int axis, int64_t offset);

// Applies all checks, then makes the shared value.
KnotVectorPtr make_knot_vector(int degree, std::vector<double> knots, bool periodic = false, int axis = -1,
                               int64_t offset = 0);

struct KnotGroup {
    double knot;
    int multiplicity;
};
std::vector<KnotGroup> distinct_knots(std::span<const double> knots);
int multiplicity(std::span<const double> knots, double knot) noexcept;

// The Greville abscissa x_i = (t_(i+1) + ... + t_(i+p)) / p, computed so that equal knots give exactly that
// knot; for degree 0 the middle of the span.
double greville(const KnotVector &axis, int64_t i) noexcept;

} // namespace nrb::inline basis
