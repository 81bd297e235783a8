// SPDX-License-Identifier: MIT
// De Casteljau's algorithm on plain arrays: [degree + 1][inner] Bernstein coefficients of a polynomial of one
// variable over [0, 1], each of `inner` values, which may be the coefficients along other variables. Also the
// Bernstein functions, which the transposed recurrence gives. Each step takes means, so that the error of a
// value is within 3 / 2 degree eps of the same means of magnitudes, and at t = 1/2 within degree eps / 2.
// Inline, because loops compiled for an instruction set or for one degree use it.
#pragma once

#include <algorithm>
#include <cstdint>

namespace nrb::inline bernstein {

// Replaces the first `count` values b_i by the means (1 - t) b_i + t b_(i+1).
[[gnu::always_inline]] inline void casteljau_step(int64_t count, int64_t inner, double t,
                                                  double *b) noexcept {
    const double s = 1 - t;
    for (int64_t i = 0; i < count; ++i) {
        b[i] = s * b[i] + t * b[i + inner];
    }
}

// The first `inner` values become the value at t.
[[gnu::always_inline]] inline void evaluate(int degree, int64_t inner, double t, double *b) noexcept {
    for (int level = degree; level > 0; --level) {
        casteljau_step(level * inner, inner, t, b);
    }
}

// `values` become the coefficients over [t, 1], `lower` those over [0, t]. Precondition: they do not overlap.
[[gnu::always_inline]] inline void subdivide(int degree, int64_t inner, double t, double *values,
                                             double *lower) noexcept {
    for (int r = 0; r <= degree; ++r) {
        std::copy_n(values, inner, lower + r * inner);
        casteljau_step((degree - r) * inner, inner, t, values);
    }
}

// A net of coefficients seen along one of its axes: [outer][degree + 1][inner].
struct AxisLayers {
    int64_t outer = 1;
    int degree = 0;
    int64_t inner = 1;

    [[nodiscard]] int64_t at(int64_t o, int layer, int64_t i) const noexcept {
        return (o * (degree + 1) + layer) * inner + i;
    }
};

// The same for a whole net [outer][degree + 1][inner].
inline void subdivide(const AxisLayers &layers, double t, double *values, double *lower) noexcept {
    for (int64_t o = 0; o < layers.outer; ++o) {
        const int64_t first = layers.at(o, 0, 0);
        subdivide(layers.degree, layers.inner, t, values + first, lower + first);
    }
}

// Replaces the coefficients over [0, 1] by those over [lower, upper]. All values are means of coefficients,
// so that coefficients of one sign and size keep their relative accuracy. Precondition: 0 <= lower < upper
// <= 1.
inline void restrict_to(int degree, double lower, double upper, double *values) noexcept {
    for (int r = 1; upper < 1 && r <= degree; ++r) {
        for (int i = degree; i >= r; --i) {
            values[i] = (1 - upper) * values[i - 1] + upper * values[i];
        }
    }
    const double t = lower / upper, rest = (upper - lower) / upper;
    for (int r = 1; lower > 0 && r <= degree; ++r) {
        for (int i = 0; i <= degree - r; ++i) {
            values[i] = rest * values[i] + t * values[i + 1];
        }
    }
}

// From the Bernstein functions of degree n - 1 at t to those of degree n.
[[gnu::always_inline]] inline void raise_functions(int n, double t, double *values) noexcept {
    const double s = 1 - t;
    values[n] = t * values[n - 1];
    for (int i = n - 1; i > 0; --i) {
        values[i] = s * values[i] + t * values[i - 1];
    }
    values[0] *= s;
}

// B_0(t), ..., B_degree(t), each with a relative error within 3 / 2 degree eps for t in [0, 1].
[[gnu::always_inline]] inline void bernstein_functions(int degree, double t, double *values) noexcept {
    values[0] = 1;
    for (int n = 1; n <= degree; ++n) {
        raise_functions(n, t, values);
    }
}

// Derivatives of the functions of a degree from the values (or derivatives) of those of one degree less. Both
// may be the same array.
[[gnu::always_inline]] inline void differentiate_functions(int degree, const double *lower,
                                                           double *out) noexcept {
    out[degree] = degree * lower[degree - 1];
    for (int i = degree - 1; i > 0; --i) {
        out[i] = degree * (lower[i - 1] - lower[i]);
    }
    out[0] = -degree * lower[0];
}

// Values, and derivatives up to order 2 at most, at t: rows of `stride` > degree doubles.
[[gnu::always_inline]] inline void bernstein_functions(int degree, double t, int order, int stride,
                                                       double *rows) noexcept {
    rows[0] = 1;
    for (int k = 1; k <= order; ++k) {
        std::fill_n(rows + k * stride, degree < k ? degree + 1 : 0, 0.0);
    }
    for (int n = 1; n <= degree; ++n) {
        if (n == degree - 1 && order > 1) { // row 0 holds the functions of degree - 2
            differentiate_functions(n, rows, rows + 2 * stride);
            differentiate_functions(degree, rows + 2 * stride, rows + 2 * stride);
        }
        if (n == degree && order > 0) {
            differentiate_functions(degree, rows, rows + stride);
        }
        raise_functions(n, t, rows);
    }
}

} // namespace nrb::inline bernstein
