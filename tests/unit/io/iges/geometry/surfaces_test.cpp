// Surfaces of IGES files against the formulas of the standard.
#include "support/iges_reading.h"
#include "support/spline_checks.h"

#include <cmath>
#include <numbers>

namespace iges_surfaces_test {

namespace {

using namespace iges_test;
using namespace spline_checks;
using nrb::Interval;
using nrb::SplinePtr;
using nrb::Status;
using nrb::Vector3;

constexpr double pi = std::numbers::pi;
constexpr const char *quarter_turn = "0.,-1.,0.,10.,1.,0.,0.,20.,0.,0.,1.,30.";
constexpr const char *mirror = "1.,0.,0.,0.,0.,-1.,0.,0.,0.,0.,1.,0.";
constexpr const char *shear = "1.,2.,0.,5.,0.,1.,0.,0.,0.,0.,1.,0.";

Vector3 turned(const Vector3 &p) {
    return {10 - p.y, 20 + p.x, 30 + p.z};
}

// The last entity of a file, which has the label "LAST".
nrb::model::Model read_last(IgesBuilder &builder, int type, const std::string &data, Fields fields = {}) {
    fields.label = "LAST";
    builder.add(type, data, fields);
    return read(builder);
}

nrb::model::Note only_note(const nrb::model::Model &document) {
    EXPECT_EQ(document.notes.size(), 1U);
    return document.notes.empty() ? nrb::model::Note{0, 0, Status::ok, ""} : document.notes.front();
}

// A line from (2, 0, 0) to (2, 0, 3) turned about the z axis from 30 to 210 degrees: angle first, then the profile.
IgesBuilder with_profile(const std::string &profile = "2.,0.,0.,2.,0.,3.") {
    IgesBuilder builder;
    builder.add(110, "0.,0.,-1.,0.,0.,5."); // 1: axis
    builder.add(110, profile);              // 3
    return builder;
}

TEST(IgesSurfaces, revolution) {
    IgesBuilder builder = with_profile();
    const SplinePtr surface = only_spline(read_last(builder, 120,
                                                    "1,3," + std::string(nrb::Number(pi / 6).text) + "," +
                                                        std::string(nrb::Number(7 * pi / 6).text)));
    expect_domain(*surface, 0, pi / 6, 7 * pi / 6);
    expect_domain(*surface, 1, 0, 1);
    for (int i = 0; i <= 4; ++i) { // the middle and the ends of two arcs
        const double u = pi / 6 + pi * i / 4;
        for (const double v : {0.0, 0.25, 1.0}) {
            expect_near(point_of(*surface, u, v), {2 * std::cos(u), 2 * std::sin(u), 3 * v}, 1e-14);
        }
    }
}

TEST(IgesSurfaces, revolution_all_around) {
    IgesBuilder builder = with_profile();
    // as many digits as files have
    const SplinePtr surface = only_spline(read_last(builder, 120, "1,3,0.,6.283185307"));
    expect_domain(*surface, 0, 0, 2 * pi);
    expect_near(point_of(*surface, 2 * pi, 1), {2, 0, 3});
}

// A mirror of space turns the other way around.
TEST(IgesSurfaces, matrices_turn_and_mirror_surfaces_of_revolution) {
    for (const bool mirrored : {false, true}) {
        IgesBuilder builder = with_profile();
        const int64_t matrix = builder.add(124, mirrored ? mirror : quarter_turn);
        const SplinePtr surface =
            only_spline(read_last(builder, 120, "1,3,0.,1.5707963267948966", {.transform = matrix}));
        for (const double u : {0.0, pi / 4, pi / 2}) {
            const Vector3 p = {2 * std::cos(u), 2 * std::sin(u), 1.5};
            expect_near(point_of(*surface, u, 0.5), mirrored ? Vector3{p.x, -p.y, p.z} : turned(p));
        }
    }
    IgesBuilder builder = with_profile();
    const int64_t matrix = builder.add(124, shear);
    const nrb::model::Model document = read_last(builder, 120, "1,3,0.,1.", {.transform = matrix});
    EXPECT_EQ(document.splines.size(), 2U); // what it would have been made of
    EXPECT_NE(only_note(document).text.find("not a rotation"), std::string::npos);
}

TEST(IgesSurfaces, bad_surfaces_of_revolution) {
    const struct {
        const char *data;
        Status reason;
        const char *words;
    } cases[] = {
        {"1,3,0.,0.", Status::angle, "from 0 to 0"},
        {"1,3,1.,0.", Status::angle, "from 1 to 0"},
        {"1,3,0.,7.", Status::angle, "from 0 to 7"},
        {"1,1000001,0.,1.", Status::syntax, "generatrix: the directory has no entity at line 1000001"},
        {"99,3,0.,1.", Status::syntax, "axis: the directory has no entity at line 99"},
        {"5,3,0.,1.", Status::syntax, "names itself"},
        {"1,5,0.,1.", Status::syntax, "generatrix: directory line 5 is a surface of revolution (120)"},
    };
    for (const auto &[data, reason, words] : cases) {
        IgesBuilder builder = with_profile();
        const nrb::model::Note note = only_note(read_last(builder, 120, data));
        EXPECT_EQ(note.reason, reason) << data;
        EXPECT_NE(note.text.find(words), std::string::npos) << note.text;
        EXPECT_EQ(note.text.rfind("surface of revolution (120) at directory line 5: ", 0), 0U) << note.text;
    }
}

// An arc moved along a line that is not across it.
TEST(IgesSurfaces, tabulated_cylinder) {
    IgesBuilder builder;
    builder.add(100, "0.,0.,0.,2.,0.,0.,2.");
    const SplinePtr surface = only_spline(read_last(builder, 122, "1,3.,1.,5."));
    expect_domain(*surface, 0, 0, pi / 2);
    expect_domain(*surface, 1, 0, 1);
    for (const double u : {0.0, pi / 4, pi / 2}) {
        for (const double v : {0.0, 0.25, 1.0}) {
            expect_near(point_of(*surface, u, v), {2 * std::cos(u) + v, 2 * std::sin(u) + v, 5 * v}, 2e-15);
        }
    }
}

TEST(IgesSurfaces, tabulated_cylinders_can_be_sheared) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,0.,0.");
    const int64_t matrix = builder.add(124, shear);
    const SplinePtr surface = only_spline(read_last(builder, 122, "1,0.,1.,0.", {.transform = matrix}));
    expect_near(point_of(*surface, 0, 0), {5, 0, 0}, 0);
    expect_near(point_of(*surface, 1, 0), {6, 0, 0}, 0);
    expect_near(point_of(*surface, 0, 1), {7, 1, 0}, 0);
}

TEST(IgesSurfaces, bad_tabulated_cylinders) {
    IgesBuilder flat;
    flat.add(110, "0.,0.,0.,1.,0.,0.");
    EXPECT_EQ(only_note(read_last(flat, 122, "1,0.,0.,0.")).reason, Status::length);
    IgesBuilder endless;
    endless.add(110, "0.,0.,0.,1.,0.,0.", {.form = 2});
    EXPECT_EQ(read_last(endless, 122, "1,0.,1.,0.").notes.back().text,
              "tabulated cylinder (122) at directory line 3: the directrix has no ends");
}

// Lines across each other: x y = z over the square, with the second rail in either direction.
TEST(IgesSurfaces, ruled_between_lines) {
    for (const bool reversed : {false, true}) {
        for (const int64_t form : {0, 1}) {
            IgesBuilder builder;
            builder.add(110, "0.,0.,0.,1.,0.,0.");
            builder.add(110, reversed ? "1.,1.,1.,0.,1.,0." : "0.,1.,0.,1.,1.,1.");
            const SplinePtr surface = only_spline(
                read_last(builder, 118, std::string("1,3,") + (reversed ? "1,0" : "0,0"), {.form = form}));
            for (const double u : {0.0, 0.3, 1.0}) {
                for (const double v : {0.0, 0.6, 1.0}) {
                    expect_near(point_of(*surface, u, v), {u, v, u * v}, 2e-16);
                }
            }
        }
    }
}

// A circle and a smaller one above it: (1 - v) C1 + v C2 where parameters and angles agree, without a note.
TEST(IgesSurfaces, ruled_between_circles) {
    for (const int64_t form : {0, 1}) {
        IgesBuilder builder;
        builder.add(100, "0.,0.,0.,2.,0.,2.,0.");
        builder.add(100, "3.,0.,0.,1.,0.,1.,0.");
        const SplinePtr cone = only_spline(read_last(builder, 118, "1,3,0,1", {.form = form}));
        for (int i = 0; i <= 8; ++i) {
            const double t = 2 * pi * i / 8;
            expect_near(point_of(*cone, i / 8.0, 0.25), {1.75 * std::cos(t), 1.75 * std::sin(t), 0.75},
                        4e-15);
        }
    }
}

TEST(IgesSurfaces, ruled_to_a_point) {
    IgesBuilder builder;
    builder.add(116, "0.,0.,1.,0");
    builder.add(110, "0.,0.,0.,2.,0.,0.");
    const SplinePtr triangle = only_spline(read_last(builder, 118, "1,3,0,1"));
    expect_near(point_of(*triangle, 0.5, 0.5), {0.5, 0, 0.5}, 0);
}

// Rulings between points of equal arc length, or of equal angles, are told where the spline has others.
TEST(IgesSurfaces, rulings_that_differ_are_told) {
    for (const int64_t form : {0, 1}) {
        IgesBuilder builder;
        builder.add(100, "0.,0.,0.,1.,0.,0.,1.");
        builder.add(110, "1.,0.,1.,0.,1.,1.");
        const nrb::model::Model document = read_last(builder, 118, "1,3,0,0", {.form = form});
        ASSERT_EQ(document.splines.size(), 1U);
        const nrb::model::Note note = only_note(document);
        EXPECT_EQ(note.line, 5);
        EXPECT_NE(note.text.find(form == 0 ? "equal arc length" : "equal angles"), std::string::npos)
            << note.text;
    }
}

// x = s, y = t, z = s t + s^2 on two patches along each axis: one polynomial, without inner knots.
TEST(IgesSurfaces, parametric_spline_surface) {
    const auto patch = [](double u, double v) {
        std::string text;
        const double x[16] = {u, 1}, y[16] = {v, 0, 0, 0, 1};
        const double z[16] = {u * v + u * u, v + 2 * u, 1, 0, u, 1};
        for (const double *coefficients : {x, y, z}) {
            for (int i = 0; i < 16; ++i) {
                text += std::string(nrb::Number(coefficients[i]).text) + ",";
            }
        }
        return text;
    };
    std::string arbitrary;
    for (int i = 0; i < 48; ++i) {
        arbitrary += "9.,";
    }
    const std::string row = patch(0, 0) + patch(0, 1) + arbitrary,
                      next = patch(2, 0) + patch(2, 1) + arbitrary;
    const SplinePtr surface =
        read_one(114, "3,1,2,2,0.,2.,3.,0.,1.,3.," + row + next + arbitrary + arbitrary + arbitrary + "0");
    EXPECT_EQ(surface->axis(0).degree(), 2);
    EXPECT_EQ(surface->axis(1).degree(), 1);
    EXPECT_EQ(surface->point_count(), 6);
    for (const double u : {0.0, 0.75, 2.5, 3.0}) {
        for (const double v : {0.0, 0.25, 1.75, 3.0}) {
            expect_near(point_of(*surface, u, v), {u, v, u * v + u * u}, 1e-14);
        }
    }
    // what comes after the last patch may be left out
    EXPECT_EQ(read_one(114, "3,1,1,1,0.,1.,0.,1.," + patch(0, 0) + "0")->point_count(), 6);
    EXPECT_EQ(note_of(114, "3,1,2,2,0.,2.,3.,0.,1.,3.," + row + patch(2, 0) + "0").reason, Status::syntax);
    EXPECT_EQ(note_of(114, "3,1,3000000000,3000000000,0.,2.").reason, Status::count);
}

TEST(IgesSurfaces, plane_is_cut_to_its_boundary_with_a_margin) {
    IgesBuilder builder;
    builder.add(106, "1,5,3.,1.,1.,5.,1.,5.,3.,1.,3.,1.,1.", {.form = 63});
    const nrb::model::Model document = read_last(builder, 108, "0.,0.,2.,6.,1,0.,0.,0.,0.", {.form = 1});
    ASSERT_EQ(document.splines.size(), 2U);
    const SplinePtr plane = document.splines[1].spline;
    EXPECT_EQ(plane->axes(), 2);
    double lower[2] = {9, 9}, upper[2] = {-9, -9};
    for (int64_t i = 0; i < 4; ++i) {
        EXPECT_EQ(plane->coordinate(i, 2), 3);
        for (int c = 0; c < 2; ++c) {
            lower[c] = std::min(lower[c], plane->coordinate(i, c));
            upper[c] = std::max(upper[c], plane->coordinate(i, c));
        }
    }
    EXPECT_EQ(lower[0], 1 - 4.0 / 64);
    EXPECT_EQ(upper[0], 5 + 4.0 / 64);
    EXPECT_LE(lower[1], 1);
    EXPECT_GE(upper[1], 3);
}

TEST(IgesSurfaces, planes_without_ends_are_notes) {
    EXPECT_EQ(note_of(108, "0.,0.,1.,2.,0,0.,0.,0.,0.").reason, Status::length);
    EXPECT_EQ(note_of(108, "0.,0.,0.,2.,0,0.,0.,0.,0.").reason, Status::direction);
    IgesBuilder hole;
    hole.add(106, "1,4,0.,0.,0.,1.,0.,1.,1.,0.,0.", {.form = 63});
    EXPECT_EQ(only_note(read_last(hole, 108, "0.,0.,1.,0.,1,0.,0.,0.,0.", {.form = -1})).reason,
              Status::length);
}

// A location (1), an axis (3) and a reference direction (5) across: the frame (0, 1, 0), (0, 0, 1), (1, 0, 0) at (1, 2, 3).
IgesBuilder with_frame() {
    IgesBuilder builder;
    builder.add(116, "1.,2.,3.,0");
    builder.add(123, "2.,0.,0.");
    builder.add(123, "0.,1.,0.");
    return builder;
}
Vector3 placed(double x, double y, double z) {
    return {1 + z, 2 + x, 3 + y};
}

TEST(IgesSurfaces, sphere) {
    IgesBuilder builder = with_frame();
    const nrb::model::Model document = read_last(builder, 196, "1,2.,3,5", {.form = 1});
    const SplinePtr sphere = only_spline(document);
    EXPECT_TRUE(document.notes.empty()); // the point and the directions are part of it
    for (int i = 0; i <= 8; ++i) {
        for (int j = -2; j <= 2; ++j) {
            const double u = pi * i / 4, v = pi * j / 4;
            expect_near(point_of(*sphere, u, v), placed(2 * std::cos(v) * std::cos(u),
                                                        2 * std::cos(v) * std::sin(u), 2 * std::sin(v)));
        }
    }
}

TEST(IgesSurfaces, sphere_without_an_orientation) {
    IgesBuilder builder;
    builder.add(116, "1.,2.,3.,0");
    const SplinePtr sphere = only_spline(read_last(builder, 196, "1,2."));
    for (const double u : {0.1, 3.0}) {
        for (const double v : {-1.0, 0.5}) {
            EXPECT_NEAR(nrb::length(point_of(*sphere, u, v) - Vector3{1, 2, 3}), 2, 4e-15);
        }
    }
}

TEST(IgesSurfaces, torus) {
    IgesBuilder builder = with_frame();
    const SplinePtr torus = only_spline(read_last(builder, 198, "1,3,5.,2.,5", {.form = 1}));
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const double u = pi * i / 4, v = pi * j / 4, r = 5 + 2 * std::cos(v);
            expect_near(point_of(*torus, u, v), placed(r * std::cos(u), r * std::sin(u), 2 * std::sin(v)),
                        2e-14);
        }
    }
}

