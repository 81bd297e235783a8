// Polynomials along the pieces of a curve in exact arithmetic, and a proof that one is nowhere negative.
#pragma once

#include "reference/definition.h"
#include "reference/exact_basis.h"

#include <algorithm>
#include <numeric>

namespace support {

using reference::Integer;
using reference::Rational;

// Bernstein coefficients times their binomials, so that products are convolutions.
using Polynomial = std::vector<Integer>;

inline Polynomial product(const Polynomial &a, const Polynomial &b) {
    Polynomial result(a.size() + b.size() - 1);
    for (size_t i = 0; i < a.size(); ++i) {
        for (size_t j = 0; j < b.size(); ++j) {
            result[i + j] += a[i] * b[j];
        }
    }
    return result;
}

inline void add(Polynomial &a, const Polynomial &b, const Integer &factor) {
    for (size_t i = 0; i < a.size(); ++i) {
        a[i] += factor * b[i];
    }
}

// (w x, ..., w) of a control point; w = 1 without weights.
inline std::vector<Rational> record(const SplineData &data, int64_t i) {
    const Rational weight = reference::exact(data.weight(i));
    std::vector<Rational> values;
    for (int c = 0; c < data.dim; ++c) {
        values.push_back(weight * reference::exact(data.coordinate(i, c)));
    }
    values.push_back(weight);
    return values;
}

// The components of a curve between two parameters in one of its spans, up to a common factor.
inline std::vector<Polynomial> piece(const SplineData &data, double from, double to) {
    const int p = data.degrees[0];
    const int64_t span = reference::exact_span(data.knots[0], p, from, false);
    std::vector<std::vector<Rational>> active, coefficients;
    for (int64_t i = span - p; i <= span; ++i) {
        active.push_back(record(data, i));
    }
    std::vector<double> arguments(static_cast<size_t>(p), from);
    for (int j = 0; j <= p; ++j) {
        if (j > 0) {
            arguments[static_cast<size_t>(p - j)] = to;
        }
        coefficients.push_back(reference::defined_blossom(data.knots[0], p, span, active, arguments));
    }
    Integer common = 1;
    for (const auto &point : coefficients) {
        for (const Rational &x : point) {
            common = lcm(common, denominator(x));
        }
    }
    std::vector<Polynomial> components(active[0].size());
    for (int j = 0; j <= p; ++j) {
        const auto &point = coefficients[static_cast<size_t>(j)];
        for (size_t c = 0; c < point.size(); ++c) {
            components[c].push_back(numerator(point[c]) * (common / denominator(point[c])) * binomial(p, j));
        }
    }
    return components;
}

// Halving of plain coefficients without divisions: sums in place of means, each level twice the one before.
inline bool nonnegative(Polynomial values, int depth) {
    if (std::all_of(values.begin(), values.end(), [](const Integer &x) { return x >= 0; })) {
        return true;
    }
    if (values.front() < 0 || values.back() < 0 || depth == 0) {
        return false;
    }
    const size_t n = values.size() - 1;
    Polynomial lower(n + 1);
    for (size_t r = 0; r <= n; ++r) {
        lower[r] = values[0] << (n - r);
        for (size_t j = 0; j < n - r; ++j) {
            values[j] += values[j + 1];
        }
        values[n - r] <<= n - r;
    }
    return nonnegative(std::move(lower), depth - 1) && nonnegative(std::move(values), depth - 1);
}

// Of a polynomial on a whole piece; one that is 0 inside may take more halvings than there are. Weights that
// are far apart crowd a curve into 2^-60 of its span.
inline bool nonnegative(Polynomial values) {
    const auto degree = static_cast<int>(values.size()) - 1;
    Integer common = 1;
    for (int j = 0; j <= degree; ++j) {
        common = lcm(common, Integer(binomial(degree, j)));
    }
    for (int j = 0; j <= degree; ++j) {
        values[static_cast<size_t>(j)] *= common / Integer(binomial(degree, j));
    }
    return nonnegative(std::move(values), 200);
}

} // namespace support
