// Surfaces of STEP files against the shapes that they state.
#include "support/step_reading.h"

#include <cmath>
#include <functional>

namespace step_surfaces_test {

namespace {

using namespace step_test;
using nrb::Interval;
using nrb::Spline;
using nrb::SplinePtr;
using nrb::Status;
using nrb::Vector3;

// In the frame of StepBuilder::some_placement().
Vector3 placed(double x, double y, double z) {
    return {1 + z, 2 + x, 3 + y};
}

// The surface of a face whose only edge is straight and has these ends in that frame.
SplinePtr cut_at(StepBuilder &builder, const std::string &surface, const std::string &start,
                 const std::string &end, const std::string &way) {
    const std::string edge = builder.straight_edge(start, end, way);
    builder.face(surface, {edge});
    const nrb::model::Model document = read(builder);
    EXPECT_TRUE(document.notes.empty());
    EXPECT_EQ(document.splines.size(), 2U); // the face, then its edge
    return document.splines.at(0).spline;
}

// At the eighths of a turn parameters and angles agree, by symmetry.
void expect_at_eighths(const Spline &surface, bool round_v,
                       const std::function<Vector3(double, double)> &expected) {
    const Interval v = surface.axis(1).domain();
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const double u = pi * i / 4,
                         w = round_v ? pi * (j - 2) / 4 : v.lower + (v.upper - v.lower) * j / 8;
            if (w >= v.lower && w <= v.upper) {
                expect_near(point_of(surface, u, w), expected(u, w), 2e-14);
            }
        }
    }
}

TEST(StepSurfaces, plane_is_cut_to_its_boundary_with_a_margin) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    // from x = 0, y = 0 to x = 4, y = 0 in the frame
    const SplinePtr surface = cut_at(builder, plane, "1.,2.,3.", "1.,6.,3.", "0.,1.,0.");
    expect_domain(*surface, 0, -0.0625, 4.0625);
    expect_domain(*surface, 1, -0.0625, 0.0625);
    for (const double u : {-0.0625, 1.5, 4.0625}) {
        for (const double v : {-0.0625, 0.0, 0.0625}) {
            expect_near(point_of(*surface, u, v), placed(u, v, 0), 1e-15);
        }
    }
}

TEST(StepSurfaces, cylinder_is_cut_along_its_axis) {
    StepBuilder builder;
    const std::string cylinder = builder.add("CYLINDRICAL_SURFACE(''," + builder.some_placement() + ",2.)");
    const SplinePtr surface =
        cut_at(builder, cylinder, "5.,4.,3.", "9.,4.,3.", "1.,0.,0."); // from z = 4 to 8
    expect_domain(*surface, 0, 0, 2 * pi);
    expect_domain(*surface, 1, 4 - 0.0625, 8 + 0.0625);
    expect_at_eighths(*surface, false,
                      [](double u, double v) { return placed(2 * std::cos(u), 2 * std::sin(u), v); });
}

TEST(StepSurfaces, cone_ends_at_its_apex) {
    StepBuilder builder;
    const std::string cone = builder.add("CONICAL_SURFACE(''," + builder.some_placement() +
                                         ",2.,0.785398163397448)"); // apex at z = -2
    const SplinePtr surface =
        cut_at(builder, cone, "-1.,2.,3.", "3.,6.,3.", "1.,1.,0."); // from there to z = 2
    const double apex = surface->axis(1).domain().lower;
    EXPECT_NEAR(apex, -2, 1e-13);
    EXPECT_NEAR(surface->axis(1).domain().upper, 2.0625, 1e-15);
    expect_at_eighths(*surface, false, [](double u, double v) {
        return placed((2 + v) * std::cos(u), (2 + v) * std::sin(u), v);
    });
    for (int64_t i = 0; i < surface->count(0); ++i) { // one point to the bit
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(surface->coordinate(2 * i, c), surface->coordinate(0, c));
        }
    }
}

