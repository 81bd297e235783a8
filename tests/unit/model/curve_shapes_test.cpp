// Curves as files state them: parts, points, and the maps of their parameters.
#include "base/error.h"
#include "model/shapes/curve_map.h"
#include "model/shapes/curve_spline.h"
#include "recognize/recognize.h"
#include "support/step_reading.h"

#include <cmath>
#include <random>

namespace curve_shapes_test {

namespace {

using namespace nrb;
using namespace nrb::model;
using step_test::expect_near;
using step_test::point_of;

CurveShapePtr shape(CurveKind kind, double a, double b) {
    const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
    CurveShape curve{kind, build::make_placement(3, origin, z, x, "origin"), {a, b}, nullptr, {}};
    return std::make_shared<const CurveShape>(std::move(curve));
}

const std::vector<std::pair<const char *, CurveShapePtr>> &shapes() {
    static const std::vector<std::pair<const char *, CurveShapePtr>> all = {
        {"line", shape(CurveKind::line, 3, 0)},
        {"circle", shape(CurveKind::circle, 2, 0)},
        {"ellipse", shape(CurveKind::ellipse, 3, 0.5)},
        {"parabola", shape(CurveKind::parabola, 0.5, 0)},
        {"hyperbola", shape(CurveKind::hyperbola, 1, 2)}};
    return all;
}

// The law of the map: the spline at to_spline_parameter(t) is the curve at t.
TEST(CurveShapes, splines_are_the_curve_at_mapped_parameters) {
    std::mt19937_64 random(20261127);
    std::uniform_real_distribution<double> start(-2, 2), extent(0.01, 5);
    for (const auto &[name, curve] : shapes()) {
        SCOPED_TRACE(name);
        for (int k = 0; k < 50; ++k) {
            const double lower = start(random);
            const Interval range = {lower, lower + extent(random)};
            for (const bool forward : {true, false}) {
                const SplinePtr spline = piece_spline({curve, range, forward});
                const CurveShapePtr part = curve_of_piece({curve, range, forward});
                const Interval domain = spline->axis(0).domain();
                EXPECT_EQ(natural_range(*part).lower, domain.lower);
                EXPECT_EQ(natural_range(*part).upper, domain.upper);
                for (int i = 0; i <= 10; ++i) {
                    const double t = i == 10 ? domain.upper : std::lerp(domain.lower, domain.upper, i / 10.0);
                    const double s = to_spline_parameter(*part, *spline, t);
                    const double size = length(point_at(*part, t)) + std::cosh(range.upper);
                    expect_near(point_of(*spline, s), point_at(*part, t), 1e-14 * size);
                    EXPECT_NEAR(from_spline_parameter(*part, *spline, s), t, 1e-14 * (1 + std::fabs(t)));
                }
            }
        }
    }
}

TEST(CurveShapes, points_of_a_curve_have_their_parameters) {
    for (const auto &[name, curve] : shapes()) {
        SCOPED_TRACE(name);
        for (const double t : {0.0, 0.25, 1.0, 2.0, 3.0}) {
            const Vector3 p = point_at(*curve, t);
            const double point[3] = {p.x, p.y, p.z};
            EXPECT_NEAR(parameter_at(*curve, point), t, 1e-14);
        }
    }
}

// Whatever turn the range is in. Beside the range the nearer end counts.
TEST(CurveShapes, points_of_an_arc_have_its_parameters) {
    const CurveShapePtr circle = shapes()[1].second;
    for (const Interval range : {Interval{0, 1.5}, {-1, 1}, {5, 8}, {-8, -5}, {2, 2 + turn}}) {
        const double middle = (range.lower + range.upper) / 2, beyond = 0.05;
        for (const auto &[at, wanted] : {std::pair(range.lower - beyond, range.lower),
                                         {range.lower + beyond, range.lower + beyond},
                                         {middle, middle},
                                         {range.upper - beyond, range.upper - beyond},
                                         {range.upper + beyond, range.upper}}) {
            if (range.upper - range.lower > 6 && (at < range.lower || at > range.upper)) {
                continue; // all around there is no place beside it
            }
            const Vector3 p = point_at(*circle, at);
            const double point[3] = {p.x, p.y, p.z};
            EXPECT_NEAR(parameter_at(*curve_of_piece({circle, range, true}), point), wanted, 1e-14);
            EXPECT_NEAR(parameter_at(*curve_of_piece({circle, range, false}), point), -wanted, 1e-14);
        }
    }
}

TEST(CurveShapes, feet_on_an_ellipse_are_nearest) {
    const CurveShapePtr ellipse = shape(CurveKind::ellipse, 3, 0.5);
    for (int i = 0; i < 32; ++i) {
        const double t = turn * i / 32;
        double point[3];
        // 0.01 outside, along the normal
        const Vector3 normal =
            unit(std::cos(t) / 3 * ellipse->place.x + std::sin(t) / 0.5 * ellipse->place.y);
        const Vector3 p = point_at(*ellipse, t) + 0.01 * normal;
        point[0] = p.x, point[1] = p.y, point[2] = p.z;
        EXPECT_NEAR(std::remainder(parameter_at(*ellipse, point) - t, turn), 0, 1e-13);
    }
}

TEST(CurveShapes, ranges_near_a_point_contain_what_is_near) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> at(-3, 3), far(0.1, 5);
    for (const auto &[name, curve] : shapes()) {
        SCOPED_TRACE(name);
        for (int k = 0; k < 200; ++k) {
            const Vector3 center = {at(random), at(random), at(random)};
            const double distance = far(random), t = at(random);
            const Interval range = range_near(*curve, center, distance);
            const bool inside = range.lower <= t && t <= range.upper;
            const bool closed = bounded(*curve);
            EXPECT_TRUE(inside || closed || length(point_at(*curve, t) - center) > distance) << t;
        }
    }
}

TEST(CurveShapes, pieces_by_parameters_are_normalized) {
    const CurveShapePtr circle = shapes()[1].second;
    const auto range = [&](double a, double b, bool forward) {
        return piece_between(circle, a, b, forward, 0).range;
    };
    EXPECT_NEAR(range(1, 2, true).upper, 2, 1e-15);
    EXPECT_NEAR(range(2, 1, true).upper, 1 + turn, 1e-15); // over the seam
    EXPECT_NEAR(range(2, 1, false).lower, 1, 1e-15);
    EXPECT_NEAR(range(1, 2, false).lower, 2, 1e-15);
    EXPECT_NEAR(range(-1, 1, true).lower, turn - 1, 1e-15);
    EXPECT_NEAR(range(0, turn, true).upper, turn, 1e-15);
    EXPECT_THROW(range(1, 1, true), Error);
    EXPECT_THROW(range(1, std::numeric_limits<double>::infinity(), true), Error);
    const CurveShapePtr line = shapes()[0].second;
    EXPECT_FALSE(piece_between(line, 2, -1, true, 0).forward);
}

TEST(CurveShapes, composite_curves_map_piece_by_piece) {
    const CurveShapePtr circle = shapes()[1].second;
    const CurvePiece arc = {circle, {0, 2}, true}, rest = {circle, {2, 3}, true};
    const CurveShapePtr both = composite_curve({arc, rest}, 0);
    EXPECT_EQ(natural_range(*both).upper, 3);
    for (const double t : {0.3, 1.1, 2.5, 2.9}) {
        const double s = to_spline_parameter(*both, *both->spline, t);
        expect_near(point_of(*both->spline, s), point_at(*circle, t), 2e-15);
        EXPECT_NEAR(from_spline_parameter(*both, *both->spline, s), t, 1e-15);
    }
}

TEST(CurveShapes, curves_without_ends_have_no_spline) {
    for (const char *name : {"line", "parabola", "hyperbola"}) {
        const auto found =
            std::ranges::find_if(shapes(), [&](const auto &pair) { return std::string(name) == pair.first; });
        EXPECT_FALSE(bounded(*found->second));
        try {
            curve_spline(*found->second);
            ADD_FAILURE() << name;
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), Status::length);
        }
    }
}

TEST(CurveShapes, splines_are_recognized_as_what_they_were_made_of) {
    using namespace nrb::recognize;
    const int32_t kinds[] = {shape_line, shape_circle, shape_ellipse, shape_parabola, shape_hyperbola};
    for (size_t i = 0; i < shapes().size(); ++i) {
        const auto &[name, curve] = shapes()[i];
        SCOPED_TRACE(name);
        const Recognition found = recognize::recognize(*curve_spline(*curve, {-0.5, 2}), 1e-12);
        EXPECT_EQ(found.shape.kind, kinds[i]);
        if (found.shape.kind != shape_line) {
            EXPECT_NEAR(found.shape.sizes[0], curve->sizes[0], 1e-11);
        }
    }
}

} // namespace

} // namespace curve_shapes_test
