// SPDX-License-Identifier: MIT
// What of a face follows from its domain and its surface: what runs along its border, and where its poles are.
#include "face/meets/along_border.h"
#include "face_shapes.h"
#include "refine/forms/transform.h"

#include <gtest/gtest.h>

#include <memory>

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

} // namespace
