// SPDX-License-Identifier: MIT
// Parts: where they are placed, in which unit, and what they are called.
#include "support/step_reading.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace step_assembly_test {
namespace {

using namespace nrb;
using namespace step_test;

model::Model model_of(const StepBuilder &file, const io::ReadSettings &settings = {}) {
    return io::read_model(file.text(), settings);
}

// A file of representations, each with its own unit and placement at the origin.
struct PartsFile : StepBuilder {
    std::string angle = radian();

    // With an edge from the origin to (1, 0, 0) in that unit.
    std::string part(const std::string &unit, const std::string &more = "") {
        const std::string edge = straight_edge("0.,0.,0.", "1.,0.,0.", "1.,0.,0.");
        const std::string set = add("CONNECTED_EDGE_SET('',(" + edge + "))");
        return shape(set + more, context(unit, angle));
    }
    std::string frame(const std::string &origin, const std::string &z = "0.,0.,1.",
                      const std::string &x = "1.,0.,0.") {
        return placement(origin, z, x);
    }
    // The frame `from` of the child becomes the frame `to` of the parent.
    void place(const std::string &child, const std::string &from, const std::string &parent,
               const std::string &to) {
        const std::string motion = add("ITEM_DEFINED_TRANSFORMATION('',''," + from + "," + to + ")");
        const std::string relation = add("(REPRESENTATION_RELATIONSHIP('',''," + child + "," + parent + ")" +
                                         "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" + motion +
                                         ")SHAPE_REPRESENTATION_RELATIONSHIP())");
        add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" + relation + ",$)");
    }
    void product(const std::string &name, const std::string &representation) {
        const std::string made = add("PRODUCT('id " + name + "','" + name + "','',())");
        const std::string formation = add("PRODUCT_DEFINITION_FORMATION('',''," + made + ")");
        const std::string definition = add("PRODUCT_DEFINITION('',''," + formation + ",$)");
        const std::string shape = add("PRODUCT_DEFINITION_SHAPE('',''," + definition + ")");
        add("SHAPE_DEFINITION_REPRESENTATION(" + shape + "," + representation + ")");
    }
};

Vector3 placed(const model::Use &use, const Vector3 &x) {
    const auto &m = use.placement;
    return {m[0] * x.x + m[1] * x.y + m[2] * x.z + m[3], m[4] * x.x + m[5] * x.y + m[6] * x.z + m[7],
            m[8] * x.x + m[9] * x.y + m[10] * x.z + m[11]};
}

const model::Use &use_of(const model::Model &model, int64_t part) {
    for (const model::Use &use : model.uses) {
        if (use.part == part) {
            return use;
        }
    }
    throw std::runtime_error("the part is not used");
}

TEST(StepAssembly, APartAloneStandsInTheWholeUnderTheNameOfItsProduct) {
    PartsFile file;
    file.product("bolt", file.part(file.millimetre()));
    const model::Model found = model_of(file);
    ASSERT_EQ(found.parts.size(), 1U);
    EXPECT_EQ(found.parts[0].name, "bolt");
    ASSERT_EQ(found.uses.size(), 1U);
    EXPECT_EQ(found.uses[0].parent, -1);
    EXPECT_EQ(found.edges.size(), 1U);
    EXPECT_EQ(found.edges[0].part, 0);
    EXPECT_TRUE(found.notes.empty());
}