TEST(StepSurfaces, sphere_and_torus_need_no_boundary) {
    StepBuilder builder;
    const std::string at = builder.some_placement();
    builder.add("SPHERICAL_SURFACE('ball'," + at + ",2.)");
    builder.add("TOROIDAL_SURFACE('ring'," + at + ",3.,1.)");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    const Spline &sphere = *document.splines[0].spline, &torus = *document.splines[1].spline;
    expect_domain(sphere, 1, -pi / 2, pi / 2);
    expect_domain(torus, 1, 0, 2 * pi);
    expect_at_eighths(sphere, true, [](double u, double v) {
        return placed(2 * std::cos(v) * std::cos(u), 2 * std::cos(v) * std::sin(u), 2 * std::sin(v));
    });
    expect_at_eighths(torus, true, [](double u, double v) {
        const double r = 3 + std::cos(v);
        return placed(r * std::cos(u), r * std::sin(u), std::sin(v));
    });
}

TEST(StepSurfaces, degenerate_torus_is_the_apple_or_the_lemon) {
    const auto torus = [](const std::string &outer) {
        StepBuilder builder;
        builder.add("DEGENERATE_TOROIDAL_SURFACE(''," + builder.some_placement() + ",1.,2.," + outer + ")");
        return only_spline(builder);
    };
    const double meets = 2 * pi / 3; // cos = -1 / 2
    const SplinePtr apple = torus(".T."), lemon = torus(".F.");
    EXPECT_NEAR(apple->axis(1).domain().lower, -meets, 1e-15);
    EXPECT_NEAR(apple->axis(1).domain().upper, meets, 1e-15);
    EXPECT_NEAR(lemon->axis(1).domain().lower, meets, 1e-15);
    EXPECT_NEAR(lemon->axis(1).domain().upper, 4 * pi / 3, 1e-15);
    expect_near(point_of(*apple, 0, 0), placed(3, 0, 0), 1e-15);
    expect_near(point_of(*lemon, 0, pi), placed(-1, 0, 0), 1e-15);
    expect_near(point_of(*apple, 1, apple->axis(1).domain().upper), placed(0, 0, std::sqrt(3.0)), 2e-15);
    StepBuilder builder;
    builder.add("DEGENERATE_TOROIDAL_SURFACE(''," + builder.some_placement() + ",2.,1.,.T.)");
    EXPECT_EQ(only_note(builder).reason, Status::length);
}

std::string axis1(StepBuilder &builder) {
    const std::string origin = builder.point("0.,0.,0."), way = builder.direction("0.,0.,2.");
    return builder.add("AXIS1_PLACEMENT(''," + origin + "," + way + ")");
}

TEST(StepSurfaces, revolution_turns_its_curve) {
    StepBuilder builder;
    const std::string points = builder.point("1.,0.,0.") + "," + builder.point("3.,0.,1.");
    const std::string profile = builder.add("POLYLINE('',(" + points + "))");
    builder.add("SURFACE_OF_REVOLUTION('vase'," + profile + "," + axis1(builder) + ")");
    const SplinePtr surface = only_spline(builder);
    expect_domain(*surface, 0, 0, 2 * pi);
    expect_domain(*surface, 1, 0, 1);
    expect_at_eighths(*surface, false, [](double u, double v) {
        return Vector3{(1 + 2 * v) * std::cos(u), (1 + 2 * v) * std::sin(u), v};
    });
}

