// SPDX-License-Identifier: MIT
// Curves that faces make: under edges, and over curves of the domain.
#include "face/deviation.h"

#include "eval/evaluate.h"
#include "face/made/curve_fit.h"
#include "face_shapes.h"
#include "refine/compose/compose.h"
#include "refine/parts/iso.h"
#include "spline/part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Coedge;
using face::Face;

// The largest distance of the edge and the image of its curve at equal parameters.
double largest_distance(const Face &face, const Coedge &coedge) {
    const SplinePtr edge = face::edge_of(face, coedge);
    const Interval range = coedge.curve->axis(0).domain();
    double largest = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double t = parameter_in(range, i / 1000.0), s = coedge.against ? -t : t;
        Point2 x;
        eval::evaluate_points(*coedge.curve, {}, 0, {&t, 1}, {x.data(), 1, 2, 2});
        std::vector<double> point(3);
        eval::evaluate_points(*edge, {}, 0, {&s, 1}, {point.data(), 1, 3, 3});
        const std::vector<double> image = face::point_at(*face.surface(), face.covering().in_domain(x));
        largest =
            std::max(largest, std::hypot(image[0] - point[0], image[1] - point[1], image[2] - point[2]));
    }
    return largest;
}

Loop edges(const std::vector<std::pair<SplinePtr, bool>> &given) {
    Loop loop;
    for (const auto &[edge, against] : given) {
        loop.push_back({nullptr, edge, 0, against});
    }
    return loop;
}

// Passes many pieces and is never followed closely enough.
class Endless : public face::CurveModel {
public:
    [[nodiscard]] int dim() const noexcept override { return 2; }
    void place(double t, const double *, double *out) const override { out[0] = out[1] = t; }
    void errors(const Spline &, std::span<const double> params, double *errors) const override {
        looked += params.size();
        std::fill_n(errors, params.size(), 1.0);
    }
    [[nodiscard]] int64_t pieces_between(double, const double *, double, const double *) const override {
        return 4096;
    }
    mutable size_t looked = 0;
};

TEST(MadeCurves, ComeToAnEnd) {
    const Endless model;
    const std::vector<double> breaks{0, 1}, same{0, 0};
    face::Effort effort;
    try {
        face::fit_curve(model, breaks, same, 1e-9, effort);
        ADD_FAILURE();
    } catch (const Error &error) {
        EXPECT_EQ(error.status(), Status::not_converged);
    }
    EXPECT_LE(model.looked, 1000000U);
    EXPECT_GT(model.looked, 100000U);
}

TEST(MadeCurves, OnAPlaneAreExact) {
    const SplinePtr s = plane(4);
    const SplinePtr round = refine::compose(s, circle({0.5, 0.5}, 0.25));
    for (const bool against : {false, true}) {
        const Face face({s, {edges({{round, against}})}, 1e-12}, nullptr);
        const face::Deviation found = face::deviation_of(face, face.loops()[0][0]);
        EXPECT_TRUE(found.proven);
        EXPECT_LE(found.distance, 1e-15);
        EXPECT_LE(largest_distance(face, face.loops()[0][0]), 4e-15);
        EXPECT_EQ(face.loops()[0][0].curve->form(), Form::rational);
    }
}

// Bottom, up the seam, top and down the seam again: of the four curves two lie on either side of the domain.
TEST(MadeCurves, AroundACylinderWithItsSeam) {
    const SplinePtr s = cylinder();
    const Interval u = s->axis(0).domain(), v = s->axis(1).domain();
    const SplinePtr bottom = refine::iso(*s, 1, v.lower, {}), top = refine::iso(*s, 1, v.upper, {}),
                    seam = refine::iso(*s, 0, u.lower, {});
    for (const double tolerance : {1e-3, 1e-7}) {
        const Face face(
            {s, {edges({{bottom, false}, {seam, false}, {top, true}, {seam, true}})}, tolerance, true},
            nullptr);
        for (const Coedge &coedge : face.loops()[0]) {
            EXPECT_LE(largest_distance(face, coedge), tolerance);
            EXPECT_LE(face::deviation_of(face, coedge).distance, tolerance);
            EXPECT_TRUE(face::deviation_of(face, coedge).proven);
        }
        for (const double a : {0.1, 0.5, 0.9}) {
            const Point2 x{u.lower + a * (u.upper - u.lower), v.lower + a * (v.upper - v.lower)};
            int32_t side = 7;
            face::classify(face, {x.data(), 1, 2, 2}, 0, &side);
            EXPECT_EQ(side, 1);
        }
    }
}

