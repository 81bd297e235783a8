// SPDX-License-Identifier: MIT
#include "numeric/golden_section.h"

#include <cmath>
#include <gtest/gtest.h>

namespace golden_section_test {

TEST(GoldenSection, finds_the_minimum_with_one_value_for_each_section) {
    for (int sections = 0; sections < 30; ++sections) {
        const double reach = 4 * std::pow(0.6180339887498949, sections);
        for (double place = -1; place <= 3; place += 0.25) { // the ends too
            int values = 0;
            const double found = nrb::golden_section(-1.0, 3.0, sections, [&](double t) {
                ++values;
                return std::abs(t - place);
            });
            EXPECT_NEAR(found, place, 0.501 * reach);
            EXPECT_EQ(values, sections + 2);
        }
    }
}

} // namespace golden_section_test
