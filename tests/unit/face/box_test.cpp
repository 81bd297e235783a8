// SPDX-License-Identifier: MIT
// Boxes of faces.
#include "face/face_box.h"

#include "face_shapes.h"

#include <gtest/gtest.h>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;

TEST(FaceBox, OfADiscIsThatOfItsCircle) {
    const Face face({plane(10), {loop_of({circle({0.5, 0.5}, 0.25)})}, 1e-12}, nullptr);
    for (const double tolerance : {1.0, 1e-2, 1e-4}) {
        const bounds::Box box = face::bounding_box(face, tolerance);
        EXPECT_LE(box.gap, tolerance);
        for (size_t c = 0; c < 2; ++c) {
            EXPECT_LE(box.lower[c], 2.5);
            EXPECT_GE(box.lower[c], 2.5 - tolerance - 1e-14);
            EXPECT_GE(box.upper[c], 7.5);
            EXPECT_LE(box.upper[c], 7.5 + tolerance + 1e-14);
        }
        EXPECT_NEAR(box.upper[2], 0, 1e-13); // the edge is composed, and sides are rounded outwards
    }
}

TEST(FaceBox, OfCapsAndHoles) {
    const SplinePtr s = sphere();
    const Face north({s, {loop_of({segment(*s, {0, 0.6}, {1, 0.6})})}, 1e-9}, nullptr);
    const Interval v = s->axis(1).domain();
    const double rim = face::point_at(*s, {0, v.lower + 0.6 * (v.upper - v.lower)})[2];
    const bounds::Box box = face::bounding_box(north, 1e-4);
    EXPECT_LE(box.gap, 1e-4);
    EXPECT_NEAR(box.upper[2], 1, 1.1e-4);
    EXPECT_NEAR(box.lower[2], rim, 1.1e-4);
    EXPECT_GE(box.upper[2], 1);
    EXPECT_LE(box.lower[2], rim);
    const Face whole({s, {}, 1e-9}, nullptr);
    EXPECT_NEAR(face::bounding_box(whole, 1e-6).lower[0], -1, 1.1e-6);
}

} // namespace
