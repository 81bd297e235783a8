#include "base/finite.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace finite_test {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();

// All lengths around those of vectors, and one value that counts at every place.
template <class Test>
void at_every_place(double background, double value, const Test &test) {
    for (size_t size = 1; size < 70; ++size) {
        for (size_t place = 0; place < size; ++place) {
            std::vector<double> values(size, background);
            values[place] = value;
            test(values);
        }
    }
}

TEST(Finite, one_value_decides_wherever_it_stands) {
    EXPECT_TRUE(nrb::all_finite({}));
    for (const double value : {-0.0, largest, -largest, 5e-324}) {
        at_every_place(-1, value, [](const auto &values) { EXPECT_TRUE(nrb::all_finite(values)); });
    }
    for (const double value : {inf, -inf, nan}) {
        at_every_place(-1, value, [](const auto &values) { EXPECT_FALSE(nrb::all_finite(values)); });
    }
}

TEST(Finite, the_largest_magnitude_may_have_either_sign_and_stand_anywhere) {
    EXPECT_EQ(nrb::largest_magnitude({}), 0);
    at_every_place(-1, -3, [](const auto &values) { EXPECT_EQ(nrb::largest_magnitude(values), 3); });
    at_every_place(-1, 3, [](const auto &values) { EXPECT_EQ(nrb::largest_magnitude(values), 3); });
    at_every_place(1, -inf, [](const auto &values) { EXPECT_EQ(nrb::largest_magnitude(values), inf); });
    at_every_place(1, nan, [](const auto &values) {
        EXPECT_EQ(nrb::largest_magnitude(values), values.size() == 1 ? 0 : 1);
    });
}

TEST(Finite, extremes_stand_anywhere) {
    at_every_place(2, 5, [](const auto &values) {
        EXPECT_EQ(nrb::extremes(values).largest, 5);
        EXPECT_EQ(nrb::extremes(values).smallest, values.size() == 1 ? 5 : 2);
    });
    at_every_place(2, -5, [](const auto &values) {
        EXPECT_EQ(nrb::extremes(values).smallest, -5);
        EXPECT_EQ(nrb::extremes(values).largest, values.size() == 1 ? -5 : 2);
    });
}

} // namespace

} // namespace finite_test
