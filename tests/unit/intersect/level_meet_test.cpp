// Meets that consist of curves.
#include "intersect/levels/level_meet.h"

#include "../shapes.h"
#include "base/watch.h"
#include "intersect/levels/sections.h"

#include <array>
#include <gtest/gtest.h>

namespace level_meet_unit_test {

using namespace nrb;
using namespace nrb::intersect;

// Of a paraboloid, whose sections are no lines; so much work is allowed, or any.
Meet sections_with(int64_t work) {
    std::vector<double> points;
    for (const double x : {1.0, -1.0, 1.0}) {
        for (const double y : {1.0, -1.0, 1.0}) {
            points.insert(points.end(), {static_cast<double>(points.size() / 9), y, x + y});
        }
    }
    const SplinePtr surface =
        make_spline({shapes::bezier_axis(2), shapes::bezier_axis(2)}, 3, Form::polynomial, std::move(points));
    const Watch watch({.work = work});
    return plane_sections(*surface, {0, 0, 1}, std::array{0.25, 0.5}, 1e-9);
}

TEST(Meets, tell_of_a_limit_of_work) {
    const Meet whole = sections_with(0), part = sections_with(5000);
    EXPECT_TRUE(whole.complete);
    EXPECT_FALSE(whole.limited);
    EXPECT_FALSE(part.complete);
    EXPECT_TRUE(part.limited);
}

TEST(Meets, are_limited_if_a_part_is) {
    Meet one, other;
    other.limited = true;
    one.append(other);
    EXPECT_TRUE(one.limited);
    one.append({});
    EXPECT_TRUE(one.limited);
}

} // namespace level_meet_unit_test
