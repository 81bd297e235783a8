// SPDX-License-Identifier: MIT
// Areas and centroids of faces against closed forms.
#include "face/integrals/face_moments.h"

#include "face_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;
using measure::MomentOrder;
using std::numbers::pi;

TEST(FaceMoments, OfDiscsAndHolesInThePlane) {
    const Face face(
        {plane(), {loop_of({circle({0.5, 0.5}, 0.4)}), loop_of({circle({0.6, 0.5}, 0.1)})}, 1e-12}, nullptr);
    const measure::Moments found = face::moments(face, MomentOrder::inertia, 1e-12);
    const double outer = pi * 0.16, inner = pi * 0.01, area = outer - inner,
                 x = (outer * 0.5 - inner * 0.6) / area;
    EXPECT_NEAR(found.content, area, 1e-12 * area);
    EXPECT_NEAR(found.centroid[0], x, 1e-12);
    EXPECT_NEAR(found.centroid[1], 0.5, 1e-12);
    EXPECT_NEAR(found.centroid[2], 0, 1e-15);
    const double polar =
        outer * 0.16 / 2 + outer * std::pow(0.5 - x, 2) - inner * 0.01 / 2 - inner * std::pow(0.6 - x, 2);
    EXPECT_NEAR(found.inertia[8], polar, 1e-12);
}

TEST(FaceMoments, OfTheWholeSurface) {
    for (const SplinePtr &s : {sphere(), torus(), cylinder(), plane(7)}) {
        const Face whole({s, {}, 1e-9}, nullptr);
        const measure::Moments all = measure::moments(*s, whole_domain(*s), MomentOrder::inertia, 1e-12),
                               found = face::moments(whole, MomentOrder::inertia, 1e-12);
        EXPECT_NEAR(found.content, all.content, 4e-12 * all.content);
        for (size_t i = 0; i < all.inertia.size(); ++i) {
            EXPECT_NEAR(found.inertia[i], all.inertia[i], 1e-10 * all.content);
        }
    }
}

// Archimedes: a zone of a sphere has the area of the cylinder around it.
TEST(FaceMoments, OfCapsOfASphere) {
    const SplinePtr s = sphere();
    for (const double at : {0.2, 0.5, 0.77}) {
        const Face cap({s, {loop_of({segment(*s, {0, at}, {1, at})})}, 1e-9}, nullptr);
        const std::vector<double> point =
            face::point_at(*s, face::Point2{0, s->axis(1).domain().lower + at * (s->axis(1).domain().upper -
                                                                                 s->axis(1).domain().lower)});
        const double area = 2 * pi * (1 - point[2]);
        EXPECT_NEAR(face::moments(cap, MomentOrder::content, 1e-12).content, area, 1e-11 * area) << at;
    }
}

TEST(FaceMoments, PartsAddUp) {
    const SplinePtr s = torus();
    const double total = 4 * pi * pi * 3;
    double sum = 0;
    for (const bool hole : {false, true}) {
        SplinePtr disc = circle({0, 0}, 0.375);
        disc = hole ? refine::reverse(*disc, 0, false) : disc;
        const Face face({s, {loop_of({disc})}, 1e-9, true}, nullptr);
        const measure::Moments found = face::moments(face, MomentOrder::content, 1e-12);
        EXPECT_LE(found.error, 1e-11 * total);
        sum += found.content;
    }
    EXPECT_NEAR(sum, total, 1e-11 * total);
}

} // namespace