// A line along the axis, across it, and one that meets it.
TEST(StepSurfaces, revolved_lines_are_cut_to_the_boundary) {
    const auto range = [](const std::string &start, const std::string &way, const std::string &from,
                          const std::string &to, const std::string &along) {
        StepBuilder builder;
        const std::string at = builder.point(start), vector = builder.vector(way, "2.");
        const std::string line = builder.add("LINE(''," + at + "," + vector + ")");
        const std::string surface =
            builder.add("SURFACE_OF_REVOLUTION(''," + line + "," + axis1(builder) + ")");
        return cut_at(builder, surface, from, to, along)->axis(1).domain();
    };
    const Interval cylinder = range("1.,0.,10.", "0.,0.,1.", "0.,1.,4.", "0.,1.,8.", "0.,0.,1.");
    EXPECT_EQ(cylinder.lower, -3 - 0.03125);
    EXPECT_EQ(cylinder.upper, -1 + 0.03125);
    const Interval disc = range("1.,0.,10.", "1.,0.,0.", "0.,3.,10.", "0.,7.,10.", "0.,1.,0.");
    EXPECT_EQ(disc.lower, 1 - 0.03125);
    EXPECT_EQ(disc.upper, 3 + 0.03125);
    const Interval cone =
        range("1.,0.,1.", "1.,0.,1.", "0.,0.,0.", "0.,4.,4.", "0.,1.,1."); // from the apex on
    EXPECT_NEAR(cone.lower, -std::sqrt(0.5), 1e-15);
    EXPECT_GT(cone.upper, 3 * std::sqrt(0.5));
}

TEST(StepSurfaces, extrusion_moves_its_curve) {
    StepBuilder builder;
    const std::string points = builder.point("1.,0.,0.") + "," + builder.point("3.,0.,1.");
    const std::string profile = builder.add("POLYLINE('',(" + points + "))"),
                      way = builder.vector("0.,1.,0.", "2.");
    const std::string surface = builder.add("SURFACE_OF_LINEAR_EXTRUSION(''," + profile + "," + way + ")");
    const SplinePtr spline = cut_at(builder, surface, "1.,4.,0.", "1.,8.,0.", "0.,1.,0.");
    expect_domain(*spline, 0, 0, 1);
    expect_domain(*spline, 1, 2 - 0.03125, 4 + 0.03125); // the margin of 1/64 of a size of 4, in steps of 2
    expect_near(point_of(*spline, 0.5, 3), {2, 6, 0.5}, 1e-15);
}

// Every point of the boundary is on the part that is cut.
TEST(StepSurfaces, extruded_conics_and_lines_reach_their_boundary) {
    const std::pair<const char *, Vector3> cases[] = {
        {"LINE", {0, 0, 0}}, {"CIRCLE", {0, 0, 0}}, {"PARABOLA", {0, 0, 0}}, {"HYPERBOLA", {0, 0, 0}}};
    for (const auto &[kind, unused] : cases) {
        SCOPED_TRACE(kind);
        StepBuilder builder;
        const std::string frame = builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.");
        const std::string origin = builder.point("2.,0.,0."), along = builder.vector("0.,1.,0.", "3.");
        const std::string curve =
            std::string(kind) == "LINE"        ? builder.add("LINE(''," + origin + "," + along + ")")
            : std::string(kind) == "HYPERBOLA" ? builder.add("HYPERBOLA(''," + frame + ",2.,1.)")
                                               : builder.add(std::string(kind) + "(''," + frame + ",2.)");
        const std::string way = builder.vector("1.,0.,1.", "1.");
        const std::string surface = builder.add("SURFACE_OF_LINEAR_EXTRUSION(''," + curve + "," + way + ")");
        // a straight edge along the way from the point (2, 0, 0), or (0, 0, 0) on the parabola
        const bool parabola = std::string(kind) == "PARABOLA";
        const SplinePtr spline = parabola ? cut_at(builder, surface, "5.,0.,5.", "7.,0.,7.", "1.,0.,1.")
                                          : cut_at(builder, surface, "7.,0.,5.", "9.,0.,7.", "1.,0.,1.");
        const Interval v = spline->axis(1).domain();
        EXPECT_LE(v.lower, 5 * std::sqrt(2.0));
        EXPECT_GE(v.upper, 7 * std::sqrt(2.0));
        const Interval u = spline->axis(0).domain();
        EXPECT_LE(u.lower, 0);
        EXPECT_GT(u.upper, 0);
    }
}

