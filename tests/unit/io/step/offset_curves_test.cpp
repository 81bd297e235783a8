// Offset curves of STEP files: C + d V x T / |V x T|.
#include "support/step_reading.h"

#include <cmath>

namespace step_offset_curves_test {

namespace {

using namespace step_test;
using nrb::SplinePtr;
using nrb::Status;
using nrb::Vector3;

std::string offset_of(StepBuilder &builder, const std::string &basis, const std::string &distance,
                      const std::string &reference) {
    const std::string way = builder.direction(reference);
    return builder.add("OFFSET_CURVE_3D(''," + basis + "," + distance + ",.F.," + way + ")");
}

std::string trimmed(StepBuilder &builder, const std::string &basis, const std::string &from,
                    const std::string &to, const std::string &sense = ".T.") {
    return builder.add("TRIMMED_CURVE(''," + basis + ",(PARAMETER_VALUE(" + from + ")),(PARAMETER_VALUE(" +
                       to + "))," + sense + ",.PARAMETER.)");
}

std::string line(StepBuilder &builder, const std::string &point, const std::string &way) {
    const std::string from = builder.point(point), along = builder.vector(way, "1.");
    return builder.add("LINE(''," + from + "," + along + ")");
}

// (x, x^2 / 4) over [0, 2] at t = x / 2.
std::string sheet_profile(StepBuilder &builder, const char *z = ",0.") {
    const std::string points = builder.point(std::string("0.,0.") + z) + "," +
                               builder.point(std::string("1.,0.") + z) + "," +
                               builder.point(std::string("2.,1.") + z);
    return builder.add("BEZIER_CURVE('',2,(" + points + "),.U.,.F.,.F.)");
}

void expect_offset_profile(const nrb::Spline &spline, double distance, double tolerance) {
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0, x = 2 * t, slope = x / 2, norm = std::hypot(1, slope);
        expect_near(point_of(spline, t), {x - distance * slope / norm, x * x / 4 + distance / norm, 0},
                    tolerance);
    }
}

// Z x T is inwards; against Z it is outwards. The kind is kept: eighths of a turn have the angles of the circle.
TEST(StepOffsetCurves, of_circles_are_circles) {
    for (const bool inwards : {true, false}) {
        StepBuilder builder;
        const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
        offset_of(builder, circle, "0.5", inwards ? "3.,0.,0." : "-3.,0.,0.");
        const SplinePtr spline = only_spline(builder);
        const double radius = inwards ? 1.5 : 2.5;
        expect_domain(*spline, 0, 0, 2 * pi);
        for (int i = 0; i <= 8; ++i) {
            expect_near(point_of(*spline, pi * i / 4),
                        placed(radius * std::cos(pi * i / 4), radius * std::sin(pi * i / 4)));
        }
    }
}

// By definition it is on the other side of the centre; by the radius it is a point.
TEST(StepOffsetCurves, of_circles_beyond_the_centre_are_told) {
    StepBuilder builder;
    const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
    const std::string offset = offset_of(builder, circle, "3.", "1.,0.,0.");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    EXPECT_EQ(only_note(document).text,
              offset + " OFFSET_CURVE_3D: its offset curve runs against the basis where the radius of "
                       "curvature of that is below the distance");
    for (int i = 0; i <= 8; ++i) {
        expect_near(point_of(*document.splines[0].spline, pi * i / 4),
                    placed(-std::cos(pi * i / 4), -std::sin(pi * i / 4)));
    }
    StepBuilder point;
    offset_of(point, point.add("CIRCLE(''," + point.some_placement() + ",2.)"), "2.", "1.,0.,0.");
    EXPECT_EQ(only_note(point).reason, Status::length);
}

TEST(StepOffsetCurves, of_lines_are_lines) {
    for (const bool forward : {true, false}) {
        StepBuilder builder;
        const std::string part = trimmed(builder, line(builder, "1.,2.,3.", "0.,1.,0."),
                                         forward ? "1." : "4.", forward ? "4." : "1.");
        offset_of(builder, part, "0.5", "0.,3.,4."); // V x T along (-1, 0, 0), or against it
        const SplinePtr spline = only_spline(builder);
        EXPECT_EQ(spline->axis(0).degree(), 1);
        const double x = forward ? 0.5 : 1.5;
        expect_domain(*spline, 0, forward ? 1 : -4, forward ? 4 : -1);
        expect_near(point_of(*spline, forward ? 1 : -4), {x, forward ? 3.0 : 6.0, 3});
        expect_near(point_of(*spline, forward ? 4 : -1), {x, forward ? 6.0 : 3.0, 3});
    }
    StepBuilder along;
    offset_of(along, line(along, "1.,2.,3.", "0.,1.,0."), "0.5", "0.,1.,0.");
    EXPECT_EQ(only_note(along).reason, Status::unsupported);
}

// The others are approximated, and a note tells how nearly; tighter where the caller asks for it.
TEST(StepOffsetCurves, of_splines_are_approximated) {
    for (const double tolerance : {0.0, 1e-9}) {
        StepBuilder builder;
        const std::string offset = offset_of(builder, sheet_profile(builder), "0.125", "0.,0.,2.");
        const nrb::model::Model document = read(builder, {.tolerance = tolerance});
        ASSERT_EQ(document.splines.size(), 1U);
        EXPECT_EQ(only_note(document).reason, Status::tolerance);
        EXPECT_EQ(only_note(document).text.rfind(
                      offset + " OFFSET_CURVE_3D: its offset curve is approximated within ", 0),
                  0U);
        expect_offset_profile(*document.splines[0].spline, 0.125, tolerance > 0 ? 0.25e-9 : 0.25e-7);
    }
}

TEST(StepOffsetCurves, of_the_plane_are_to_the_left) {
    StepBuilder builder;
    builder.add("OFFSET_CURVE_2D(''," + sheet_profile(builder, "") + ",-0.125,.F.)");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    EXPECT_EQ(document.splines[0].spline->dim(), 2);
    expect_offset_profile(*document.splines[0].spline, -0.125, 4e-9);
    StepBuilder space;
    space.add("OFFSET_CURVE_2D(''," + sheet_profile(space) + ",-0.125,.F.)");
    EXPECT_EQ(only_note(space).reason, Status::dimension);
}

// A distance of 0 leaves a curve as it is.
TEST(StepOffsetCurves, at_no_distance_are_the_basis) {
    StepBuilder builder;
    offset_of(builder, sheet_profile(builder), "0.", "0.,0.,1.");
    expect_offset_profile(*only_spline(builder), 0, 1e-15);
}

// Parameters are those of the basis, angles of an ellipse; in the other direction the normal stays on its side.
TEST(StepOffsetCurves, are_trimmed_by_the_parameters_of_their_basis) {
    const auto on_offset = [](double t) {
        const double size = std::hypot(3 * std::sin(t), 2 * std::cos(t));
        return placed(3 * std::cos(t) - 0.5 * 2 * std::cos(t) / size,
                      2 * std::sin(t) - 0.5 * 3 * std::sin(t) / size);
    };
    for (const bool forward : {true, false}) {
        StepBuilder builder;
        const std::string ellipse = builder.add("ELLIPSE(''," + builder.some_placement() + ",3.,2.)");
        trimmed(builder, offset_of(builder, ellipse, "0.5", "1.,0.,0."), forward ? "0.3" : "1.7",
                forward ? "1.7" : "0.3", forward ? ".T." : ".F.");
        const nrb::model::Model document = read(builder);
        ASSERT_EQ(document.splines.size(), 1U);
        const nrb::Interval domain = document.splines[0].spline->axis(0).domain();
        EXPECT_NEAR(domain.lower, forward ? 0.3 : -1.7, 1e-15);
        expect_near(point_of(*document.splines[0].spline, domain.lower), on_offset(forward ? 0.3 : 1.7),
                    2.5e-8);
        expect_near(point_of(*document.splines[0].spline, domain.upper), on_offset(forward ? 1.7 : 0.3),
                    2.5e-8);
    }
}

// A parabola has no ends, and so has its offset, but parts of both have.
TEST(StepOffsetCurves, without_ends_have_parts) {
    StepBuilder builder;
    const std::string parabola = builder.add("PARABOLA(''," + builder.some_placement() + ",0.5)");
    const std::string offset = offset_of(builder, parabola, "0.25", "1.,0.,0.");
    EXPECT_EQ(only_note(builder).reason, Status::length);
    trimmed(builder, offset, "-1.", "1.5");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    for (int i = 0; i <= 20; ++i) { // (t^2 / 2, t), to the left of (t, 1)
        const double t = -1 + 2.5 * i / 20, size = std::hypot(t, 1);
        expect_near(point_of(*document.splines[0].spline, t),
                    placed(t * t / 2 - 0.25 / size, t + 0.25 * t / size), 2.5e-8);
    }
}

// A line that goes over into a quarter of a circle without a corner: two pieces of the same kinds.
TEST(StepOffsetCurves, of_composite_curves_have_the_pieces) {
    StepBuilder builder;
    const std::string straight = trimmed(builder, line(builder, "0.,0.,0.", "1.,0.,0."), "0.", "1.");
    const std::string circle =
        builder.add("CIRCLE(''," + builder.placement("1.,1.,0.", "0.,0.,1.", "0.,-1.,0.") + ",1.)");
    const std::string arc = trimmed(builder, circle, "0.", "1.5707963267948966");
    const std::string all = builder.add(
        "COMPOSITE_CURVE('',(" + builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + straight + ")") +
        "," + builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + arc + ")") + "),.F.)");
    offset_of(builder, all, "0.25", "0.,0.,1.");
    const SplinePtr spline = only_spline(builder);
    expect_domain(*spline, 0, 0, 1 + pi / 2);
    expect_near(point_of(*spline, 0.5), {0.5, 0.25, 0});
    expect_near(point_of(*spline, 1 + pi / 4), {1 + 0.75 * std::sqrt(0.5), 1 - 0.75 * std::sqrt(0.5), 0});
    expect_near(point_of(*spline, 1 + pi / 2), {1.75, 1, 0});
}

