// Curves of STEP files against the shapes that they state.
#include "support/step_reading.h"

#include <cmath>

namespace step_curves_test {

namespace {

using namespace step_test;
using nrb::SplinePtr;
using nrb::Status;
using nrb::Vector3;

SplinePtr trimmed(StepBuilder &builder, const std::string &basis, const std::string &ends) {
    builder.add("TRIMMED_CURVE(''," + basis + "," + ends + ")");
    return only_spline(builder);
}

TEST(StepCurves, circle) {
    StepBuilder builder;
    builder.add("CIRCLE('ring'," + builder.some_placement() + ",2.)");
    const nrb::model::Model document = read(builder);
    const SplinePtr circle = only_spline(document);
    EXPECT_EQ(document.splines[0].name, "ring");
    expect_domain(*circle, 0, 0, 2 * pi);
    for (int i = 0; i <= 64; ++i) {
        const Vector3 p = point_of(*circle, 2 * pi * i / 64) - Vector3{1, 2, 3};
        EXPECT_NEAR(std::hypot(p.y, p.z), 2, 2e-15);
        EXPECT_NEAR(p.x, 0, 2e-16);
    }
    for (int i = 0; i <= 8; ++i) { // parameters and angles agree at the eighths, by symmetry
        expect_near(point_of(*circle, pi * i / 4),
                    placed(2 * std::cos(pi * i / 4), 2 * std::sin(pi * i / 4)));
    }
}

TEST(StepCurves, ellipse) {
    StepBuilder builder;
    builder.add("ELLIPSE(''," + builder.some_placement() + ",3.,0.5)");
    const SplinePtr ellipse = only_spline(builder);
    for (int i = 0; i <= 8; ++i) {
        expect_near(point_of(*ellipse, pi * i / 4),
                    placed(3 * std::cos(pi * i / 4), 0.5 * std::sin(pi * i / 4)));
    }
}

// Z defaults to (0, 0, 1), and X to the part of (1, 0, 0) across it.
TEST(StepCurves, missing_axes_have_those_of_the_standard) {
    const auto start_of_circle = [](const std::string &axes) {
        StepBuilder builder;
        const std::string origin = builder.point("0.,0.,0."), along_x = builder.direction("3.,0.,0."),
                          tilted = builder.direction("1.,0.,1.");
        std::string text;
        for (const char c : axes) {
            text += c == 'X' ? along_x : (c == 'T' ? tilted : std::string(1, c));
        }
        builder.add("CIRCLE(''," + builder.add("AXIS2_PLACEMENT_3D(''," + origin + text + ")") + ",1.)");
        return point_of(*only_spline(builder), 0);
    };
    expect_near(start_of_circle(",$,$"), {1, 0, 0}, 0);
    expect_near(start_of_circle(",X,$"), {0, 1, 0}, 0);
    expect_near(start_of_circle(",T,$"), {std::sqrt(0.5), 0, -std::sqrt(0.5)}, 1e-15);
    expect_near(start_of_circle(",$,T"), {1, 0, 0}, 0); // made perpendicular, and of length 1
    expect_near(start_of_circle(",X,X"), {0, 1, 0}, 0); // parallel counts as missing
}

TEST(StepCurves, polyline) {
    StepBuilder builder;
    const std::string points =
        builder.point("0.,0.,0.") + "," + builder.point("1.,0.,2.") + "," + builder.point("1.,5.,2.");
    builder.add("POLYLINE('',(" + points + "))");
    const SplinePtr line = only_spline(builder);
    expect_domain(*line, 0, 0, 2);
    expect_near(point_of(*line, 1), {1, 0, 2}, 0);
    expect_near(point_of(*line, 1.5), {1, 2.5, 2}, 0);
}

std::string line(StepBuilder &builder) {
    const std::string from = builder.point("1.,0.,0."), way = builder.vector("0.,3.,0.", "2.");
    return builder.add("LINE(''," + from + "," + way + ")");
}

TEST(StepCurves, line_between_parameters_counts_lengths_of_its_vector) {
    StepBuilder builder;
    const SplinePtr part =
        trimmed(builder, line(builder), "(PARAMETER_VALUE(-1.)),(PARAMETER_VALUE(3.)),.T.,.PARAMETER.");
    expect_domain(*part, 0, -1, 3);
    expect_near(point_of(*part, -1), {1, -2, 0}, 0);
    expect_near(point_of(*part, 3), {1, 6, 0}, 0);
}

TEST(StepCurves, line_between_points) {
    StepBuilder builder;
    const std::string basis = line(builder), a = builder.point("1.,8.,0."), b = builder.point("1.,4.,0.");
    const SplinePtr part = trimmed(builder, basis, "(" + a + "),(" + b + "),.F.,.CARTESIAN.");
    expect_domain(*part, 0, -4, -2);
    expect_near(point_of(*part, -4), {1, 8, 0}, 0);
    expect_near(point_of(*part, -2), {1, 4, 0}, 0);
}

std::string unit_circle(StepBuilder &builder) {
    return builder.add("CIRCLE(''," + builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",1.)");
}

TEST(StepCurves, arcs_by_angle_go_the_way_that_their_sense_says) {
    for (const bool forward : {true, false}) {
        StepBuilder builder;
        const SplinePtr arc =
            trimmed(builder, unit_circle(builder),
                    "(PARAMETER_VALUE(4.71238898038469)),(PARAMETER_VALUE(1.5707963267949)),." +
                        std::string(forward ? "T" : "F") + ".,.PARAMETER.");
        const nrb::Interval domain = arc->axis(0).domain();
        EXPECT_NEAR(domain.upper - domain.lower, pi, 1e-13);
        expect_near(point_of(*arc, domain.lower), {0, -1, 0}, 1e-13);
        expect_near(point_of(*arc, domain.upper), {0, 1, 0}, 1e-13);
        expect_near(point_of(*arc, domain.lower + pi / 2), {forward ? 1.0 : -1.0, 0, 0}, 1e-13);
    }
}

TEST(StepCurves, arcs_by_points_may_cross_the_seam) {
    StepBuilder builder;
    const std::string basis = unit_circle(builder), a = builder.point("0.,-1.,0."),
                      b = builder.point("0.,1.,0.");
    // the parameters are wrong, and do not count
    const SplinePtr arc = trimmed(
        builder, basis, "(" + a + ",PARAMETER_VALUE(0.1)),(" + b + ",PARAMETER_VALUE(0.2)),.T.,.CARTESIAN.");
    const nrb::Interval domain = arc->axis(0).domain();
    expect_near(point_of(*arc, domain.lower), {0, -1, 0}, 0);
    expect_near(point_of(*arc, (domain.lower + domain.upper) / 2), {1, 0, 0});
    expect_near(point_of(*arc, domain.upper), {0, 1, 0}, 0);
}

TEST(StepCurves, equal_points_of_a_circle_mean_all_of_it) {
    StepBuilder builder;
    const std::string basis = unit_circle(builder), a = builder.point("0.,1.,0.");
    const SplinePtr circle = trimmed(builder, basis, "(" + a + "),(" + a + "),.T.,.CARTESIAN.");
    const nrb::Interval domain = circle->axis(0).domain();
    EXPECT_NEAR(domain.upper - domain.lower, 2 * pi, 1e-14);
    expect_near(point_of(*circle, domain.lower), {0, 1, 0}, 0);
    expect_near(point_of(*circle, (domain.lower + domain.upper) / 2), {0, -1, 0});
}

TEST(StepCurves, angles_have_the_unit_of_their_context) {
    StepBuilder builder;
    const std::string basis = unit_circle(builder);
    const std::string arc = builder.add("TRIMMED_CURVE(''," + basis +
                                        ",(PARAMETER_VALUE(30.)),(PARAMETER_VALUE(90.)),.T.,.PARAMETER.)");
    builder.shape(arc, builder.context(builder.millimetre(), builder.degree()));
    const SplinePtr spline = only_spline(builder);
    expect_domain(*spline, 0, pi / 180 * 30, pi / 180 * 90);
    expect_near(point_of(*spline, pi / 180 * 30), {std::sqrt(0.75), 0.5, 0}, 1e-16);
}

TEST(StepCurves, parabola_and_hyperbola) {
    const std::string ends = "(PARAMETER_VALUE(-1.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.";
    StepBuilder parabolas;
    const SplinePtr parabola =
        trimmed(parabolas, parabolas.add("PARABOLA(''," + parabolas.some_placement() + ",0.25)"), ends);
    StepBuilder hyperbolas;
    const SplinePtr hyperbola =
        trimmed(hyperbolas, hyperbolas.add("HYPERBOLA(''," + hyperbolas.some_placement() + ",2.,3.)"), ends);
    for (const double t : {-1.0, 0.5, 2.0}) { // a parabola everywhere, a hyperbola where symmetry has it
        expect_near(point_of(*parabola, t), placed(0.25 * t * t, 0.5 * t));
        expect_near(point_of(*hyperbola, t), placed(2 * std::cosh(t), 3 * std::sinh(t)));
    }
}

TEST(StepCurves, composite_curves_are_joined) {
    StepBuilder builder;
    const std::string first =
        builder.add("TRIMMED_CURVE(''," + unit_circle(builder) +
                    ",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.5707963267948966)),.T.,.PARAMETER.)");
    const std::string corner = builder.point("0.,1.,0."), end = builder.point("-3.,1.,0.");
    const std::string second = builder.add("POLYLINE('',(" + end + "," + corner + "))");
    const std::string a = builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + first + ")");
    const std::string b = builder.add("COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.F.," + second + ")");
    builder.add("COMPOSITE_CURVE('',(" + a + "," + b + "),.F.)");
    const SplinePtr all = only_spline(builder);
    expect_domain(*all, 0, 0, pi / 2 + 1);
    expect_near(point_of(*all, 0), {1, 0, 0}, 0);
    expect_near(point_of(*all, pi / 4), {std::sqrt(0.5), std::sqrt(0.5), 0});
    expect_near(point_of(*all, pi / 2), {0, 1, 0}, 1e-16);
    expect_near(point_of(*all, pi / 2 + 1), {-3, 1, 0}, 0);
}

TEST(StepCurves, composite_curves_with_a_gap_are_noted) {
    StepBuilder builder;
    const std::string points[] = {builder.point("0.,0.,0."), builder.point("1.,0.,0."),
                                  builder.point("1.,1.,0.")};
    const std::string a = builder.add("POLYLINE('',(" + points[0] + "," + points[1] + "))");
    const std::string b = builder.add("POLYLINE('',(" + points[2] + "," + points[0] + "))");
    const std::string first = builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + a + ")");
    const std::string second = builder.add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + b + ")");
    builder.add("COMPOSITE_CURVE('',(" + first + "," + second + "),.F.)");
    EXPECT_EQ(only_note(builder).reason, Status::gap);
}

