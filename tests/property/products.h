// Pairs of splines over the same domains, and their exact values.
#pragma once

#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "same_shape.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace support::products {

using reference::Fraction;
using reference::Rational;

using Point = std::vector<Rational>;

inline Handle product(const nurbs *a, const nurbs *b, uint32_t flags = 0) {
    nurbs *out = nullptr;
    require_ok(nurbs_product(a, b, flags, &out));
    return Handle(out);
}

inline Handle sum(const nurbs *a, double alpha, const nurbs *b, double beta) {
    nurbs *out = nullptr;
    require_ok(nurbs_sum(a, alpha, b, beta, &out));
    return Handle(out);
}

inline long double size_of(const Rational &x) {
    return std::fabs(reference::quotient(numerator(x), denominator(x)));
}

// Knots inside [lower, upper], some of them out of `others`; sorted, at most degree + 1 equal.
inline std::vector<double> inner_knots(Random &random, int degree, double lower, double upper,
                                       const std::vector<double> &others) {
    std::vector<double> knots;
    for (int i = random.whole(0, 3); i > 0; --i) {
        const double other = others[random.bits() % others.size()];
        const double fresh = lower + (upper - lower) * random.whole(1, 63) / 64;
        const double knot = random.chance(60) ? other : fresh;
        if (lower < knot && knot < upper && std::find(knots.begin(), knots.end(), knot) == knots.end()) {
            knots.insert(knots.end(),
                         random.chance(60) ? 1U : random.bits() % static_cast<size_t>(degree + 1) + 1, knot);
        }
    }
    std::sort(knots.begin(), knots.end());
    return knots;
}

// `degree` knots beyond an end of the domain: at it, beyond, or some of each.
inline std::vector<double> beyond(Random &random, int degree, double end, double step) {
    std::vector<double> knots;
    const bool clamped = random.chance(40);
    for (int i = 0; i < degree; ++i) {
        end += clamped || random.chance(30) ? 0 : step * random.whole(1, 8) / 8;
        knots.push_back(end);
    }
    return knots;
}

inline void set_axis(SplineData &data, int degree, std::vector<double> knots) {
    data.degrees.push_back(degree);
    data.counts.push_back(static_cast<int64_t>(knots.size()) - degree - 1);
    data.knots.push_back(std::move(knots));
}

inline void wrap(SplineData &data, std::vector<double> &values, int width) {
    for (int axis = 0; axis < data.axes(); ++axis) {
        const Layers layers(data, axis);
        const int64_t distinct = layers.count - data.degrees[static_cast<size_t>(axis)];
        for (int64_t o = 0; data.periodic(axis) && o < layers.outer; ++o) {
            for (int64_t l = distinct; l < layers.count; ++l) {
                for (int64_t i = 0; i < layers.inner * width; ++i) {
                    const auto at = [&](int64_t layer) {
                        return static_cast<size_t>((o * layers.count + layer) * layers.inner * width + i);
                    };
                    values[at(l)] = values[at(l - distinct)];
                }
            }
        }
    }
}