TEST(StepOffsetCurves, of_corners_have_a_gap) {
    StepBuilder builder;
    const std::string points =
        builder.point("0.,0.,0.") + "," + builder.point("1.,0.,0.") + "," + builder.point("1.,1.,0.");
    const std::string offset =
        offset_of(builder, builder.add("POLYLINE('',(" + points + "))"), "0.5", "0.,0.,1.");
    EXPECT_EQ(only_note(builder).text, offset + " OFFSET_CURVE_3D: the curve has a kink at a knot, where its "
                                                "offset has a gap of 0.7071067811865476");
}

// A half disk of radius 1.5 whose arc is the offset of a circle: its edges end at its vertices.
TEST(StepOffsetCurves, bound_faces) {
    StepBuilder builder;
    const std::string centre = builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.");
    const std::string plane = builder.add("PLANE(''," + centre + ")");
    const std::string circle = builder.add("CIRCLE(''," + centre + ",2.)");
    const std::string offset = offset_of(builder, circle, "0.5", "0.,0.,1.");
    const std::string chord = builder.straight_edge("-1.5,0.,0.", "1.5,0.,0.", "1.,0.,0."),
                      arc = builder.edge("1.5,0.,0.", "-1.5,0.,0.", offset);
    builder.face(plane, {chord, arc});
    const nrb::model::Model model = nrb::io::read_model(builder.text(), {});
    for (const nrb::model::Note &note : model.notes) {
        ADD_FAILURE() << note.text;
    }
    ASSERT_EQ(model.faces.size(), 1U);
    ASSERT_EQ(model.edges.size(), 2U);
    for (const nrb::model::Edge &edge : model.edges) {
        const nrb::Interval domain = edge.curve->axis(0).domain();
        EXPECT_NEAR(nrb::length(point_of(*edge.curve, domain.lower)), 1.5, 1e-14);
        EXPECT_NEAR(nrb::length(point_of(*edge.curve, domain.upper)), 1.5, 1e-14);
    }
}

