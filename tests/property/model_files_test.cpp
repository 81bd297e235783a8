// Models of STEP files: areas that have a closed form, edges that are used as often as they should be, shapes and sides.
#include "property/models.h"
#include "support/step_solids.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>

namespace model_files_test {

using namespace support;
using namespace support::models;
using namespace step_test;
using std::numbers::pi;

namespace {

struct Expected {
    const char *name;
    std::string text;
    double area;
    int64_t faces, edges, vertices;
    std::vector<int64_t> uses; // how many edges are used never, once, twice
};

std::vector<Expected> solids() {
    const double plate = 16 - pi;
    return {
        {"cube", step_cube(), 24, 6, 12, 8, {0, 0, 12}},
        {"cylinder", step_cylinder(false), 28 * pi, 3, 3, 2, {0, 0, 3}},
        {"cylinder with a seam curve", step_cylinder(true), 28 * pi, 3, 3, 2, {0, 0, 3}},
        {"cone", step_cone(), 24 * pi, 2, 2, 2, {0, 0, 2}},
        {"sphere in a vertex loop", step_sphere(true), 36 * pi, 1, 0, 0, {}},
        {"sphere with its seam", step_sphere(false), 36 * pi, 1, 1, 2, {0, 0, 1}},
        {"half a torus", step_half_torus(), 20 * pi * pi + 40 * pi, 2, 3, 2, {0, 0, 3}},
        {"plate", step_plate(".T.", ".T."), plate, 1, 5, 5, {0, 5}},
        {"plate against its plane", step_plate(".T.", ".F."), plate, 1, 5, 5, {0, 5}},
        {"plate with turned bounds", step_plate(".F.", ".T."), plate, 1, 5, 5, {0, 5}},
        {"plate with both", step_plate(".F.", ".F."), plate, 1, 5, 5, {0, 5}},
        {"polygon", step_polygon(), 4, 1, 0, 0, {}},
        {"patch", step_patch(), (5 * std::sqrt(5.0) - 1) / 12, 1, 3, 3, {0, 3}},
    };
}

// Areas to 1e-10 of them were asked for; trims and radii that are rounded add some eps.
TEST(ModelFiles, areas_have_their_closed_forms) {
    for (const Expected &solid : solids()) {
        SCOPED_TRACE(solid.name);
        const Model model = read_model(solid.text);
        EXPECT_EQ(notes_of(model.get()), std::vector<std::string>{});
        EXPECT_EQ(counts_of(model.get()), (ModelCounts{1, 1, solid.faces, solid.edges, solid.vertices}));
        EXPECT_NEAR(area_of(model.get(), 1e-10), solid.area, 1.1e-10 * solid.area);
        EXPECT_EQ(uses_of(model.get()), solid.uses);
    }
}

TEST(ModelFiles, closed_surfaces_have_their_euler_characteristic) {
    EXPECT_EQ(counts_of(read_model(step_cube()).get()).euler(), 2);
    EXPECT_EQ(counts_of(read_model(step_cylinder(false)).get()).euler(), 2);
    EXPECT_EQ(counts_of(read_model(step_sphere(false)).get()).euler(), 2);
    EXPECT_EQ(counts_of(read_model(step_cone()).get()).euler(), 2);
}

struct Known {
    int32_t shape = -1, against = -1;
    std::string name;
};

Known known_of(const nurbs_model *model, int64_t index) {
    Known known;
    nurbs_face *face = nullptr;
    require_ok(nurbs_model_face(model, index, nullptr, &known.shape, &known.against, nullptr, &face));
    const Face owner(face);
    char name[64];
    require_ok(nurbs_model_face_name(model, index, name, sizeof name, nullptr));
    known.name = name;
    return known;
}

TEST(ModelFiles, faces_keep_the_kinds_of_their_surfaces) {
    const std::pair<std::string, int32_t> first_faces[] = {
        {step_cube(), NURBS_SHAPE_PLANE},       {step_cylinder(false), NURBS_SHAPE_CYLINDER},
        {step_cone(), NURBS_SHAPE_CONE},        {step_sphere(true), NURBS_SHAPE_SPHERE},
        {step_half_torus(), NURBS_SHAPE_TORUS}, {step_patch(), NURBS_SHAPE_NONE},
        {step_polygon(), NURBS_SHAPE_PLANE},
    };
    for (const auto &[text, shape] : first_faces) {
        EXPECT_EQ(known_of(read_model(text).get(), 0).shape, shape);
    }
}

TEST(ModelFiles, faces_say_whether_they_are_against_their_surfaces) {
    for (const char *const bound : {".T.", ".F."}) {
        for (const char *const same : {".T.", ".F."}) {
            EXPECT_EQ(known_of(read_model(step_plate(bound, same)).get(), 0).against, same[1] == 'F');
        }
    }
    const Model cube = read_model(step_cube());
    const char *const names[] = {"x-", "x+", "y-", "y+", "z-", "z+"};
    for (int64_t i = 0; i < 6; ++i) {
        const Known known = known_of(cube.get(), i);
        EXPECT_EQ(known.name, names[i]);
        EXPECT_EQ(known.against, i % 2 == 0);
    }
}

// The key of an edge in a face is its index in the model + 1, and outward normals see it run both ways.
TEST(ModelFiles, keys_name_edges) {
    const Model cube = read_model(step_cube());
    for (int64_t edge = 0; edge < 12; ++edge) {
        int64_t sum = 0;
        for (const Place &at : places_of(cube.get(), edge)) {
            int64_t key = 0;
            nurbs *made = nullptr;
            require_ok(nurbs_face_edge(face_of(cube.get(), at[0]).get(), at[1], at[2], &key, &made));
            const Handle curve(made);
            EXPECT_EQ(std::abs(key), edge + 1);
            EXPECT_TRUE(
                same_bits(homogeneous_points(made), homogeneous_points(edge_of(cube.get(), edge).get())));
            sum += known_of(cube.get(), at[0]).against != 0 ? -key : key;
        }
        EXPECT_EQ(sum, 0);
    }
}

// --- Real files.

struct Real {
    const char *name;
    int64_t faces;
    double area;
    bool closed;
};

TEST(ModelFiles, real_files_have_their_faces_and_areas) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    const Real files[] = {{"boxed_sphere.step", 192, 8.23268, true},
                          {"countersunk_screw.step", 28, 465.6342, true},
                          {"stellarator_magnets.step", 16, 1234696.936, true},
                          {"nacelle.stp", 6, 10920037.32, false},
                          {"satellite_mainbody.stp", 31, 211.8716, true}};
    for (const Real &file : files) {
        SCOPED_TRACE(file.name);
        nurbs_model *made = nullptr;
        require_ok(
            nurbs_read_model_file((std::filesystem::path(folder) / file.name).c_str(), nullptr, &made));
        const Model model(made);
        const ModelCounts n = counts_of(made);
        EXPECT_EQ(n.faces, file.faces);
        EXPECT_NEAR(area_of(made, 1e-7), file.area, 1e-5 * file.area);
        if (file.closed) {
            EXPECT_EQ(uses_of(made), (std::vector<int64_t>{0, 0, n.edges}));
        }
    }
}

} // namespace

} // namespace model_files_test
