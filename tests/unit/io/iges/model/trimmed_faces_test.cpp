// Trimmed and bounded surfaces, and surfaces that nothing trims, as faces.
#include "eval/curve_point.h"
#include "support/iges_solids.h"

#include <numbers>

namespace iges_trimmed_test {

namespace {

using namespace iges_test;
using nrb::Status;
using nrb::model::Model;

void expect_no_notes(const Model &found) {
    for (const nrb::model::Note &note : found.notes) {
        ADD_FAILURE() << note.text;
    }
}

// The only face of a file, without notes, and with an area.
const nrb::model::ModelFace &only_face(const Model &found, double area) {
    expect_no_notes(found);
    if (found.faces.size() != 1) {
        throw std::runtime_error("there are " + std::to_string(found.faces.size()) + " faces");
    }
    EXPECT_NEAR(area_of(found.faces[0]), area, 1e-9 * area);
    EXPECT_TRUE(found.splines.empty());
    return found.faces[0];
}

TEST(IgesTrimmedFaces, a_surface_alone_is_a_face_of_its_whole_domain) {
    FacesBuilder file;
    file.square(3);
    const Model found = read_model(file);
    EXPECT_EQ(only_face(found, 9).name, "128#1");
    EXPECT_EQ(found.edges.size(), 4U);
    EXPECT_EQ(found.vertices.size(), 4U);
    EXPECT_EQ(found.metres_per_unit, 0.001);
    ASSERT_EQ(found.parts.size(), 1U);
    ASSERT_EQ(found.uses.size(), 1U);
    EXPECT_EQ(found.uses[0].parent, -1);
    for (const nrb::model::Edge &edge : found.edges) {
        EXPECT_EQ(edge.uses.size(), 1U);
    }
}

TEST(IgesTrimmedFaces, a_hole_in_the_whole_domain) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t hole = file.curve_on_surface(
        surface, file.polygon({"0.25,0.25", "0.75,0.25", "0.75,0.5", "0.25,0.5"}), 0, 1);
    file.trimmed(surface, 0, {hole}, {.label = "PLATE"});
    const Model found = read_model(file);
    EXPECT_EQ(only_face(found, 16 - 2).name, "PLATE");
    EXPECT_EQ(found.edges.size(), 8U);
    EXPECT_EQ(found.vertices.size(), 8U);
}

// Boundaries in space alone, in the domain alone, and both, which run either way.
TEST(IgesTrimmedFaces, the_kind_and_the_direction_of_curves_do_not_matter) {
    const std::vector<std::string> domain = {"0.25,0.25", "0.75,0.25", "0.75,0.5", "0.25,0.5"},
                                   space = {"1.,1.", "3.,1.", "3.,2.", "1.,2."};
    for (const bool backwards : {false, true}) {
        for (const int kinds : {1, 2, 3}) {
            FacesBuilder file;
            const int64_t surface = file.square(4);
            const auto turned = [&](std::vector<std::string> corners) {
                if (backwards) {
                    std::reverse(corners.begin(), corners.end());
                }
                return corners;
            };
            const int64_t in_domain = (kinds & 1) != 0 ? file.polygon(turned(domain)) : 0,
                          in_space = (kinds & 2) != 0 ? file.polygon(turned(space)) : 0;
            file.trimmed(surface, file.curve_on_surface(surface, in_domain, in_space, 0));
            const Model found = read_model(file);
            only_face(found, 2);
            EXPECT_EQ(found.edges.size(), 4U);
            EXPECT_EQ(found.vertices.size(), 4U);
        }
    }
}

// Two boundaries that do not agree: the preference says which one counts.
TEST(IgesTrimmedFaces, the_preferred_curve_rules) {
    const std::pair<int, double> cases[] = {{1, 16}, {2, 4}, {0, 4}, {3, 4}};
    for (const auto &[preference, area] : cases) {
        FacesBuilder file;
        const int64_t surface = file.square(4);
        const int64_t in_domain = file.polygon({"0.,0.", "1.,0.", "1.,1.", "0.,1."}),
                      in_space = file.polygon({"1.,1.", "3.,1.", "3.,3.", "1.,3."});
        file.trimmed(surface, file.curve_on_surface(surface, in_domain, in_space, preference));
        only_face(read_model(file), area);
    }
}

// The square [1, 3]^2 far above the surface is no boundary of it.
TEST(IgesTrimmedFaces, the_other_curve_counts_where_the_preferred_one_fails) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t in_domain = file.polygon({"0.,0.", "1.,0.", "1.,1.", "0.,1."}),
                  in_space = file.polygon({"1.,1.,9.", "3.,1.,9.", "3.,3.,9.", "1.,3.,9."});
    const int64_t face = file.trimmed(surface, file.curve_on_surface(surface, in_domain, in_space, 2));
    const Model found = read_model(file);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_NEAR(area_of(found.faces[0]), 16, 1e-9);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_EQ(found.notes[0].line, face);
    EXPECT_EQ(found.notes[0].reason, Status::gap);
    EXPECT_NE(found.notes[0].text.find("the curves are taken that the file does not prefer"),
              std::string::npos)
        << found.notes[0].text;
}