// Inches in millimetres in metres: lengths are converted, and so are the origins of frames, each in its own unit.
TEST(StepAssembly, UnitsNestedThreeDeep) {
    PartsFile file;
    const std::string inner_from = file.frame("1.,0.,0."),
                      middle_to = file.frame("0.,10.,0.", "0.,0.,1.", "0.,1.,0.");
    const std::string middle_from = file.frame("0.,0.,5."), outer_to = file.frame("0.,0.,2.");
    const std::string inner = file.part(file.inch(), "," + inner_from);
    const std::string middle = file.part(file.millimetre(), "," + middle_to + "," + middle_from);
    const std::string outer = file.part(file.metre(), "," + outer_to);
    file.place(inner, inner_from, middle, middle_to);
    file.place(middle, middle_from, outer, outer_to);
    const model::Model found = model_of(file, {1e-3, int64_t{1} << 20}); // in millimetres
    ASSERT_EQ(found.parts.size(), 3U);
    EXPECT_EQ(found.metres_per_unit, 1e-3);
    const model::Use &first = use_of(found, 0), &second = use_of(found, 1), &third = use_of(found, 2);
    EXPECT_EQ(first.parent, 1);
    EXPECT_EQ(second.parent, 2);
    EXPECT_EQ(third.parent, -1);
    expect_near(placed(first, {25.4, 0, 0}), {0, 10, 0}, 1e-11);
    expect_near(placed(first, {26.4, 0, 0}), {0, 11, 0}, 1e-11);
    expect_near(placed(second, {0, 0, 5}), {0, 0, 2000}, 1e-11);
    ASSERT_EQ(found.edges.size(), 3U);
    const double lengths[] = {25.4, 1, 1000};
    for (const model::Edge &edge : found.edges) {
        const Spline &curve = *edge.curve;
        EXPECT_NEAR(curve.coordinate(curve.count(0) - 1, 0) - curve.coordinate(0, 0),
                    lengths[static_cast<size_t>(edge.part)], 1e-12);
    }
}

TEST(StepAssembly, MappedItemsMayBeMirroredAndScaled) {
    PartsFile file;
    const std::string origin = file.frame("1.,0.,0.");
    const std::string child = file.part(file.millimetre(), "," + origin);
    const std::string map = file.add("REPRESENTATION_MAP(" + origin + "," + child + ")");
    const std::string x = file.direction("1.,0.,0."), y = file.direction("0.,-1.,0."),
                      z = file.direction("0.,0.,1.");
    const std::string at = file.point("0.,0.,7.");
    const std::string mirror =
        file.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('',''," + x + "," + y + "," + at + ",2.," + z + ")");
    const std::string mapped = file.add("MAPPED_ITEM(''," + map + "," + mirror + ")");
    file.part(file.millimetre(), "," + mapped);
    const model::Model found = model_of(file);
    ASSERT_EQ(found.parts.size(), 2U);
    const model::Use &use = use_of(found, 0);
    EXPECT_EQ(use.parent, 1);
    expect_near(placed(use, {1, 0, 0}), {0, 0, 7}, 1e-11);
    expect_near(placed(use, {2, 3, 4}), {2, -6, 15}, 1e-11);
}

TEST(StepAssembly, RelationshipsWithoutATransformationMakeOnePart) {
    PartsFile file;
    const std::string a = file.part(file.millimetre()), b = file.part(file.millimetre());
    file.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + a + "," + b + ")");
    file.product("plate", a);
    const model::Model found = model_of(file);
    ASSERT_EQ(found.parts.size(), 1U);
    EXPECT_EQ(found.parts[0].name, "plate");
    EXPECT_EQ(found.edges.size(), 2U);
}

// 2^40 copies if they were multiplied.
TEST(StepAssembly, PartsThatDoubleAreToldAndNotMultiplied) {
    PartsFile file;
    const std::string left = file.frame("0.,0.,0."), right = file.frame("3.,0.,0.");
    std::vector<std::string> parts;
    for (int level = 0; level <= 40; ++level) {
        parts.push_back(file.part(file.millimetre(), "," + left + "," + right));
        if (level > 0) {
            file.place(parts[static_cast<size_t>(level) - 1], left, parts.back(), left);
            file.place(parts[static_cast<size_t>(level) - 1], left, parts.back(), right);
        }
    }
    const model::Model found = model_of(file);
    EXPECT_EQ(found.parts.size(), 41U);
    EXPECT_EQ(found.uses.size(), 81U);
    EXPECT_EQ(found.edges.size(), 41U);
}