// Ends at points of the offset, which is a spline.
TEST(StepOffsetCurves, are_cut_by_vertices) {
    StepBuilder builder;
    const std::string offset = offset_of(builder, sheet_profile(builder), "0.125", "0.,0.,1.");
    builder.edge("0.,0.125,0.", "1.9116116523516815,1.0883883476483185,0.", offset);
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 1U);
    expect_offset_profile(*document.splines[0].spline, 0.125, 2.5e-8);
}

// Distances are lengths of the file.
TEST(StepOffsetCurves, are_in_the_unit_of_the_file) {
    StepBuilder builder;
    const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
    const std::string offset = offset_of(builder, circle, "0.5", "1.,0.,0.");
    builder.shape(offset, builder.context(builder.inch(), builder.radian()));
    expect_near(point_of(*only_spline(builder, {.unit = 1e-3}), 0), {25.4, 25.4 * 3.5, 25.4 * 3}, 1e-13);
}

// Along its own normal: where it runs against the profile, beyond the centres of curvature, on the other side.
TEST(StepOffsetCurves, of_offsets_add_up) {
    struct Case {
        const char *first, *second, *reference;
        double whole;
    };
    for (const Case &c : {Case{"0.125", "0.25", "0.,0.,1.", 0.375},
                          Case{"0.125", "0.25", "0.,0.,-2.", -0.125}, Case{"-1.", "0.5", "0.,0.,1.", -0.5},
                          Case{"8.", "0.5", "0.,0.,1.", 7.5}, Case{"8.", "-0.5", "0.,0.,1.", 8.5}}) {
        StepBuilder builder;
        const std::string twice = offset_of(
            builder, offset_of(builder, sheet_profile(builder), c.first, "0.,0.,1."), c.second, c.reference);
        const nrb::model::Model document = read(builder);
        ASSERT_EQ(document.splines.size(), 1U);
        EXPECT_TRUE(only_note(document).text.starts_with(
            twice + " OFFSET_CURVE_3D: its offset curve is approximated within "))
            << only_note(document).text;
        expect_offset_profile(*document.splines[0].spline, c.whole, 0.25e-7);
    }
    StepBuilder circle;
    const std::string ring = circle.add("CIRCLE(''," + circle.some_placement() + ",1.)");
    offset_of(circle, offset_of(circle, ring, "1.5", "1.,0.,0."), "1.", "1.,0.,0.");
    const nrb::model::Model document = read(circle); // -1/2, and 1 inwards of that: 1/2 again
    ASSERT_EQ(document.splines.size(), 1U);
    EXPECT_TRUE(document.notes.empty());
    expect_near(point_of(*document.splines[0].spline, 0), placed(0.5, 0));
}