TEST(IgesTrimmedFaces, bounded_surfaces_turn_curves_by_their_sense) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t a = file.line({0, 0, 0}, {4, 0, 0}), b = file.line({4, 4, 0}, {4, 0, 0}),
                  c = file.line({4, 4, 0}, {0, 0, 0});
    const int64_t boundary = file.add(141, "0,1," + file.name(surface) + ",3," + file.name(a) + ",1,0," +
                                               file.name(b) + ",2,0," + file.name(c) + ",1,0");
    file.add(143, "0," + file.name(surface) + ",1," + file.name(boundary));
    const Model found = read_model(file);
    EXPECT_EQ(only_face(found, 8).name, "143#11");
    EXPECT_EQ(found.edges.size(), 3U);
    EXPECT_EQ(found.vertices.size(), 3U);
}

// The parameter curves of a boundary are taken, whichever way they run: the edges are the curves in space.
TEST(IgesTrimmedFaces, boundaries_with_parameter_curves) {
    for (const bool backwards : {false, true}) {
        FacesBuilder file;
        const int64_t surface = file.square(4);
        const Corner corners[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
        const std::string params[] = {"0.,0.,0.", "1.,0.,0.", "1.,1.,0."};
        std::string text = "1,2," + file.name(surface) + ",3";
        for (size_t i = 0; i < 3; ++i) {
            const size_t j = (i + 1) % 3;
            const int64_t edge = file.line(corners[i], corners[j]);
            const int64_t curve =
                file.add(110, backwards ? params[j] + "," + params[i] : params[i] + "," + params[j]);
            text += "," + file.name(edge) + ",1,1," + file.name(curve);
        }
        const int64_t boundary = file.add(141, text);
        file.add(143, "1," + file.name(surface) + ",1," + file.name(boundary));
        const Model found = read_model(file);
        const nrb::model::ModelFace &face = only_face(found, 8);
        EXPECT_EQ(found.edges.size(), 3U);
        EXPECT_EQ(face.face->loops().size(), 1U);
        for (const nrb::face::Coedge &coedge : face.face->loops()[0]) {
            EXPECT_NE(coedge.edge, nullptr);
        }
    }
}

constexpr const char *around = "6.283185307179586";

// The boundary of a cylinder that is cut open at a line: u along the line, v the angle in the file.
TEST(IgesTrimmedFaces, a_cylinder_with_a_seam) {
    const double area = 2 * std::numbers::pi * 2 * 3;
    for (const bool backwards : {false, true}) {
        FacesBuilder file;
        const int64_t surface = file.cylinder(2, 3);
        const std::string turn = around;
        std::vector<std::string> corners = {"0.,0.", "1.,0.", "1.," + turn, "0.," + turn};
        if (backwards) {
            std::reverse(corners.begin(), corners.end());
        }
        file.trimmed(surface, file.curve_on_surface(surface, file.polygon(corners), 0, 1));
        const Model found = read_model(file);
        const nrb::model::ModelFace &face = only_face(found, area);
        ASSERT_NE(face.shape, nullptr);
        EXPECT_EQ(found.edges.size(), 4U);
    }
}

// Half of it by parameters that are angles, which those of the spline are not.
TEST(IgesTrimmedFaces, parameters_around_an_axis_are_angles) {
    FacesBuilder file;
    const int64_t surface = file.cylinder(2, 3);
    file.trimmed(surface,
                 file.curve_on_surface(surface, file.polygon({"0.,1.", "1.,1.", "1.,3.", "0.,3."}), 0, 1));
    only_face(read_model(file), 2 * 2 * 3); // radius times angle times height
    FacesBuilder slanted;
    const int64_t other = slanted.cylinder(2, 3);
    slanted.trimmed(
        other, slanted.curve_on_surface(other, slanted.polygon({"0.,1.", "1.,2.", "1.,4.", "0.,3."}), 0, 1));
    only_face(read_model(slanted), 2 * 2 * 3);
}

TEST(IgesTrimmedFaces, a_cylinder_alone_has_two_round_edges) {
    FacesBuilder file;
    file.cylinder(2, 3);
    const Model found = read_model(file);
    only_face(found, 2 * std::numbers::pi * 2 * 3);
    ASSERT_EQ(found.edges.size(), 2U);
    for (const nrb::model::Edge &edge : found.edges) {
        EXPECT_EQ(edge.vertices[0], edge.vertices[1]);
    }
}

TEST(IgesTrimmedFaces, a_sphere_alone_has_no_edges) {
    FacesBuilder file;
    const int64_t centre = file.add(116, "1.,2.,3.,0");
    file.add(196, file.name(centre) + ",2.");
    const Model found = read_model(file);
    only_face(found, 4 * std::numbers::pi * 4);
    EXPECT_TRUE(found.edges.empty());
}

TEST(IgesTrimmedFaces, planes_without_ends_are_cut_to_their_boundary) {
    FacesBuilder file;
    const int64_t plane = file.add(108, "0.,0.,1.,2.,0,0.,0.,2.,0.");
    const int64_t outer = file.polygon({"0.,0.,2.", "5.,0.,2.", "5.,1.,2.", "0.,1.,2."});
    file.trimmed(plane, file.curve_on_surface(plane, 0, outer, 2));
    only_face(read_model(file), 5);
    FacesBuilder alone;
    const int64_t boundary = alone.polygon({"0.,0.,2.", "5.,0.,2.", "5.,1.,2.", "0.,1.,2."});
    alone.add(108, "0.,0.,1.,2.," + alone.name(boundary) + ",0.,0.,2.,0.", {.form = 1});
    only_face(read_model(alone), 5);
    FacesBuilder endless;
    endless.add(108, "0.,0.,1.,2.,0,0.,0.,2.,0.");
    const Model none = read_model(endless);
    EXPECT_TRUE(none.faces.empty());
    ASSERT_EQ(none.notes.size(), 1U);
    EXPECT_EQ(none.notes[0].reason, Status::length);
}

// The boundary lies 9e-6 above the surface, where the file states 1e-7.
TEST(IgesTrimmedFaces, tolerances_grow_by_powers_of_ten_and_are_told) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t outer = file.polygon({"1.,1.,9.E-6", "3.,1.,9.E-6", "3.,2.,9.E-6", "1.,2.,9.E-6"});
    const int64_t face = file.trimmed(surface, file.curve_on_surface(surface, 0, outer, 2));
    const Model found = read_model(file);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_NEAR(area_of(found.faces[0]), 2, 1e-9);
    EXPECT_NEAR(found.faces[0].face->tolerance(), 1e-5, 1e-5 / 1024);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_EQ(found.notes[0].line, face);
    EXPECT_EQ(found.notes[0].reason, Status::tolerance);
    const Model in_metres = read_model(file, {.unit = 1});
    EXPECT_NEAR(in_metres.faces.at(0).face->tolerance(), 1e-8, 1e-8 / 1024);
}

