// Solids and shells with edges and vertices that faces share.
#include "support/iges_solids.h"

#include <cmath>

namespace iges_solids_test {

namespace {

using namespace iges_test;
using nrb::Status;
using nrb::model::Model;

TEST(IgesSolids, a_cube_shares_twelve_edges_and_eight_vertices) {
    CubeBuilder file;
    file.cube();
    const Model found = read_model(file);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_TRUE(found.splines.empty());
    ASSERT_EQ(found.faces.size(), 6U);
    ASSERT_EQ(found.edges.size(), 12U);
    ASSERT_EQ(found.vertices.size(), 8U);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(area_of(found.faces[i]), 1, 1e-12);
        EXPECT_EQ(found.faces[i].against, i % 2 == 0); // the lower side of each axis
    }
    for (const nrb::model::Edge &edge : found.edges) {
        EXPECT_EQ(edge.uses.size(), 2U);
    }
}

// Also those that the file has backwards.
TEST(IgesSolids, edges_run_from_their_first_vertex_to_the_second) {
    CubeBuilder file;
    file.cube();
    const Model found = read_model(file);
    for (const nrb::model::Edge &edge : found.edges) {
        for (const int end : {0, 1}) {
            const nrb::Vector3 &vertex =
                found.vertices.at(static_cast<size_t>(edge.vertices[static_cast<size_t>(end)]));
            const int64_t at = end * (edge.curve->point_count() - 1);
            EXPECT_EQ(edge.curve->coordinate(at, 0), vertex.x);
            EXPECT_EQ(edge.curve->coordinate(at, 1), vertex.y);
            EXPECT_EQ(edge.curve->coordinate(at, 2), vertex.z);
        }
    }
}

// Each edge once along and once against the boundary, as seen from outside.
TEST(IgesSolids, neighbours_use_an_edge_in_opposite_directions) {
    CubeBuilder file;
    file.cube();
    const Model found = read_model(file);
    for (const nrb::model::Edge &edge : found.edges) {
        int sum = 0;
        for (const nrb::model::EdgeUse &use : edge.uses) {
            const nrb::model::ModelFace &face = found.faces[static_cast<size_t>(use.face)];
            const nrb::face::Coedge &coedge =
                face.face->loops()[static_cast<size_t>(use.loop)][static_cast<size_t>(use.index)];
            sum += coedge.against != face.against ? -1 : 1;
        }
        EXPECT_EQ(sum, 0);
    }
}

// The name that its sender gives to the product is that of what stands in no subfigure.
TEST(IgesSolids, the_first_part_has_the_name_of_the_product) {
    CubeBuilder file;
    file.cube();
    EXPECT_EQ(read_model(file.global(3, "9H gearbox ")).parts.at(0).name, "gearbox");
    EXPECT_EQ(read_model(file.global(3, "")).parts.at(0).name, "");
}

TEST(IgesSolids, the_orientation_of_shells_turns_all_of_their_faces) {
    CubeBuilder file;
    const int64_t solid = file.cube();
    std::string text = file.text();
    const std::string right = "186," + file.name(solid - 2) + ",1,0;",
                      wrong = "186," + file.name(solid - 2) + ",0,0;";
    const size_t at = text.find(right);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, right.size(), wrong);
    const Model found = read_model(text);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(found.faces.at(i).against, i % 2 == 1);
    }
}

TEST(IgesSolids, colours_are_those_of_the_face_or_what_is_around_it) {
    const std::array<double, 3> red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
    CubeBuilder by_solid, by_shell, by_face;
    by_solid.cube(-1, {}, {}, {.colour = 2});
    by_shell.cube(-1, {}, {.colour = 3}, {.colour = 2});
    by_face.cube(-1, {.colour = 4}, {.colour = 3}, {.colour = 2});
    EXPECT_EQ(read_model(by_solid).faces.at(0).colour, red);
    EXPECT_EQ(read_model(by_shell).faces.at(0).colour, green);
    EXPECT_EQ(read_model(by_face).faces.at(0).colour, blue);
}

TEST(IgesSolids, names_are_labels) {
    CubeBuilder file;
    file.cube(-1, {.label = "SIDE", .subscript = 7});
    EXPECT_EQ(read_model(file).faces.at(3).name, "SIDE(7)");
}

// The two faces at the edge are lost, the four others are not.
TEST(IgesSolids, an_edge_that_cannot_be_read_is_told) {
    CubeBuilder file;
    file.cube(4);
    const Model found = read_model(file);
    EXPECT_EQ(found.faces.size(), 4U);
    EXPECT_EQ(found.edges.size(), 11U);
    ASSERT_EQ(found.notes.size(), 3U);
    EXPECT_NE(found.notes[0].text.find("edge 5: "), std::string::npos) << found.notes[0].text;
    EXPECT_EQ(found.notes[0].entity_type, 504);
    EXPECT_EQ(found.notes[0].reason, Status::syntax);
    for (const size_t i : {1U, 2U}) {
        EXPECT_EQ(found.notes[i].entity_type, 510);
        EXPECT_EQ(found.notes[i].reason, Status::unsupported);
    }
}

// A cylinder as one face: around below, up its seam, back around above, down the seam.
TEST(IgesSolids, a_seam_is_one_edge_used_twice_by_one_face) {
    FacesBuilder file;
    const int64_t surface = file.cylinder(2, 3);
    const int64_t below = file.add(100, "0.,0.,0.,2.,0.,2.,0."),
                  above = file.add(100, "3.,0.,0.,2.,0.,2.,0."), seam = file.line({2, 0, 0}, {2, 0, 3});
    const int64_t vertices = file.add(502, "2,2.,0.,0.,2.,0.,3.");
    const std::string list = file.name(vertices);
    const auto edge = [&](int64_t curve, const char *from, const char *to) {
        return "," + file.name(curve) + "," + list + "," + from + "," + list + "," + to;
    };
    const int64_t edges =
        file.add(504, "3" + edge(below, "1", "1") + edge(seam, "1", "2") + edge(above, "2", "2"));
    const std::string at = file.name(edges);
    const int64_t loop =
        file.add(508, "4,0," + at + ",1,1,0,0," + at + ",2,1,0,0," + at + ",3,0,0,0," + at + ",2,0,0");
    const int64_t face = file.add(510, file.name(surface) + ",1,1," + file.name(loop));
    file.add(514, "1," + file.name(face) + ",1");
    const Model found = read_model(file);
    for (const nrb::model::Note &note : found.notes) {
        ADD_FAILURE() << note.text;
    }
    ASSERT_EQ(found.faces.size(), 1U);
    EXPECT_NEAR(area_of(found.faces[0]), 4 * M_PI * 3, 1e-8);
    ASSERT_EQ(found.edges.size(), 3U);
    EXPECT_EQ(found.edges[0].uses.size(), 1U);
    EXPECT_EQ(found.edges[1].uses.size(), 2U);
    EXPECT_EQ(found.edges[2].uses.size(), 1U);
    EXPECT_EQ(found.vertices.size(), 2U);
}

} // namespace

} // namespace iges_solids_test
