// Places where feet may stay.
#include "closest/stops.h"

#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace stops_test {

using namespace nrb;
using closest::may_hold_foot;

namespace {

TEST(Stops, are_ends_and_kinks) {
    const KnotVectorPtr axis = make_knot_vector(2, {0, 0, 0, 1, 2, 2, 3, 3, 3});
    for (const double t : {0.0, 2.0, 3.0}) {
        EXPECT_TRUE(may_hold_foot(*axis, t)) << t;
    }
    for (const double t : {0.5, 1.0, 2.5}) {
        EXPECT_FALSE(may_hold_foot(*axis, t)) << t;
    }
    EXPECT_FALSE(may_hold_foot(*make_knot_vector(2, {-2, -1, 0, 1, 2, 3, 4, 5}, true), 0));
    EXPECT_TRUE(may_hold_foot(*make_knot_vector(0, {0, 1, 2}), 0.5));
}

} // namespace

} // namespace stops_test
