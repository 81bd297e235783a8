// What is wrong inside an instance becomes a note that names the instance, the attribute, and what stands there.
#include "io/step/structure/exchange.h"
#include "support/step_reading.h"

namespace step_damage_test {

namespace {

using namespace step_test;
using nrb::Status;

using Reader = nrb::model::Model (*)(std::span<const char>, const nrb::io::ReadSettings &);

nrb::model::Note note_of(const std::string &data, Reader reader = nrb::io::read) {
    return only_note(reader(StepBuilder::around(data), {}));
}

const std::string frame = "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=AXIS2_PLACEMENT_3D('',#1,$,$);";
const std::string two = "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=CARTESIAN_POINT('',(1.,0.,0.));";

struct Case {
    std::string data;
    Status reason;
    std::string text;
};

void expect_notes(const std::vector<Case> &cases, Reader reader = nrb::io::read) {
    for (const Case &wrong : cases) {
        SCOPED_TRACE(wrong.data);
        const nrb::model::Note note = note_of(wrong.data, reader);
        EXPECT_EQ(note.reason, wrong.reason);
        EXPECT_EQ(note.text, wrong.text);
        EXPECT_EQ(note.entity_type, 0);
    }
}

TEST(StepDamage, values) {
    expect_notes({
        {frame + "#3=CIRCLE('',#2,.T.);", Status::syntax, "#3 CIRCLE: radius: found T, expected a number"},
        {frame + "#3=CIRCLE('',#2,1.5.);", Status::syntax,
         "#3 CIRCLE: radius: found 1.5., expected a number"},
        {frame + "#3=CIRCLE('',#2,1e999);", Status::syntax,
         "#3 CIRCLE: radius: found 1e999, expected a number"},
        {frame + "#3=CIRCLE('',#2,-1.);", Status::length,
         "#3 CIRCLE: radius: found -1, expected a length above 0"},
        {frame + "#3=CIRCLE('',#2);", Status::syntax,
         "#3 CIRCLE: radius: is missing, expected ',' and a value"},
        {frame + "#3=CIRCLE('',#2 1.);", Status::syntax,
         "#3 CIRCLE: radius: found 1., expected ',' and a value"},
        {frame + "#3=CIRCLE;", Status::syntax, "#3 CIRCLE: found ;, expected '(' after the keyword"},
        {frame + "#3=CIRCLE();", Status::syntax, "#3 CIRCLE: name: is missing, expected a value"},
        {frame + "#3=CIRCLE('',2,1.);", Status::syntax,
         "#3 CIRCLE: position: found 2, expected an instance such as #1"},
        {"#1=CARTESIAN_POINT('',(0.,'x',0.));#2=POLYLINE('',(#1,#1));", Status::syntax,
         "#2 POLYLINE: #1 CARTESIAN_POINT: coordinates[1]: found x, expected a number"},
        {"#1=CARTESIAN_POINT('',(0.));#2=POLYLINE('',(#1,#1));", Status::syntax,
         "#2 POLYLINE: #1 CARTESIAN_POINT: coordinates: 1 numbers, expected 2 or 3"},
        {"#1=CARTESIAN_POINT('',(0.,1.,2.,3.));#2=POLYLINE('',(#1,#1));", Status::syntax,
         "#2 POLYLINE: #1 CARTESIAN_POINT: coordinates[3]: more than 3 numbers"},
        {"#1=CARTESIAN_POINT('',(0.,1.,2.;#2=POLYLINE('',(#1,#1));", Status::syntax,
         "#2 POLYLINE: #1 CARTESIAN_POINT: coordinates[2]: is missing, expected ')'"},
    });
}

TEST(StepDamage, references) {
    expect_notes({
        {frame + "#3=CIRCLE('',#9,1.);", Status::syntax, "#3 CIRCLE: position: #9 is not in the file"},
        {frame + "#3=CIRCLE('',#1,1.);", Status::syntax,
         "#3 CIRCLE: position: #1 is a CARTESIAN_POINT, expected an AXIS2_PLACEMENT_2D or _3D"},
        {"#1=FOO();#2=POLYLINE('',(#1,#1));", Status::unsupported,
         "#2 POLYLINE: points[0]: #1 is a FOO, expected a CARTESIAN_POINT"},
        {"#1=SURFACE_CURVE('',#2,(),.U.);#2=SURFACE_CURVE('',#1,(),.U.);#3=EDGE_CURVE('',#4,#4,#1,.T.);"
         "#4=VERTEX_POINT('',#5);#5=CARTESIAN_POINT('',(0.,0.,0.));",
         Status::syntax, "#3 EDGE_CURVE: #1: names itself by way of #2"},
        {"#1=SURFACE_CURVE('',#1,(),.U.);", Status::syntax,
         "#1 SURFACE_CURVE: #1: names itself by way of #1"},
        {frame + "#3=DIRECTION('',(0.,0.,0.));#4=AXIS2_PLACEMENT_3D('',#1,#3,$);#5=CIRCLE('',#4,1.);",
         Status::direction, "#5 CIRCLE: #3 DIRECTION: direction_ratios: all are 0"},
        {frame + "#3=(CIRCLE(1.)CURVE()REPRESENTATION_ITEM(''));", Status::syntax,
         "#3 CIRCLE: no part CONIC"},
    });
}

TEST(StepDamage, counts) {
    const auto curve = [](const std::string &rest) {
        return two + "#3=B_SPLINE_CURVE_WITH_KNOTS(''," + rest + ",.U.);";
    };
    const std::string flags = ",.U.,.F.,.F.,";
    expect_notes({
        {curve("1,(#1,#2)" + flags + "(2,3),(0.,1.)"), Status::count,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: knot_multiplicities: their sum is 5, expected 4, count + degree + 1"},
        {curve("1,(#1,#2)" + flags + "(2,2000000000),(0.,1.)"), Status::multiplicity,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: knot_multiplicities: found 2000000000"},
        {curve("1,(#1,#2)" + flags + "(2,2),(0.,0.5,1.)"), Status::count,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: knots: 3 knots for 2 multiplicities"},
        {curve("2,(#1,#2)" + flags + "(2,2),(0.,1.)"), Status::too_few_points,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: control_points_list: 2 along an axis of degree 2"},
        {curve("99,(#1,#2)" + flags + "(2,2),(0.,1.)"), Status::degree,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: degree: found 99, expected 1 to 31"},
        {curve("1,(#1,#2)" + flags + "(2,2),(1.,0.)"), Status::knots_decreasing,
         "#3 B_SPLINE_CURVE_WITH_KNOTS: knots[2] = 0 is smaller than knots[1] = 1"},
        {two + "#3=BEZIER_CURVE('',2,(#1,#2,#1,#2),.U.,.F.,.F.);", Status::too_few_points,
         "#3 BEZIER_CURVE: control_points_list: 4 along an axis of degree 2, expected a multiple of the "
         "degree and 1 more"},
        {two + "#3=B_SPLINE_CURVE('',1,(#1,#2),.U.,.F.,.F.);", Status::syntax,
         "#3 B_SPLINE_CURVE: says nothing about its knots"},
        {two + "#3=POLYLINE('',(#1));", Status::too_few_points, "#3 POLYLINE: points: fewer than 2 points"},
    });
}

// Faces are read without the colours and solids that name what is missing.
TEST(StepDamage, styles_and_solids) {
    const std::string red = "#3=FILL_AREA_STYLE_COLOUR('',#4);#4=DRAUGHTING_PRE_DEFINED_COLOUR('red');";
    const std::string ball = frame + "#5=SPHERICAL_SURFACE('',#2,1.);#6=ADVANCED_FACE('',(),#5,.T.);";
    expect_notes(
        {
            {ball + red + "#7=STYLED_ITEM('',(#3),#9);", Status::syntax,
             "#7 STYLED_ITEM: item: #9 is not in the file"},
            {ball + red + "#7=STYLED_ITEM('',(#3,#9),#6);", Status::syntax,
             "#7 STYLED_ITEM: styles: #9 is not in the file"},
            {ball + "#7=STYLED_ITEM('',(3),#6);", Status::syntax,
             "#7 STYLED_ITEM: styles[0]: found 3, expected an instance such as #1"},
            {ball + "#7=MANIFOLD_SOLID_BREP('',#9);", Status::syntax,
             "#7 MANIFOLD_SOLID_BREP: outer: #9 is not in the file"},
            {ball + "#7=MANIFOLD_SOLID_BREP('',#8);#8=CLOSED_SHELL('',7);", Status::syntax,
             "#7 MANIFOLD_SOLID_BREP: #8 CLOSED_SHELL: cfs_faces: found 7, expected a list"},
        },
        nrb::io::read_model);
}

// Values behind those that are needed, and parentheses that nobody needs to see closed.
TEST(StepDamage, what_nobody_looks_at_does_no_harm) {
    EXPECT_EQ(only_spline(read(StepBuilder::around(frame + "#3=CIRCLE('',#2,1,5);")))->axes(), 1);
    const std::string open = "#1=CARTESIAN_POINT('',(0.,1.,2.);#2=POLYLINE('',(#1,#1));";
    EXPECT_EQ(only_spline(read(StepBuilder::around(open)))->axes(), 1);
}

// A guard against depth, not the stack, ends this.
TEST(StepDamage, chains_are_followed_to_a_limit) {
    std::string data = two + "#3=POLYLINE('',(#1,#2));";
    for (int i = 4; i < 100; ++i) {
        data += "#" + std::to_string(i) + "=SURFACE_CURVE('',#" + std::to_string(i - 1) + ",(),.U.);";
    }
    EXPECT_EQ(note_of(data).text, "#99 SURFACE_CURVE: #75: lies more than 24 entities deep");
}

// Twelve composite curves of eight times the one before would be 8^12 pieces.
TEST(StepDamage, instances_that_multiply_end_at_a_limit) {
    std::string data =
        "#1=CARTESIAN_POINT('',(0.,0.));#2=CARTESIAN_POINT('',(0.,0.));#3=POLYLINE('',(#1,#2));";
    for (int i = 4; i < 28; i += 2) {
        const std::string segment = "#" + std::to_string(i);
        data += segment + "=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#" + std::to_string(i - 1) + ");#" +
                std::to_string(i + 1) + "=COMPOSITE_CURVE('',(" + segment;
        for (int k = 1; k < 8; ++k) {
            data += "," + segment;
        }
        data += "),.F.);";
    }
    EXPECT_EQ(note_of(data).reason, Status::too_large);
}

TEST(StepDamage, many_faces_of_one_surface_share_its_spline) {
    StepBuilder builder;
    const std::string ball = builder.add("SPHERICAL_SURFACE(''," + builder.some_placement() + ",2.)");
    for (int i = 0; i < 50; ++i) {
        builder.face(ball, {});
    }
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 50U);
    EXPECT_EQ(document.splines.front().spline.use_count(), 50);
}

} // namespace

} // namespace step_damage_test
