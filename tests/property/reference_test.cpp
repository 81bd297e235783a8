// The judge is judged first: the fast exact reference against the definitions, in equality of rationals.
#include "reference/definition.h"
#include "reference/exact_basis.h"
#include "reference/magnitudes.h"
#include "support/cases.h"

#include <cmath>
#include <gtest/gtest.h>

namespace reference_test {

using namespace support;
using reference::exact;
using reference::Fraction;
using reference::Rational;

namespace {

bool equal(const Fraction &x, const Rational &y) {
    return x.numerator * boost::multiprecision::denominator(y) ==
           boost::multiprecision::numerator(y) * x.denominator;
}

TEST(Reference, basis_and_derivatives_follow_the_definition) {
    for_each_case(100, 300, [](Random &random, uint64_t seed) {
        const int degree = random.whole(0, 5);
        const auto knots = random_knots(random, random_axis(random, degree));
        const double t = random_param(random, knots, degree);
        const bool left = random.chance(50);
        const auto basis = reference::exact_basis(knots, degree, t, 3, left);
        for (int k = 0; k <= 3; ++k) {
            for (int j = 0; j <= degree; ++j) {
                const auto &row = basis.numerators[static_cast<size_t>(k)];
                const Rational want = reference::defined_basis_derivative(
                    knots, basis.span, basis.span - degree + j, degree, exact(t), k);
                ASSERT_TRUE(equal({row[static_cast<size_t>(j)], basis.denominator}, want))
                    << "seed " << seed << " derivative " << k << " of function " << j;
            }
        }
    });
}

TEST(Reference, points_follow_the_definition) {
    for_each_case(200, 300, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, random_recipe(random, axes, axes == 1 ? 5 : 4 - axes));
        const auto param = random_params(random, data, 1);
        const reference::Sides left = {random.chance(50), random.chance(50), random.chance(50)};
        // From the left a parameter may meet only weights that are 0 there when it lies outside the checked
        // sides: none does.
        const auto fast = reference::exact_point(data, param.data(), left);
        const auto slow = reference::defined_point(data, param.data(), left);
        for (size_t c = 0; c < slow.size(); ++c) {
            ASSERT_TRUE(equal(fast[c], slow[c])) << where(seed, data);
        }
    });
}

// x = t, y = t^2 on a rational curve w = 1 + t: all partial derivatives of (x/w, y/w) are known in closed
// form.
TEST(Reference, quotient_rule_of_a_known_fraction) {
    const SplineData data = {{2}, {3}, {{0, 0, 0, 1, 1, 1}}, 1, {0, 1.0 / 3, 0.5}, {1, 1.5, 2}, 0};
    // The homogeneous numerators are (0, 0.5, 1) up to the rounding of 1/3, so that C = a(t) / (1 + t) with a
    // near t.
    const double t = 0.25;
    const auto derivs = reference::exact_derivatives(data, 3, &t);
    const Rational a1 = 2 * (exact(1.5) * exact(1.0 / 3)); // a'(0)
    const Rational a2 = 2 * (1 - a1);                      // a''
    const Rational x = exact(t);
    const Rational value = (a1 * x + a2 * x * x / 2) / (1 + x);
    const Rational first = (a1 + a2 * x - value) / (1 + x);
    const Rational second = (a2 - 2 * first) / (1 + x);
    const Rational third = (-3 * second) / (1 + x);
    EXPECT_TRUE(equal(derivs[0][0], value));
    EXPECT_TRUE(equal(derivs[1][0], first));
    EXPECT_TRUE(equal(derivs[2][0], second));
    EXPECT_TRUE(equal(derivs[3][0], third));
}

TEST(Reference, insertion_by_polar_forms_keeps_every_point) {
    for_each_case(300, 300, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {random_axis(random, random.whole(0, 4))};
        recipe.dim = 1;
        const auto data = random_spline(random, recipe);
        const double knot = random_param(random, data.knots[0], data.degrees[0]);
        const auto there = std::count(data.knots[0].begin(), data.knots[0].end(), knot);
        const int times = random.whole(0, data.degrees[0] + 1 - static_cast<int>(there));
        const auto layers = reference::defined_insertion(data, 0, knot, times);
        // Evaluated by the definition over the refined knots, with exact control values.
        const double t = random_param(random, data.knots[0], data.degrees[0]);
        const int64_t span = reference::exact_span(layers.knots, data.degrees[0], t);
        Rational sum = 0;
        for (int64_t i = span - data.degrees[0]; i <= span; ++i) {
            const bool fresh = i >= layers.first && i <= layers.last;
            const Rational value = fresh ? layers.records[static_cast<size_t>(i - layers.first)][0]
                                         : exact(data.coordinate(i < layers.first ? i : i - times, 0));
            sum += value * reference::defined_basis(layers.knots, span, i, data.degrees[0], exact(t));
        }
        ASSERT_TRUE(equal(reference::exact_point(data, &t)[0], sum))
            << where(seed, data) << "knot " << hex(knot) << " times " << times << " at " << hex(t);
    });
}

TEST(Reference, rounding_and_distances) {
    const Fraction third = {1, 3};
    EXPECT_EQ(reference::nearest(third), 1.0 / 3);
    EXPECT_EQ(reference::nearest({-10, 4}), -2.5);
    EXPECT_EQ(reference::nearest({(reference::Integer(1) << 53) + 1, 1}), 0x1p53); // a tie goes to even
    EXPECT_EQ(reference::nearest({(reference::Integer(1) << 54) + 3, 2}), 0x1p53 + 2);
    EXPECT_EQ(reference::distance(0.5, {1, 4}), 0.25L);
    EXPECT_EQ(reference::error_ratio(1 + 0x1p-52, {1, 1}, 0x1p-52L), 1);
    EXPECT_EQ(reference::error_ratio(1, {1, 1}, 0), 0);
    EXPECT_TRUE(std::isinf(reference::error_ratio(1, {1, 2}, 0)));
    EXPECT_TRUE(std::isinf(reference::error_ratio(std::nan(""), {1, 2}, 1)));
}

// The magnitudes of a derivative whose terms all have one sign are the derivative itself.
TEST(Reference, magnitudes_of_terms_of_one_sign) {
    const SplineData data = {{2}, {4}, {{0, 0, 0, 1, 2, 2, 2}}, 1, {1, -1, 1, -1}, {}, 0};
    const double t = 0.25;
    const auto sizes = reference::magnitudes(data, 2, &t, reference::Terms::stored);
    const auto derivs = reference::exact_derivatives(data, 2, &t);
    EXPECT_EQ(sizes[0][0], 1);
    EXPECT_EQ(sizes[2][0], reference::quotient(derivs[2][0].numerator, derivs[2][0].denominator));
}

} // namespace

} // namespace reference_test
