// Curves of IGES files against the formulas of the standard.
#include "support/iges_reading.h"
#include "support/spline_checks.h"

#include <cmath>
#include <numbers>

namespace iges_curves_test {

namespace {

using namespace iges_test;
using namespace spline_checks;
using nrb::SplinePtr;
using nrb::Status;
using nrb::Vector3;

constexpr double pi = std::numbers::pi;

// x -> (-y, x, z) + (10, 20, 30), as a curve that has been read and then moved by hand.
constexpr const char *quarter_turn = "0.,-1.,0.,10.,1.,0.,0.,20.,0.,0.,1.,30.";
Vector3 turned(const Vector3 &p) {
    return {10 - p.y, 20 + p.x, 30 + p.z};
}

SplinePtr read_placed(int type, const std::string &data, const char *matrix, const Fields &fields = {}) {
    IgesBuilder builder;
    Fields placed = fields;
    placed.transform = builder.add(124, matrix);
    builder.add(type, data, placed);
    return only_spline(read(builder));
}

std::string text_of(double value) {
    return nrb::Number(value).text;
}

TEST(IgesCurves, line_ends_are_those_of_the_file_to_the_bit) {
    const SplinePtr line = read_one(110, "0.1,0.2,0.3,1.7,-2.9,1e-9");
    EXPECT_EQ(points_of(*line), (std::vector<double>{0.1, 0.2, 0.3, 1.7, -2.9, 1e-9}));
    EXPECT_EQ(knots_of(*line), (std::vector<double>{0, 0, 1, 1}));
}

TEST(IgesCurves, lines_without_ends_are_notes) {
    for (const int64_t form : {1, 2}) {
        const nrb::model::Note note = note_of(110, "0.,0.,0.,1.,0.,0.", {.form = form});
        EXPECT_EQ(note.reason, Status::length) << form;
        EXPECT_NE(note.text.find("no ends"), std::string::npos) << note.text;
    }
    EXPECT_EQ(note_of(110, "0.,0.,0.,1.,0.,0.", {.form = 3}).reason, Status::unsupported);
    EXPECT_EQ(note_of(110, "0.,0.,0.,0.,0.,0.", {.form = 1}).reason, Status::direction);
}

// From 30 degrees counterclockwise to 20: angles and parameters agree in the middle of each arc of the spline.
TEST(IgesCurves, circular_arc) {
    const double a = pi / 6, b = pi / 9;
    const SplinePtr arc =
        read_one(100, "4.,1.,2.," + text_of(1 + 3 * std::cos(a)) + "," + text_of(2 + 3 * std::sin(a)) + "," +
                          text_of(1 + 3 * std::cos(b)) + "," + text_of(2 + 3 * std::sin(b)));
    const nrb::Interval range = arc->axis(0).domain();
    EXPECT_NEAR(range.lower, a, 4e-16);
    EXPECT_NEAR(range.upper, b + 2 * pi, 1e-15);
    for (int i = 0; i <= 8; ++i) {
        const double t = range.lower + (range.upper - range.lower) * i / 8;
        expect_near(point_of(*arc, t), {1 + 3 * std::cos(t), 2 + 3 * std::sin(t), 4}, 1e-14);
    }
    for (int i = 0; i <= 100; ++i) {
        const Vector3 p = point_of(*arc, range.lower + (range.upper - range.lower) * i / 100);
        EXPECT_NEAR(std::hypot(p.x - 1, p.y - 2), 3, 4e-15);
        EXPECT_NEAR(p.z, 4, 4e-15);
    }
}

TEST(IgesCurves, equal_ends_of_an_arc_are_all_of_the_circle) {
    const SplinePtr circle = read_one(100, "0.,0.,0.,0.,-2.,0.,-2.");
    expect_domain(*circle, 0, 1.5 * pi, 1.5 * pi + 2 * pi);
    expect_near(point_of(*circle, 2 * pi), {2, 0, 0});
    EXPECT_EQ(note_of(100, "0.,1.,1.,1.,1.,1.,1.").reason, Status::length);
}

// The same as the arc without its matrix, which is a mirror in the second case and a shear in the third.
TEST(IgesCurves, matrices_turn_mirror_and_shear_arcs) {
    const std::string arc = "1.,1.,0.,3.,0.,1.,2.";
    const SplinePtr plain = read_one(100, arc);
    const struct {
        const char *matrix;
        Vector3 (*image)(const Vector3 &);
    } cases[] = {
        {quarter_turn, turned},
        {"1.,0.,0.,0.,0.,-1.,0.,0.,0.,0.,1.,0.",
         [](const Vector3 &p) {
             return Vector3{p.x, -p.y, p.z};
         }},
        {"1.,2.,0.,5.,0.,1.,0.,0.,0.,0.,1.,0.",
         [](const Vector3 &p) {
             return Vector3{p.x + 2 * p.y + 5, p.y, p.z};
         }},
        {"3.,0.,0.,0.,0.,3.,0.,0.,0.,0.,3.,0.", [](const Vector3 &p) { return 3.0 * p; }},
    };
    for (const auto &[matrix, image] : cases) {
        const SplinePtr placed = read_placed(100, arc, matrix);
        for (int i = 0; i <= 16; ++i) {
            const double t = pi / 2 * i / 16;
            expect_near(point_of(*placed, t), image(point_of(*plain, t)), 2e-14);
        }
    }
}

TEST(IgesCurves, lengths_of_arcs_are_in_the_wanted_unit) {
    IgesBuilder builder;
    builder.global(14, "6");
    builder.add(100, "1.,0.,0.,2.,0.,0.,2.");
    const SplinePtr arc = only_spline(read(builder, {.unit = 0.001}));
    expect_near(point_of(*arc, 0), {2000, 0, 1000}, 1e-12);
    expect_near(point_of(*arc, pi / 2), {0, 2000, 1000}, 1e-12);
}

// x^2 / 9 + y^2 / 4 = 1, a quarter; and with its longer axis along y.
TEST(IgesCurves, ellipse) {
    const SplinePtr ellipse = read_one(104, "4.,0.,9.,0.,0.,-36.,7.,3.,0.,0.,2.", {.form = 1});
    expect_domain(*ellipse, 0, 0, pi / 2);
    for (const double t : {0.0, pi / 4, pi / 2}) {
        expect_near(point_of(*ellipse, t), {3 * std::cos(t), 2 * std::sin(t), 7}, 2e-15);
    }
    const SplinePtr tall = read_one(104, "9.,0.,4.,0.,0.,-36.,0.,2.,0.,2.,0.", {.form = 1});
    expect_domain(*tall, 0, 0, 2 * pi);
    expect_near(point_of(*tall, pi / 2), {0, 3, 0}, 2e-15);
}

// Any three numbers t: points of the equation, ends as stated, at the parameter in the middle the middle of the arc.
void expect_on(const nrb::Spline &spline, const double (&q)[6], double tolerance) {
    const nrb::Interval range = spline.axis(0).domain();
    for (int i = 0; i <= 50; ++i) {
        const Vector3 p = point_of(spline, range.lower + (range.upper - range.lower) * i / 50);
        EXPECT_NEAR(q[0] * p.x * p.x + q[1] * p.x * p.y + q[2] * p.y * p.y + q[3] * p.x + q[4] * p.y + q[5],
                    0, tolerance)
            << i;
    }
}

TEST(IgesCurves, parabola_both_ways) {
    const double q[6] = {1, 0, 0, 0, -4, 0}; // x^2 = 4 y
    for (const bool forward : {true, false}) {
        const SplinePtr arc =
            read_one(104, std::string("1.,0.,0.,0.,-4.,0.,0.,") + (forward ? "-2.,1.,4.,4." : "4.,4.,-2.,1."),
                     {.form = 3});
        EXPECT_EQ(arc->axis(0).degree(), 2);
        EXPECT_FALSE(arc->rational());
        const nrb::Interval range = arc->axis(0).domain();
        expect_near(point_of(*arc, range.lower), forward ? Vector3{-2, 1, 0} : Vector3{4, 4, 0}, 4e-15);
        expect_near(point_of(*arc, range.upper), forward ? Vector3{4, 4, 0} : Vector3{-2, 1, 0}, 4e-15);
        expect_on(*arc, q, 4e-14);
    }
}

// (x + y)^2 / 2 = 4 (y - x) / sqrt 2 with rounded coefficients, whose discriminant is not 0: form 3 says what it is.
TEST(IgesCurves, parabola_across_the_axes) {
    const double r = 1.4142135623; // in ten digits
    const double q[6] = {0.5000000001, 1.0, 0.5, 2 * r, -2 * r, 0};
    std::string data;
    for (const double value : q) {
        data += text_of(value) + ",";
    }
    const SplinePtr arc =
        read_one(104, data + "0.,0.,0.," + text_of(-r * 0.5) + "," + text_of(r * 1.5), {.form = 3});
    EXPECT_EQ(arc->axis(0).degree(), 2);
    expect_on(*arc, q, 1e-8);
}

// x^2 / 4 - y^2 = 1: the branch of the start counts.
TEST(IgesCurves, hyperbola) {
    const double q[6] = {0.25, 0, -1, 0, 0, -1};
    for (const double side : {1.0, -1.0}) {
        const double x = side * 2 * std::cosh(1.0), y = std::sinh(1.0);
        const SplinePtr arc = read_one(104,
                                       "0.25,0.,-1.,0.,0.,-1.,0.," + text_of(x) + "," + text_of(-y) + "," +
                                           text_of(x) + "," + text_of(y),
                                       {.form = 2});
        const nrb::Interval range = arc->axis(0).domain();
        expect_near(point_of(*arc, range.lower), {x, -y, 0}, 4e-15);
        expect_near(point_of(*arc, range.upper), {x, y, 0}, 4e-15);
        expect_near(point_of(*arc, (range.lower + range.upper) / 2), {side * 2, 0, 0}, 4e-15);
        expect_on(*arc, q, 1e-14);
    }
}

TEST(IgesCurves, equations_of_lines_and_points_are_no_conics) {
    EXPECT_EQ(note_of(104, "1.,0.,-1.,0.,0.,0.,0.,1.,1.,2.,2.").reason, Status::conic);
    EXPECT_EQ(note_of(104, "0.,0.,0.,1.,1.,0.,0.,1.,-1.,2.,-2.").reason, Status::conic);
    EXPECT_EQ(note_of(104, "1.,0.,0.,0.,-4.,0.,0.,2.,1.,2.,1.", {.form = 3}).reason, Status::empty_domain);
}

TEST(IgesCurves, polygons) {
    const SplinePtr flat = read_one(106, "1,3,5.,0.,0.,1.,0.,1.,2.", {.form = 11});
    EXPECT_EQ(points_of(*flat), (std::vector<double>{0, 0, 5, 1, 0, 5, 1, 2, 5}));
    EXPECT_EQ(knots_of(*flat), (std::vector<double>{0, 0, 1, 2, 2}));
    EXPECT_EQ(points_of(*read_one(106, "2,2,1.,2.,3.,4.,5.,6.", {.form = 12})),
              (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(points_of(*read_one(106, "3,2,1.,2.,3.,9.,9.,9.,4.,5.,6.,9.,9.,9.", {.form = 13})),
              (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(read_one(106, "1,4,0.,0.,0.,1.,0.,1.,1.,0.,0.", {.form = 63})->point_count(), 4);
}

TEST(IgesCurves, polygons_that_are_none) {
    EXPECT_EQ(note_of(106, "2,2,1.,2.,3.,4.,5.,6.", {.form = 2}).reason, Status::unsupported);
    EXPECT_EQ(note_of(106, "1,2,0.,1.,2.,3.,4.", {.form = 40}).reason, Status::unsupported);
    EXPECT_EQ(note_of(106, "4,2,1.,2.,3.,4.,5.,6.", {.form = 12}).reason, Status::syntax);
    EXPECT_EQ(note_of(106, "2,1,1.,2.,3.", {.form = 12}).reason, Status::too_few_points);
    EXPECT_EQ(note_of(106, "2,9,1.,2.,3.,4.,5.,6.", {.form = 12}).reason, Status::count);
    EXPECT_EQ(note_of(106, "2,9223372036854775807,1.,2.,3.", {.form = 12}).reason, Status::overflow);
}

// A line, a half circle and a line, one after the other: one spline, and not its parts again.
TEST(IgesCurves, composite) {
    IgesBuilder builder;
    builder.add(110, "-2.,-1.,0.,0.,-1.,0.");
    builder.add(100, "0.,0.,0.,0.,-1.,0.,1.");
    builder.add(110, "0.,1.,0.,-2.,1.,0.");
    builder.add(116, "0.,1.,0.");
    builder.add(102, "4,1,3,7,5", {.label = "HOOK"});
    const nrb::model::Model document = read(builder);
    const SplinePtr hook = only_spline(document);
    EXPECT_EQ(document.splines[0].name, "HOOK");
    EXPECT_TRUE(document.notes.empty());
    expect_domain(*hook, 0, 0, 2 + pi);
    expect_near(point_of(*hook, 0.5), {-1, -1, 0});
    expect_near(point_of(*hook, 1 + pi / 2), {1, 0, 0});
    expect_near(point_of(*hook, 1.75 + pi), {-1.5, 1, 0});
}

TEST(IgesCurves, composite_moves_its_parts) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,0.,0.", {.transform = builder.next() + 2});
    builder.add(124, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,7."); // first by the line's own matrix
    builder.add(102, "1,1", {.transform = builder.next() + 2});
    builder.add(124, quarter_turn);
    const SplinePtr curve = only_spline(read(builder));
    expect_near(point_of(*curve, 0), turned({0, 0, 7}), 0);
    expect_near(point_of(*curve, 1), turned({1, 0, 7}), 0);
}

TEST(IgesCurves, b_splines_in_composites_are_listed_as_before) {
    IgesBuilder builder;
    builder.add(102, "2,3,5");
    builder.add(126, line_126);
    builder.add(110, "4.,6.,8.,5.,6.,8.");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    EXPECT_EQ(document.splines[0].name, "126#3"); // B-splines come first
    EXPECT_EQ(document.splines[1].name, "102#1");
}

// What a composite that cannot be read consists of is not lost.
TEST(IgesCurves, parts_of_a_bad_composite) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,0.,0.");
    builder.add(110, "2.,0.,0.,3.,0.,0.");
    builder.add(102, "2,1,3");
    const nrb::model::Model document = read(builder);
    EXPECT_EQ(document.splines.size(), 2U);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_EQ(document.notes[0].reason, Status::gap);
    EXPECT_EQ(document.notes[0].line, 5);
}

// s^3 along x, and a jump of nothing: two pieces of one cubic polynomial need no knot between them.
TEST(IgesCurves, parametric_spline) {
    // x = u, y = u^2, z = u^3 on [0, 1] and [1, 3]
    const std::string pieces = "0.,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,"
                               "1.,1.,0.,0.,1.,2.,1.,0.,1.,3.,3.,1.,";
    const SplinePtr curve = read_one(112, "3,2,3,2,0.,1.,3.," + pieces + "0,0,0,0,0,0,0,0,0,0,0,0");
    EXPECT_EQ(curve->axis(0).degree(), 3);
    EXPECT_EQ(curve->point_count(), 4);
    for (int i = 0; i <= 12; ++i) {
        const double u = i * 0.25;
        expect_near(point_of(*curve, u), {u, u * u, u * u * u}, 1e-14);
    }
}

// Straight pieces with a corner at 1, and a gap at 2.
TEST(IgesCurves, parametric_spline_keeps_corners_and_gaps) {
    const std::string pieces = "0.,1.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,"
                               "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,0.,0.,"
                               "5.,0.,0.,0.,1.,1.,0.,0.,0.,0.,0.,0.,";
    const SplinePtr curve = read_one(112, "1,0,2,3,0.,1.,2.,3.," + pieces + "0,0,0,0,0,0,0,0,0,0,0,0");
    EXPECT_EQ(curve->axis(0).degree(), 1);
    EXPECT_EQ(points_of(*curve), (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 5, 1, 0, 5, 2, 0}));
    EXPECT_EQ(knots_of(*curve), (std::vector<double>{0, 0, 1, 2, 2, 3, 3}));
}

TEST(IgesCurves, wrong_counts_of_parametric_splines) {
    EXPECT_EQ(note_of(112, "3,2,3,0,0.,1.").reason, Status::count);
    EXPECT_EQ(note_of(112, "3,2,3,1000,0.,1.").reason, Status::count);
    EXPECT_EQ(note_of(112, "3,2,3,1,0.,1.,1.,2.").reason, Status::syntax);
    EXPECT_EQ(note_of(112, "3,2,3,1,1.,1.,0,1,0,0,0,0,0,0,0,0,0,0").reason, Status::knots_decreasing);
}

TEST(IgesCurves, in_the_parameter_plane) {
    IgesBuilder builder;
    builder.global(14, "6");
    builder.add(100, "9.,0.,0.,2.,0.,0.,2.", {.status = "00000500"});
    builder.add(142, "0,99,5,0,1");
    builder.add(102, "1,7");
    builder.add(110, "1.,2.,9.,3.,4.,9.");
    const nrb::model::Model document = read(builder, {.unit = 0.001});
    ASSERT_EQ(document.splines.size(), 2U);
    EXPECT_EQ(document.splines[0].spline->dim(), 2);
    expect_near(point_of(*document.splines[0].spline, pi / 2), {0, 2, 0});
    EXPECT_EQ(points_of(*document.splines[1].spline), (std::vector<double>{1, 2, 3, 4}));
}

} // namespace

} // namespace iges_curves_test