// The fourth side is missing.
TEST(IgesTrimmedFaces, open_boundaries_are_closed_in_the_domain_and_told) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t outer = file.composite(
        {file.line({1, 1, 0}, {3, 1, 0}), file.line({3, 1, 0}, {3, 2, 0}), file.line({3, 2, 0}, {1, 2, 0})});
    const int64_t face = file.trimmed(surface, file.curve_on_surface(surface, 0, outer, 2));
    const Model found = read_model(file);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_NEAR(area_of(found.faces[0]), 2, 1e-9);
    ASSERT_FALSE(found.notes.empty());
    EXPECT_EQ(found.notes.back().line, face);
    EXPECT_EQ(found.notes.back().reason, Status::gap);
    // The last side ends at a vertex of its own.
    ASSERT_EQ(found.edges.size(), 3U);
    ASSERT_EQ(found.vertices.size(), 4U);
    for (const nrb::model::Edge &edge : found.edges) {
        for (const size_t end : {size_t{0}, size_t{1}}) {
            const nrb::Vector3 at = found.vertices[static_cast<size_t>(edge.vertices[end])];
            const std::vector<double> x = nrb::eval::end_point(*edge.curve, end == 1);
            EXPECT_EQ((std::vector<double>{at.x, at.y, at.z}), x);
        }
    }
}

