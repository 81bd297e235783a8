// Subfigures and their instances, groups, and entities that are parts of their own.
#include "support/iges_solids.h"

#include <algorithm>

namespace iges_assembly_test {

namespace {

using namespace iges_test;
using nrb::Status;
using nrb::Vector3;
using nrb::model::Model;
using nrb::model::Use;

Vector3 placed(const Use &use, const Vector3 &x) {
    const auto &m = use.placement;
    return {m[0] * x.x + m[1] * x.y + m[2] * x.z + m[3], m[4] * x.x + m[5] * x.y + m[6] * x.z + m[7],
            m[8] * x.x + m[9] * x.y + m[10] * x.z + m[11]};
}

void expect_place(const Use &use, const Vector3 &x, const Vector3 &wanted) {
    const Vector3 found = placed(use, x);
    EXPECT_NEAR(found.x, wanted.x, 1e-12);
    EXPECT_NEAR(found.y, wanted.y, 1e-12);
    EXPECT_NEAR(found.z, wanted.z, 1e-12);
}

int64_t part_named(const Model &found, const std::string &name) {
    for (size_t i = 0; i < found.parts.size(); ++i) {
        if (found.parts[i].name == name) {
            return static_cast<int64_t>(i);
        }
    }
    throw std::runtime_error("no part " + name);
}

std::vector<Use> uses_of(const Model &found, int64_t part) {
    std::vector<Use> result;
    std::copy_if(found.uses.begin(), found.uses.end(), std::back_inserter(result),
                 [part](const Use &use) { return use.part == part; });
    return result;
}

// A bolt in a flange in a pump, each twice as large as it is defined, or half; in inches, wanted in millimetres.
TEST(IgesAssembly, subfigures_three_deep_with_scales_and_matrices) {
    FacesBuilder file;
    file.global(14, "1").global(15, "4HINCH");
    const int64_t square = file.square(1);
    const int64_t bolt = file.subfigure("bolt", {square});
    const int64_t quarter = file.matrix("0.,-1.,0.,10.,1.,0.,0.,0.,0.,0.,1.,0."); // turns x to y
    const int64_t at_flange = file.instance(bolt, "1.,2.,3.", "2.", {.transform = quarter});
    const int64_t flange = file.subfigure("flange", {at_flange});
    const int64_t first = file.instance(flange, "0.,0.,5."),
                  second = file.instance(flange, "0.,0.,-5.", "0.5");
    const int64_t pump = file.subfigure("pump", {first, second});
    file.instance(pump, "100.,0.,0.", "", {.label = "P", .subscript = 1});
    const Model found = read_model(file, {.unit = 1e-3});
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.parts.size(), 4U);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_EQ(found.faces[0].part, part_named(found, "bolt"));
    EXPECT_EQ(found.edges.at(0).part, part_named(found, "bolt"));
    EXPECT_NEAR(area_of(found.faces[0]), 25.4 * 25.4, 1e-9);
    const std::vector<Use> bolts = uses_of(found, part_named(found, "bolt"));
    ASSERT_EQ(bolts.size(), 1U);
    EXPECT_EQ(bolts[0].parent, part_named(found, "flange"));
    expect_place(bolts[0], {25.4, 0, 0}, {(10 - 2) * 25.4, (2 + 1) * 25.4, 3 * 25.4});
    const std::vector<Use> flanges = uses_of(found, part_named(found, "flange"));
    ASSERT_EQ(flanges.size(), 2U);
    expect_place(flanges[0], {1, 1, 1}, {1, 1, 1 + 5 * 25.4});
    expect_place(flanges[1], {1, 1, 1}, {0.5, 0.5, 0.5 - 5 * 25.4});
    const std::vector<Use> pumps = uses_of(found, part_named(found, "pump"));
    ASSERT_EQ(pumps.size(), 1U);
    EXPECT_EQ(pumps[0].parent, 0);
    EXPECT_EQ(pumps[0].name, "P(1)");
    const std::vector<Use> whole = uses_of(found, 0);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].parent, -1);
}

