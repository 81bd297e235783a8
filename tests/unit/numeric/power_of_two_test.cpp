// Products with powers of two have the bits of std::ldexp, from the smallest numbers to overflow.
#include "numeric/power_of_two.h"

#include "support/generators.h"

#include <bit>
#include <gtest/gtest.h>
#include <limits>

namespace power_of_two_test {

TEST(PowerOfTwo, products_have_the_bits_of_ldexp) {
    support::Random random(771);
    for (int i = 0; i < 20000; ++i) {
        const double x = std::ldexp(random.between(-1, 1), static_cast<int>(random.between(-1080, 1025)));
        const int exponent = static_cast<int>(random.between(-2200, 2200));
        EXPECT_EQ(std::bit_cast<uint64_t>(nrb::times_power_of_two(x, exponent)),
                  std::bit_cast<uint64_t>(std::ldexp(x, exponent)))
            << x << " 2^" << exponent;
    }
}

TEST(PowerOfTwo, what_is_no_number_stays) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const int exponent : {-2000, -1023, -1022, 0, 1023, 1024, 2000}) {
        EXPECT_EQ(nrb::times_power_of_two(infinite, exponent), infinite);
        EXPECT_TRUE(std::isnan(nrb::times_power_of_two(std::nan(""), exponent)));
        EXPECT_TRUE(std::signbit(nrb::times_power_of_two(-0.0, exponent)));
    }
}

} // namespace power_of_two_test
