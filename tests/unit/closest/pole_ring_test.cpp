// SPDX-License-Identifier: MIT
#include "closest/patch/critical/pole_ring.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace pole_ring_test {

using namespace nrb;

namespace {

closest::PoleRing ring(std::initializer_list<int> signs) {
    closest::PoleRing result;
    for (const int sign : signs) {
        result.add(sign);
    }
    return result;
}

TEST(PoleRing, larger_distances_all_around_are_a_minimum_and_smaller_ones_a_maximum) {
    EXPECT_TRUE(ring({1, 1, 1}).decides());
    EXPECT_EQ(ring({1, 1, 1}).kind(true), closest::critical_minimum);
    EXPECT_EQ(ring({-1, -1}).kind(false), closest::critical_maximum);
}

TEST(PoleRing, two_changes_around_a_pole_are_a_slope_and_four_a_saddle) {
    EXPECT_EQ(ring({1, 1, -1, -1}).kind(true), 0);
    EXPECT_EQ(ring({1, -1, 1, -1}).kind(true), closest::critical_saddle);
    EXPECT_EQ(ring({1, 0, -1, 0, 1, 0, -1}).kind(true), closest::critical_saddle);
}

TEST(PoleRing, only_extrema_count_in_an_open_ring) {
    EXPECT_EQ(ring({1, -1, 1, -1}).kind(false), 0);
}

TEST(PoleRing, equal_distances_decide_nothing_beside_one_sign) {
    EXPECT_FALSE(ring({0, 0}).decides());
    EXPECT_FALSE(ring({1, 0, 1}).decides());
    EXPECT_TRUE(ring({1, 0, -1}).decides());
}

} // namespace

} // namespace pole_ring_test