TEST(IgesAssembly, a_subfigure_in_itself_is_told_and_left_out) {
    FacesBuilder file;
    const int64_t square = file.square(1);
    const int64_t instance = file.next(), definition = instance + 2;
    file.instance(definition, "1.,0.,0.");
    file.subfigure("ring", {square, instance});
    const Model found = read_model(file);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_EQ(found.notes[0].reason, Status::cycle);
    EXPECT_EQ(found.notes[0].line, instance);
    EXPECT_EQ(found.notes[0].entity_type, 408);
    EXPECT_EQ(found.faces.size(), 1U);
    ASSERT_EQ(found.uses.size(), 2U); // of the first part and the ring, in the whole
    EXPECT_EQ(found.uses[1].parent, -1);
}

// 2^40 squares, of which the model has one.
TEST(IgesAssembly, parts_that_double_at_each_of_forty_levels_are_not_multiplied) {
    FacesBuilder file;
    int64_t part = file.subfigure("0", {file.square(1)});
    for (int level = 1; level <= 40; ++level) {
        const int64_t a = file.instance(part, "1.,0.,0."), b = file.instance(part, "0.,1.,0.");
        part = file.subfigure(std::to_string(level), {a, b});
    }
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_EQ(found.faces.size(), 1U);
    EXPECT_EQ(found.parts.size(), 42U);
    EXPECT_EQ(found.uses.size(), 82U);
}

TEST(IgesAssembly, groups_hand_their_members_on) {
    FacesBuilder file;
    const int64_t a = file.square(1), b = file.square(2);
    const int64_t inner = file.add(402, listed({b}), {.form = 7});
    const int64_t outer = file.add(402, listed({a, inner, file.next()}), {.form = 1}); // and itself
    file.subfigure("both", {outer});
    file.add(402, listed({a}), {.form = 14});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 2U);
    EXPECT_EQ(found.faces[0].part, part_named(found, "both"));
    EXPECT_EQ(found.faces[1].part, part_named(found, "both"));
}

// A thousand subfigures that share a group of a thousand squares: a million places, told by as many uses as the file has lists.
TEST(IgesAssembly, a_group_that_many_subfigures_list_is_a_part_of_its_own) {
    FacesBuilder file;
    std::vector<int64_t> squares;
    for (int i = 0; i < 1000; ++i) {
        squares.push_back(file.square(1));
    }
    const int64_t group = file.add(402, listed(squares), {.form = 7});
    for (int i = 0; i < 1000; ++i) {
        file.subfigure(std::to_string(i), {group});
    }
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 1000U);
    EXPECT_EQ(found.parts.size(), 1002U);
    const int64_t shared = found.faces[0].part;
    for (const nrb::model::ModelFace &face : found.faces) {
        EXPECT_EQ(face.part, shared);
    }
    const std::vector<Use> uses = uses_of(found, shared);
    ASSERT_EQ(uses.size(), 1000U);
    for (size_t i = 0; i < uses.size(); ++i) {
        EXPECT_EQ(uses[i].parent, part_named(found, std::to_string(i)));
        EXPECT_EQ(uses[i].placement, Use().placement);
    }
}

// However many ways lead to an entity, it is in a subfigure once.
TEST(IgesAssembly, groups_that_share_members_place_them_once) {
    FacesBuilder file;
    const int64_t a = file.square(1), b = file.square(2), c = file.square(3);
    const int64_t inner = file.add(402, listed({a, b}), {.form = 7});
    const int64_t left = file.add(402, listed({inner, c}), {.form = 7}),
                  right = file.add(402, listed({c, inner, left}), {.form = 7});
    file.subfigure("one", {left, right, left});
    const Model alone = read_model(file);
    EXPECT_EQ(alone.parts.size(), 2U);
    file.subfigure("two", {right, a});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    for (const nrb::model::ModelFace &face : found.faces) {
        std::vector<int64_t> parents;
        std::vector<int64_t> waiting{face.part};
        while (!waiting.empty()) {
            const int64_t part = waiting.back();
            waiting.pop_back();
            if (part == part_named(found, "one") || part == part_named(found, "two")) {
                parents.push_back(part);
                continue;
            }
            for (const Use &use : uses_of(found, part)) {
                waiting.push_back(use.parent);
            }
        }
        std::sort(parents.begin(), parents.end());
        EXPECT_EQ(parents, (std::vector{part_named(found, "one"), part_named(found, "two")}));
    }
}

