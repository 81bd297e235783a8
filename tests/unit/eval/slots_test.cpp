#include "eval/kernels/contraction.h"
#include "eval/kernels/slots.h"

#include <gtest/gtest.h>
#include <set>

namespace slots_test {

namespace {

TEST(Slots, for_each_visits_them_in_order) {
    for (int axes = 1; axes <= 3; ++axes) {
        int64_t next = 0;
        nrb::eval::for_each_slot(
            axes, 6, [&](int i, int j, int k) { EXPECT_EQ(nrb::eval::slot(axes, i, j, k), next++); });
        EXPECT_EQ(next, nrb::eval::slot_count(axes, 6));
    }
}

TEST(Slots, follow_the_formulas_of_the_header) {
    nrb::eval::for_each_slot(3, 5, [](int i, int j, int k) {
        const int s = i + j + k;
        const int r = j + k;
        EXPECT_EQ(nrb::eval::slot(3, i, j, k), s * (s + 1) * (s + 2) / 6 + r * (r + 1) / 2 + k);
        if (k == 0) {
            EXPECT_EQ(nrb::eval::slot(2, i, j), (i + j) * (i + j + 1) / 2 + j);
        }
    });
}

TEST(ContractionSteps, fill_every_slot_once) {
    for (int axes = 1; axes <= 3; ++axes) {
        std::set<int64_t> targets;
        int64_t steps = 0;
        nrb::eval::for_each_step(axes - 1, 4, [&](int64_t, int, int64_t target) {
            targets.insert(target);
            ++steps;
        });
        EXPECT_EQ(steps, nrb::eval::slot_count(axes, 4));
        EXPECT_EQ(static_cast<int64_t>(targets.size()), steps);
        EXPECT_EQ(*targets.rbegin(), steps - 1);
    }
}

} // namespace

} // namespace slots_test
