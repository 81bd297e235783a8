// Functions that do not vanish at a place, and the places of their products in a matrix.
#include "fit/least_squares/active_functions.h"

#include "unit/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace active_functions_test {

using namespace nrb;
using fit::ActiveFunctions;
using fit::Index;
using fit::StencilPattern;

namespace {

KnotVectorPtr axis(int degree, std::vector<double> knots, bool periodic = false) {
    return std::make_shared<const KnotVector>(degree, std::move(knots), periodic);
}

// At the middle of the second span of degree 2: 1/8, 3/4, 1/8; at a quarter of a line: 3/4, 1/4.
TEST(ActiveFunctions, are_products_of_those_of_the_axes) {
    const std::vector<KnotVectorPtr> axes{axis(2, {0, 1, 2, 3, 4, 5, 6}), axis(1, {0, 0, 1, 1})};
    ActiveFunctions functions(axes);
    functions.set(0, 3, 3.5);
    functions.set(1, 1, 0.25);
    functions.multiply();
    const std::vector<double> wanted{0.09375, 0.03125, 0.5625, 0.1875, 0.09375, 0.03125};
    ASSERT_EQ(functions.size(), wanted.size());
    for (size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(functions.values()[i], wanted[i]) << i;
        EXPECT_EQ(functions.layer(i),
                  (Index{1 + static_cast<int64_t>(i) / 2, static_cast<int64_t>(i) % 2, 0}));
    }
}

TEST(ActiveFunctions, have_derivatives_and_then_none_again) {
    ActiveFunctions functions({axis(2, {0, 1, 2, 3, 4, 5, 6})});
    functions.set(0, 2, 2.5, 1);
    functions.multiply();
    EXPECT_EQ(std::vector<double>(functions.values().begin(), functions.values().end()),
              (std::vector<double>{-0.5, 0, 0.5}));
    functions.set(0, 2, 2.5);
    functions.multiply();
    EXPECT_EQ(std::vector<double>(functions.values().begin(), functions.values().end()),
              (std::vector<double>{0.125, 0.75, 0.125}));
}

// Every pair of unknowns whose functions overlap has one place, in one of its two orders.
TEST(StencilPattern, has_a_place_for_each_pair) {
    const std::vector<KnotVectorPtr> axes{axis(2, {0, 0, 0, 1, 2, 3, 3, 3}),
                                          axis(1, {-1, 0, 1, 2, 3, 4, 5}, true)};
    const StencilPattern pattern(axes);
    ASSERT_EQ(pattern.size(), 5 * 4);
    std::set<std::array<int64_t, 2>> pairs;
    pattern.for_each_element([&](int64_t first, int64_t second, int64_t place) {
        EXPECT_TRUE(pairs.insert({std::min(first, second), std::max(first, second)}).second);
        EXPECT_EQ(first == second, place == pattern.start(first));
        EXPECT_LT(place, pattern.elements());
    });
    EXPECT_EQ(std::ssize(pairs),
              (19 * 12 + 20) / 2); // 5, 4, 3 beside each other: 19 along the one, 3 along the ring
    const int64_t own = pattern.unknown({1, 3, 0});
    bool found = false;
    pattern.for_each_element([&](int64_t first, int64_t second, int64_t place) {
        found = found || (first == own && second == pattern.unknown({2, 4, 0}) &&
                          place == pattern.start(own) + pattern.step({1, 3, 0}, {2, 4, 0}));
    });
    EXPECT_TRUE(found);
    EXPECT_EQ(pattern.unknown({2, 4, 0}), pattern.unknown({2, 0, 0}));
}

} // namespace

} // namespace active_functions_test