std::string four_points(StepBuilder &builder) {
    std::string points;
    for (const char *at : {"0.,0.,0.", "1.,2.,0.", "3.,2.,0.", "4.,0.,1."}) {
        points += (points.empty() ? "" : ",") + builder.point(at);
    }
    return "(" + points + ")";
}

std::vector<double> knots_of(const SplinePtr &spline) {
    const auto knots = spline->axis(0).knots();
    return {knots.begin(), knots.end()};
}

TEST(StepCurves, b_splines_with_stated_knots) {
    StepBuilder builder;
    builder.add("B_SPLINE_CURVE_WITH_KNOTS('wave',2," + four_points(builder) +
                ",.UNSPECIFIED.,.F.,.F.,(3,1,3),(0.,0.25,1.),.UNSPECIFIED.)");
    const SplinePtr spline = only_spline(builder);
    EXPECT_EQ(knots_of(spline), (std::vector<double>{0, 0, 0, 0.25, 1, 1, 1}));
    EXPECT_EQ(spline->form(), nrb::Form::polynomial);
    const std::vector<double> points(spline->points().begin(), spline->points().end());
    EXPECT_EQ(points, (std::vector<double>{0, 0, 0, 1, 2, 0, 3, 2, 0, 4, 0, 1}));
}

TEST(StepCurves, unclamped_b_splines_stay_unclamped) {
    StepBuilder builder;
    builder.add("B_SPLINE_CURVE_WITH_KNOTS('',2," + four_points(builder) +
                ",.UNSPECIFIED.,.T.,.F.,(1,1,1,1,1,1,1),(-2.,-1.,0.,1.,2.,3.,4.),.UNIFORM_KNOTS.)");
    const SplinePtr spline = only_spline(builder);
    expect_domain(*spline, 0, 0, 2);
    EXPECT_FALSE(spline->axis(0).clamped_start());
}