TEST(StepSurfaces, rectangular_trimmed_surfaces) {
    StepBuilder builder;
    const std::string cylinder = builder.add("CYLINDRICAL_SURFACE(''," + builder.some_placement() + ",2.)");
    builder.add("RECTANGULAR_TRIMMED_SURFACE(''," + cylinder +
                ",4.71238898038469,1.5707963267949,-1.,5.,.T.,.T.)");
    const SplinePtr half = only_spline(builder); // over the seam
    const Interval u = half->axis(0).domain();
    EXPECT_NEAR(u.upper - u.lower, pi, 1e-13);
    expect_domain(*half, 1, -1, 5);
    expect_near(point_of(*half, u.lower, 5), placed(0, -2, 5), 1e-13);
    expect_near(point_of(*half, u.lower + pi / 2, 5), placed(2, 0, 5), 1e-13);
}

TEST(StepSurfaces, senses_of_rectangular_trimmed_surfaces) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    builder.add("RECTANGULAR_TRIMMED_SURFACE(''," + plane + ",3.,1.,-1.,5.,.F.,.T.)");
    const SplinePtr part = only_spline(builder);
    expect_domain(*part, 0, -3, -1);
    expect_near(point_of(*part, -3, -1), placed(3, -1, 0), 0);
    expect_near(point_of(*part, -1, 5), placed(1, 5, 0), 0);
}

TEST(StepSurfaces, curve_bounded_surfaces_are_cut_to_their_curves) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",4.)");
    const std::string segment = builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + circle + ")");
    const std::string outline = builder.add("OUTER_BOUNDARY_CURVE('',(" + segment + "),.F.)");
    builder.add("CURVE_BOUNDED_SURFACE('disc'," + plane + ",(" + outline + "),.F.)");
    const SplinePtr disc = only_spline(builder);
    expect_domain(*disc, 0, -4.125, 4.125);
    expect_domain(*disc, 1, -4.125, 4.125);
}

std::string net(StepBuilder &builder) {
    std::string rows;
    for (const char *x : {"0.", "1.", "2."}) {
        const std::string a = builder.point(std::string(x) + ",0.,0."),
                          b = builder.point(std::string(x) + ",1.,5.");
        rows += (rows.empty() ? "(" : ",(") + a + "," + b + ")";
    }
    return "(" + rows + ")";
}

TEST(StepSurfaces, b_spline_surfaces_run_along_u_from_row_to_row) {
    StepBuilder builder;
    const std::string rows = net(builder);
    builder.add("B_SPLINE_SURFACE_WITH_KNOTS('sheet',2,1," + rows +
                ",.UNSPECIFIED.,.F.,.F.,.F.,(3,3),(2,2),(0.,2.),(0.,1.),.UNSPECIFIED.)");
    builder.add("(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1," + rows +
                ",.U.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,2.),(0.,1.),.U.)"
                "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),(0.5,0.25),(1.,1.)))"
                "REPRESENTATION_ITEM('')SURFACE())");
    builder.add("BEZIER_SURFACE('',1,1," + rows + ",.U.,.F.,.F.,.F.)");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 3U);
    const Spline &plain = *document.splines[0].spline, &rational = *document.splines[1].spline,
                 &bezier = *document.splines[2].spline;
    EXPECT_EQ(plain.count(0), 3);
    EXPECT_EQ(plain.count(1), 2);
    expect_near(point_of(plain, 2, 0), {2, 0, 0}, 0);
    expect_near(point_of(plain, 0, 1), {0, 1, 5}, 0);
    EXPECT_EQ(rational.weights()[2], 0.5);
    EXPECT_EQ(rational.weights()[3], 0.25);
    expect_domain(bezier, 0, 0, 2);
    expect_near(point_of(bezier, 1, 1), {1, 1, 5}, 0);
}

