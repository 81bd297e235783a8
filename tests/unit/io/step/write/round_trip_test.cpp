// What is written reads back as it was, and is written again as the same bytes.
#include "io/writers.h"
#include "support/same_model.h"
#include "support/step_reading.h"
#include "support/step_solids.h"

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

TEST(StepRoundTrip, OfRealFiles) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &file : std::filesystem::directory_iterator(folder)) {
        const std::string suffix = file.path().extension().string();
        if (suffix == ".stp" || suffix == ".step") {
            SCOPED_TRACE(file.path());
            std::ifstream in(file.path(), std::ios::binary);
            expect_round_trip({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
        }
    }
}

} // namespace
} // namespace step_round_trip_test