TEST(StepCurves, rational_b_splines_in_parts) {
    StepBuilder builder;
    const std::string points = four_points(builder);
    for (const char *weights : {"1.,0.5,0.25,1.", "2.,2.,2.,2."}) {
        builder.add("(BOUNDED_CURVE()B_SPLINE_CURVE(3," + points +
                    ",.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((4,4),(0.,1.),.UNSPECIFIED.)CURVE()"
                    "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((" +
                    weights + "))REPRESENTATION_ITEM('arch'))");
    }
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    EXPECT_EQ(document.splines[0].name, "arch");
    const auto weights = document.splines[0].spline->weights();
    EXPECT_EQ(std::vector<double>(weights.begin(), weights.end()), (std::vector<double>{1, 0.5, 0.25, 1}));
    EXPECT_EQ(document.splines[1].spline->form(), nrb::Form::polynomial); // a common weight cancels
}

TEST(StepCurves, forms_without_stated_knots) {
    const auto knots = [](const std::string &entity, int degree) {
        StepBuilder builder;
        builder.add(entity + "(''," + std::to_string(degree) + "," + four_points(builder) +
                    ",.UNSPECIFIED.,.F.,.F.)");
        return knots_of(only_spline(builder));
    };
    EXPECT_EQ(knots("BEZIER_CURVE", 3), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(knots("BEZIER_CURVE", 1), (std::vector<double>{0, 0, 1, 2, 3, 3}));
    EXPECT_EQ(knots("UNIFORM_CURVE", 2), (std::vector<double>{-2, -1, 0, 1, 2, 3, 4}));
    EXPECT_EQ(knots("QUASI_UNIFORM_CURVE", 2), (std::vector<double>{0, 0, 0, 1, 2, 2, 2}));
    StepBuilder complex;
    complex.add("(BEZIER_CURVE()BOUNDED_CURVE()B_SPLINE_CURVE(3," + four_points(complex) +
                ",.U.,.F.,.F.)CURVE()REPRESENTATION_ITEM('')RATIONAL_B_SPLINE_CURVE((1.,2.,2.,1.)))");
    EXPECT_TRUE(only_spline(complex)->rational());
}

TEST(StepCurves, surface_curves_are_their_curves_of_space) {
    for (const char *entity : {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"}) {
        StepBuilder builder;
        const std::string circle = unit_circle(builder);
        builder.add(std::string(entity) + "('seam'," + circle + ",(#999),.CURVE_3D.)");
        const nrb::model::Model document = read(builder);
        EXPECT_EQ(only_spline(document)->axis(0).degree(), 2);
        EXPECT_EQ(document.splines[0].name, "seam"); // the circle is a part of it, and no curve of its own
    }
}

TEST(StepCurves, any_entity_may_come_in_parts) {
    StepBuilder builder;
    builder.add("(CIRCLE(2.)CONIC(" + builder.some_placement() +
                ")CURVE()GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('parts'))");
    const nrb::model::Model document = read(builder);
    expect_near(point_of(*only_spline(document), 0), placed(2, 0), 0);
    EXPECT_EQ(document.splines[0].name, "parts");
}

TEST(StepCurves, curves_without_ends_are_noted) {
    StepBuilder builder;
    const std::string free = line(builder);
    const nrb::model::Note note = only_note(builder);
    EXPECT_EQ("#" + std::to_string(note.line), free);
    EXPECT_EQ(note.entity_type, 0);
    EXPECT_EQ(note.text, free + " LINE: the curve has no ends");
}

} // namespace

} // namespace step_curves_test
