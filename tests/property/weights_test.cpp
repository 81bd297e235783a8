// Weights changed, the shape kept: new weights and knots against their exact values, points against each
// other.
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "same_shape.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace weights_test {

using namespace support;
using reference::eps;
using reference::exact;
using reference::Rational;

namespace {

Handle moebius(const nurbs *g, int axis, double ratio) {
    nurbs *out = nullptr;
    require_ok(nurbs_reparametrize_moebius(g, axis, ratio, &out));
    return Handle(out);
}

Handle equalize(const nurbs *g, int axis) {
    nurbs *out = nullptr;
    require_ok(nurbs_equalize_end_weights(g, axis, &out));
    return Handle(out);
}

Handle normalize(const nurbs *g) {
    nurbs *out = nullptr;
    require_ok(nurbs_normalize_weights(g, &out));
    return Handle(out);
}

long double size_of(const Rational &x) {
    return std::fabs(reference::quotient(numerator(x), denominator(x)));
}

// Axes on which a map with a pole is possible: not periodic, of degree 1 or more, clamped or with the pole
// far off.
Recipe mapped_recipe(Random &random, int axes, int axis) {
    Recipe recipe = open_recipe(random, axes, axes == 1 ? 9 : 3);
    AxisRecipe &along = recipe.axes[static_cast<size_t>(axis)];
    along.degree = std::max(along.degree, 1);
    along.form = random.chance(70) ? KnotForm::clamped : KnotForm::half_clamped;
    return recipe;
}

// The root of the ratio is a power of two, which is known exactly.
TEST(Moebius, weights_and_knots_are_exact_to_rounding) {
    WorstErrors worst("weights after Moebius maps by degree, unit eps * weight * degree");
    for_each_case(810000, 1000, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3), axis = random.whole(0, axes - 1);
        const auto data = random_spline(random, mapped_recipe(random, axes, axis));
        const auto k = static_cast<size_t>(axis);
        const int p = data.degrees[k], power = random.chance(50) ? 1 : random.whole(-3, 3);
        const double rho = std::ldexp(1, power);
        nurbs *out = nullptr;
        const nurbs_status status =
            nurbs_reparametrize_moebius(create(data).get(), axis, std::ldexp(1, power * p), &out);
        const Handle made(out);
        if (status == NURBS_ERROR_KNOTS_MERGE) {
            return; // spans of a few units of rounding, or a pole among the outer knots
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto got = read_back(made.get());
        ASSERT_TRUE(same_bits(got.points, data.points)) << where(seed, data);
        ASSERT_EQ(got.rational(), data.rational() || power != 0);
        const Rational a = exact(data.lower(axis)), b = exact(data.upper(axis)), r = exact(rho);
        const auto denominator = [&](const Rational &t) { return Rational(r * (b - t) + t - a); };
        std::vector<Rational> factors;
        long double worst_condition = 1; // beyond the domain the terms of the denominator have opposite signs
        for (size_t i = 0; i < got.knots[k].size(); ++i) {
            const Rational t = exact(data.knots[k][i]);
            const Rational u = (a * r * (b - t) + b * (t - a)) / denominator(t);
            const long double condition = size_of((r * abs(b - t) + abs(t - a)) / denominator(t));
            worst_condition = std::max(worst_condition, condition);
            // The nearer end, the length and the quotient are rounded.
            const long double far = 4 * condition * size_of(u - (2 * u < a + b ? a : b)) + size_of(u);
            ASSERT_LE(size_of(exact(got.knots[k][i]) - u), eps * far) << where(seed, data);
            factors.push_back(r * (b - a) / denominator(t));
        }
        const Layers layers(data, axis);
        for (int64_t i = 0; got.rational() && i < data.point_count(); ++i) {
            const int64_t layer = i / layers.inner % layers.count;
            Rational want = exact(data.weight(i));
            for (int j = 1; j <= p; ++j) {
                want *= factors[static_cast<size_t>(layer + j)];
            }
            const long double error = reference::error_ratio(got.weight(i), reference::fraction(want),
                                                             eps * size_of(want) * p * worst_condition);
            worst.add(p, error / 4, error);
            ASSERT_LE(error, 4) << where(seed, data) << "weight " << i;
        }
    });
}

