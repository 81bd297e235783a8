// Knots and layers of periodic axes beyond one period.
#include "refine/periodic/period.h"
#include "refine/periodic/periods.h"
#include "refine/periodic/seam.h"
#include "unit/shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace periods_test {

using namespace nrb;
using namespace shapes;

namespace {

SplinePtr loop() {
    return curve(2, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 1, {1, 2, 3, 4, 1, 2}, true);
}

TEST(Period, continues_knots_both_ways) {
    std::vector<double> knots{0, 0, 1, 1.5, 4, 0, 0};
    refine::continue_knots(knots, 1, 4, 3); // the period [0, 4)
    EXPECT_EQ(knots, (std::vector<double>{-2.5, 0, 1, 1.5, 4, 5, 5.5}));
}

TEST(Period, keeps_equal_knots_equal) {
    const KnotVector axis(1, {-0.3, 0.1, 0.1, 0.4, 0.8, 0.8}, true);
    const std::vector<double> knots = refine::extended_knots(axis, 3);
    ASSERT_EQ(knots.size(), 12U);
    EXPECT_EQ(knots[1], knots[2]);
    EXPECT_EQ(knots[7], knots[8]);
    EXPECT_EQ(knots[10], knots[11]);
}

TEST(OverPeriods, numbers_periods_from_the_domain) {
    const KnotVectorPtr made = refine::over_periods(loop()->axis(0), -1, 2);
    EXPECT_FALSE(made->periodic());
    EXPECT_EQ(made->count(), 14);
    EXPECT_EQ(made->domain().lower, -2);
    EXPECT_EQ(made->domain().upper, 10);
    EXPECT_EQ((*made)[0], -4);
    EXPECT_EQ(made->knots().back(), 12);
}

TEST(OverPeriods, one_period_is_that_of_the_axis) {
    const SplinePtr curve = loop();
    EXPECT_EQ(vector_of(nrb::refine::over_periods(curve->axis(0), 0, 1)->knots()),
              vector_of(curve->axis(0).knots()));
}

TEST(OverPeriods, far_away_takes_no_more_than_its_periods) {
    const KnotVectorPtr made = refine::over_periods(loop()->axis(0), 1000000, 1000001);
    EXPECT_EQ(made->count(), 6);
    EXPECT_EQ(made->domain().lower, 4000002);
    EXPECT_EQ(made->domain().upper, 4000006);
}

TEST(OverPeriods, keeps_equal_knots_equal_and_their_order) {
    const KnotVector axis(1, {-0.3, 0.1, 0.1, 0.4, 0.8, 0.8}, true); // lengths that are rounded
    for (const int64_t first : {-12345, -3, -1, 0, 1, 7, 54321}) {
        const KnotVectorPtr made = refine::over_periods(axis, first, first + 4);
        const std::span<const double> knots = made->knots();
        ASSERT_EQ(knots.size(), 15U);
        EXPECT_TRUE(std::ranges::is_sorted(knots));
        for (size_t i = 1; i + 1 < knots.size(); i += 3) {
            EXPECT_EQ(knots[i], knots[i + 1]) << first;
        }
    }
}

TEST(OverPeriods, refuses_knots_that_rounding_makes_equal) {
    const KnotVector axis(1, {-0.25, 0, 0.25, 0.5, 0.75, 1, 1.25}, true); // where doubles are whole numbers
    const int64_t far = int64_t{1} << 52;
    EXPECT_THROW(nrb::refine::over_periods(axis, far, far + 1), Error);
}

TEST(Seam, at_a_knot_moves_layers_only) {
    const SplinePtr moved = refine::move_seam(loop(), 0, 3);
    EXPECT_EQ(moved->axis(0).domain().lower, 3);
    EXPECT_EQ(vector_of(moved->points()), (std::vector<double>{2, 3, 4, 1, 2, 3}));
    EXPECT_FALSE(nrb::refine::open_axis(loop(), 0)->axis(0).periodic());
}

} // namespace

} // namespace periods_test
