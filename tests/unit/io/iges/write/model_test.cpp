// What kinds of entities a model becomes, what cannot be written, and parts in parts.
#include "base/error.h"
#include "build/placement.h"
#include "io/writers.h"
#include "model/from_faces.h"
#include "support/iges_solids.h"
#include "support/same_model.h"
#include "support/step_solids.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace iges_write_model_test {
namespace {

using namespace nrb;
using namespace iges_test;

std::string written(const model::Model &model, const io::WriteSettings &settings = {}) {
    return io::write(model, 2, settings);
}

model::Model step_model(const std::string &text) {
    return io::read_model(text, {});
}

// Directory entries of a type, and of a form of it.
int64_t count(const std::string &text, int type, int form = -1) {
    int64_t found = 0;
    for (size_t at = 0; at + 162 <= text.size(); at += 81) {
        const std::string first = text.substr(at, 80), second = text.substr(at + 81, 80);
        if (first[72] == 'D' && (first[79] - '0') % 2 == 1 && std::stoi(first.substr(0, 8)) == type) {
            found += form < 0 || std::stoi(second.substr(32, 8)) == form ? 1 : 0;
        }
    }
    return found;
}

void expect_again(const model::Model &model) {
    const std::string text = written(model);
    const model::Model again = read_model(text);
    EXPECT_EQ(step_test::ModelDifferences(model, again).found(), std::vector<std::string>());
    EXPECT_TRUE(written(again) == text);
}

// As it comes out of an IGES file: from then on nothing changes.
model::Model settled(const model::Model &model) {
    return read_model(written(model));
}

model::Model cube() {
    CubeBuilder file;
    file.cube();
    return read_model(file);
}

SplinePtr spline_of(int dim, Form form, std::vector<double> knots, int degree, std::vector<double> points,
                    std::vector<double> weights = {}) {
    return make_spline({make_knot_vector(degree, std::move(knots))}, dim, form, std::move(points),
                       std::move(weights));
}

model::Model list_of(std::vector<SplinePtr> splines) {
    model::Model model;
    for (SplinePtr &spline : splines) {
        model.splines.push_back({"s" + std::to_string(model.splines.size()), std::move(spline)});
    }
    return model;
}

TEST(IgesWriteModel, ClosedFacesAreASolidAndOthersAShell) {
    const std::string text = written(step_model(step_test::step_cube()));
    EXPECT_EQ(count(text, 186), 1);
    EXPECT_EQ(count(text, 514, 1), 1);
    EXPECT_EQ(count(text, 510), 6);
    EXPECT_EQ(count(text, 508), 6);
    EXPECT_EQ(count(text, 504), 1);
    EXPECT_EQ(count(text, 502), 1);
    EXPECT_EQ(count(text, 190, 1), 6);
    EXPECT_EQ(count(text, 110), 12);
    EXPECT_EQ(count(text, 126) + count(text, 128), 0);
    const std::string plate = written(step_model(step_test::step_plate(".T.", ".T.")));
    EXPECT_EQ(count(plate, 186), 0);
    EXPECT_EQ(count(plate, 514, 2), 1);
}

TEST(IgesWriteModel, ElementarySurfacesStayWhatTheyAre) {
    EXPECT_EQ(count(written(step_model(step_test::step_cylinder(true))), 192, 1), 1);
    EXPECT_EQ(count(written(step_model(step_test::step_cone())), 194, 1), 1);
    EXPECT_EQ(count(written(step_model(step_test::step_sphere(true))), 196, 1), 1);
    EXPECT_EQ(count(written(step_model(step_test::step_half_torus())), 198, 1), 1);
    EXPECT_EQ(count(written(step_model(step_test::step_cylinder(true))), 100), 2);
}

TEST(IgesWriteModel, FacesThatAreTurnedInsideOutAreNoSolid) {
    model::Model model = cube();
    model.faces[2].against = !model.faces[2].against;
    EXPECT_EQ(count(written(model), 186), 0);
}

TEST(IgesWriteModel, CurvesInDomainsAreInTheParameterPlane) {
    const std::string text = written(cube());
    int64_t found = 0;
    for (size_t at = text.find("00010500"); at != std::string::npos; at = text.find("00010500", at + 1)) {
        ++found;
    }
    EXPECT_EQ(found, 24);
}

// Three deep, mirrored, scaled and turned.
TEST(IgesWriteModel, PartsAreSubfigures) {
    model::Model model = cube();
    model.parts = {{"whole"}, {"bolt's \xC3\xA9"}, {"case"}, {"bolt's \xC3\xA9"}};
    for (model::ModelFace &face : model.faces) {
        face.part = 3;
    }
    for (model::Edge &edge : model.edges) {
        edge.part = 3;
    }
    const double c = std::cos(0.3), s = std::sin(0.3);
    model.uses = {{0, 1, {c, -s, 0, 1, s, c, 0, 2, 0, 0, 1, 3}, "one"},
                  {1, 2, {1, 0, 0, -5, 0, 1, 0, 0, 0, 0, 1, 0}, "two"},
                  {2, 3, {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 7}, "three"},
                  {2, 3, {2.5, 0, 0, 0, 0, 2.5, 0, 0, 0, 0, 2.5, 7}, "four"},
                  {-1, 0, model::Use().placement, ""}};
    const std::string text = written(model);
    EXPECT_EQ(count(text, 308), 3);
    EXPECT_EQ(count(text, 408), 4);
    EXPECT_EQ(count(text, 124, 1), 1);
    EXPECT_EQ(count(text, 124, 0), 1);
    EXPECT_NE(text.find("308,2,"), std::string::npos); // how deep the first one is
    expect_again(model);
}

// A first part that is moved, or is in another one, is a subfigure too.
TEST(IgesWriteModel, PartsThatAreMovedInTheWhole) {
    model::Model model = cube();
    model.parts[0].name = "cube";
    model.uses = {{-1, 0, {1, 0, 0, 4, 0, 1, 0, 0, 0, 0, 1, 0}, ""}, {-1, 0, model::Use().placement, ""}};
    const model::Model again = read_model(written(model));
    ASSERT_EQ(again.parts.size(), 2U);
    EXPECT_EQ(again.parts[1].name, "cube");
    ASSERT_EQ(again.uses.size(), 3U);
    EXPECT_EQ(again.uses[0].parent, 0);
    EXPECT_EQ(again.uses[0].placement, model.uses[0].placement);
    EXPECT_EQ(again.faces[0].part, 1);
    expect_again(again);
}

TEST(IgesWriteModel, RandomMotionsReadBackBitForBit) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> some(-1, 1);
    for (int i = 0; i < 300; ++i) {
        const double axis[] = {some(random), some(random), some(random)},
                     x[] = {some(random), some(random), some(random)},
                     at[] = {100 * some(random), some(random), some(random)};
        const build::Placement frame = build::make_placement(3, at, axis, x, "origin");
        const Vector3 y = cross(frame.z, frame.x);
        const double scale = i % 3 == 0 ? 2.5 : (i % 3 == 1 ? 1 : 2 + some(random)),
                     side = i % 2 == 0 ? 1 : -1;
        model::Model model;
        model.metres_per_unit = 0.001;
        model.parts = {{"parent"}, {"child"}};
        model.uses = {{0,
                       1,
                       {scale * frame.x.x, side * scale * y.x, scale * frame.z.x, at[0], scale * frame.x.y,
                        side * scale * y.y, scale * frame.z.y, at[1], scale * frame.x.z, side * scale * y.z,
                        scale * frame.z.z, at[2]},
                       ""},
                      {-1, 0, model::Use().placement, ""}};
        const model::Model once = read_model(written(model));
        EXPECT_TRUE(written(once) == written(model));
        for (size_t k = 0; k < 12; ++k) {
            EXPECT_NEAR(once.uses[0].placement[k], model.uses[0].placement[k], 1e-11 * scale);
            if (i % 3 == 1) {
                EXPECT_EQ(once.uses[0].placement[k], model.uses[0].placement[k]);
            }
        }
        expect_again(once);
    }
}

