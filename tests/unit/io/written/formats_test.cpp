// What holds of the writers of all formats.
#include "base/error.h"
#include "io/formats.h"
#include "io/writers.h"
#include "model/from_faces.h"
#include "support/same_model.h"
#include "support/step_solids.h"
#include "support/written_models.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace written_formats_test {
namespace {

using namespace write_test;

class WrittenFormats : public testing::TestWithParam<int> {
protected:
    static std::string written(const model::Model &model, const io::WriteSettings &settings = {}) {
        return io::write(model, GetParam(), settings);
    }
    [[nodiscard]] static model::Model through(const model::Model &model,
                                              const io::WriteSettings &settings = {}) {
        return io::read_model(written(model, settings), {});
    }
    static void expect_again(const model::Model &model) {
        const std::string text = written(model);
        const model::Model again = io::read_model(text, {});
        EXPECT_EQ(step_test::ModelDifferences(model, again).found(), std::vector<std::string>());
        EXPECT_TRUE(written(again) == text);
    }
    static void expect_refused(const model::Model &model, Status status, const std::string &text) {
        try {
            (void)written(model);
            ADD_FAILURE() << "is written";
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), status);
            EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
        }
    }
    [[nodiscard]] static model::Model cube() { return io::read_model(step_test::step_cube(), {}); }
};

TEST_P(WrittenFormats, WhatTheyCannotHoldIsNamed) {
    const std::vector<double> knots = {0, 0, 1, 1};
    const SplinePtr good = spline_of(3, Form::polynomial, knots, 1, {0, 0, 0, 1, 0, 0});
    expect_refused(list_of({good, spline_of(1, Form::polynomial, knots, 1, {0, 1})}), Status::dimension,
                   "splines[1]: has dimension 1, expected 2 or 3");
    expect_refused(list_of({spline_of(4, Form::polynomial, knots, 1, {0, 0, 0, 0, 1, 0, 0, 0})}),
                   Status::dimension, "splines[0]: has dimension 4, expected 2 or 3");
    const KnotVectorPtr axis = make_knot_vector(1, {0, 0, 1, 1});
    expect_refused(list_of({make_spline({axis, axis}, 2, Form::polynomial, {0, 0, 0, 1, 1, 0, 1, 1})}),
                   Status::dimension, "splines[0]: has dimension 2, expected 3");
    std::vector<double> corners;
    for (int i = 0; i < 8; ++i) {
        corners.insert(corners.end(), {double(i / 4), double(i / 2 % 2), double(i % 2)});
    }
    expect_refused(list_of({make_spline({axis, axis, axis}, 3, Form::polynomial, corners)}), Status::axes,
                   "splines[0]: a volume, which " + std::string(GetParam() == 1 ? "STEP" : "IGES"));
    expect_refused(list_of({spline_of(3, Form::polynomial, {0, 1, 2}, 0, {0, 0, 0, 1, 0, 0})}),
                   Status::degree, "splines[0]: has degree 0");
    expect_refused(list_of({good, good,
                            spline_of(3, Form::homogeneous, {0, 0, 0, 1, 1, 1}, 2,
                                      {0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1})}),
                   Status::weight_sign, "splines[2]: control point 1");
    model::Model sheared = cube();
    sheared.parts = {{}, {}};
    sheared.uses = {{-1, 0, model::Use().placement, ""}, {0, 1, {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, ""}};
    expect_refused(sheared, Status::matrix, "uses[1]: its placement is no similarity");
}

TEST_P(WrittenFormats, SettingsAreChecked) {
    const model::Model model;
    for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(written(model, {wrong, 0}), Error);
        EXPECT_THROW(written(model, {0, wrong}), Error);
    }
    EXPECT_THROW(written(model, {5e-324, 0}), Error);
}

TEST(WrittenFormats, OthersAreRefused) {
    EXPECT_THROW(io::write({}, 0, {}), Error);
    EXPECT_THROW(io::write({}, 3, {}), Error);
}

// A model in another unit is the same in metres, whether the unit has a name or not.
TEST_P(WrittenFormats, UnitsAreConverted) {
    const model::Model model = cube();
    for (const double unit : {1.0, 0.0254, 0.3048, 1e-6, 0.123, 0.9144, 1e-10}) {
        const model::Model again = through(model, {unit, 0});
        EXPECT_EQ(again.metres_per_unit, unit);
        ASSERT_EQ(again.vertices.size(), model.vertices.size());
        ASSERT_EQ(again.faces.size(), 6U);
        const double factor = model.metres_per_unit / unit;
        for (size_t i = 0; i < model.vertices.size(); ++i) {
            EXPECT_EQ(again.vertices[i].x, factor * model.vertices[i].x);
            EXPECT_EQ(again.vertices[i].z, factor * model.vertices[i].z);
        }
        EXPECT_EQ(again.faces[0].shape->kind, model::SurfaceKind::plane);
        EXPECT_NEAR(again.faces[0].face->tolerance(), factor * model.faces[0].face->tolerance(),
                    1e-12 * factor);
        expect_again(through(again));
    }
}

TEST_P(WrittenFormats, TolerancesAreStated) {
    const model::Model again = through(cube(), {0, 0.0123});
    EXPECT_EQ(again.faces[0].face->tolerance(), 0.0123);
    expect_again(again);
}

// The least tolerance is stated, unless readers could not find the largest one from it.
TEST_P(WrittenFormats, FacesMayHaveAnyTolerances) {
    const model::Model again =
        through(model::model_of_faces({square_at(0, 1e-7), square_at(0.05, 0.1)}, 0.001));
    ASSERT_EQ(again.faces.size(), 2U);
    EXPECT_EQ(again.faces[0].face->tolerance(), 1e-5);
    EXPECT_GE(again.faces[1].face->tolerance(), 0.05);
    const model::Model near = model::model_of_faces({square_at(0, 1e-7), square_at(5e-5, 1e-4)}, 0.001);
    EXPECT_EQ(through(near).faces.at(0).face->tolerance(), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(All, WrittenFormats, testing::Values(1, 2));

} // namespace
} // namespace written_formats_test
