// SPDX-License-Identifier: MIT
// Sums of two doubles against rational numbers, on every instruction set: the steps that claim to be exact
// are, the others keep the bounds that are proved for them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/numeric/double_double_lanes_test.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "numeric/double_double-inl.h"

#include <cstddef>

#ifndef NURBS_TESTS_TWIN_OPERATION
#define NURBS_TESTS_TWIN_OPERATION
namespace {
enum class Operation { exact_sum, ordered_sum, exact_product, plus, minus, times, inverse };
} // namespace
#endif

HWY_BEFORE_NAMESPACE();
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleDouble = hn::CappedTag<double, 8>;
using Number = nrb::HWY_NAMESPACE::DoubleDoubleLanes<hn::Vec<DoubleDouble>>;

Number compute(Operation operation, const Number &a, const Number &b) {
    switch (operation) {
    case Operation::exact_sum:
        return nrb::HWY_NAMESPACE::exact_sum(a.high, b.high);
    case Operation::ordered_sum:
        return nrb::HWY_NAMESPACE::ordered_sum(a.high, b.high);
    case Operation::exact_product:
        return nrb::HWY_NAMESPACE::exact_product(a.high, b.high);
    case Operation::plus:
        return a + b;
    case Operation::minus:
        return a - b;
    case Operation::times:
        return a * b;
    case Operation::inverse:
        return inverse(a);
    }
    return a;
}

