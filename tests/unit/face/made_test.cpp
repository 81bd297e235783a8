// SPDX-License-Identifier: MIT
// Curves that faces make: under edges, and over curves of the domain.
#include "face/deviation.h"

#include "eval/curve_point.h"
#include "eval/evaluate.h"
#include "face/made/curve_fit.h"
#include "face/made/curve_under.h"
#include "face_shapes.h"
#include "numeric/norm.h"
#include "refine/compose/compose.h"
#include "refine/forms/transpose.h"
#include "refine/knots/insert.h"
#include "refine/parts/iso.h"
#include "spline/part.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Coedge;
using face::Covering;
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

// The largest distance, at equal parameters, of a curve in space and the image of one in the plane that
// covers the domain.
double largest_distance(const Spline &surface, const Covering &covering, const Spline &curve,
                        const Spline &space) {
    const Interval range = curve.axis(0).domain();
    double largest = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double t = parameter_in(range, i / 1000.0);
        Point2 x;
        eval::curve_point(curve, t, false, x.data());
        const std::vector<double> image = face::point_at(surface, covering.in_domain(x)),
                                  point = eval::curve_point(space, t, false);
        largest = std::max(largest, distance(image.data(), point.data(), surface.dim()));
    }
    return largest;
}

// A cylinder whose axis of this number is the round one. Where it closes it is open by so much.
SplinePtr cylinder_around(int axis, double gap = 0) {
    const SplinePtr s = cylinder();
    std::vector<double> points(s->points().begin(), s->points().end());
    for (size_t i = points.size() - 4; i < points.size(); i += 3) {
        points[i] += gap;
    }
    const SplinePtr open =
        make_spline(s->knot_vectors(), 3, s->form(), points, {s->weights().begin(), s->weights().end()});
    const int32_t exchanged[] = {1, 0};
    return axis == 0 ? open : refine::transpose(*open, exchanged);
}

// Across its seam, in shares of its domain.
SplinePtr across(const Spline &surface, int axis, double from = 0.25, double to = 0.75) {
    Point2 a{0.6, 0.6}, b{1.3, 1.3};
    a[static_cast<size_t>(1 - axis)] = from;
    b[static_cast<size_t>(1 - axis)] = to;
    return segment(surface, a, b);
}

TEST(MadeCurves, OverSeamsAreExactWhicheverAxisCloses) {
    for (const int axis : {0, 1}) {
        const SplinePtr s = cylinder_around(axis), curve = across(*s, axis);
        const Covering covering(*s, 1e-9);
        ASSERT_TRUE(covering.closed(axis));
        const face::MadeCurve made = face::edge_over(s, covering, curve, 1e-6);
        EXPECT_TRUE(made.proven);
        EXPECT_LE(made.distance, 1e-14);
        EXPECT_LE(largest_distance(*s, covering, *curve, *made.curve), 4e-15);
        EXPECT_EQ(made.curve->axis(0).degree(), 3);
    }
}

// What joining the parts between seams moves, and setting them into the domain, is in the bound.
TEST(MadeCurves, OverSeamsAreOffByWhatWasMoved) {
    constexpr double rounding = 0x1p-50;
    for (const int axis : {0, 1}) {
        const SplinePtr open = cylinder_around(axis, 1e-11), whole = cylinder_around(axis);
        for (const auto &[s, to, least] :
             {std::tuple(open, 0.75, 9e-12), {whole, 1 + 0x1p-41, 4e-13}, {open, 1 + 0x1p-41, 9e-12}}) {
            const Covering covering(*s, 1e-9);
            const SplinePtr curve = across(*s, axis, 0.25, to);
            const face::MadeCurve made = face::edge_over(s, covering, curve, 1e-6);
            const double found = largest_distance(*s, covering, *curve, *made.curve);
            EXPECT_GE(found, least);
            EXPECT_TRUE(made.proven);
            EXPECT_LE(found, made.distance + rounding);
            EXPECT_LE(made.distance, 8 * found);
        }
    }
}