TEST(IgesSurfaces, elementary_surfaces_without_ends_are_notes) {
    const struct {
        int type;
        const char *data;
    } cases[] = {{190, "1,3,5"}, {192, "1,3,2.,5"}, {194, "1,3,2.,30.,5"}};
    for (const auto &[type, data] : cases) {
        IgesBuilder builder = with_frame();
        const nrb::model::Model document = read_last(builder, type, data, {.form = 1});
        EXPECT_TRUE(document.splines.empty());
        EXPECT_EQ(document.notes.back().reason, Status::length) << type;
    }
}

TEST(IgesSurfaces, bad_elementary_surfaces) {
    const struct {
        int type;
        const char *data;
        Status reason;
        const char *words;
    } cases[] = {
        {196, "1,0.,3,5", Status::length, "radius = 0"},
        {198, "1,3,-5.,2.,5", Status::length, "major radius = -5"},
        {194, "1,3,2.,90.,5", Status::angle, "semi-angle = 90 degrees"},
        {194, "1,3,-2.,9.,5", Status::length, "radius = -2"},
        {192, "3,3,2.,5", Status::syntax,
         "direction (123) at directory line 3: where a point (116) was expected"},
        {192, "1,1,2.,5", Status::syntax,
         "point (116) at directory line 1: where a direction (123) was expected"},
        {192, "1,3,2.,3", Status::direction, "parallel"},
        {190, "1,0,5", Status::syntax, "axis: the directory has no entity at line 0"},
    };
    for (const auto &[type, data, reason, words] : cases) {
        IgesBuilder builder = with_frame();
        const nrb::model::Note note = read_last(builder, type, data, {.form = 1}).notes.back();
        EXPECT_EQ(note.reason, reason) << type << " " << note.text;
        EXPECT_NE(note.text.find(words), std::string::npos) << note.text;
    }
}

TEST(IgesSurfaces, offset_surfaces_take_the_place_of_their_basis) {
    IgesBuilder builder = with_profile();
    builder.add(120, "1,3,0.,1.");
    const nrb::model::Model document = read_last(builder, 140, "1.,0.,0.,0.5,5");
    ASSERT_EQ(document.splines.size(), 1U);
    EXPECT_EQ(document.splines[0].name, "LAST");
    EXPECT_EQ(only_note(document).reason, Status::tolerance);
    EXPECT_EQ(only_note(document).line, 7);
}

} // namespace

} // namespace iges_surfaces_test