TEST(MadeCurves, OverAndUnderAWavyPatchComeBack) {
    std::vector<double> points;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            points.insert(points.end(),
                          {i / 5.0, j / 5.0 + 0.05 * std::sin(3.0 * i), 0.3 * std::cos(2.0 * i + j)});
        }
    }
    const KnotVectorPtr axis = make_knot_vector(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3});
    const SplinePtr s = make_spline({axis, axis}, 3, Form::polynomial, points);
    const SplinePtr curve = circle({1.5, 1.5}, 1.2);
    const Face given({s, {loop_of({curve})}, 1e-9}, nullptr);
    EXPECT_TRUE(face::deviation_of(given, given.loops()[0][0]).proven);
    const SplinePtr edge = face::edge_of(given, given.loops()[0][0]);
    const Face made({s, {edges({{edge, false}})}, 1e-6}, nullptr);
    EXPECT_LE(largest_distance(made, made.loops()[0][0]), 1e-6);
    EXPECT_LE(face::deviation_of(made, made.loops()[0][0]).distance, 1e-6);
    EXPECT_LT(made.loops()[0][0].curve->count(0), 400);
}

TEST(MadeCurves, MeridiansOfASphereMeetAtThePole) {
    const SplinePtr s = sphere();
    const Interval u = s->axis(0).domain();
    const SplinePtr up = refine::iso(*s, 0, u.lower, {}),
                    down = refine::iso(*s, 0, u.lower + (u.upper - u.lower) / 4, {});
    const Face face({s, {edges({{down, false}, {up, true}})}, 1e-7, true}, nullptr);
    for (const Coedge &coedge : face.loops()[0]) {
        EXPECT_LE(largest_distance(face, coedge), 1e-7);
    }
    int32_t side = 7;
    const Point2 inside{u.lower + (u.upper - u.lower) / 8, s->axis(1).domain().lower + 0.1},
        outside{u.lower + (u.upper - u.lower) / 2, inside[1]};
    face::classify(face, {inside.data(), 1, 2, 2}, 0, &side);
    EXPECT_EQ(side, 1);
    face::classify(face, {outside.data(), 1, 2, 2}, 0, &side);
    EXPECT_EQ(side, -1);
}

TEST(MadeCurves, RefuseEdgesOffTheSurface) {
    const SplinePtr s = cylinder();
    const SplinePtr off = build::polyline(3, {1, 0, 0, 1.5, 0, 1}, {0, 1});
    try {
        const Face face({s, {edges({{off, false}})}, 1e-3}, nullptr);
        FAIL();
    } catch (const Error &error) {
        EXPECT_EQ(error.status(), Status::gap);
        EXPECT_NE(std::string(error.what()).find("edge 0 of loop 0"), std::string::npos) << error.what();
    }
}

// An edge without number runs with its loop, also after the loop was turned.
TEST(MadeCurves, EdgesWithoutNumbersTurnWithTheirLoops) {
    const SplinePtr s = plane(1);
    const auto side = [&](Point2 a, Point2 b) {
        return build::polyline(3, {a[0], a[1], 0, b[0], b[1], 0}, {0, 1});
    };
    const Face face({s,
                     {edges({{side({0.1, 0.1}, {0.1, 0.9}), false},
                             {side({0.1, 0.9}, {0.9, 0.9}), false},
                             {side({0.9, 0.9}, {0.9, 0.1}), false},
                             {side({0.9, 0.1}, {0.1, 0.1}), false}})},
                     1e-9},
                    nullptr);
    for (const Coedge &coedge : face.loops()[0]) {
        EXPECT_FALSE(coedge.against);
        EXPECT_LE(largest_distance(face, coedge), 1e-15);
    }
}

} // namespace