// A plane is mapped by its parallelogram: curves keep their degrees, however high.
TEST(MadeCurves, OverAPlaneHaveAnyDegree) {
    const SplinePtr s = plane(4);
    const Covering covering(*s, 1e-9);
    for (const int degree : {15, 16, 31}) {
        std::vector<double> points;
        for (int i = 0; i <= degree; ++i) {
            points.insert(points.end(), {static_cast<double>(i) / degree, 0.5 + 0.4 * std::sin(i)});
        }
        const SplinePtr curve = shapes::bezier(2, points);
        const face::MadeCurve made = face::edge_over(s, covering, curve, 1e-6);
        EXPECT_TRUE(made.proven);
        EXPECT_EQ(made.distance, 0);
        EXPECT_EQ(made.curve->axis(0).degree(), degree);
        EXPECT_LE(largest_distance(*s, covering, *curve, *made.curve), 4e-15);
    }
}

// Where weights are negative, curves leave the hull of their control points.
TEST(MadeCurves, UnderEdgesOfNegativeWeightsOnAPlane) {
    constexpr double off = 1e-3, precision = 1e-6;
    const SplinePtr s = plane(8);
    const Covering covering(*s, 1e-9);
    const double w = -0.9; // (1 w 1), so that the middle is off the plane by 9 times as much as the point
    const SplinePtr edge = make_spline({shapes::bezier_axis(2)}, 3, Form::homogeneous,
                                       {3, 4, 0, 1, 4 * w, 4 * w, off * w, w, 5, 4, 0, 1});
    face::Effort effort;
    effort.allow(*edge);
    const face::MadeCurve made = face::curve_under(s, covering, edge, {10 * off, precision, true}, effort);
    const double found = largest_distance(*s, covering, *made.curve, *edge);
    EXPECT_GE(found, 8.9 * off);
    EXPECT_TRUE(made.proven);
    EXPECT_LE(found, made.distance + 1e-15);
    EXPECT_LE(made.distance, 1.25 * (9 * off + 2 * precision)); // as close as deviation() looks
    EXPECT_EQ(face::proven_distance(s, covering, made.curve, *edge), made.distance);
    face::Effort more;
    EXPECT_THROW(face::curve_under(s, covering, edge, {8 * off, precision, true}, more), Error);
}

// A disc around its pole.
SplinePtr disc() {
    const SplinePtr s = cylinder();
    std::vector<double> points;
    for (int64_t i = 0; i < s->point_count(); ++i) {
        const double radius = i % 2 == 0 ? 1 : 0;
        points.insert(points.end(), {radius * s->coordinate(i, 0), radius * s->coordinate(i, 1), 0});
    }
    return make_spline(s->knot_vectors(), 3, s->form(), points, {s->weights().begin(), s->weights().end()});
}

// The cubic (x (r^2 - 1), y r (r^2 - 1)), which passes the origin at r = -1 and 1, for |r| <= 1.4.
SplinePtr knot_at_origin(double x, double y) {
    constexpr double reach = 1.4;
    std::vector<double> points;
    for (int i = 0; i < 4; ++i) {
        const double a = i > 2 ? reach : -reach, b = i > 1 ? reach : -reach, c = i > 0 ? reach : -reach;
        points.insert(points.end(),
                      {x * ((a * b + b * c + c * a) / 3 - 1), y * (a * b * c - (a + b + c) / 3), 0});
    }
    return shapes::bezier(3, points);
}

TEST(MadeCurves, UnderEdgesThatPassAPoleTwice) {
    const SplinePtr s = disc();
    const Covering covering(*s, 1e-9);
    ASSERT_TRUE(covering.has_poles());
    for (const bool halved : {false, true}) { // with a break at one of the passages
        SplinePtr edge = knot_at_origin(0.5, 0.3);
        if (halved) {
            edge = refine::insert_knot(edge, 0, (1 + 1 / 1.4) / 2, 3);
        }
        face::Effort effort;
        effort.allow(*edge);
        const face::MadeCurve made = face::curve_under(s, covering, edge, {1e-6, 1e-6, false}, effort);
        EXPECT_LE(largest_distance(*s, covering, *made.curve, *edge), 2e-6);
        EXPECT_LE(made.curve->point_count(), 200);
    }
}

} // namespace
