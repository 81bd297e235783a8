// Which kinds of entities are read: what is left is as if all had been read.
#include "io/formats.h"
#include "spline/same_numbers.h"
#include "support/iges_solids.h"
#include "support/step_solids.h"

#include <gtest/gtest.h>

namespace kinds_test {
namespace {

using namespace nrb;

io::ReadSettings only(uint32_t kinds) {
    io::ReadSettings settings;
    settings.kinds = kinds;
    return settings;
}

std::string step_cube_and_line() {
    step_test::SolidBuilder b;
    b.add("POLYLINE('',"
          "(" +
          b.point("0.,0.,0.") + "," + b.point("0.,0.,9.") + "))");
    b.add("PLANE(''," + b.level("0.") + ")"); // without ends, which a note tells
    return b.solid(step_test::cube_faces(b, "0.", "2."));
}

std::string iges_cube_and_line() {
    iges_test::CubeBuilder builder;
    builder.line({0, 0, 0}, {0, 0, 9});
    (void)builder.cube();
    return builder.text();
}

class Kinds : public testing::TestWithParam<std::string (*)()> {};

TEST_P(Kinds, OfListsAreCurvesAndSurfaces) {
    const std::string text = GetParam()();
    const model::Model all = io::read(text, {});
    for (const uint32_t kind : {io::kind_curves, io::kind_surfaces}) {
        const int axes = kind == io::kind_curves ? 1 : 2;
        std::vector<model::NamedSpline> expected;
        for (const model::NamedSpline &one : all.splines) {
            if (one.spline->axes() == axes) {
                expected.push_back(one);
            }
        }
        const model::Model some = io::read(text, only(kind | io::kind_faces));
        ASSERT_FALSE(expected.empty());
        ASSERT_EQ(some.splines.size(), expected.size());
        for (size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ(some.splines[i].name, expected[i].name);
            EXPECT_TRUE(same_numbers(*some.splines[i].spline, *expected[i].spline));
        }
    }
    EXPECT_TRUE(io::read(text, only(io::kind_faces)).splines.empty());
}

TEST_P(Kinds, OfModelsAreFacesAndCurves) {
    const std::string text = GetParam()();
    const model::Model all = io::read_model(text, {});
    ASSERT_EQ(all.faces.size(), 6U);
    const model::Model faces = io::read_model(text, only(io::kind_faces));
    EXPECT_EQ(faces.faces.size(), 6U);
    EXPECT_EQ(faces.edges.size(), all.edges.size());
    EXPECT_TRUE(faces.splines.empty());
    EXPECT_TRUE(faces.notes.empty());
    const model::Model curves = io::read_model(text, only(io::kind_curves));
    EXPECT_TRUE(curves.faces.empty() && curves.edges.empty() && curves.vertices.empty());
    ASSERT_EQ(curves.splines.size(), 1U);
    EXPECT_EQ(curves.splines[0].spline->axes(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, Kinds, testing::Values(step_cube_and_line, iges_cube_and_line));

} // namespace
} // namespace kinds_test