// Numbers a and b, high and low parts apart, n of each, a multiple of 8.
void compute_all(Operation operation, const double *const *parts, size_t n, double *high, double *low) {
    const DoubleDouble d;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        const Number a = {hn::LoadU(d, parts[0] + i), hn::LoadU(d, parts[1] + i)};
        const Number b = {hn::LoadU(d, parts[2] + i), hn::LoadU(d, parts[3] + i)};
        const Number result = compute(operation, a, b);
        hn::StoreU(result.high, d, high + i);
        hn::StoreU(result.low, d, low + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "reference/number.h"
#include "support/generators.h"
#include "unit/targets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using reference::exact;
using reference::Rational;

NURBS_FORMS(compute_all);

constexpr size_t n = 4096;

struct Numbers {
    std::vector<double> high;
    std::vector<double> low;

    [[nodiscard]] Rational at(size_t i) const { return exact(high[i]) + exact(low[i]); }
};

// Low parts to half a unit of the high ones, as the operations leave them.
Numbers random_numbers(support::Random &random) {
    Numbers numbers;
    for (size_t i = 0; i < n; ++i) {
        const double size = random.magnitude(1e-9, 1e9);
        numbers.high.push_back(random.chance(50) ? size : -size);
        numbers.low.push_back(std::ldexp(random.between(-1, 1), std::ilogb(size) - 53));
    }
    return numbers;
}

struct Pairs {
    Numbers a;
    Numbers b;
};

// A third of the pairs nearly cancel.
Pairs random_pairs() {
    support::Random random(95000);
    Pairs pairs{random_numbers(random), random_numbers(random)};
    for (size_t i = 0; i < n; i += 3) {
        const double step = std::ldexp(pairs.a.high[i], -random.whole(20, 52));
        pairs.b.high[i] = -pairs.a.high[i] + step;
        pairs.b.low[i] = std::ldexp(random.between(-1, 1), std::ilogb(pairs.b.high[i]) - 53);
    }
    return pairs;
}

Numbers compute(Operation operation, const Pairs &pairs) {
    const double *const parts[] = {pairs.a.high.data(), pairs.a.low.data(), pairs.b.high.data(),
                                   pairs.b.low.data()};
    Numbers result{std::vector<double>(n), std::vector<double>(n)};
    NURBS_BEST(compute_all)(operation, parts, n, result.high.data(), result.low.data());
    return result;
}

using DoubleDoubleLanesTest = targets::Targets;

// high + low is exactly `want`, high is `want` rounded.
void expect_exact(const Numbers &result, size_t i, const Rational &want) {
    ASSERT_TRUE(result.at(i) == want) << result.high[i] << " " << result.low[i];
    ASSERT_EQ(result.high[i], reference::nearest(reference::fraction(want)));
}

TEST_P(DoubleDoubleLanesTest, sums_and_products_of_doubles_are_exact) {
    Pairs pairs = random_pairs();
    const Numbers sums = compute(Operation::exact_sum, pairs);
    const Numbers products = compute(Operation::exact_product, pairs);
    for (size_t i = 0; i < n; ++i) {
        expect_exact(sums, i, exact(pairs.a.high[i]) + exact(pairs.b.high[i]));
        expect_exact(products, i, exact(pairs.a.high[i]) * exact(pairs.b.high[i]));
        if (std::fabs(pairs.a.high[i]) < std::fabs(pairs.b.high[i])) {
            std::swap(pairs.a.high[i], pairs.b.high[i]);
        }
    }
    const Numbers ordered = compute(Operation::ordered_sum, pairs);
    for (size_t i = 0; i < n; ++i) {
        expect_exact(ordered, i, exact(pairs.a.high[i]) + exact(pairs.b.high[i]));
    }
}

// One factor near the end of the range, the other one small.
TEST_P(DoubleDoubleLanesTest, products_of_enormous_numbers_are_exact) {
    Pairs pairs = random_pairs();
    for (size_t i = 0; i < n; ++i) {
        pairs.a.high[i] = std::ldexp(pairs.a.high[i], 990);
        pairs.b.high[i] = std::ldexp(pairs.b.high[i], -980);
        if (i % 2 == 1) {
            std::swap(pairs.a.high[i], pairs.b.high[i]);
        }
    }
    const Numbers products = compute(Operation::exact_product, pairs);
    for (size_t i = 0; i < n; ++i) {
        expect_exact(products, i, exact(pairs.a.high[i]) * exact(pairs.b.high[i]));
    }
}

// The largest double has no upper half that is rounded.
TEST_P(DoubleDoubleLanesTest, products_with_the_largest_number_are_exact) {
    const double largest = std::numeric_limits<double>::max();
    Pairs pairs = random_pairs();
    std::fill(pairs.a.high.begin(), pairs.a.high.end(), largest);
    std::fill(pairs.b.high.begin(), pairs.b.high.end(), -0.25);
    const Numbers products = compute(Operation::exact_product, pairs);
    for (size_t i = 0; i < n; ++i) {
        expect_exact(products, i, exact(largest) / -4);
    }
}

// The largest |result - want| / unit, in units of 2^-106; results must be normalised: the high part is the
// sum of both, rounded.
template <class Want, class Unit>
double worst_error(Operation operation, Want &&want, Unit &&unit) {
    const Pairs pairs = random_pairs();
    const Numbers result = compute(operation, pairs);
    Rational worst = 0;
    for (size_t i = 0; i < n; ++i) {
        const Rational a = pairs.a.at(i);
        const Rational b = pairs.b.at(i);
        EXPECT_EQ(result.high[i], result.high[i] + result.low[i]);
        const Rational error = abs(Rational(result.at(i) - want(a, b))) / unit(a, b);
        worst = std::max(worst, error);
    }
    const auto in_units =
        static_cast<double>(std::ldexp(reference::quotient(boost::multiprecision::numerator(worst),
                                                           boost::multiprecision::denominator(worst)),
                                       106));
    std::printf("operation %d: largest error %.3f * 2^-106\n", static_cast<int>(operation), in_units);
    return in_units;
}

// Three roundings of low parts: two of their sum, one of what the high parts left over.
TEST_P(DoubleDoubleLanesTest, sums_keep_their_bound) {
    const auto sum_of_sizes = [](const Rational &a, const Rational &b) { return Rational(abs(a) + abs(b)); };
    EXPECT_LE(worst_error(
                  Operation::plus, [](const Rational &a, const Rational &b) { return Rational(a + b); },
                  sum_of_sizes),
              3);
    EXPECT_LE(worst_error(
                  Operation::minus, [](const Rational &a, const Rational &b) { return Rational(a - b); },
                  sum_of_sizes),
              3);
}

// Joldes, Muller and Popescu 2017, algorithms 10 (7 units) and 11 (6 units).
TEST_P(DoubleDoubleLanesTest, products_keep_their_bound) {
    const auto product = [](const Rational &a, const Rational &b) { return Rational(a * b); };
    EXPECT_LE(worst_error(Operation::times, product,
                          [&](const Rational &a, const Rational &b) { return Rational(abs(product(a, b))); }),
              7);
}

// 4 units of the square that Newton's step leaves, 3 of roundings of the rest and 2 of its product; without
// fused operations one more.
TEST_P(DoubleDoubleLanesTest, inverses_keep_their_bound) {
    const auto inverse = [](const Rational &a, const Rational &) { return Rational(1 / a); };
    EXPECT_LE(worst_error(Operation::inverse, inverse,
                          [&](const Rational &a, const Rational &b) { return Rational(abs(inverse(a, b))); }),
              9);
}

INSTANTIATE_TEST_SUITE_P(All, DoubleDoubleLanesTest, targets::every_target(), targets::target_name);

} // namespace
#endif