TEST(IgesAssembly, groups_in_each_other_hand_their_members_on) {
    FacesBuilder file;
    const int64_t a = file.square(1), b = file.square(2), first = file.next(), second = first + 2;
    file.add(402, listed({a, second}), {.form = 7});
    file.add(402, listed({b, first}), {.form = 7});
    file.subfigure("both", {second});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 2U);
    EXPECT_EQ(found.faces[0].part, part_named(found, "both"));
    EXPECT_EQ(found.faces[1].part, part_named(found, "both"));
}

TEST(IgesAssembly, matrices_in_a_circle_are_told) {
    FacesBuilder file;
    const int64_t square = file.square(1), first = file.next();
    const std::string shift = "1.,0.,0.,1.,0.,1.,0.,2.,0.,0.,1.,3.";
    file.add(124, shift, {.transform = first + 2});
    file.add(124, shift, {.transform = first});
    file.add(124, shift, {.transform = first});
    file.add(124, shift); // nothing is wrong with it, but nothing needs it
    file.subfigure("part", {square});
    const Model found = read_model(file);
    EXPECT_EQ(found.faces.size(), 1U);
    ASSERT_EQ(found.notes.size(), 4U);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(found.notes[i].reason, Status::cycle);
        EXPECT_NE(found.notes[i].text.find("applies to itself"), std::string::npos) << found.notes[i].text;
    }
    EXPECT_EQ(found.notes[3].reason, Status::unsupported);
}

TEST(IgesAssembly, what_two_subfigures_list_is_a_part_of_its_own) {
    FacesBuilder file;
    const int64_t square = file.square(1);
    file.subfigure("left", {square});
    file.subfigure("right", {square});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.parts.size(), 4U);
    ASSERT_EQ(found.faces.size(), 1U);
    const std::vector<Use> uses = uses_of(found, found.faces[0].part);
    ASSERT_EQ(uses.size(), 2U);
    EXPECT_EQ(uses[0].parent, part_named(found, "left"));
    EXPECT_EQ(uses[1].parent, part_named(found, "right"));
    expect_place(uses[1], {1, 2, 3}, {1, 2, 3});
}

TEST(IgesAssembly, a_trimmed_surface_with_a_matrix_is_a_part_that_it_places) {
    FacesBuilder file;
    const int64_t surface = file.square(1), matrix = file.matrix("1.,0.,0.,7.,0.,1.,0.,0.,0.,0.,1.,0.");
    file.trimmed(surface, 0, {}, {.transform = matrix});
    const Model found = read_model(file, {.unit = 1});
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 1U);
    const std::vector<Use> uses = uses_of(found, found.faces[0].part);
    ASSERT_EQ(uses.size(), 1U);
    EXPECT_EQ(uses[0].parent, 0);
    expect_place(uses[0], {0, 0, 0}, {0.007, 0, 0});
}

TEST(IgesAssembly, solids_with_instances_stand_where_those_place_them) {
    CubeBuilder file;
    const int64_t solid = file.cube();
    const int64_t shift = file.matrix("1.,0.,0.,7.,0.,1.,0.,0.,0.,0.,1.,0.");
    file.add(430, file.name(solid), {.transform = shift});
    file.add(430, file.name(solid));
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 6U);
    const std::vector<Use> uses = uses_of(found, found.faces[5].part);
    ASSERT_EQ(uses.size(), 2U);
    expect_place(uses[0], {0, 0, 0}, {7, 0, 0});
    expect_place(uses[1], {0, 0, 0}, {0, 0, 0});
}

TEST(IgesAssembly, damaged_instances_are_told) {
    FacesBuilder file;
    const int64_t square = file.square(1), part = file.subfigure("part", {square});
    const int64_t nowhere = file.instance(999, "0.,0.,0."), flat = file.instance(part, "0.,0.,0.", "-1."),
                  to_square = file.instance(square, "0.,0.,0.");
    const Model found = read_model(file);
    ASSERT_EQ(found.notes.size(), 2U);
    EXPECT_EQ(found.notes[0].line, nowhere);
    EXPECT_EQ(found.notes[0].reason, Status::syntax);
    EXPECT_EQ(found.notes[1].line, flat);
    EXPECT_EQ(found.notes[1].reason, Status::factor);
    EXPECT_GT(to_square, flat); // an instance of something else than a subfigure places that
    EXPECT_EQ(found.faces.size(), 1U);
}

} // namespace

} // namespace iges_assembly_test
