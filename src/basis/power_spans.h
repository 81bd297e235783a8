// SPDX-License-Identifier: MIT
// Power spans: the polynomials on the spans in powers of a centred local parameter. Spans of low degree are
// evaluated in this form.
//
// On a span the parameter becomes x = (t - middle) * scale, where the scale is a power of two and |x| <= 1.
// Powers of an x that starts at the end of the span would lose 3^p eps. Centred powers amplify rounding by
// 2.5 at degree 3 and by 19 at degree 9, so that Horner's rule is as accurate as the recurrences and several
// times cheaper.
#pragma once

#include <cstdint>
#include <vector>

namespace nrb::inline basis {

class KnotVector;

// Up to this degree spans are evaluated from power spans, above it by the Cox-de Boor recurrence. At degree 0
// control points are copied.
inline constexpr int max_power_span_degree = 9;
constexpr bool power_span_degree(int degree) noexcept {
    return degree >= 1 && degree <= max_power_span_degree;
}

// A power span is one record of doubles: the head, then for each power 0, ..., p the coefficients of all
// components, padded with zeros to a multiple of 4.
struct PowerSpan {
    enum Head { lower, upper, middle, scale, head_size };

    // Doubles per power: the number of components rounded up to a multiple of 4.
    static constexpr int lanes(int components) noexcept { return (components + 3) / 4 * 4; }
    static constexpr int64_t size(int degree, int components) noexcept {
        return head_size + static_cast<int64_t>(degree + 1) * lanes(components);
    }
};

// Largest size of the power span of a basis: powers 0 to 9 of 10 functions.
inline constexpr int64_t max_basis_power_span =
    PowerSpan::size(max_power_span_degree, max_power_span_degree + 1);

// The largest number of power spans computed together, and the number that this processor computes together.
inline constexpr int most_power_spans_together = 8;
int power_spans_together() noexcept;

// Writes the power spans of the functions N_(s-p), ..., N_s for `count` spans s. Coefficient k of N_j is its
// k-th derivative with respect to x at x = 0, divided by k!. It is accurate to about 2^-100 of the terms it
// is summed from, and so correctly rounded except for rare ties and sums that cancel: the recurrences of
// basis_values() and basis_derivs() are computed in twice the precision. The rounding errors are written to
// `rests`, records like the power spans; null: they are dropped. A power span has the same bits whatever is
// computed together with it. Preconditions: power_span_degree(degree), count <= power_spans_together(), and
// those of basis_values().
void basis_power_spans(const double *knots, int degree, const int64_t *spans, int count,
                       double *const *power_spans, double *const *rests) noexcept;

// Up to this degree the power span of a curve, with its head, is computed directly from its points: by de
// Boor's algorithm with the middle of the span and the direction of the parameter as arguments of the polar
// form. Every coefficient is rounded once, up to about 2^-100 of the terms it is summed from. points: [degree
// + 1][lanes], the control points of N_(span-p), ..., N_span, which are multiplied by the weights.
inline constexpr int max_blossom_degree = 3;
void low_power_span(const double *knots, int degree, int64_t span, const double *weights,
                    const double *points, int lanes, double *power_span, double *rests = nullptr) noexcept;
// The same for the basis functions, which are the curves whose control points are unit vectors.
void low_basis_power_span(const double *knots, int degree, int64_t span, double *power_span,
                          double *rests) noexcept;
void write_power_span_head(double lower, double upper, double *power_span) noexcept;

// Computes the coefficients of the power span of a curve from those of its basis and their rests: component c
// of power k is the sum over j of coefficient [k][j] times weights[j] * points[j * lanes + c], rounded once.
void combine_power_spans(const double *basis, const double *rests, int degree, const double *weights,
                         const double *points, int lanes, double *powers) noexcept;

// An array of power spans of equal size, aligned to cache lines.
class PowerSpans {
public:
    PowerSpans(int64_t count, int64_t size);
    PowerSpans(PowerSpans &&) noexcept = default;
    PowerSpans(const PowerSpans &) = delete;
    PowerSpans &operator=(const PowerSpans &) = delete;

    [[nodiscard]] const double *operator[](int64_t i) const noexcept { return first_ + i * size_; }
    [[nodiscard]] double *operator[](int64_t i) noexcept { return first_ + i * size_; }
    [[nodiscard]] int64_t size() const noexcept { return size_; }

private:
    int64_t size_;
    std::vector<double> storage_;
    double *first_;
};

// The power spans of the basis functions on every non-empty span of a knot vector.
PowerSpans basis_power_spans(const KnotVector &axis);

} // namespace nrb::inline basis