TEST(IgesWriteModel, ColoursAreWrittenOncePerColour) {
    model::Model model = cube();
    for (size_t i = 0; i < 5; ++i) {
        model.faces[i].colour = std::array{i < 3 ? 0.1 : 1.0, 0.25, 0.5};
    }
    EXPECT_EQ(count(written(model), 314), 2);
    expect_again(model);
}

TEST(IgesWriteModel, HostileNames) {
    model::Model model = cube();
    const std::string long_name(200, 'n');
    const char *const names[] = {"it's",       ",;5Hab", "\xE6\xB0\xB4 \xF0\x9F\x94\xA9",
                                 "S      1\\", "510#7",  long_name.c_str()};
    for (size_t i = 0; i < 6; ++i) {
        model.faces[i].name = names[i];
    }
    model.parts[0].name = "prod;uct,1H";
    expect_again(model);
    model.faces[0].name = " \n";
    model.faces[1].name = "\xFF\t";
    const model::Model again = read_model(written(model));
    EXPECT_EQ(again.faces[1].name, "\xFF?");
    expect_again(again);
}

// Those without a name have the type and the number of their entity.
TEST(IgesWriteModel, NamesThatReadersGiveAreLeftOut) {
    model::Model model = cube();
    for (model::ModelFace &face : model.faces) {
        face.name.clear();
    }
    const std::string text = written(model);
    EXPECT_EQ(count(text, 406), 0);
    EXPECT_EQ(count(written(read_model(text)), 406), 0);
}

