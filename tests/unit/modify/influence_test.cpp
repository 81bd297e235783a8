// What control points contribute to a point: exact for dyadic numbers.
#include "base/error.h"
#include "modify/edit/influence.h"
#include "unit/shapes.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace influence_test {

namespace {

using nrb::SplinePtr;
using nrb::modify::Contribution;

// B = (1, 2, 1) / 4 at 1/2; weights 1, 3, 1, so w = 2, and R_1 = 3/4.
SplinePtr arc() {
    return shapes::bezier(2, {0, 0, 1, 2, 2, 0}, {1, 3, 1});
}

TEST(Contribution, of_one_point_is_exact) {
    const double half = 0.5;
    const Contribution one = nrb::modify::contribution_about(*arc(), 1, &half);
    EXPECT_EQ(one.function, 0.5);
    EXPECT_EQ(one.weight / one.unit, 1.5);
    EXPECT_EQ(one.rest / one.unit, 0.5);
    EXPECT_EQ(one.influence(), 0.75);
    EXPECT_EQ(one.centre, (std::vector<double>{1, 2}));
    // S = Q + offset / w = (1, 3/2)
    EXPECT_EQ(one.centre[1] + one.offset[1] / (one.weight + one.rest), 1.5);
    EXPECT_EQ(one.offset[0], 0);
    EXPECT_EQ(one.reach(), 0.5);
}

TEST(Contribution, of_several_has_their_mean_as_centre) {
    const double half = 0.5;
    const std::array<int64_t, 2> ends = {0, 2};
    const Contribution both = nrb::modify::contribution_of(*arc(), ends, &half);
    EXPECT_EQ(both.centre, (std::vector<double>{1, 0}));
    EXPECT_EQ(both.influence(), 0.25);
}

TEST(Contribution, of_points_that_do_not_act_is_refused) {
    const SplinePtr polyline = shapes::curve(1, {0, 0, 1, 2, 2}, 1, {0, 1, 5});
    const double t = 0.5;
    const std::array<int64_t, 1> last = {2};
    try {
        nrb::modify::contribution_of(*polyline, last, &t);
        FAIL();
    } catch (const nrb::Error &error) {
        EXPECT_EQ(error.status(), nrb::Status::influence);
    }
}

TEST(MostInfluential, is_the_first_of_several_and_counts_copies_together) {
    const SplinePtr line = shapes::bezier(1, {3, 4});
    const SplinePtr closed =
        shapes::curve(2, {-2, -1, 0, 1, 2, 3, 4, 5}, 2, {0, 0, 4, 0, 0, 4, 0, 0, 4, 0}, true);
    const std::array<double, 2> params = {0.5, 0.75};
    std::array<int64_t, 2> indices{};
    std::array<double, 2> influences{};
    nrb::modify::most_influential(*line, {params.data(), 2, 1, 1, 1}, indices.data(), influences.data());
    EXPECT_EQ(indices, (std::array<int64_t, 2>{0, 1}));
    EXPECT_EQ(influences, (std::array<double, 2>{0.5, 0.75}));
    // The middle of the last span: its functions are 1/8, 3/4, 1/8, the middle one belongs to layer 3, a copy
    // of 0.
    const double last = 2.5;
    nrb::modify::most_influential(*closed, {&last, 1, 1, 1, 1}, indices.data(), influences.data());
    EXPECT_EQ(indices[0], 0);
    EXPECT_EQ(influences[0], 0.75);
}

} // namespace

} // namespace influence_test
