// Control points and weights replaced one by one, and which of them stay.
#include "base/error.h"
#include "modify/edit/kept_layers.h"
#include "modify/edit/net_editor.h"
#include "unit/shapes.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace net_editor_test {

namespace {

using nrb::SplinePtr;
using nrb::modify::NetEditor;
using shapes::vector_of;

// A closed quadratic of 3 different points; layers 3 and 4 are copies of 0 and 1.
SplinePtr ring() {
    return shapes::curve(2, {-2, -1, 0, 1, 2, 3, 4, 5}, 2, {0, 0, 4, 0, 0, 4, 0, 0, 4, 0}, true);
}

TEST(NetEditor, finds_the_first_of_the_copies) {
    const SplinePtr closed = ring();
    for (int64_t i = 0; i < 5; ++i) {
        EXPECT_EQ(nrb::modify::original_of(*closed, i), i % 3);
    }
}

TEST(NetEditor, copies_on_periodic_axes_go_along) {
    const SplinePtr closed = ring();
    NetEditor editor(*closed);
    const std::array<double, 2> offset = {1, -2};
    editor.move(1, offset.data(), 2);
    editor.set_weight(0, 8);
    const SplinePtr made = editor.finish();
    EXPECT_EQ(vector_of(made->points()), (std::vector<double>{0, 0, 6, -4, 0, 4, 0, 0, 6, -4}));
    EXPECT_EQ(vector_of(made->weights()), (std::vector<double>{8, 1, 1, 8, 1}));
    EXPECT_TRUE(made->axis(0).periodic());
}

TEST(NetEditor, a_homogeneous_point_keeps_its_place) {
    const SplinePtr arc =
        nrb::make_spline({shapes::bezier_axis(2)}, 2, nrb::Form::homogeneous, {1, 0, 1, 1, 1, 0.5, 0, 2, 2});
    NetEditor editor(*arc);
    editor.set_weight(2, 4);
    EXPECT_EQ(vector_of(editor.finish()->points()), (std::vector<double>{1, 0, 1, 1, 1, 0.5, 0, 4, 4}));
}

TEST(NetEditor, a_point_at_infinity_has_no_place_to_keep) {
    const SplinePtr half =
        nrb::make_spline({shapes::bezier_axis(2)}, 2, nrb::Form::homogeneous, {1, 0, 1, 0, 1, 0, -1, 0, 1});
    NetEditor editor(*half);
    try {
        editor.set_weight(1, 2);
        FAIL();
    } catch (const nrb::Error &error) {
        EXPECT_EQ(error.status(), nrb::Status::point_not_finite);
    }
}

std::vector<int> kept(const SplinePtr &spline, const std::vector<int32_t> &keep) {
    const std::vector<char> kept = nrb::modify::kept_points(*spline, keep.empty() ? nullptr : keep.data());
    return {kept.begin(), kept.end()};
}

TEST(KeptPoints, are_those_that_derivatives_at_the_ends_depend_on) {
    const SplinePtr cubic = shapes::bezier(1, {1, 2, 3, 4});
    EXPECT_EQ(kept(cubic, {}), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(kept(cubic, {-1, -1}), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(kept(cubic, {0, -1}), (std::vector<int>{1, 0, 0, 0}));
    EXPECT_EQ(kept(cubic, {1, 0}), (std::vector<int>{1, 1, 0, 1}));
    EXPECT_EQ(kept(cubic, {31, -1}), (std::vector<int>{1, 1, 1, 1}));
}

// At an end that is not clamped all but one of the degree + 1 control points act on the value.
TEST(KeptPoints, of_an_unclamped_end) {
    const SplinePtr open = shapes::curve(2, {0, 1, 2, 3, 4, 5, 6, 7}, 1, {1, 2, 3, 4, 5});
    EXPECT_EQ(kept(open, {0, -1}), (std::vector<int>{1, 1, 0, 0, 0}));
    EXPECT_EQ(kept(open, {-1, 1}), (std::vector<int>{0, 0, 0, 1, 1}));
    EXPECT_EQ(kept(open, {2, -1}), (std::vector<int>{1, 1, 1, 0, 0}));
}

} // namespace

} // namespace net_editor_test
