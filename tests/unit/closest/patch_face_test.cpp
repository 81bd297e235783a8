// SPDX-License-Identifier: MIT
#include "closest/patch/critical/patch_face.h"

#include "unit/shapes.h"

#include <gtest/gtest.h>

namespace patch_face_test {

using namespace nrb;

namespace {

// Degrees 2 and 1, two pieces along the first axis.
SplinePtr strip() {
    std::vector<double> points;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 2; ++j) {
            points.insert(points.end(), {1.0 * i, 1.0 * j, 0.5 * i * j});
        }
    }
    return make_spline({make_knot_vector(2, {0, 0, 0, 1, 2, 2, 2}), shapes::bezier_axis(1)}, 3,
                       Form::polynomial, std::move(points));
}

TEST(PatchFace, codes_are_all_sides_edges_and_corners) {
    const SplinePtr spline = strip();
    const pieces::PieceGrid pieces(*spline);
    EXPECT_EQ(closest::face_count(pieces.shape()), 9);
    const closest::PatchFace inside = closest::face_of(pieces.shape(), 0);
    EXPECT_EQ(inside.shape.axes, 2);
    EXPECT_EQ(inside.side[0], -1);
    const closest::PatchFace edge = closest::face_of(pieces.shape(), 2); // the upper end of axis 0
    EXPECT_EQ(edge.side[0], 1);
    EXPECT_EQ(edge.side[1], -1);
    EXPECT_EQ(edge.shape.axes, 1);
    EXPECT_EQ(edge.shape.degree(0), 1);
    EXPECT_EQ(edge.in_piece({0.25}), (closest::AxisValues{1, 0.25, 0}));
    EXPECT_EQ(closest::face_of(pieces.shape(), 8).shape.axes, 0);
}

TEST(PatchFace, only_pieces_at_an_end_touch_a_side) {
    const SplinePtr spline = strip();
    const pieces::PieceGrid pieces(*spline);
    const double point[3] = {};
    const closest::Query query{point, nullptr, 0, 0};
    const auto at = [&](int code) {
        return closest::pieces_at(pieces, query, closest::face_of(pieces.shape(), code));
    };
    EXPECT_EQ(at(0), (std::vector<int64_t>{0, 1}));
    EXPECT_EQ(at(1), (std::vector<int64_t>{0}));
    EXPECT_EQ(at(2), (std::vector<int64_t>{1}));
    const Interval range[2] = {{0.25, 0.75}, {0, 1}};
    const closest::Query part{point, range, 0, 0};
    EXPECT_EQ(closest::pieces_at(pieces, part, closest::face_of(pieces.shape(), 2)),
              (std::vector<int64_t>{0}));
}

TEST(PatchFace, coefficients_of_a_side_are_the_control_points_there) {
    const SplinePtr spline = strip();
    const pieces::PieceGrid pieces(*spline);
    const pieces::PatchShape &shape = pieces.shape();
    std::vector<double> work(static_cast<size_t>(shape.values())), patch(work);
    pieces.patch(1, work.data(), patch.data());
    const closest::PatchFace side = closest::face_of(shape, 2);
    std::vector<double> edge(static_cast<size_t>(side.shape.values()));
    closest::copy_face(shape, side, patch.data(), edge.data());
    const auto last = patch.end() - side.shape.values();
    EXPECT_EQ(edge, std::vector<double>(last, patch.end()));
}

} // namespace

} // namespace patch_face_test