TEST(StepAssembly, PartsInThemselvesAreToldAndLeftOut) {
    PartsFile file;
    const std::string frame = file.frame("0.,0.,0.");
    const std::string a = file.part(file.millimetre(), "," + frame),
                      b = file.part(file.millimetre(), "," + frame);
    file.place(a, frame, b, frame);
    file.place(b, frame, a, frame);
    file.place(a, frame, a, frame);
    const model::Model found = model_of(file);
    EXPECT_EQ(found.notes.size(), 2U);
    for (const model::Note &note : found.notes) {
        EXPECT_EQ(note.reason, Status::cycle) << note.text;
        EXPECT_GT(note.line, 0);
    }
    EXPECT_EQ(found.uses.size(), 2U); // one in the other, that one in the whole
}

TEST(StepAssembly, DamagedPlacementsBecomeNotes) {
    PartsFile file;
    const std::string frame = file.frame("0.,0.,0.");
    const std::string a = file.part(file.millimetre(), "," + frame), b = file.part(file.millimetre());
    file.place(a, frame, b, "#99999");
    file.place("#99998", frame, b, frame);
    const model::Model found = model_of(file);
    EXPECT_EQ(found.notes.size(), 2U);
    EXPECT_EQ(found.parts.size(), 2U);
    EXPECT_EQ(found.uses.size(), 2U); // both stand in the whole
}