TEST(StepOffsetCurves, that_cannot_be_known_are_noted) {
    StepBuilder twice; // behind the cusps of the first one it runs against the profile, and nowhere else
    const std::string first = offset_of(twice, sheet_profile(twice), "2.5", "0.,0.,1.");
    const std::string second = offset_of(twice, first, "0.125", "0.,0.,1.");
    EXPECT_EQ(only_note(twice).text,
              second + " OFFSET_CURVE_3D: the direction of the curve at the distance 2.5, from which it "
                       "is offset, is not known to be that of its basis, or against it");
    EXPECT_EQ(only_note(twice).reason, Status::unsupported);
    StepBuilder skew;
    const std::string about = offset_of(skew, sheet_profile(skew), "0.125", "0.,0.,1.");
    const std::string other = offset_of(skew, about, "0.125", "0.,1.,1.");
    EXPECT_EQ(only_note(skew).text,
              other + " OFFSET_CURVE_3D: basis_curve: is an offset about another reference direction");
    StepBuilder cycle;
    const std::string way = cycle.direction("0.,0.,1.");
    cycle.add("OFFSET_CURVE_3D(''," + cycle.next() + ",1.,.F.," + way + ")");
    for (const nrb::model::Note &note : read(cycle).notes) {
        EXPECT_EQ(note.reason, Status::syntax) << note.text;
    }
    for (const char *reference : {"0.,0.,0.", "0.,1."}) {
        StepBuilder builder;
        offset_of(builder, sheet_profile(builder), "0.125", reference);
        EXPECT_FALSE(read(builder).notes.empty());
        EXPECT_TRUE(read(builder).splines.empty());
    }
}

} // namespace

} // namespace step_offset_curves_test
