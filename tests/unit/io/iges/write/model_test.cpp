// What kinds of entities a model becomes, what cannot be written, and parts in parts.
#include "base/error.h"
#include "io/writers.h"
#include "support/iges_solids.h"
#include "support/same_model.h"
#include "support/step_solids.h"
#include "support/written_models.h"

#include <array>
#include <cmath>
#include <random>

namespace iges_write_model_test {
namespace {

using namespace nrb;
using namespace iges_test;
using write_test::list_of;
using write_test::random_motion;
using write_test::spline_of;

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

model::Model cube() {
    CubeBuilder file;
    file.cube();
    return read_model(file);
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
        const double scale = i % 3 == 0 ? 2.5 : (i % 3 == 1 ? 1 : 2 + some(random)),
                     side = i % 2 == 0 ? 1 : -1;
        model::Model model;
        model.metres_per_unit = 0.001;
        model.parts = {{"parent"}, {"child"}};
        model.uses = {{0, 1, random_motion(random, scale, side), ""}, {-1, 0, model::Use().placement, ""}};
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

// However the file ends, it is none.
TEST(IgesWriteModel, EveryTruncationIsRefused) {
    const std::string text = written(step_model(step_test::step_half_torus()));
    for (size_t size = 0; size + 20 < text.size(); size += 7) {
        EXPECT_THROW(io::read_model(text.substr(0, size), {}), Error) << size;
    }
}

} // namespace
} // namespace iges_write_model_test