TEST(StepAssembly, ColoursOfFacesOverruleThoseOfTheWhole) {
    PartsFile file;
    const std::string frame = file.frame("0.,0.,0."), plane = file.add("PLANE(''," + frame + ")");
    std::vector<std::string> faces;
    for (int i = 0; i < 2; ++i) {
        const std::string corners[] = {"0.,0.,0.", "1.,0.,0.", "0.,1.,0."};
        std::string loop;
        for (const std::string &corner : corners) {
            loop += (loop.empty() ? "" : ",") + file.point(corner);
        }
        loop = file.add("POLY_LOOP('',(" + loop + "))");
        const std::string bound = file.add("FACE_OUTER_BOUND(''," + loop + ",.T.)");
        faces.push_back(
            file.add("ADVANCED_FACE('f" + std::to_string(i) + "',(" + bound + ")," + plane + ",.T.)"));
    }
    const std::string shell = file.add("OPEN_SHELL('',(" + faces[0] + "," + faces[1] + "))");
    file.shape(shell, file.context(file.millimetre(), file.angle));
    const auto style = [&](const std::string &colour, const std::string &item) {
        const std::string fill = file.add("FILL_AREA_STYLE_COLOUR(''," + file.add(colour) + ")");
        const std::string area = file.add("FILL_AREA_STYLE('',(" + fill + "))");
        const std::string surface = file.add("SURFACE_STYLE_FILL_AREA(" + area + ")");
        const std::string side = file.add("SURFACE_SIDE_STYLE('',(" + surface + "))");
        const std::string usage = file.add("SURFACE_STYLE_USAGE(.BOTH.," + side + ")");
        const std::string assignment = file.add("PRESENTATION_STYLE_ASSIGNMENT((" + usage + "))");
        file.add("STYLED_ITEM('',(" + assignment + ")," + item + ")");
    };
    style("COLOUR_RGB('',0.25,0.5,0.75)", faces[1]);
    style("DRAUGHTING_PRE_DEFINED_COLOUR('red')", shell);
    const model::Model found = model_of(file);
    ASSERT_EQ(found.faces.size(), 2U);
    EXPECT_EQ(found.faces[0].name, "f0");
    ASSERT_TRUE(found.faces[0].colour && found.faces[1].colour);
    EXPECT_EQ(*found.faces[0].colour, (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(*found.faces[1].colour, (std::array<double, 3>{0.25, 0.5, 0.75}));
}

// In whatever order they come.
TEST(StepAssembly, ColoursThatOverRideOthers) {
    PartsFile file;
    const std::string ball = file.add("SPHERICAL_SURFACE(''," + file.frame("0.,0.,0.") + ",1.)");
    const std::string dot = file.add("VERTEX_LOOP(''," + file.vertex("0.,0.,-1.") + ")");
    const std::string bound = file.add("FACE_OUTER_BOUND(''," + dot + ",.T.)");
    const std::string face = file.add("ADVANCED_FACE('',(" + bound + ")," + ball + ",.T.)");
    file.shape(file.add("OPEN_SHELL('',(" + face + "))"), file.context(file.millimetre(), file.angle));
    const auto style = [&](const std::string &colour) {
        const std::string named = file.add("DRAUGHTING_PRE_DEFINED_COLOUR('" + colour + "')");
        return file.add("PRESENTATION_STYLE_ASSIGNMENT((" + named + "))");
    };
    const std::string red = style("red"), green = style("green"), blue = style("blue");
    const auto number = [&](int ahead) {
        return "#" + std::to_string(std::stoi(file.next().substr(1)) + ahead);
    };
    file.add("OVER_RIDING_STYLED_ITEM('',(" + green + ")," + face + "," + number(1) + ")");
    file.add("OVER_RIDING_STYLED_ITEM('',(" + blue + ")," + face + "," + number(1) + ")");
    file.add("STYLED_ITEM('',(" + red + ")," + face + ")");
    const model::Model found = model_of(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_EQ(found.faces[0].colour, (std::array<double, 3>{0, 1, 0}));
}

// 20^10 ways through the styles.
TEST(StepAssembly, StylesThatShareStylesAreReadOnce) {
    PartsFile file;
    std::string next = file.add("FILL_AREA_STYLE_COLOUR('',$)");
    for (int level = 0; level < 10; ++level) {
        std::string all;
        for (int i = 0; i < 20; ++i) {
            all += (i == 0 ? "" : ",") + next;
        }
        next = file.add("PRESENTATION_STYLE_ASSIGNMENT((" + all + "))");
    }
    const std::string edge = file.straight_edge("0.,0.,0.", "1.,0.,0.", "1.,0.,0.");
    file.add("STYLED_ITEM('',(" + next + ")," + edge + ")");
    EXPECT_EQ(model_of(file).edges.size(), 1U);
}

// Faces of a few bytes each that share bounds for which curves are made: they end where the file has used up its memory.
TEST(StepAssembly, FacesThatShareBoundsAreLimited) {
    PartsFile file;
    const std::string frame = file.frame("0.,0.,0."),
                      cylinder = file.add("CYLINDRICAL_SURFACE(''," + frame + ",1.)");
    std::vector<std::string> bounds;
    for (const char *height : {"0.", "1."}) {
        const std::string at = file.frame(std::string("0.,0.,") + height),
                          circle = file.add("CIRCLE(''," + at + ",1.)");
        const std::string edge =
            file.edge(std::string("1.,0.,") + height, std::string("1.,0.,") + height, circle);
        const std::string used =
            file.add("ORIENTED_EDGE('',*,*," + edge + (bounds.empty() ? ",.T.)" : ",.F.)"));
        const std::string loop = file.add("EDGE_LOOP('',(" + used + "))");
        bounds.push_back(file.add("FACE_BOUND(''," + loop + ",.T.)"));
    }
    for (int i = 0; i < 3000; ++i) {
        file.add("ADVANCED_FACE('',(" + bounds[0] + "," + bounds[1] + ")," + cylinder + ",.T.)");
    }
    const model::Model found = model_of(file);
    EXPECT_GT(found.faces.size(), 100U);
    EXPECT_LT(found.faces.size(), 2000U);
    EXPECT_EQ(found.notes.size() + found.faces.size(), 3000U);
}

} // namespace
} // namespace step_assembly_test
