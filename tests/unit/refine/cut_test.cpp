// Cutting axes: breaks, saturated knots, pieces.
#include "refine/parts/cut.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace cut_test {

using namespace nrb;
using namespace shapes;

namespace {

const KnotVector wavy(2, {0, 0, 0, 1, 2, 2, 3, 3, 3, 4, 4, 4});

TEST(Cut, saturates_breaks) {
    const double breaks[] = {1, 2.5};
    EXPECT_EQ(nrb::refine::saturated(2, wavy.knots(), breaks),
              (std::vector<double>{0, 0, 0, 1, 1, 1, 2, 2, 2.5, 2.5, 2.5, 3, 3, 3, 4, 4, 4}));
}

TEST(Cut, rough_knots_are_those_of_less_continuity) {
    EXPECT_EQ(nrb::refine::rough_knots(wavy, 0), (std::vector<double>{0, 3, 4}));
    EXPECT_EQ(nrb::refine::rough_knots(wavy, 1), (std::vector<double>{0, 2, 3, 4}));
    EXPECT_EQ(nrb::refine::rough_knots(wavy, 2), (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(Cut, pieces_share_their_ends) {
    const SplinePtr whole = curve(2, {0, 1, 2, 3, 4, 5, 6}, 1, {0, 2, 4, 8});
    const refine::PartedSpline pieces = refine::bezier_pieces(whole);
    ASSERT_EQ(pieces.size(), 2);
    EXPECT_EQ(vector_of(pieces.part(0)->points()), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(vector_of(pieces.part(1)->points()), (std::vector<double>{3, 4, 6}));
    EXPECT_EQ(vector_of(pieces.part(1)->axis(0).knots()), (std::vector<double>{3, 3, 3, 4, 4, 4}));
}

TEST(Cut, a_part_of_a_part_is_that_part) {
    const SplinePtr whole = bezier(1, {0, 8, 8, 0});
    const SplinePtr half = refine::cut_axis(whole, 0, 0, 0.5, {false, false});
    const SplinePtr quarter = refine::cut_axis(half, 0, 0.25, 0.5, {false, false});
    EXPECT_EQ(vector_of(quarter->points()),
              vector_of(nrb::refine::cut_axis(whole, 0, 0.25, 0.5, {false, false})->points()));
}

} // namespace

} // namespace cut_test
