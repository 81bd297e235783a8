// SPDX-License-Identifier: MIT
// Boxes of faces.
#include "face/face_box.h"

#include "eval/evaluate.h"
#include "face/boundary.h"
#include "face/deviation.h"
#include "face_shapes.h"
#include "refine/degree/elevate.h"
#include "spline/part.h"

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

// A half turn about z takes a disc over the seam to one that lies inside the domain.
TEST(FaceBox, OverSeamsIsAsTightAsBesideThem) {
    for (const SplinePtr &surface : {torus(), sphere(), cylinder()}) {
        const Interval u = surface->axis(0).domain(), v = surface->axis(1).domain();
        const double radius = 0.1 * std::min(u.upper - u.lower, v.upper - v.lower),
                     middle = (v.lower + v.upper) / 2;
        const Face over({surface, {loop_of({circle({u.lower, middle}, radius)})}, 1e-6}, nullptr);
        const Face beside({surface, {loop_of({circle({(u.lower + u.upper) / 2, middle}, radius)})}, 1e-6},
                          nullptr);
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 0.0}) {
            const bounds::Box a = face::bounding_box(over, tolerance),
                              b = face::bounding_box(beside, tolerance);
            const double within = std::max(tolerance, 1e-12);
            EXPECT_LE(a.gap, within);
            for (size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(a.upper[c], c < 2 ? -b.lower[c] : b.upper[c], 2 * within);
                EXPECT_NEAR(a.lower[c], c < 2 ? -b.upper[c] : b.lower[c], 2 * within);
            }
        }
    }
}

// z = 1 at a control point whose layer a jump begins and ends.
TEST(FaceBox, OfSurfacesThatJump) {
    const KnotVectorPtr u = make_knot_vector(1, {0, 0, 0.5, 0.5, 1, 1}),
                        v = make_knot_vector(1, {0, 0, 0.5, 1, 1});
    std::vector<double> points;
    const double heights[4][3] = {{0, 0, 0}, {0.001, 10, 0.001}, {0.001, -5, 0.001}, {0.002, 5, 0.002}};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
            points.insert(points.end(), {i / 3.0, j / 2.0, heights[i][j]});
        }
    }
    const Face face({make_spline({u, v}, 3, Form::polynomial, points), {}, 1e-9}, nullptr);
    const bounds::Box box = face::bounding_box(face, 1e-3);
    EXPECT_GE(box.upper[2], 10);
    EXPECT_LE(box.lower[2], -5);
    EXPECT_LE(box.upper[2] - box.gap, 10);
}

// Edges of degree (3 + 3) 6 have no spline; a ridge between the places at which a first line is looked at.
TEST(FaceBox, OfEdgesThatCannotBeComposed) {
    const int n = 120;
    std::vector<double> knots(4, 0), points;
    for (int i = 1; i < n - 3; ++i) {
        knots.push_back(i);
    }
    knots.insert(knots.end(), 4, n - 3);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 4; ++j) {
            points.insert(points.end(), {i * 1.0, j * 1.0, i == 40 ? 1 - 0.1 * j : 0});
        }
    }
    const SplinePtr s =
        make_spline({make_knot_vector(3, knots), make_knot_vector(3, {0, 0, 0, 0, 1, 1, 1, 1})}, 3,
                    Form::polynomial, points);
    const auto high = [&](const Point2 &a, const Point2 &b) {
        return refine::elevate(segment(*s, a, b), 0, 5);
    };
    const Face face({s,
                     {loop_of({high({0.05, 0.1}, {0.95, 0.1}), high({0.95, 0.1}, {0.95, 0.9}),
                               high({0.95, 0.9}, {0.05, 0.9}), high({0.05, 0.9}, {0.05, 0.1})})},
                     1e-6},
                    nullptr);
    const bounds::Box box = face::bounding_box(face, 1e-3);
    double highest = 0;
    for (int i = 0; i <= 20000; ++i) {
        const double u = (0.05 + 0.9 * i / 20000) * (n - 3);
        highest = std::max(highest, face::point_at(*s, {u, 0.1})[2]);
    }
    EXPECT_GT(highest, 0.6);
    EXPECT_GE(box.upper[2], highest);
    EXPECT_LE(box.upper[2], highest + 2e-3);
    const SplinePtr edge = face::edge_of(face, face.loops()[0][0]);
    double made = 0;
    for (int i = 0; i <= 20000; ++i) {
        const Interval range = edge->axis(0).domain();
        const double t = parameter_in(range, i / 20000.0);
        std::vector<double> x(3);
        eval::evaluate_points(*edge, {}, 0, {&t, 1}, {x.data(), 1, 3, 3});
        made = std::max(made, x[2]);
    }
    EXPECT_NEAR(made, highest, 1e-5);
}

// The gap of this loop crosses the seam of the cylinder.
TEST(BoundaryCurves, OfGapsOverASeamAreInTheDomain) {
    const SplinePtr s = cylinder();
    face::FaceParts parts{
        s,
        {loop_of({segment(*s, {0.125, 0.25}, {0.125, 0.75}), segment(*s, {0.125, 0.75}, {-0.125, 0.75}),
                  segment(*s, {-0.125, 0.75}, {-0.125, 0.25})})},
        1e-9};
    parts.keep_gaps = true;
    const Face face(parts, nullptr);
    ASSERT_EQ(face.joints().size(), 1U);
    const Interval u = s->axis(0).domain();
    double width = 0;
    for (const face::BoundaryCurve &curve : face::boundary_curves(face)) {
        EXPECT_NE(curve.space, nullptr);
        for (int64_t i = 0; i < curve.plane->point_count(); ++i) {
            EXPECT_GE(curve.plane->coordinate(i, 0), u.lower);
            EXPECT_LE(curve.plane->coordinate(i, 0), u.upper);
        }
        if (curve.loop < 0 && !curve.at_end) {
            width += std::abs(curve.plane->coordinate(1, 0) - curve.plane->coordinate(0, 0));
        }
    }
    EXPECT_NEAR(width, (u.upper - u.lower) / 4, 1e-14 * (u.upper - u.lower));
}

} // namespace
