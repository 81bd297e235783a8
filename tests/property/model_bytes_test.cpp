// Models as bytes: what they hold comes back, however they were made, and any change is found.
#include "property/bytes.h"
#include "property/models.h"
#include "support/step_solids.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace model_bytes_test {

using namespace support;
using namespace support::models;
using namespace step_test;

namespace {

Bytes bytes_of(const Model &model) {
    return written(nurbs_model_to_bytes, model);
}

std::string face_text(const nurbs_model *model, int64_t i) {
    char name[256] = "";
    require_ok(nurbs_model_face_name(model, i, name, sizeof name, nullptr));
    int64_t part = -1;
    int32_t shape = -1, against = -1;
    double colour[3];
    nurbs_face *face = nullptr;
    require_ok(nurbs_model_face(model, i, &part, &shape, &against, colour, &face));
    nurbs_face_destroy(face);
    std::string text = name;
    for (const double x : {double(part), double(shape), double(against), colour[0], colour[1], colour[2]}) {
        text += " " + std::to_string(x);
    }
    return text;
}

std::string edge_text(const nurbs_model *model, int64_t i) {
    int64_t part = -1, ends[2] = {-2, -2};
    int32_t shape = -1;
    nurbs *curve = nullptr;
    require_ok(nurbs_model_edge(model, i, &part, ends, &shape, &curve));
    const Handle owned(curve);
    std::string text = std::to_string(part) + " " + std::to_string(ends[0]) + " " + std::to_string(ends[1]) +
                       " " + std::to_string(shape);
    for (const Place &place : places_of(model, i)) {
        text +=
            " " + std::to_string(place[0]) + "/" + std::to_string(place[1]) + "/" + std::to_string(place[2]);
    }
    return text;
}

std::string use_text(const nurbs_model *model, int64_t i) {
    int64_t parent = -2, part = -2;
    double placement[12];
    require_ok(nurbs_model_use(model, i, &parent, &part, placement));
    std::string text = std::to_string(parent) + " " + std::to_string(part);
    for (const double x : placement) {
        text += " " + std::to_string(x);
    }
    return text;
}

std::string step_of(const nurbs_model *model) {
    int64_t size = 0;
    require_ok(nurbs_model_write(model, NURBS_FORMAT_STEP, nullptr, 0, nullptr, &size));
    std::string text(static_cast<size_t>(size), ' ');
    require_ok(nurbs_model_write(model, NURBS_FORMAT_STEP, nullptr, size, text.data(), nullptr));
    return text;
}

void expect_same(const nurbs_model *a, const nurbs_model *b) {
    const ModelCounts n = counts_of(a);
    ASSERT_EQ(counts_of(b), n);
    for (int64_t i = 0; i < n.faces; ++i) {
        EXPECT_EQ(face_text(a, i), face_text(b, i));
        EXPECT_EQ(written(nurbs_face_to_bytes, face_of(a, i)), written(nurbs_face_to_bytes, face_of(b, i)));
    }
    for (int64_t i = 0; i < n.edges; ++i) {
        EXPECT_EQ(edge_text(a, i), edge_text(b, i));
        EXPECT_EQ(written(nurbs_to_bytes, edge_of(a, i)), written(nurbs_to_bytes, edge_of(b, i)));
    }
    for (int64_t i = 0; i < n.vertices; ++i) {
        double x[3] = {1, 2, 3}, y[3] = {4, 5, 6};
        require_ok(nurbs_model_vertex(a, i, x));
        require_ok(nurbs_model_vertex(b, i, y));
        EXPECT_TRUE(same_bits(std::vector(x, x + 3), std::vector(y, y + 3)));
    }
    for (int64_t i = 0; i < n.uses; ++i) {
        EXPECT_EQ(use_text(a, i), use_text(b, i));
    }
    EXPECT_EQ(notes_of(a), notes_of(b));
    EXPECT_EQ(area_of(a, 1e-4), area_of(b, 1e-4));
}

Model expect_survives(const Model &model) {
    const Bytes bytes = bytes_of(model);
    Model again;
    EXPECT_EQ(read_bytes(nurbs_model_from_bytes, bytes, again), NURBS_OK) << last_error();
    if (again != nullptr) {
        EXPECT_EQ(bytes_of(again), bytes);
        expect_same(model.get(), again.get());
    }
    return again;
}

TEST(ModelBytes, solids_of_files_survive) {
    for (const std::string &text :
         {step_cube(), step_cylinder(false), step_cylinder(true), step_cone(), step_sphere(true),
          step_sphere(false), step_half_torus(), step_plate(".F.", ".T."), step_polygon(), step_patch()}) {
        const Model model = read_model(text), again = expect_survives(model);
        // Frames by the directions that the file gave; equal splines, which are one in bytes, may be two in a model.
        EXPECT_TRUE(step_of(again.get()) == step_of(model.get()));
    }
}

TEST(ModelBytes, every_change_is_found) {
    Random random(1201000);
    expect_every_change_found<Model>(nurbs_model_from_bytes, random, 1201000,
                                     bytes_of(read_model(step_cylinder(true))));
}

// Faces of one surface hold it once: twice as many take less than the surface more.
TEST(ModelBytes, a_surface_is_stored_once) {
    SplineData data{{1, 1}, {500, 2}, {{0}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (int i = 0; i < 500; ++i) {
        data.knots[0].push_back(i);
        data.points.insert(data.points.end(), {i * 1.0, 0, 0, i * 1.0, 1, 0});
    }
    data.knots[0].push_back(499);
    const Handle surface = create(data);
    std::vector<Face> faces;
    std::vector<const nurbs_face *> handles;
    for (int i = 0; i < 4; ++i) {
        nurbs_face *face = nullptr;
        require_ok(
            nurbs_face_create(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 0, 0, nullptr, &face));
        handles.push_back(faces.emplace_back(face).get());
    }
    const size_t two = bytes_of(model_of({handles[0], handles[1]})).size();
    const Model model = model_of(handles);
    EXPECT_LT(bytes_of(model).size(), two + 8 * data.points.size());
    expect_survives(model);
}

TEST(ModelBytes, real_files_survive) {
    const char *folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        const auto extension = entry.path().extension();
        if (extension == ".stp" || extension == ".step" || extension == ".iges" || extension == ".igs") {
            SCOPED_TRACE(entry.path().filename());
            nurbs_model *model = nullptr;
            require_ok(nurbs_read_model_file(entry.path().c_str(), nullptr, &model));
            expect_survives(Model(model));
        }
    }
}

} // namespace
} // namespace model_bytes_test
