// The deviations of one spline from several others.
#include "bounds/deviation.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace deviation_test {

using namespace nrb;
using namespace shapes;

TEST(Deviation, does_not_depend_on_what_was_compared_before) {
    const SplinePtr f = curve(2, {0, 0, 0, 0.5, 1, 1, 1}, 1, {0, 1, 4, 2});
    const std::vector<SplinePtr> others{
        curve(2, {0, 0, 0, 0.5, 1, 1, 1}, 1, {0, 1, 4, 3}),  // alike
        curve(2, {0, 0, 0, 0.25, 1, 1, 1}, 1, {0, 1, 4, 2}), // at another knot
        curve(2, {0, 0, 0, 0.75, 1, 1, 1}, 1, {0, 1, 4, 2}), // with as many pieces
        bezier(1, {0, 1, 4, 2}),                             // of a higher degree
        bezier(1, {0, 1, 4, 2}, {1, 2, 3, 4}),               // and rational
        bezier(1, {0, 4}),                                   // and then a line
    };
    bounds::DeviationsFrom deviations(*f);
    for (const SplinePtr &g : others) {
        const bounds::DeviationPieces pieces = deviations.to(*g), alone(*f, *g);
        EXPECT_EQ(pieces.breaks(), alone.breaks());
        EXPECT_EQ(pieces.uppers(), alone.uppers());
    }
}

} // namespace deviation_test