const std::vector<double> knots = {0, 0, 0, 0.7, 1, 1, 1};
const std::vector<double> points = {0, 0, 0, 0.1, 1.0 / 3, -0.0, 2, 1e-300, 1e300, 3, 0, 1};

TEST(IgesWriteModel, CurvesReadBack) {
    model::Model model = list_of({spline_of(3, Form::polynomial, knots, 2, points),
                                  spline_of(3, Form::rational, knots, 2, points, {1, 0.1, 3, 1}),
                                  spline_of(3, Form::polynomial, {-3, 0.1, 0.5, 0.7, 0.9, 1, 8}, 2, points),
                                  spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1, {0, 0, 0, 1, 2, 3})});
    model.metres_per_unit = 0.001;
    model.parts = {{"p"}};
    model.uses = {{}};
    expect_again(model);
}

// Lists have surfaces too, and periodic axes stay periodic.
TEST(IgesWriteModel, ListsReadBack) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-1, 1);
    std::vector<SplinePtr> all;
    for (int i = 0; i < 40; ++i) {
        const bool around = i % 2 == 0, rational = i % 3 == 0;
        std::vector<double> u = {-3, -2, -1, 0, 1, 2, 3, 4, 5}, net, weights;
        for (int64_t j = 0; j < 6 * 3; ++j) {
            const bool again = around && j >= 9; // the first three rows
            for (int c = 0; c < 3; ++c) {
                net.push_back(again ? net[static_cast<size_t>(3 * (j - 9) + c)] : some(random));
            }
            weights.push_back(again ? weights[static_cast<size_t>(j - 9)] : 2 + some(random));
        }
        u = around ? std::vector<double>{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6}
                   : std::vector<double>{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
        all.push_back(make_spline(
            {std::make_shared<const KnotVector>(3, u, around), make_knot_vector(1, {0, 0, 0.3, 2, 2})}, 3,
            rational ? Form::rational : Form::polynomial, net, rational ? weights : std::vector<double>()));
    }
    const model::Model list = list_of(all);
    const model::Model again = io::read(written(list), {});
    ASSERT_EQ(again.splines.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(again.splines[i].name, list.splines[i].name);
        EXPECT_TRUE(same_numbers(*again.splines[i].spline, *all[i])) << i;
        EXPECT_EQ(again.splines[i].spline->axis(0).periodic(), all[i]->axis(0).periodic()) << i;
    }
    EXPECT_TRUE(written(again) == written(list));
}

// Edges that no face uses stand in the list of edges.
TEST(IgesWriteModel, EdgesWithoutFacesStay) {
    model::Model model = cube();
    model::Edge edge;
    edge.curve = spline_of(3, Form::polynomial, knots, 2, {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0});
    edge.vertices = {8, 9};
    model.edges.push_back(edge);
    model.vertices.push_back({0, 0, 0});
    model.vertices.push_back({3, 0, 0});
    const model::Model again = read_model(written(model));
    ASSERT_EQ(again.edges.size(), 13U);
    EXPECT_TRUE(again.edges[12].uses.empty());
    EXPECT_TRUE(again.splines.empty());
    expect_again(again);
}