// A spline over the domains of another one, sharing some of its knots, periodic where that is (or nowhere).
inline SplineData partner(Random &random, const SplineData &other, int max_degree, int dim, bool rational,
                          bool periodic) {
    SplineData data;
    data.dim = dim;
    for (int k = 0; k < other.axes(); ++k) {
        const double lower = other.lower(k), upper = other.upper(k), length = upper - lower;
        const int p = random.whole(0, max_degree);
        const std::vector<double> inner =
            inner_knots(random, p, lower, upper, other.knots[static_cast<size_t>(k)]);
        std::vector<double> knots;
        if (periodic && other.periodic(k)) {
            std::vector<double> one(static_cast<size_t>(random.whole(1, p + 1)), lower);
            one.insert(one.end(), inner.begin(), inner.end());
            const auto m = std::ssize(one);
            const int64_t start = random.whole(
                0, std::min<int>(p, static_cast<int>(std::count(one.begin(), one.end(), lower)) - 1));
            for (int64_t i = start - p; i <= start + m + p;
                 ++i) { // knot `start` is the last before the domain
                const int64_t turn = i >= 0 ? i / m : -((m - 1 - i) / m);
                knots.push_back(one[static_cast<size_t>(i - turn * m)] + static_cast<double>(turn) * length);
            }
            data.flags |= NURBS_ON_AXIS(k, NURBS_PERIODIC);
        } else {
            knots = beyond(random, p, lower, -length / 8);
            std::reverse(knots.begin(), knots.end());
            knots.push_back(lower);
            knots.insert(knots.end(), inner.begin(), inner.end());
            knots.push_back(upper);
            const auto behind = beyond(random, p, upper, length / 8);
            knots.insert(knots.end(), behind.begin(), behind.end());
        }
        set_axis(data, p, std::move(knots));
    }
    for (int64_t i = 0; i < data.point_count() * dim; ++i) {
        data.points.push_back(random.between(-1, 1));
    }
    for (int64_t i = 0; rational && i < data.point_count(); ++i) {
        data.weights.push_back(random.between(0.2, 5));
    }
    wrap(data, data.points, dim);
    if (rational) {
        wrap(data, data.weights, 1);
    }
    return data;
}

// Recipes whose periodic axes repeat exactly.
inline Recipe exact_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = random.whole(1, 4);
        if (axis.form == KnotForm::periodic) {
            axis.spacing = random.chance(50) ? Spacing::few_bits : Spacing::integers;
            axis.placement = Placement::origin;
        }
    }
    return recipe;
}

struct Pair {
    SplineData a;
    SplineData b;
};

inline Pair random_pair(Random &random, int axes, int degree_a, int degree_b, int dim_b, bool same_dim) {
    Pair pair;
    pair.a = random_spline(random, exact_recipe(random, axes, degree_a));
    pair.b = partner(random, pair.a, degree_b, same_dim ? pair.a.dim : dim_b, random.chance(40),
                     random.chance(80));
    return pair;
}

inline int degree_sum(const SplineData &data) {
    int total = 0;
    for (const int32_t p : data.degrees) {
        total += p + 1;
    }
    return total;
}

// (w x, ..., w) at a parameter, exactly; w = 1 where there are no weights.
inline Point exact_record(const nurbs *g, const std::vector<double> &param, const reference::Sides &left) {
    Point point;
    for (const Fraction &x : reference::exact_point(homogeneous(g), param.data(), left)) {
        point.push_back(Rational(x.numerator, x.denominator));
    }
    return point;
}

inline reference::Sides random_sides(Random &random, const SplineData &data,
                                     const std::vector<double> &param) {
    reference::Sides left{};
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        left[at] = param[at] == data.upper(k) || (param[at] != data.lower(k) && random.chance(30));
    }
    return left;
}

// The sides of a parameter that is a knot of only one of the splines do not matter to the other.
inline std::vector<double> random_place(Random &random, const Pair &pair) {
    return random_params(random, random.chance(50) ? pair.a : pair.b, 1);
}

// The largest magnitude of a component among the active control points.
inline long double hull_of(const nurbs *g, const std::vector<double> &param, const reference::Sides &left,
                           int c) {
    SplineData data = homogeneous(g);
    SplineData one = data;
    one.dim = 1;
    one.points.clear();
    for (int64_t i = 0; i < data.point_count(); ++i) {
        one.points.push_back(data.coordinate(i, c));
    }
    return reference::exact_hull(one, param.data(), left);
}

inline std::string places(uint64_t seed, const Pair &pair) {
    return where(seed, pair.a) + where(seed, pair.b);
}

inline void expect_same_domains(const SplineData &got, const Pair &pair, const std::string &place) {
    for (int k = 0; k < pair.a.axes(); ++k) {
        ASSERT_EQ(got.lower(k), pair.a.lower(k)) << place;
        ASSERT_EQ(got.upper(k), pair.a.upper(k)) << place;
        ASSERT_EQ(got.periodic(k), pair.a.periodic(k) && pair.b.periodic(k)) << place;
    }
}

} // namespace support::products