// Points at t and at the image of t; parameters are rounded, which moves points by at most their speed.
TEST(Moebius, keeps_the_shape) {
    for_each_case(820000, 500, [](Random &random, uint64_t seed) {
        Recipe recipe = mapped_recipe(random, 1, 0);
        recipe.axes[0].form = KnotForm::clamped;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].placement = Placement::origin;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const double ratio = random.magnitude(0.1, 10);
        const auto made = moebius(g.get(), 0, ratio);
        const auto got = read_back(made.get());
        ASSERT_NEAR(got.weights.back() / got.weights.front(),
                    ratio * data.weight(data.point_count() - 1) / data.weight(0), 50 * ratio * 25 * 0x1p-52);
        const double rho = std::pow(ratio, 1.0 / data.degrees[0]);
        const double a = data.lower(0), b = data.upper(0);
        double size = 0;
        for (const double x : data.points) {
            size = std::max(size, std::fabs(x));
        }
        for (const double t : random_params(random, data, 5)) {
            const double u = (a * rho * (b - t) + b * (t - a)) / (rho * (b - t) + (t - a));
            const int64_t s = reference::first_active(data, &t)[0], r = reference::first_active(got, &u)[0];
            if (s != r) {
                continue; // the other side of a jump
            }
            const auto x = eval(g.get(), {t}), y = eval(made.get(), {std::clamp(u, a, b)});
            for (size_t c = 0; c < x.size(); ++c) {
                // Speed: at most 2 p hull over the shortest span for each of numerator and weight, ratios of
                // weights up to 25 and of the factors up to 10.
                ASSERT_LE(std::fabs(x[c] - y[c]), eps * size * 1000 * data.degrees[0] * 250 * (b - a))
                    << where(seed, data) << hex(t) << " " << hex(ratio);
            }
        }
    });
}

TEST(EqualEndWeights, are_equal) {
    for_each_case(830000, 1000, [](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 9);
        recipe.axes[0].degree = std::max(recipe.axes[0].degree, 1);
        recipe.weights = random.chance(70) ? Weights::moderate : Weights::extreme;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_equalize_end_weights(g.get(), 0, &out);
        const Handle made(out);
        if (status == NURBS_ERROR_KNOTS_MERGE || data.knots[0].front() != data.lower(0) ||
            data.knots[0].back() != data.upper(0)) {
            ASSERT_TRUE(status == NURBS_OK || status == NURBS_ERROR_KNOTS_MERGE) << last_error();
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto got = read_back(made.get());
        ASSERT_LE(std::fabs(got.weights.back() - got.weights.front()),
                  (4 * data.degrees[0] + 8) * eps * got.weights.front())
            << where(seed, data);
    });
}

// A ruled surface between a curve and its copy with all weights doubled: one factor serves both axes' ends.
TEST(EqualEndWeights, of_surfaces_need_one_factor) {
    SplineData data;
    data.degrees = {2, 1};
    data.counts = {3, 2};
    data.knots = {{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}};
    data.dim = 1;
    data.points = {0, 1, 2, 3, 4, 5};
    data.weights = {1, 2, 3, 6, 4, 8};
    const auto along = read_back(equalize(create(data).get(), 0).get());
    ASSERT_EQ(along.weights[0], along.weights[4]);
    ASSERT_EQ(along.weights[1], along.weights[5]);
    const auto across = read_back(equalize(create(data).get(), 1).get());
    ASSERT_EQ(across.weights[0], across.weights[1]);
    data.weights = {1, 2, 3, 6, 4, 9};
    nurbs *out = nullptr;
    ASSERT_EQ(nurbs_equalize_end_weights(create(data).get(), 0, &out), NURBS_ERROR_END_WEIGHTS);
}

TEST(NormalizedWeights, have_the_largest_at_one) {
    for_each_case(840000, 1000, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 3));
        const auto got = read_back(normalize(create(data).get()).get());
        ASSERT_TRUE(same_bits(got.points, data.points)) << where(seed, data);
        const bool equal = std::all_of(data.weights.begin(), data.weights.end(),
                                       [&](double w) { return w == data.weights.front(); });
        ASSERT_EQ(got.rational(), !equal) << where(seed, data);
        if (!equal) {
            const double largest = *std::max_element(data.weights.begin(), data.weights.end());
            ASSERT_EQ(*std::max_element(got.weights.begin(), got.weights.end()), 1);
            for (size_t i = 0; i < got.weights.size(); ++i) {
                ASSERT_EQ(got.weights[i], data.weights[i] / largest) << where(seed, data);
            }
        }
    });
}

} // namespace

} // namespace weights_test
