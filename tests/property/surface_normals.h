// Exact normals of surfaces, for the tests of frames.
#pragma once

#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace surface_normals {

using namespace support;
using reference::eps;
using reference::Rational;

using ExactVector = std::array<Rational, 3>;

inline Rational rational(const reference::Fraction &x) {
    return Rational(x.numerator, x.denominator);
}

inline ExactVector exact_vector(const std::vector<reference::Fraction> &x) {
    return {rational(x[0]), rational(x[1]), rational(x[2])};
}

inline ExactVector exact_cross(const ExactVector &a, const ExactVector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline bool is_zero(const ExactVector &a) {
    return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

inline long double approximate(const Rational &x) {
    return x == 0 ? 0.0L : reference::quotient(numerator(x), denominator(x));
}

inline Vector approximate(const ExactVector &x) {
    return {approximate(x[0]), approximate(x[1]), approximate(x[2])};
}

// The quotients by the largest coordinate, so that no size leaves the range.
inline Vector direction(const ExactVector &x) {
    const Rational size = std::max({Rational(abs(x[0])), Rational(abs(x[1])), Rational(abs(x[2]))});
    return unit(approximate({x[0] / size, x[1] / size, x[2] / size}));
}

inline Vector magnitude(const std::vector<long double> &x) {
    return {x[0], x[1], x[2]};
}

struct Exact {
    ExactVector product; // S_u x S_v
    Vector du;
    Vector dv;
    long double error_u; // the header's bounds of the rounding errors
    long double error_v;
    [[nodiscard]] long double noise() const { return norm(du) * error_v + error_u * (norm(dv) + error_v); }
};

inline Exact exact_at(const SplineData &data, const double *param, reference::Sides left = {}) {
    const auto derivs = reference::exact_derivatives(data, 1, param, left);
    const auto sizes = reference::magnitudes(data, 1, param, left);
    const long double factor = 2 * (reference::c_of(data) + 2) * eps;
    const ExactVector du = exact_vector(derivs[1]);
    const ExactVector dv = exact_vector(derivs[2]);
    return {exact_cross(du, dv), approximate(du), approximate(dv), factor * norm(magnitude(sizes[1])),
            factor * norm(magnitude(sizes[2]))};
}

inline Recipe surface_recipe(Random &random, int max_degree) {
    Recipe recipe = random_recipe(random, 2, max_degree);
    recipe.dim = 3;
    return recipe;
}

// All layers of points at one end of an axis become one point, so that the edge collapses.
inline void collapse(SplineData &data, int axis, bool at_end) {
    const int64_t m = data.counts[0];
    const int64_t n = data.counts[1];
    for (int64_t i = 0; i < (axis == 0 ? n : m); ++i) {
        const int64_t layer = at_end ? (axis == 0 ? m : n) - 1 : 0;
        const int64_t at = axis == 0 ? layer * n + i : i * n + layer;
        for (int c = 0; c < 3; ++c) {
            data.points[static_cast<size_t>(3 * at + c)] = 0.125 * (c + 1);
        }
    }
}

} // namespace surface_normals