// What is wrong with one face is told, and does not affect the others, nor does what it consists of become something else.
TEST(IgesTrimmedFaces, damage_is_told) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    const int64_t bad = file.trimmed(surface, 999), no_surface = file.trimmed(998, 0);
    const int64_t short_list = file.add(144, "1,1,100000,3");
    file.square(1);
    const Model found = read_model(file);
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_NEAR(area_of(found.faces[0]), 1, 1e-12);
    ASSERT_EQ(found.notes.size(), 3U);
    const int64_t lines[] = {bad, no_surface, short_list};
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(found.notes[i].line, lines[i]);
        EXPECT_EQ(found.notes[i].entity_type, 144);
        EXPECT_EQ(found.notes[i].reason, Status::syntax);
    }
    EXPECT_NE(found.notes[2].text.find("number of inner boundaries is 100000"), std::string::npos)
        << found.notes[2].text;
}

TEST(IgesTrimmedFaces, curves_that_nothing_consists_of_are_splines) {
    FacesBuilder file;
    const int64_t surface = file.square(4);
    file.trimmed(surface,
                 file.curve_on_surface(surface, 0, file.polygon({"1.,1.,0.", "3.,1.,0.", "3.,2.,0."}), 2));
    file.line({0, 0, 5}, {1, 0, 5}, {.label = "FREE"});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.splines.size(), 1U);
    EXPECT_EQ(found.splines[0].name, "FREE");
}

TEST(IgesTrimmedFaces, colours_by_number_and_by_definition) {
    FacesBuilder file;
    const int64_t orange = file.add(314, "100.,50.,0.,6HOrange");
    file.square(1, {.colour = 4});
    file.square(1, {.colour = -orange});
    file.square(1);
    file.square(1, {.colour = -999});
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    ASSERT_EQ(found.faces.size(), 4U);
    using Colour = std::array<double, 3>;
    EXPECT_EQ(found.faces[0].colour, (Colour{0, 0, 1}));
    EXPECT_EQ(found.faces[1].colour, (Colour{1, 0.5, 0}));
    EXPECT_FALSE(found.faces[2].colour);
    EXPECT_FALSE(found.faces[3].colour);
}

} // namespace

} // namespace iges_trimmed_test
