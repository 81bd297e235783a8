// Knots and layers of periodic axes beyond one period.
#include "curves.h"
#include "refine/period.h"
#include "refine/seam.h"
#include "refine/unrolled.h"

#include <gtest/gtest.h>

using namespace nrb;

namespace {

SplinePtr loop() {
    return curve(2, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 1, {1, 2, 3, 4, 1, 2}, true);
}

TEST(Period, ContinuesKnotsBothWays) {
    std::vector<double> knots{0, 0, 1, 1.5, 4, 0, 0};
    continue_knots(knots, 1, 4, 3); // the period [0, 4)
    EXPECT_EQ(knots, (std::vector<double>{-2.5, 0, 1, 1.5, 4, 5, 5.5}));
}

TEST(Period, KeepsEqualKnotsEqual) {
    const KnotVector axis(1, {-0.3, 0.1, 0.1, 0.4, 0.8, 0.8}, true);
    const std::vector<double> knots = extended_knots(axis, 3);
    ASSERT_EQ(knots.size(), 12U);
    EXPECT_EQ(knots[1], knots[2]);
    EXPECT_EQ(knots[7], knots[8]);
    EXPECT_EQ(knots[10], knots[11]);
}

TEST(Unrolled, RepeatsLayersAndKnots) {
    const SplinePtr made = unrolled(loop(), 0, 1);
    EXPECT_FALSE(made->axis(0).periodic());
    EXPECT_EQ(vector_of(made->points()), (std::vector<double>{1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2}));
    EXPECT_EQ(made->axis(0).domain().lower, -2);
    EXPECT_EQ(made->axis(0).domain().upper, 10);
    EXPECT_EQ(made->axis(0)[0], -4);
}

TEST(Unrolled, ByNothingIsTheSameSpline) {
    const SplinePtr made = unrolled(loop(), 0, 0);
    EXPECT_EQ(vector_of(made->points()), vector_of(loop()->points()));
    EXPECT_EQ(vector_of(made->axis(0).knots()), vector_of(loop()->axis(0).knots()));
}

TEST(Seam, AtAKnotMovesLayersOnly) {
    const SplinePtr moved = move_seam(loop(), 0, 3);
    EXPECT_EQ(moved->axis(0).domain().lower, 3);
    EXPECT_EQ(vector_of(moved->points()), (std::vector<double>{2, 3, 4, 1, 2, 3}));
    EXPECT_FALSE(open_axis(loop(), 0)->axis(0).periodic());
}

} // namespace
