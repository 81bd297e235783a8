// Searches without a budget of their own.
#include "closest/locator.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace budget_test {

using namespace nrb;

namespace {

TEST(Budget, of_0_is_the_usual_one) {
    const SplinePtr curve = shapes::bezier(2, {0, 0, 1, 2, 2, -2, 3, 0}),
                    plane = make_spline({shapes::bezier_axis(1), shapes::bezier_axis(1)}, 2, Form::polynomial,
                                        {0, 0, 0, 1, 1, 0, 1, 2});
    const double point[] = {1.25, 1};
    for (const SplinePtr &spline : {curve, plane}) {
        const closest::Locator &locator = closest::locator_of(*spline);
        const closest::Query query{point, nullptr, 1e-9, 0};
        EXPECT_NE(locator.nearest(query).status & closest::closest_certified, 0);
        EXPECT_FALSE(locator.critical(query).points.empty());
        EXPECT_EQ(locator.critical(query).status & closest::closest_budget, 0);
    }
}

} // namespace

} // namespace budget_test
