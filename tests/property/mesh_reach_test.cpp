// Faces of wild surfaces: wherever the mesh of a surface reaches a chord, so do those of its faces, and each says what it holds.
#include "property/mesh_samples.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace mesh_reach_test {

using namespace support;
using namespace support::meshes;
using faces::polygon;

namespace {

Vec clamped_knots(int count, int degree) {
    Vec knots(static_cast<size_t>(degree), 0);
    for (int i = 0; i <= count - degree; ++i) {
        knots.push_back(static_cast<double>(i) / (count - degree));
    }
    knots.insert(knots.end(), static_cast<size_t>(degree), 1);
    return knots;
}

// Degrees 3 and 2 over the unit square, up and down by its size from each control point to the next one.
Handle wild(Random &random, int rows, int columns) {
    const int32_t degrees[] = {3, 2};
    const int64_t counts[] = {rows, columns};
    Vec knots = clamped_knots(rows, degrees[0]), points;
    const Vec more = clamped_knots(columns, degrees[1]);
    knots.insert(knots.end(), more.begin(), more.end());
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            points.insert(points.end(), {static_cast<double>(i) / (rows - 1),
                                         static_cast<double>(j) / (columns - 1), random.between(-1, 1)});
        }
    }
    return made([&](nurbs **out) {
        return nurbs_create(2, degrees, counts, knots.data(), static_cast<int64_t>(knots.size()), 3,
                            points.data(), 0, 0, nullptr, 0, 0, out);
    });
}

void expect_as_near(const nurbs *ground, const nurbs_face *face, double chord, Random &random) {
    const Mesh mesh = mesh_of(face, chord);
    EXPECT_EQ(mesh.reached, mesh_of(ground, chord).reached) << "chord " << chord;
    EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
    expect_whole(mesh);
    expect_shape_near(ground, face, mesh, random, 200);
}

} // namespace

TEST(MeshReach, faces_reach_what_their_surface_does) {
    for (int seed = 1; seed <= scaled(6); ++seed) {
        Random random(static_cast<uint64_t>(seed));
        const Handle ground = wild(random, 14, seed % 2 == 0 ? 3 : 9);
        const Handle border = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
                     hole = polygon({{0.3, 0.3}, {0.3, 0.62}, {0.62, 0.55}, {0.62, 0.33}});
        const faces::Face own = faces::face_of(ground.get(), {{border.get()}}),
                          trimmed = faces::face_of(ground.get(), {{border.get()}, {hole.get()}});
        for (const double chord : {1.0, 0.3, 0.03}) {
            SCOPED_TRACE(seed);
            expect_as_near(ground.get(), own.get(), chord, random);
            expect_as_near(ground.get(), trimmed.get(), chord, random);
        }
    }
}

// Borders beside the ends of a domain, nearer than the tolerance of the face and farther than the chord: not on the ends.
TEST(MeshReach, faces_reach_chords_below_their_tolerance) {
    constexpr double beside = 4e-4, other = 1 - beside;
    const Handle border =
        polygon({{beside, beside}, {other, beside}, {0.98, 0.5}, {other, other}, {beside, other}});
    for (int seed = 1; seed <= scaled(4); ++seed) {
        Random random(static_cast<uint64_t>(seed));
        const Handle ground = wild(random, 6, 5);
        const faces::Face own = faces::face_of(ground.get(), {{border.get()}}, 10 * beside);
        expect_as_near(ground.get(), own.get(), beside / 2, random);
    }
}

// Beyond the ends of a domain there is no surface: how far a border is beyond them counts once.
TEST(MeshReach, borders_beyond_a_domain_are_as_far_as_they_are) {
    constexpr double beyond = 4e-4, other = 1 + beyond;
    const Handle border = polygon({{-beyond, -beyond}, {other, -beyond}, {other, other}, {-beyond, other}});
    Random random(1);
    const faces::Ground ground = faces::plane();
    const faces::Face own = faces::face_of(ground.surface.get(), {{border.get()}}, 10 * beyond);
    expect_as_near(ground.surface.get(), own.get(), 1.5 * beyond, random);
    EXPECT_EQ(mesh_of(own.get(), 1.5 * beyond).triangles.size(), 2U);
}

// A curve and its edge are farther apart than such a chord however they are divided: not on and on.
TEST(MeshReach, edges_are_not_divided_when_the_work_has_ended) {
    Random random(1);
    const Handle ground = wild(random, 6, 5);
    const Handle border = polygon({{0.1, 0.2}, {0.8, 0.3}, {0.7, 0.9}});
    const faces::Face own = faces::face_of(ground.get(), {{border.get()}});
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = 1e-14;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 10'000'000;
    nurbs_mesh *made = nullptr;
    require_ok(nurbs_mesh_face_with(own.get(), &options, &call, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> mesh(made);
    int64_t edge_points = 0;
    int32_t reached = -1;
    require_ok(nurbs_mesh_counts(made, nullptr, nullptr, nullptr, nullptr, nullptr, &edge_points));
    require_ok(nurbs_mesh_bound(made, nullptr, nullptr, &reached));
    EXPECT_LE(edge_points, call.work / 300);
    EXPECT_EQ(reached, 0);
}

} // namespace mesh_reach_test
