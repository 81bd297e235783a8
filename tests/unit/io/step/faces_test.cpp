// Faces and edges of STEP files, their names, and what is not read of them.
#include "support/step_reading.h"

#include <cmath>
#include <numbers>

namespace step_faces_test {

namespace {

using namespace step_test;
using nrb::SplinePtr;
using nrb::Status;

TEST(StepFaces, edges_go_from_their_start_to_their_end) {
    for (const char *sense : {".T.", ".F."}) {
        StepBuilder builder;
        const std::string circle =
            builder.add("CIRCLE(''," + builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",2.)");
        builder.edge("2.,0.,0.", "0.,2.,0.", circle, sense);
        const SplinePtr arc = only_spline(builder);
        const nrb::Interval domain = arc->axis(0).domain();
        expect_near(point_of(*arc, domain.lower), {2, 0, 0}, 0);
        expect_near(point_of(*arc, domain.upper), {0, 2, 0}, 0);
        EXPECT_NEAR(domain.upper - domain.lower, std::numbers::pi / (sense[1] == 'T' ? 2 : 2.0 / 3), 1e-15);
    }
}

TEST(StepFaces, an_edge_with_one_vertex_is_a_whole_circle_from_there) {
    StepBuilder builder;
    const std::string circle =
        builder.add("CIRCLE(''," + builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ",2.)");
    builder.edge("0.,2.,0.", "0.,2.,0.", circle, ".F.");
    const SplinePtr all = only_spline(builder);
    const nrb::Interval domain = all->axis(0).domain();
    EXPECT_EQ(domain.upper - domain.lower, 2 * std::numbers::pi);
    expect_near(point_of(*all, domain.lower), {0, 2, 0}, 0);
    expect_near(point_of(*all, domain.lower + std::numbers::pi / 2), {2, 0, 0}); // against the circle
}

std::string closed_polyline(StepBuilder &builder) {
    const std::string a = builder.point("0.,0.,0."), b = builder.point("4.,0.,0."),
                      c = builder.point("4.,4.,0.");
    return builder.add("POLYLINE('',(" + a + "," + b + "," + c + "," + a + "))");
}

TEST(StepFaces, edges_on_closed_splines_may_cross_their_seam) {
    StepBuilder builder;
    builder.edge("4.,2.,0.", "2.,0.,0.", closed_polyline(builder));
    const SplinePtr part = only_spline(builder);
    expect_domain(*part, 0, 1.5, 3.5);
    expect_near(point_of(*part, 2.5), {2, 2, 0});
    expect_near(point_of(*part, 3), {0, 0, 0}, 0);
    expect_near(point_of(*part, 3.5), {2, 0, 0}, 0);
    StepBuilder backwards;
    backwards.edge("4.,2.,0.", "2.,0.,0.", closed_polyline(backwards), ".F.");
    const SplinePtr other = only_spline(backwards);
    expect_domain(*other, 0, -1.5, -0.5);
    StepBuilder whole;
    whole.edge("0.,0.,0.", "0.,0.,0.", closed_polyline(whole));
    expect_domain(*only_spline(whole), 0, 0, 3);
}

TEST(StepFaces, vertices_inside_of_a_spline_cut_it) {
    StepBuilder builder;
    const std::string a = builder.point("0.,0.,0."), b = builder.point("4.,0.,0.");
    builder.edge("3.,0.,0.", "1.,0.,0.", builder.add("POLYLINE('',(" + a + "," + b + "))"), ".F.");
    const SplinePtr part = only_spline(builder);
    expect_domain(*part, 0, -0.75, -0.25);
    expect_near(point_of(*part, -0.75), {3, 0, 0}, 0);
}

TEST(StepFaces, names_are_those_of_faces_or_their_numbers) {
    StepBuilder builder;
    const std::string ball = builder.add("SPHERICAL_SURFACE('ball'," + builder.some_placement() + ",2.)");
    const std::string named = builder.face(ball, {}, "\\X2\\00E9\\X0\\toile"),
                      nameless = builder.face(ball, {}, "  ");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    EXPECT_EQ(document.splines[0].name, "\xc3\xa9toile");
    EXPECT_EQ(document.splines[1].name, nameless);
    EXPECT_EQ(document.splines[0].spline, document.splines[1].spline); // made once
}

TEST(StepFaces, vertex_loops_and_polygons_bound_too) {
    StepBuilder builder;
    const std::string plane =
        builder.add("PLANE(''," + builder.placement("0.,0.,0.", "0.,0.,1.", "1.,0.,0.") + ")");
    const std::string corners =
        builder.point("0.,0.,0.") + "," + builder.point("2.,0.,0.") + "," + builder.point("0.,4.,0.");
    const std::string loop = builder.add("POLY_LOOP('',(" + corners + "))");
    const std::string dot = builder.add("VERTEX_LOOP(''," + builder.vertex("3.,1.,0.") + ")");
    const std::string outer = builder.add("FACE_OUTER_BOUND(''," + loop + ",.T.)");
    const std::string inner = builder.add("FACE_BOUND(''," + dot + ",.T.)");
    builder.add("FACE_SURFACE('',(" + outer + "," + inner + ")," + plane + ",.T.)");
    const SplinePtr surface = only_spline(builder);
    expect_domain(*surface, 0, -0.0625, 3.0625);
    expect_domain(*surface, 1, -0.0625, 4.0625);
}

TEST(StepFaces, a_face_whose_edge_is_broken_is_noted_with_it) {
    StepBuilder builder;
    const std::string plane = builder.add("PLANE(''," + builder.some_placement() + ")");
    const std::string edge = builder.edge("0.,0.,0.", "1.,0.,0.", "#99");
    const std::string face = builder.face(plane, {edge});
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.notes.size(), 2U);
    EXPECT_EQ(document.notes[0].text, edge + " EDGE_CURVE: edge_geometry: #99 is not in the file");
    EXPECT_EQ("#" + std::to_string(document.notes[1].line), face);
    EXPECT_NE(document.notes[1].text.find(edge + " is no edge that could be read"), std::string::npos);
}

TEST(StepFaces, parts_of_others_are_not_read_again) {
    StepBuilder builder;
    const std::string circle = builder.add("CIRCLE(''," + builder.some_placement() + ",2.)");
    const std::string vase = builder.add("SURFACE_OF_REVOLUTION(''," + circle + ",#99)");
    const nrb::model::Model document = read(builder);
    EXPECT_TRUE(document.splines.empty());
    EXPECT_EQ(only_note(document).text,
              vase + " SURFACE_OF_REVOLUTION: axis_position: #99 is not in the file");
}

TEST(StepFaces, items_that_are_not_read_are_noted_once) {
    StepBuilder builder;
    const std::string block = builder.add("BLOCK('',#1,1.,1.,1.)"), ring = builder.add("CIRCLE('',#8,1.)");
    builder.add("GEOMETRIC_CURVE_SET('',(" + ring + "," + block + "))");
    builder.shape(block + "," + ring, builder.context(builder.millimetre(), builder.radian()));
    builder.add("MAPPED_ITEM('',#1,#2)");
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.notes.size(), 3U);
    EXPECT_EQ(document.notes[0].text, block + " BLOCK: does not become a spline in this version");
    EXPECT_EQ(document.notes[1].text,
              ring + " CIRCLE: position: #8 is a MAPPED_ITEM, expected an AXIS2_PLACEMENT_2D or _3D");
    EXPECT_EQ(document.notes[2].reason, Status::unsupported);
}

} // namespace

} // namespace step_faces_test
