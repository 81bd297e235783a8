// SPDX-License-Identifier: MIT
// Sides of lines against exact integers.
#include "numeric/exact_products.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace {

using Integer = boost::multiprecision::cpp_int;
using Place = std::array<double, 2>;

// Of numbers that are multiples of 2^-60.
int exact_side(const Place &a, const Place &b, const Place &c) {
    const auto whole = [](double x) { return Integer(static_cast<int64_t>(std::ldexp(x, 60))); };
    const Integer left = (whole(b[0]) - whole(a[0])) * (whole(c[1]) - whole(a[1])),
                  right = (whole(b[1]) - whole(a[1])) * (whole(c[0]) - whole(a[0]));
    return left > right ? 1 : left < right ? -1 : 0;
}

TEST(SideOfLine, IsExactBesideTheLine) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int64_t> number(int64_t{1} << 52, int64_t{1} << 53), step(-2, 2);
    const auto place = [&] { return std::ldexp(static_cast<double>(number(random)), -53); };
    int on = 0;
    for (int i = 0; i < 20000; ++i) {
        const Place a{place(), place()}, b{place(), place()};
        const double share = place() - 0.5;
        Place c{a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share};
        for (double &x : c) {
            x = std::ldexp(std::round(std::ldexp(x, 53)) + static_cast<double>(step(random)), -53);
        }
        const int side = nrb::side_of_line(a.data(), b.data(), c.data());
        EXPECT_EQ(side, exact_side(a, b, c));
        for (const double scale : {0x1p-400, 0x1p500}) { // the same at any size
            const Place p{a[0] * scale, a[1] * scale}, q{b[0] * scale, b[1] * scale},
                r{c[0] * scale, c[1] * scale};
            EXPECT_EQ(nrb::side_of_line(p.data(), q.data(), r.data()), side);
        }
        EXPECT_EQ(nrb::side_of_line(a.data(), b.data(), b.data()), 0);
        on += side == 0 ? 1 : 0;
    }
    EXPECT_LT(on, 2000);
}

} // namespace
