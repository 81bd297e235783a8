// What kinds of entities a model becomes, what cannot be written, and parts in parts.
#include "base/error.h"
#include "io/writers.h"
#include "model/shapes/surface_spline.h"
#include "support/same_model.h"
#include "support/step_reading.h"
#include "support/step_solids.h"
#include "support/written_models.h"

#include <array>
#include <cmath>
#include <random>

namespace step_write_model_test {
namespace {

using namespace nrb;
using namespace step_test;
using write_test::list_of;
using write_test::random_motion;
using write_test::spline_of;

std::string written(const model::Model &model, const io::WriteSettings &settings = {}) {
    return io::write(model, 1, settings);
}

int64_t count(const std::string &text, const std::string &what) {
    int64_t found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++found;
    }
    return found;
}

void expect_again(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = io::read_model(text, {});
    EXPECT_EQ(ModelDifferences(model, again).found(), std::vector<std::string>());
    EXPECT_TRUE(written(again) == text);
}

TEST(StepWriteModel, ClosedFacesAreASolidAndOthersAShell) {
    const std::string cube = written(io::read_model(step_cube(), {}));
    EXPECT_EQ(count(cube, "=MANIFOLD_SOLID_BREP("), 1);
    EXPECT_EQ(count(cube, "=CLOSED_SHELL("), 1);
    EXPECT_EQ(count(cube, "=ADVANCED_BREP_SHAPE_REPRESENTATION("), 1);
    EXPECT_EQ(count(cube, "=EDGE_CURVE("), 12);
    EXPECT_EQ(count(cube, "=VERTEX_POINT("), 8);
    EXPECT_EQ(count(cube, "=PLANE("), 6);
    EXPECT_EQ(count(cube, "=LINE("), 12);
    EXPECT_EQ(count(cube, "B_SPLINE"), 0);
    const std::string plate = written(io::read_model(step_plate(".T.", ".T."), {}));
    EXPECT_EQ(count(plate, "=SHELL_BASED_SURFACE_MODEL("), 1);
    EXPECT_EQ(count(plate, "=OPEN_SHELL("), 1);
    EXPECT_EQ(count(plate, "=MANIFOLD_SURFACE_SHAPE_REPRESENTATION("), 1);
    EXPECT_EQ(count(written(io::read_model(step_sphere(true), {})), "=VERTEX_LOOP("), 1);
    EXPECT_EQ(count(written(io::read_model(step_sphere(true), {})), "=MANIFOLD_SOLID_BREP("), 1);
}

TEST(StepWriteModel, FacesThatAreTurnedInsideOutAreNoSolid) {
    model::Model cube = io::read_model(step_cube(), {});
    cube.faces[2].against = !cube.faces[2].against;
    EXPECT_EQ(count(written(cube), "=CLOSED_SHELL("), 0);
}

TEST(StepWriteModel, PartsOfOneModelAreProducts) {
    model::Model model = io::read_model(step_cube(), {});
    model.parts[0].name = "bolt's \xC3\xA9";
    model.parts.push_back({"case"});
    model.parts.push_back({"bolt's \xC3\xA9"});
    const double c = std::cos(0.3), s = std::sin(0.3);
    model.uses = {{1, 0, {c, -s, 0, 1, s, c, 0, 2, 0, 0, 1, 3}, ""},
                  {1, 0, {1, 0, 0, -5, 0, 1, 0, 0, 0, 0, 1, 0}, ""},
                  {1, 2, {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 7}, ""},
                  {1, 2, {2 * c, -2 * s, 0, 0, 2 * s, 2 * c, 0, 0, 0, 0, 2, 7}, ""},
                  {-1, 1, model::Use().placement, ""}};
    const std::string text = written(model);
    EXPECT_EQ(count(text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE("), 2);
    EXPECT_EQ(count(text, "=MAPPED_ITEM("), 2);
    EXPECT_EQ(count(text, "=PRODUCT("), 3);
    expect_again(model);
}

// The whole becomes a part where a part stands in it in another way than once and unmoved.
TEST(StepWriteModel, PartsThatAreMovedInTheWhole) {
    model::Model model = io::read_model(step_cube(), {});
    model.uses = {{-1, 0, {1, 0, 0, 4, 0, 1, 0, 0, 0, 0, 1, 0}, ""}, {-1, 0, model::Use().placement, ""}};
    const model::Model again = io::read_model(written(model), {});
    ASSERT_EQ(again.parts.size(), 2U);
    ASSERT_EQ(again.uses.size(), 3U);
    EXPECT_EQ(again.uses[0].parent, 1);
    EXPECT_EQ(again.uses[0].placement, model.uses[0].placement);
    EXPECT_EQ(again.uses[2].parent, -1);
    EXPECT_EQ(again.uses[2].part, 1);
    expect_again(again);
}

// Also where vertices that are not the same are at the same place, and where a polygon has corners at later
// ones.
TEST(StepWriteModel, EdgesEndAtTheirVertices) {
    SolidBuilder file;
    const std::string low = file.vertex("0.,0.,0."), twin = file.vertex("0.,-0.,0."),
                      high = file.vertex("0.,0.,4."), far = file.vertex("4.,0.,0.");
    file.curve_edge(low, high, file.line("0.,0.,0.", "0.,0.,1."));
    file.curve_edge(twin, far, file.line("0.,0.,0.", "1.,0.,0."));
    const std::string corners =
        file.point("4.,0.,0.") + "," + file.point("0.,4.,0.") + "," + file.point("0.,0.,4.");
    const std::string loop = file.add("POLY_LOOP('',(" + corners + "))");
    const std::string slope =
        file.add("PLANE(''," + file.placement("4.,0.,0.", "1.,1.,1.", "-1.,1.,0.") + ")");
    const model::Model model =
        io::read_model(file.solid({file.bounded_face(slope, {{{}, ".T.", loop}})}), {});
    ASSERT_EQ(model.vertices.size(), 4U);
    for (const int32_t format : {1, 2}) {
        const model::Model again = io::read_model(io::write(model, format, {}), {});
        ASSERT_GE(again.edges.size(), 3U);
        for (const model::Edge &edge : again.edges) {
            const Interval domain = edge.curve->axis(0).domain();
            const auto vertex = [&](size_t end) {
                return again.vertices.at(static_cast<size_t>(edge.vertices[end]));
            };
            spline_checks::expect_near(spline_checks::point_of(*edge.curve, domain.lower), vertex(0), 1e-12);
            spline_checks::expect_near(spline_checks::point_of(*edge.curve, domain.upper), vertex(1), 1e-12);
        }
    }
}

TEST(StepWriteModel, RandomMotionsReadBackBitForBit) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const double scale = i % 3 == 0 ? 2.5 : 1, side = i % 2 == 0 ? 1 : -1;
        model::Model model;
        model.metres_per_unit = 0.001;
        model.parts = {{"child"}, {"parent"}};
        model.uses = {{1, 0, random_motion(random, scale, side), ""}, {-1, 1, model::Use().placement, ""}};
        const model::Model once = io::read_model(written(model), {});
        for (size_t k = 0; k < 12; ++k) {
            EXPECT_NEAR(once.uses[0].placement[k], model.uses[0].placement[k], 4 * 0x1p-52 * scale);
        }
        expect_again(once);
    }
}

TEST(StepWriteModel, ColoursAreWrittenOncePerColour) {
    model::Model cube = io::read_model(step_cube(), {});
    for (size_t i = 0; i < 5; ++i) {
        cube.faces[i].colour = std::array{i < 3 ? 0.1 : 1.0, 0.25, 1.0 / 3};
    }
    EXPECT_EQ(count(written(cube), "=COLOUR_RGB("), 2);
    EXPECT_EQ(count(written(cube), "=STYLED_ITEM("), 5);
    expect_again(cube);
}

TEST(StepWriteModel, HostileNames) {
    model::Model cube = io::read_model(step_cube(), {});
    const char *const names[] = {"it's",    "a\\b",          "\xE6\xB0\xB4 \xF0\x9F\x94\xA9",
                                 "ENDSEC;", "/* no comment", "#7"};
    for (size_t i = 0; i < 6; ++i) {
        cube.faces[i].name = names[i];
    }
    expect_again(cube);
    cube.faces[0].name = " \n";
    cube.faces[1].name = "\xFF\t";
    const model::Model again = io::read_model(written(cube), {});
    EXPECT_EQ(again.faces[1].name, "\xC3\xBF?");
    expect_again(again);
}

TEST(StepWriteModel, SplinesReadBack) {
    const std::vector<double> points = {0, 0, 0, 0.1, 1.0 / 3, -0.0, 2, 1e-300, 1e300, 3, 0, 1};
    const std::vector<double> knots = {0, 0, 0, 0.7, 1, 1, 1};
    expect_again([&] {
        model::Model model =
            list_of({spline_of(3, Form::polynomial, knots, 2, points),
                     spline_of(3, Form::rational, knots, 2, points, {1, 0.1, 3, 1}),
                     spline_of(3, Form::polynomial, {-3, 0.1, 0.5, 0.7, 0.9, 1, 8}, 2, points)});
        model.metres_per_unit = 0.001;
        model.parts = {{""}};
        model.uses = {{}};
        return model;
    }());
}

// But for the rounding of readers, which convert them to metres and back; what has been read is read again.
TEST(StepWriteModel, StatedTolerancesAreRead) {
    const model::Model cube = io::read_model(step_cube(), {});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> some(0.01, 0.1);
    for (int i = 0; i < 50; ++i) {
        const double tolerance = some(random), unit = i % 2 == 0 ? 0.001 : 0.0123;
        const model::Model again = io::read_model(written(cube, {unit, tolerance}), {});
        EXPECT_NEAR(again.faces[0].face->tolerance(), tolerance, 0x1p-52 * tolerance);
        expect_again(again);
    }
}

// A cone without a seam has its apex as a vertex, without which readers would not know how far it goes.
TEST(StepWriteModel, TheApexOfAConeIsAVertex) {
    SolidBuilder file;
    const std::string rim = file.vertex("3.,0.,0."), apex = file.vertex("0.,0.,-4.");
    const std::string circle = file.curve_edge(rim, rim, file.circle(file.level("0."), "3."));
    const std::string cone = file.add("CONICAL_SURFACE(''," + file.level("0.") + ",3.,0.6435011087932844)");
    const std::string tip = file.add("VERTEX_LOOP(''," + apex + ")");
    const std::string text = file.solid({file.bounded_face(cone, {{{{circle, ".F."}}}, {{}, ".T.", tip}})});
    const model::Model model = io::read_model(text, {});
    ASSERT_EQ(model.faces.size(), 1U);
    EXPECT_EQ(count(written(model), "=VERTEX_LOOP("), 1);
    expect_again(model);
}

// However the file ends, it is none.
TEST(StepWriteModel, EveryTruncationIsRefused) {
    const std::string text = written(io::read_model(step_half_torus(), {}));
    for (size_t size = 0; size + 1 < text.size(); size += 7) {
        EXPECT_THROW(io::read_model(text.substr(0, size), {}), Error) << size;
    }
}

} // namespace
} // namespace step_write_model_test
