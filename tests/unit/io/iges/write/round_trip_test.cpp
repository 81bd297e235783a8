// What is written reads back as it was, and is written again as the same bytes.
#include "io/writers.h"
#include "support/iges_solids.h"
#include "support/same_model.h"
#include "support/step_solids.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace iges_round_trip_test {
namespace {

using namespace nrb;
using namespace iges_test;

std::string written(const model::Model &model, const io::WriteSettings &settings = {}) {
    return io::write(model, 2, settings);
}

// Once through a file. Shapes that do not read back bit for bit become splines.
void expect_again(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = io::read_model(text, {});
    for (const std::string &difference : step_test::ModelDifferences(model, again).found()) {
        EXPECT_TRUE(difference.ends_with(": kind")) << difference;
    }
    EXPECT_TRUE(written(again) == text);
}

// Loops whose gaps were kept are closed by edges of their own, and stay so.
void expect_closed(const model::Model &open) {
    const model::Model closed = io::read_model(written(open), {});
    ASSERT_EQ(open.faces.size(), closed.faces.size());
    for (size_t i = 0; i < open.faces.size(); ++i) {
        EXPECT_NEAR(area_of(open.faces[i]), area_of(closed.faces[i]), 1e-9 * area_of(open.faces[i])) << i;
    }
    expect_again(closed);
}

bool has_gaps(const model::Model &model) {
    return std::ranges::any_of(model.faces,
                               [](const model::ModelFace &face) { return face.face->has_gaps(); });
}

void expect_round_trip(const std::string &text) {
    const model::Model model = io::read_model(text, {});
    has_gaps(model) ? expect_closed(model) : expect_again(model);
}

// From another format: the same faces, and from then on the same file.
void expect_same_faces(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = io::read_model(text, {});
    ASSERT_EQ(model.faces.size(), again.faces.size());
    ASSERT_EQ(model.edges.size(), again.edges.size());
    ASSERT_EQ(model.vertices.size(), again.vertices.size());
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const model::ModelFace &a = model.faces[i], &b = again.faces[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.colour, b.colour);
        EXPECT_EQ(a.against, b.against);
        EXPECT_TRUE(same_numbers(*a.face->surface(), *b.face->surface())) << i;
        EXPECT_NEAR(area_of(a), area_of(b), 1e-12 * area_of(a)) << i;
    }
    for (size_t i = 0; i < model.edges.size(); ++i) {
        const Spline &a = *model.edges[i].curve, &b = *again.edges[i].curve;
        EXPECT_TRUE(std::ranges::equal(a.points(), b.points())) << i;
        EXPECT_TRUE(std::ranges::equal(a.weights(), b.weights())) << i;
    }
    EXPECT_TRUE(written(again) == text);
    expect_again(again);
}

TEST(IgesRoundTrip, OfSolids) {
    CubeBuilder cube;
    cube.cube();
    expect_round_trip(cube.text());
}

// With a seam, without edges, and with a hole; alone, so that they are shells of one face.
TEST(IgesRoundTrip, OfFacesAlone) {
    FacesBuilder files[4];
    files[0].cylinder(2, 3);
    files[1].add(196, std::to_string(files[1].add(116, "1.,2.,3.,0")) + ",2.");
    const int64_t square = files[2].square(4);
    files[2].trimmed(
        square, 0,
        {files[2].curve_on_surface(square, files[2].polygon({"0.25,0.25", "0.5,0.25", "0.5,0.5"}), 0, 1)});
    const int64_t around = files[3].cylinder(2, 3);
    files[3].trimmed(around, files[3].curve_on_surface(
                                 around, files[3].polygon({"0.,1.", "1.,2.", "1.,4.", "0.,3."}), 0, 1));
    for (const FacesBuilder &file : files) {
        const model::Model model = io::read_model(file.text(), {});
        EXPECT_EQ(model.faces.size(), 1U);
        expect_again(model);
    }
}

// Curves in domains are read as they are written, though near the ends of a domain files with few digits mean the ends.
TEST(IgesRoundTrip, OfCurvesNextToTheEndsOfADomain) {
    model::Model model = [] {
        CubeBuilder cube;
        cube.cube();
        return io::read_model(cube.text(), {});
    }();
    face::FaceParts parts{model.faces[0].face->surface(), {}};
    for (const face::Loop &loop : model.faces[0].face->loops()) {
        parts.loops.push_back(loop);
    }
    parts.tolerance = model.faces[0].face->tolerance();
    const SplinePtr &curve = parts.loops[0][0].curve;
    std::vector<double> points(curve->points().begin(), curve->points().end());
    for (double &x : points) {
        x = x == 0 ? 1e-11 : x;
    }
    parts.loops[0][0].curve = make_spline(curve->knot_vectors(), 2, Form::polynomial, points);
    model.faces[0].face = std::make_shared<const face::Face>(std::move(parts), nullptr);
    expect_again(model);
}

TEST(IgesRoundTrip, OfSolidsOfStepFiles) {
    for (const std::string &text :
         {step_test::step_cube(), step_test::step_cylinder(false), step_test::step_cylinder(true),
          step_test::step_cone(), step_test::step_cone(true), step_test::step_sphere(true),
          step_test::step_sphere(false), step_test::step_half_torus(), step_test::step_patch()}) {
        SCOPED_TRACE(text.substr(0, 3000));
        expect_same_faces(io::read_model(text, {}));
    }
}

TEST(IgesRoundTrip, OfFacesOnBothSides) {
    for (const char *const bound : {".T.", ".F."}) {
        for (const char *const same : {".T.", ".F."}) {
            expect_same_faces(io::read_model(step_test::step_plate(bound, same), {}));
        }
    }
}

TEST(IgesRoundTrip, OfRealFiles) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &file : std::filesystem::directory_iterator(folder)) {
        const std::string suffix = file.path().extension().string();
        const bool iges = suffix == ".igs" || suffix == ".iges", step = suffix == ".stp" || suffix == ".step";
        if (iges || step) {
            SCOPED_TRACE(file.path());
            std::ifstream in(file.path(), std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
            iges ? expect_round_trip(text) : expect_same_faces(io::read_model(text, {}));
        }
    }
}

} // namespace
} // namespace iges_round_trip_test
