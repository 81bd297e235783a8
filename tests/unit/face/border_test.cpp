// SPDX-License-Identifier: MIT
// What of a face follows from its domain and its surface: what runs along its border, and where its poles are.
#include "base/numbers.h"
#include "face/made/seam_parts.h"
#include "face/meets/along_border.h"
#include "face_shapes.h"
#include "refine/forms/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;

TEST(AlongBorder, IsToldOnAxesOfVeryDifferentLengths) {
    for (const double longer : {1.0, 1e6, 1e9}) {
        const Face face({refine::reparametrize(plane(), 0, {0, longer}), {}, 0}, nullptr);
        EXPECT_TRUE(face::runs_along_border(face, *line({0, 0}, {longer, 0}))) << longer;
        EXPECT_TRUE(face::runs_along_border(face, *line({longer, 0}, {longer, 1}))) << longer;
        EXPECT_FALSE(face::runs_along_border(face, *line({0, 1e-6}, {longer, 1e-6}))) << longer;
        EXPECT_FALSE(face::runs_along_border(face, *line({longer / 2, 0}, {longer / 2, 1}))) << longer;
    }
}

TEST(MovedFaces, HaveTheirPolesWhereTheSurfaceIs) {
    const auto face = std::make_shared<const Face>(face::FaceParts{sphere(), {}, 1e-9}, nullptr);
    const double unit[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, by[] = {10, 20, 30};
    const Face moved(face, refine::transform(*face->surface(), {3, 3, unit}, by), 1e-9);
    const double there[] = {10, 20, 31}, before[] = {0, 0, 1};
    EXPECT_GE(moved.covering().pole_near(there, 1e-9).axis, 0);
    EXPECT_LT(moved.covering().pole_near(before, 1e-9).axis, 0);
    EXPECT_GE(face->covering().pole_near(before, 1e-9).axis, 0);
}

// Control points off an open axis are set to its end: weights and form stay, in homogeneous form too.
TEST(SetInside, KeepsWeightsAndTellsTheLargestStep) {
    const double off = 0x1p-10;
    const face::Covering covering(*plane(), 0);
    const SplinePtr given = circle({0.5, 0.5 + off}, 0.5);
    std::vector<double> records;
    for (int64_t i = 0; i < given->point_count(); ++i) {
        const double w = given->weight(i);
        records.insert(records.end(), {w * given->coordinate(i, 0), w * given->coordinate(i, 1), w});
    }
    const SplinePtr homogeneous =
        make_spline(given->knot_vectors(), 2, Form::homogeneous, std::move(records));
    for (const SplinePtr &curve : {given, homogeneous}) {
        face::Point2 step{};
        const SplinePtr inside = face::set_inside(covering, curve, false, step);
        EXPECT_EQ(inside->form(), curve->form());
        EXPECT_LE(step[0], 4 * eps); // of the division of homogeneous points
        EXPECT_NEAR(step[1], off, 4 * eps);
        for (int64_t i = 0; i < curve->point_count(); ++i) {
            EXPECT_EQ(inside->weight(i), curve->weight(i));
            EXPECT_NEAR(inside->coordinate(i, 0), curve->coordinate(i, 0), 4 * eps);
            EXPECT_NEAR(inside->coordinate(i, 1), std::min(curve->coordinate(i, 1), 1.0), 4 * eps);
        }
    }
}

} // namespace
