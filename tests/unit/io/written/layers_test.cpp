// Layers: of what a file puts into them, through both formats.
#include "io/formats.h"
#include "io/writers.h"
#include "support/iges_solids.h"
#include "support/same_model.h"
#include "support/step_solids.h"
#include "support/written_models.h"

namespace written_layers_test {
namespace {

using namespace write_test;
using Numbers = std::vector<int64_t>;

class WrittenLayers : public testing::TestWithParam<int> {
protected:
    static void expect_again(const model::Model &model) {
        const std::string text = io::write(model, GetParam(), {});
        const model::Model again = io::read_model(text, {});
        EXPECT_TRUE(again.notes.empty());
        EXPECT_EQ(step_test::ModelDifferences(model, again).found(), std::vector<std::string>());
        EXPECT_TRUE(io::write(again, GetParam(), {}) == text);
    }
};

model::Model cube() {
    return io::read_model(step_test::step_cube(), {});
}

TEST_P(WrittenLayers, ComeBack) {
    for (const std::vector<std::string> &names : {std::vector<std::string>{"7"},
                                                  {"walls", "roof"},
                                                  {"1", "b", "2", "30", "3", "it's \xC3\xA9"},
                                                  {"999999", "1000000", "9999999", "007", "-4"}}) {
        // Once through the format before, for lines have the parameters of that.
        model::Model model = io::read_model(io::write(cube(), GetParam(), {}), {});
        model.layers = names;
        const auto count = static_cast<int64_t>(names.size());
        for (int64_t i = 0; i < 6; ++i) {
            model.faces[static_cast<size_t>(i)].layers = {i % count};
        }
        model.faces[0].layers.clear();
        for (int64_t i = 0; i < count; ++i) {
            model.faces[5].layers = i == 0 ? Numbers{0} : Numbers{0, i};
            model.splines.push_back({"s" + std::to_string(i),
                                     spline_of(3, Form::polynomial, {0, 0, 1, 1}, 1, {0, 0, 0, 1, 2, 3}),
                                     {i}});
        }
        expect_again(model);
    }
}

TEST(StepLayers, OfEqualNamesAreOneAndThoseOfNothingAreLeftOut) {
    std::string text = step_test::step_cube();
    const size_t end = text.find("ENDSEC;", text.find("DATA;"));
    const size_t brep = text.rfind('#', text.find("=MANIFOLD_SOLID_BREP")), equals = text.find('=', brep);
    const std::string solid = text.substr(brep, equals - brep);
    text.insert(end, "#9001=PRESENTATION_LAYER_ASSIGNMENT('empty','',(#1));\n"
                     "#9002=PRESENTATION_LAYER_ASSIGNMENT('a','',(" +
                         solid + "));\n#9003=PRESENTATION_LAYER_ASSIGNMENT('b','',(" + solid +
                         "));\n#9004=PRESENTATION_LAYER_ASSIGNMENT('a','once more',(" + solid +
                         "));\n#9005=PRESENTATION_LAYER_ASSIGNMENT('c',$,(#9999));\n"
                         "#9006=PRESENTATION_LAYER_ASSIGNMENT('d');\n");
    const model::Model model = io::read_model(text, {});
    EXPECT_EQ(model.layers, (std::vector<std::string>{"a", "b"}));
    for (const model::ModelFace &face : model.faces) {
        EXPECT_EQ(face.layers, (Numbers{0, 1}));
    }
    ASSERT_EQ(model.notes.size(), 2U); // of nothing, and without its attributes
    EXPECT_EQ(model.notes[0].line, 9005);
    EXPECT_TRUE(model.notes[0].text.ends_with("#9999 is not in the file")) << model.notes[0].text;
    EXPECT_EQ(model.notes[1].line, 9006);
    EXPECT_TRUE(model.notes[1].text.starts_with("#9006 PRESENTATION_LAYER_ASSIGNMENT: "))
        << model.notes[1].text;
}

// A face has the level of its solid unless it has one itself; several are in a property, and another one names a level.
TEST(IgesLevels, AreInheritedListedAndNamed) {
    iges_test::CubeBuilder builder;
    iges_test::Fields of_list, of_name, of_solid, of_square;
    of_list.form = 1;
    of_name.form = 3;
    of_name.level = 5;
    of_solid.level = 9;
    of_square.level = -builder.add(406, "3,12,5,12", of_list);
    builder.add(406, "2,0,4Hroof", of_name);
    (void)builder.cube(-1, {}, {}, of_solid);
    builder.square(3, of_square);
    const model::Model model = iges_test::read_model(builder);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(model.layers, (std::vector<std::string>{"roof", "9", "12"}));
    ASSERT_EQ(model.faces.size(), 7U);
    EXPECT_EQ(model.faces[3].layers, Numbers{1});
    EXPECT_EQ(model.faces[6].layers, (Numbers{0, 2}));
    iges_test::CubeBuilder own;
    iges_test::Fields of_faces;
    of_faces.level = 3;
    (void)own.cube(-1, of_faces, {}, of_solid);
    EXPECT_EQ(iges_test::read_model(own).layers, std::vector<std::string>{"3"});
}

INSTANTIATE_TEST_SUITE_P(All, WrittenLayers, testing::Values(1, 2));

} // namespace
} // namespace written_layers_test