// Of a ball they are a ball again.
TEST(StepSurfaces, offsets_of_known_surfaces_are_known) {
    StepBuilder builder;
    const std::string ball = builder.add("SPHERICAL_SURFACE(''," + builder.some_placement() + ",2.)");
    builder.add("OFFSET_SURFACE(''," + ball + ",0.5,.F.)");
    const nrb::model::Model document = read(builder);
    EXPECT_TRUE(document.notes.empty());
    ASSERT_EQ(document.splines.size(), 1U);
    expect_at_eighths(*document.splines[0].spline, true, [](double u, double v) {
        return placed(2.5 * std::cos(v) * std::cos(u), 2.5 * std::cos(v) * std::sin(u), 2.5 * std::sin(v));
    });
}

// The others are approximated, and a note tells how nearly: z = x^2 / 4 over [0, 2] x [0, 1] on y, at 1/8 above it.
TEST(StepSurfaces, offsets_of_splines_are_approximated) {
    StepBuilder builder;
    std::string rows;
    for (const char *row : {"0.,%,0.", "1.,%,0.", "2.,%,1."}) {
        std::string columns;
        for (const char *y : {"0.", "1."}) {
            std::string text = row;
            text.replace(text.find('%'), 1, y);
            columns += (columns.empty() ? "" : ",") + builder.add("CARTESIAN_POINT('',(" + text + "))");
        }
        rows += (rows.empty() ? "(" : ",(") + columns + ")";
    }
    const std::string sheet = builder.add("BEZIER_SURFACE('',2,1,(" + rows + "),.U.,.F.,.F.,.F.)");
    const std::string offset = builder.add("OFFSET_SURFACE(''," + sheet + ",0.125,.F.)");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_EQ(document.notes[0].reason, Status::tolerance);
    EXPECT_EQ(document.notes[0].text.rfind(
                  offset + " OFFSET_SURFACE: its offset surface is approximated within ", 0),
              0U);
    for (int i = 0; i <= 20; ++i) {
        const double t = i / 20.0, x = 2 * t, slope = x / 2, norm = std::hypot(1, slope);
        expect_near(point_of(*document.splines[0].spline, t, 0.3),
                    {x - 0.125 * slope / norm, 0.3, x * x / 4 + 0.125 / norm}, 2.5e-8);
    }
}

TEST(StepSurfaces, offsets_of_kinks_and_others_are_noted) {
    StepBuilder builder;
    const std::string corner = "CARTESIAN_POINT('',(0.,0.,0.))", a = builder.add(corner),
                      b = builder.add(corner);
    const std::string fan = builder.add(
        "BEZIER_SURFACE('',1,1,((" + a + "," + b + "),(" + builder.add("CARTESIAN_POINT('',(1.,0.,0.))") +
        "," + builder.add("CARTESIAN_POINT('',(1.,1.,0.))") + ")),.U.,.F.,.F.,.F.)");
    const std::string offset = builder.add("OFFSET_SURFACE(''," + fan + ",0.5,.F.)");
    EXPECT_EQ(only_note(builder).text,
              offset + " OFFSET_SURFACE: the surface has no normal at (0, 0), where its offset is not known");
    EXPECT_EQ(only_note(builder).reason, Status::unsupported);
    StepBuilder other;
    const std::string unread = other.add("RECTANGULAR_COMPOSITE_SURFACE('',())");
    EXPECT_EQ(only_note(other).text,
              unread + " RECTANGULAR_COMPOSITE_SURFACE: does not become a spline in this version");
}

TEST(StepSurfaces, without_ends_and_boundary_there_is_a_note) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    EXPECT_EQ(only_note(builder).text,
              plane + " PLANE: the surface has no ends, and nothing bounds the face");
}

} // namespace

} // namespace step_surfaces_test