void expect_refused(const model::Model &model, Status status, const std::string &text) {
    try {
        written(model);
        ADD_FAILURE() << "is written";
    } catch (const Error &error) {
        EXPECT_EQ(error.status(), status);
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
}

TEST(IgesWriteModel, WhatIgesCannotHoldIsNamed) {
    const SplinePtr good = spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1, {0, 0, 0, 1, 0, 0});
    expect_refused(list_of({good, spline_of(2, Form::polynomial, {0, 0, 1, 1}, 1, {0, 0, 1, 0})}),
                   Status::dimension, "splines[1]: has dimension 2, expected 3");
    const KnotVectorPtr axis = make_knot_vector(1, {0, 0, 1, 1});
    std::vector<double> corners;
    for (int i = 0; i < 8; ++i) {
        corners.insert(corners.end(), {double(i / 4), double(i / 2 % 2), double(i % 2)});
    }
    expect_refused(list_of({make_spline({axis, axis, axis}, 3, Form::polynomial, corners)}), Status::axes,
                   "splines[0]: a volume, which IGES");
    expect_refused(list_of({spline_of(3, Form::polynomial, {0, 1, 2}, 0, {0, 0, 0, 1, 0, 0})}),
                   Status::degree, "splines[0]: has degree 0");
    expect_refused(list_of({good, good,
                            spline_of(3, Form::homogeneous, {0, 0, 0, 1, 1, 1}, 2,
                                      {0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1})}),
                   Status::weight_sign, "splines[2]: control point 1");
    model::Model sheared = cube();
    sheared.parts = {{}, {}};
    sheared.uses = {{-1, 0, model::Use().placement, ""}, {0, 1, {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, ""}};
    expect_refused(sheared, Status::matrix, "uses[1]: its placement is no similarity, which IGES needs");
}

TEST(IgesWriteModel, SettingsAreChecked) {
    const model::Model model;
    for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(written(model, {wrong, 0}), Error);
        EXPECT_THROW(written(model, {0, wrong}), Error);
    }
    EXPECT_THROW(written(model, {5e-324, 0}), Error);
    EXPECT_THROW(io::write(model, 3, {}), Error);
}

// A model in another unit is the same in metres, whether the unit has a number or not.
TEST(IgesWriteModel, UnitsAreConverted) {
    const model::Model model = step_model(step_test::step_cube());
    for (const double unit : {1.0, 0.0254, 0.3048, 1e-6, 0.123, 0.9144, 1e-10}) {
        const model::Model again = read_model(written(model, {unit, 0}));
        EXPECT_EQ(again.metres_per_unit, unit);
        ASSERT_EQ(again.vertices.size(), model.vertices.size());
        const double factor = model.metres_per_unit / unit;
        for (size_t i = 0; i < model.vertices.size(); ++i) {
            EXPECT_EQ(again.vertices[i].x, factor * model.vertices[i].x);
            EXPECT_EQ(again.vertices[i].z, factor * model.vertices[i].z);
        }
        ASSERT_EQ(again.faces.size(), 6U);
        EXPECT_EQ(again.faces[0].shape->kind, model::SurfaceKind::plane);
        EXPECT_NEAR(again.faces[0].face->tolerance(), factor * model.faces[0].face->tolerance(),
                    1e-12 * factor);
        expect_again(settled(again));
    }
}

TEST(IgesWriteModel, TolerancesAreStated) {
    const model::Model again = read_model(written(cube(), {0, 0.0123}));
    EXPECT_EQ(again.faces[0].face->tolerance(), 0.0123);
    expect_again(again);
}

// A square at a height, on the plane z = 0.
face::FacePtr square_at(double height, double tolerance) {
    face::FaceParts parts;
    const auto axis = [] { return make_knot_vector(1, {0, 0, 1, 1}); };
    parts.surface =
        make_spline({axis(), axis()}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, {});
    const double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    face::Loop &loop = parts.loops.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        const auto &a = corners[i], &b = corners[i + 1];
        loop.push_back({nullptr, spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1,
                                           {a[0], a[1], height, b[0], b[1], height})});
    }
    parts.tolerance = tolerance;
    return std::make_shared<const face::Face>(std::move(parts), nullptr);
}

// The least tolerance is stated, unless readers could not find the largest one from it.
TEST(IgesWriteModel, FacesMayHaveAnyTolerances) {
    const model::Model model = model::model_of_faces({square_at(0, 1e-7), square_at(0.05, 0.1)}, 0.001);
    const model::Model again = read_model(written(model));
    ASSERT_EQ(again.faces.size(), 2U);
    EXPECT_EQ(again.faces[0].face->tolerance(), 1e-5);
    EXPECT_GE(again.faces[1].face->tolerance(), 0.05);
    const model::Model near = model::model_of_faces({square_at(0, 1e-7), square_at(5e-5, 1e-4)}, 0.001);
    EXPECT_EQ(read_model(written(near)).faces.at(0).face->tolerance(), 1e-7);
}

// However the file ends, it is none.
TEST(IgesWriteModel, EveryTruncationIsRefused) {
    const std::string text = written(step_model(step_test::step_half_torus()));
    for (size_t size = 0; size + 20 < text.size(); size += 7) {
        EXPECT_THROW(io::read_model(text.substr(0, size), {}), Error) << size;
    }
}

} // namespace
} // namespace iges_write_model_test
