// What is written reads back as it was, and is written again as the same bytes.
#include "face/integrals/face_moments.h"
#include "io/writers.h"
#include "support/same_model.h"
#include "support/step_reading.h"
#include "support/step_solids.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace step_round_trip_test {
namespace {

using namespace nrb;
using namespace step_test;

std::string written(const model::Model &model, const io::WriteSettings &settings = {}) {
    return io::write(model, 1, settings);
}

double area_of(const model::ModelFace &face) {
    return face::moments(*face.face, measure::MomentOrder::content, 1e-12).content;
}

bool elementary(const model::ModelFace &face) {
    return face.shape != nullptr && face.shape->kind != model::SurfaceKind::spline;
}

// Once through a file.
void expect_again(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = io::read_model(text, {});
    EXPECT_EQ(ModelDifferences(model, again).found(), std::vector<std::string>());
    EXPECT_TRUE(written(again) == text);
}

void expect_round_trip(const std::string &text) {
    expect_again(io::read_model(text, {}));
}

TEST(StepRoundTrip, OfSolids) {
    expect_round_trip(step_cube());
    expect_round_trip(step_cylinder(false));
    expect_round_trip(step_cylinder(true));
    expect_round_trip(step_cone());
    expect_round_trip(step_cone(true));
    expect_round_trip(step_sphere(true));
    expect_round_trip(step_sphere(false));
    expect_round_trip(step_half_torus());
    expect_round_trip(step_patch());
}

TEST(StepRoundTrip, OfFacesOnBothSides) {
    for (const char *const bound : {".T.", ".F."}) {
        for (const char *const same : {".T.", ".F."}) {
            expect_round_trip(step_plate(bound, same));
        }
    }
}

// Polygons become edges, which they did not have.
TEST(StepRoundTrip, OfAPolygonGivesEdges) {
    const model::Model model = io::read_model(written(io::read_model(step_polygon(), {})), {});
    EXPECT_EQ(model.edges.size(), 3U);
    expect_again(model);
}

std::vector<std::filesystem::path> real_files(const std::vector<std::string> &suffixes) {
    std::vector<std::filesystem::path> found;
    if (const char *const folder = std::getenv("NURBS_TEST_DATA")) {
        for (const auto &file : std::filesystem::directory_iterator(folder)) {
            if (std::ranges::count(suffixes, file.path().extension().string()) > 0) {
                found.push_back(file.path());
            }
        }
    }
    return found;
}

std::string contents_of(const std::filesystem::path &path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(StepRoundTrip, OfRealFiles) {
    const auto files = real_files({".stp", ".step"});
    if (files.empty()) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &file : files) {
        SCOPED_TRACE(file);
        expect_round_trip(contents_of(file));
    }
}

// Open loops become closed ones, for which edges are added; faces keep their areas, but for curves on elementary surfaces, which
// are made anew with a precision of 2^-22 of their size.
void expect_faces_again(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = io::read_model(text, {});
    ASSERT_EQ(again.faces.size(), model.faces.size());
    EXPECT_TRUE(written(again) == text);
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const double area = area_of(model.faces[i]);
        EXPECT_NEAR(area_of(again.faces[i]), area, (elementary(model.faces[i]) ? 0x1p-22 : 1e-9) * area) << i;
    }
}

TEST(StepRoundTrip, OfRealIgesFiles) {
    const auto files = real_files({".igs", ".iges"});
    if (files.empty()) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &file : files) {
        SCOPED_TRACE(file);
        expect_faces_again(io::read_model(contents_of(file), {}));
    }
}

} // namespace
} // namespace step_round_trip_test
