// A hash grid of points.
#include "closest/near_points.h"

#include <gtest/gtest.h>

namespace near_points_test {

using namespace nrb::closest;

namespace {

bool are_near(int dim, const double *a, const double *b, double near) {
    NearPoints points(dim, near);
    points.add(a);
    return points.any_near(b, [](int64_t) { return true; });
}

// The distance of such pairs is rounded to the radius, while the border of a cube as wide as that, on which one
// of them lies, is two borders away from the other.
TEST(NearPoints, pairs_at_the_radius_are_found) {
    for (const double near : {1.0, 0.1, 3e-9}) {
        for (int axis = 0; axis < 3; ++axis) {
            double a[3] = {}, b[3] = {};
            a[axis] = -1e-20 * near;
            b[axis] = near;
            EXPECT_TRUE(are_near(3, a, b, near)) << near << " " << axis;
            EXPECT_TRUE(are_near(3, b, a, near)) << near << " " << axis;
            b[axis] = 1.01 * near;
            EXPECT_FALSE(are_near(3, a, b, near)) << near << " " << axis;
        }
    }
}

} // namespace

} // namespace near_points_test
