// Loops that are open in space: the segments that close them are written as edges.
#include "face/integrals/face_moments.h"
#include "io/writers.h"
#include "model/from_faces.h"
#include "support/same_model.h"
#include "support/step_reading.h"

#include <array>

namespace step_write_gaps_test {
namespace {

using namespace nrb;
using namespace step_test;

using Places = std::vector<std::array<double, 2>>;

std::string written(const model::Model &model) {
    return io::write(model, 1, {});
}

SplinePtr polygon(const Places &corners) {
    std::vector<double> knots{0}, points;
    for (const auto &corner : corners) {
        points.insert(points.end(), corner.begin(), corner.end());
        knots.push_back(static_cast<double>(knots.size() - 1));
    }
    knots.push_back(knots.back());
    return make_spline({make_knot_vector(1, std::move(knots))}, 2, Form::polynomial, std::move(points), {});
}

// z = u v over the unit square, on which the segments of the domain are lines or parabolas.
SplinePtr saddle() {
    const auto axis = [] { return make_knot_vector(1, {0, 0, 1, 1}); };
    return make_spline({axis(), axis()}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1}, {});
}

// A loop of open chains of curves in the domain.
model::Model face_of(const std::vector<Places> &chains) {
    face::FaceParts parts;
    parts.surface = saddle();
    parts.tolerance = 1e-6;
    parts.keep_gaps = true;
    face::Loop &loop = parts.loops.emplace_back();
    for (const Places &chain : chains) {
        loop.push_back({polygon(chain), nullptr});
    }
    return model::model_of_faces({std::make_shared<const face::Face>(std::move(parts), nullptr)}, 0.001);
}

double area_of(const model::Model &model) {
    return face::moments(*model.faces.at(0).face, measure::MomentOrder::content, 1e-12).content;
}

// With as many edges more as there are gaps; after that the model stays as it is.
void expect_closed(const model::Model &open, size_t gaps) {
    const model::Model closed = io::read_model(written(open), {});
    for (const model::Note &note : closed.notes) {
        ADD_FAILURE() << note.text;
    }
    ASSERT_EQ(closed.faces.size(), 1U);
    EXPECT_FALSE(closed.faces[0].face->has_gaps());
    EXPECT_EQ(closed.edges.size(), open.edges.size() + gaps);
    EXPECT_EQ(closed.vertices.size(), open.vertices.size());
    EXPECT_NEAR(area_of(closed), area_of(open), 1e-9 * area_of(open));
    const std::string text = written(closed);
    const model::Model again = io::read_model(text, {});
    EXPECT_EQ(ModelDifferences(closed, again).found(), std::vector<std::string>());
    EXPECT_TRUE(written(again) == text);
}

TEST(StepWriteGaps, BetweenTheLastCurveAndTheFirstOne) {
    expect_closed(face_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}), 1);
    expect_closed(face_of({{{0.1, 0.2}, {0.9, 0.1}, {0.7, 0.8}}}), 1);
}

TEST(StepWriteGaps, BetweenAllCurves) {
    expect_closed(
        face_of({{{0.1, 0}, {0.9, 0}}, {{1, 0.1}, {1, 0.9}}, {{0.9, 1}, {0.1, 1}}, {{0, 0.8}, {0, 0.3}}}), 4);
    expect_closed(face_of({{{0.1, 0.1}, {0.9, 0.1}}, {{0.9, 0.9}, {0.1, 0.7}}}), 2);
}

// Loops that close within the tolerance have no more edges than before.
TEST(StepWriteGaps, NoLargerThanTheToleranceAreNone) {
    expect_closed(face_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 5e-7}}}), 0);
}

} // namespace
} // namespace step_write_gaps_test
