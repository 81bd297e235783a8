// Faults of other meshers, by the number of the issue that reports them.
#include "property/mesh_samples.h"
#include "property/solids.h"
#include "support/cases.h"
#include "support/step_solids.h"

#include <gtest/gtest.h>

namespace mesh_traps_test {

using namespace support;
using namespace support::meshes;
using faces::Face;
using faces::Ground;
using faces::pi;
using faces::Place;
using faces::polygon;
using faces::segment;
using meshes::Point;

namespace {

Handle circle(const Place &centre, double radius) {
    return made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre.data(), nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

Mesh expect_meshed(const nurbs_face *face, double chord, int64_t characteristic) {
    const Mesh mesh = mesh_of(face, chord);
    EXPECT_EQ(mesh.reached, 1);
    EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
    EXPECT_EQ(euler(mesh, sides_of(mesh)), characteristic);
    expect_whole(mesh);
    return mesh;
}

// The whole of a ground, with a border where it is not closed.
Face whole(const Ground &ground) {
    return faces::face_of(ground.surface.get(), {});
}

// A spindle: circles around the z axis, made of cubics, about three cones that end in points.
Handle spindle() {
    const int32_t degrees[] = {1, 3};
    const int64_t counts[] = {4, 7};
    const double knots[] = {0, 0, 1, 2, 3, 3, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    const double radii[] = {0, 1, 2, 0}, heights[] = {0, 1, 2, 9}, turns[] = {1, 0, -1, 0};
    Vec points;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = 0; j < 7; ++j) {
            points.insert(points.end(), {radii[i] * turns[j % 4], radii[i] * turns[(j + 3) % 4], heights[i]});
        }
    }
    return made([&](nurbs **out) {
        return nurbs_create(2, degrees, counts, knots, 17, 3, points.data(), 0, 0, nullptr, 0,
                            NURBS_ON_AXIS(1, NURBS_PERIODIC), out);
    });
}

Mesh mesh_within(const nurbs *g, double chord, int64_t work) {
    return mesh_of(g, chord, [&](const nurbs *shape, const nurbs_mesh_options *options, nurbs_mesh **out) {
        nurbs_call_options call;
        require_ok(nurbs_call_options_init(&call, sizeof call));
        call.work = work;
        return nurbs_mesh_surface_with(shape, options, &call, out);
    });
}

} // namespace

// Oblikovati#101: faces flattened to a plane and cut into ears. Half a ball that its equator bounds has points inside.
TEST(MeshTraps, faces_are_not_flattened) {
    const Ground ground = faces::sphere(1);
    const Handle equator = segment(ground.at(0, 0.5), ground.at(1, 0.5));
    const Face face = faces::face_of(ground.surface.get(), {{equator.get()}});
    for (const double chord : {0.1, 0.01, 0.001}) {
        const Mesh mesh = expect_meshed(face.get(), chord, 1);
        EXPECT_NEAR(area_of(mesh), 2 * pi, 4 * pi * chord);
        EXPECT_GT(mesh.points.size(), 2 * static_cast<size_t>(mesh.edge_sizes[0]));
    }
}

// oce#143: 46948 triangles where 1676 do. A trimmed face has about its share of those of the surface, and some along the border.
TEST(MeshTraps, borders_do_not_multiply_triangles) {
    for (const Ground &ground : {faces::torus(3, 1), faces::sphere(1.5)}) {
        const Mesh all = mesh_of(ground.surface.get(), 3e-3);
        for (const double radius : {0.2, 0.05}) {
            const Handle hole =
                circle(ground.at(0.55, 0.55), radius * std::min(ground.period[0], ground.period[1]));
            const Face face = faces::face_of(ground.surface.get(), {{hole.get()}});
            const Mesh mesh = expect_meshed(face.get(), 3e-3, 1);
            const double share = faces::area_of(face.get(), 1e-6) / area_of(all);
            EXPECT_LE(static_cast<double>(mesh.triangles.size()),
                      1.5 * share * static_cast<double>(all.triangles.size()) +
                          12 * static_cast<double>(mesh.edge_points.size()));
        }
    }
}

// oce#641: three quarters of a face. All of what closes up is there, whatever the tolerance.
TEST(MeshTraps, faces_around_are_whole) {
    const Ground grounds[] = {faces::cylinder(2, 3), faces::sphere(1.5), faces::torus(3, 1)};
    const double areas[] = {12 * pi, 9 * pi, 12 * pi * pi}, characteristics[] = {0, 2, 0};
    for (size_t i = 0; i < 3; ++i) {
        for (const double chord : {0.5, 0.1, 0.01}) {
            const Mesh mesh =
                expect_meshed(whole(grounds[i]).get(), chord, static_cast<int64_t>(characteristics[i]));
            EXPECT_NEAR(area_of(mesh), areas[i], 1.5 * areas[i] * chord);
        }
    }
}

// OCCT#929: vertices inside that no triangle has; gridfinity-layout-tool#2085 and brepkit#696: T-junctions, and sides with one
// triangle or three.
TEST(MeshTraps, solids_are_closed) {
    const std::pair<std::string, int64_t> solids[] = {
        {step_test::step_cube(), 2},          {step_test::step_cylinder(true), 2},
        {step_test::step_cylinder(false), 2}, {step_test::step_cone(), 2},
        {step_test::step_sphere(false), 2},   {step_test::step_sphere(true), 2},
        {step_test::step_half_torus(), 0}};
    for (const auto &[text, characteristic] : solids) {
        const models::Model model = models::read_model(text);
        for (const double chord : {0.3, 0.03, 0.003}) {
            const Mesh mesh = mesh_of(model.get(), chord);
            const Sides sides = sides_of(model.get(), mesh);
            EXPECT_EQ(mesh.reached, 1);
            EXPECT_EQ(free_sides(sides), 0);
            EXPECT_EQ(euler(mesh, sides), characteristic);
            expect_whole(mesh, sides);
        }
    }
}

// OCCT#682: rough tangents. Normals are those of the surface, whatever the tolerance.
TEST(MeshTraps, normals_are_those_of_the_surface) {
    Random random(3);
    const Ground ground = faces::wavy(random);
    const Handle hole = circle({0.5, 0.5}, 0.3);
    const Face face = faces::face_of(ground.surface.get(), {{hole.get()}});
    for (const double chord : {0.1, 0.001}) {
        const Mesh mesh = mesh_of(face.get(), chord);
        Vec params;
        for (const auto &param : mesh.params) {
            params.insert(params.end(), param.begin(), param.end());
        }
        const Vec jets = eval_derivs(ground.surface.get(), 1, params);
        for (size_t i = 0; i < mesh.normals.size(); ++i) {
            const double *jet = &jets[9 * i];
            const Point product = meshes::cross({jet[3], jet[4], jet[5]}, {jet[6], jet[7], jet[8]});
            for (size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(mesh.normals[i][c], product[c] / std::sqrt(dot(product, product)), 1e-13);
            }
        }
    }
}

// text-to-cad#371: vertices at a seam welded by the distance of their parameters. A slot that is narrower than any epsilon stays open,
// beside the seam, across it and elsewhere.
TEST(MeshTraps, what_is_close_is_not_welded) {
    const Ground ground = faces::cylinder(2, 3);
    for (const double width : {1e-4, 1e-6}) {
        for (const double at : {0.5, 1.0, 1 + 2 * width, 0.7}) {
            const Handle slot = polygon({ground.at(at - width, 0.3), ground.at(at + width, 0.3),
                                         ground.at(at + width, 0.7), ground.at(at - width, 0.7)}),
                         low = segment(ground.at(0, 0), ground.at(1, 0)),
                         high = segment(ground.at(1, 1), ground.at(0, 1));
            const Face face = faces::face_of(ground.surface.get(), {{low.get()}, {high.get()}, {slot.get()}});
            expect_meshed(face.get(), 0.01, -1);
        }
    }
}

// And what is one is one: the seam, whose ends have other parameters.
TEST(MeshTraps, seams_are_welded) {
    const Ground ground = faces::torus(3, 1);
    const Mesh mesh = expect_meshed(whole(ground).get(), 0.01, 0);
    EXPECT_EQ(free_sides(sides_of(mesh)), 0);
    EXPECT_GT(mesh.at.size(), mesh.points.size()); // vertices on both sides of it
}

// Where work ends early, a strip around an axis may have a single cell, and no triangle with three points. What is missing is told.
TEST(MeshTraps, strips_without_triangles_are_told) {
    Random random(6);
    const Handle g = spindle();
    size_t proven = 0;
    for (double work = 1000; work < 1e6; work *= 1.1) {
        const Mesh mesh = mesh_within(g.get(), 3, static_cast<int64_t>(work));
        const Vec places = places_of(g.get(), nullptr, random, 40);
        for (size_t i = 0; i < places.size(); i += 2) {
            Point x{};
            require_ok(nurbs_eval(g.get(), 1, &places[i], 0, 0, x.data(), 0, 0, 0));
            ASSERT_LE(distance(mesh, x), mesh.from_shape * (1 + 1e-12)) << work;
        }
        proven += std::isfinite(mesh.from_shape) ? 1 : 0;
    }
    EXPECT_GT(proven, 10U);
}

// A border along a kink, around a bump on the other side of it: what is beside a segment in another block has first derivatives of its own.
TEST(MeshTraps, bumps_beside_a_kink_are_seen) {
    const int32_t degrees[] = {2, 8}, straight = 1, round = 2;
    const int64_t counts[] = {5, 9}, three = 3;
    const double knots[] = {0, 0, 0, 0.5, 0.5, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    Vec points;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 9; ++j) {
            const double high = j != 4 ? 0 : i == 0 ? -1316.6 : i == 1 ? 73.14 : 0;
            points.insert(points.end(), {i / 4.0, j / 8.0, high});
        }
    }
    const Handle g = made([&](nurbs **out) {
        return nurbs_create(2, degrees, counts, knots, 26, 3, points.data(), 0, 0, nullptr, 0, 0, out);
    });
    const double along[] = {0, 0, 1, 2, 2}, back[] = {0, 0, 0, 1, 1, 1}, a[] = {0.5, 0, 1, 0.5, 0.5, 1},
                 b[] = {0.5, 1, 0.4, 0.5, 0.5, 0};
    const Handle first = made([&](nurbs **out) {
        return nurbs_create(1, &straight, &three, along, 5, 2, a, 0, 0, nullptr, 0, 0, out);
    });
    const Handle second = made([&](nurbs **out) {
        return nurbs_create(1, &round, &three, back, 6, 2, b, 0, 0, nullptr, 0, 0, out);
    });
    const int64_t size = 2;
    const nurbs *const curves[] = {first.get(), second.get()};
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(g.get(), 1, &size, curves, nullptr, nullptr, 1e-9, 0, nullptr, &face));
    const Face own(face);
    const double top[] = {0.475, 0.5};
    Point x{};
    require_ok(nurbs_eval(g.get(), 1, top, 0, 0, x.data(), 0, 0, 0));
    for (const double chord : {2.0, 0.9, 0.5, 0.35}) {
        const Mesh mesh = mesh_of(face, chord);
        EXPECT_LE(distance(mesh, x), mesh.from_shape * (1 + 1e-12)) << chord;
    }
}

// build123d#1444 is a mesh that is coarser than asked for; where work ends that cannot be helped, but it is told, and equally fine all over.
TEST(MeshTraps, work_that_ends_makes_all_of_a_mesh_coarser) {
    Random random(7);
    const Ground ground = faces::wavy(random);
    double before = HUGE_VAL;
    for (const int64_t work : {3000000, 12000000, 48000000}) {
        const Mesh mesh = mesh_within(ground.surface.get(), 1e-9, work);
        EXPECT_EQ(mesh.reached, 0);
        const auto triangles = static_cast<double>(mesh.triangles.size());
        EXPECT_LE(mesh.from_shape, 0.3 * before); // four times as many triangles
        before = mesh.from_shape;
        // One for that distance is no smaller than a third.
        const Mesh other = mesh_of(ground.surface.get(), mesh.from_shape);
        EXPECT_LE(triangles, 3 * static_cast<double>(other.triangles.size()));
        EXPECT_GE(triangles, 2.5e-5 * static_cast<double>(work));
    }
}

// CDT!133: refinement that does not end, and Oblikovati#1409: a limit of it that is taken for success. Between sides that meet at a
// small angle there are few triangles.
TEST(MeshTraps, refinement_ends_at_small_angles) {
    Random random(4);
    const Ground ground = faces::wavy(random);
    for (const double angle : {1e-2, 1e-4, 1e-6}) {
        const Handle needle = polygon({{0.1, 0.2}, {0.9, 0.3}, {0.9, 0.3 + angle}});
        const Face face = faces::face_of(ground.surface.get(), {{needle.get()}});
        EXPECT_LE(expect_meshed(face.get(), 1e-3, 1).triangles.size(), 2000U);
    }
}

// build123d#1444: a coarse mesh that is there already in place of a finer one. Meshes do not depend on those before them.
TEST(MeshTraps, meshes_do_not_depend_on_those_before) {
    for_each_case(5, 3, [](Random &random, uint64_t seed) {
        const Ground ground = faces::wavy(random);
        const Handle fresh = create(read_back(ground.surface.get())), hole = circle({0.5, 0.5}, 0.3);
        const Face face = faces::face_of(ground.surface.get(), {{hole.get()}}),
                   other = faces::face_of(fresh.get(), {{hole.get()}});
        const size_t coarse = mesh_of(face.get(), 0.1).triangles.size();
        const Mesh fine = mesh_of(face.get(), 0.001), alone = mesh_of(other.get(), 0.001);
        EXPECT_GT(fine.triangles.size(), 4 * coarse) << seed;
        EXPECT_EQ(fine.triangles, alone.triangles) << seed;
        EXPECT_EQ(fine.points, alone.points) << seed;
        EXPECT_EQ(mesh_of(face.get(), 0.1).triangles.size(), coarse) << seed;
    });
}

} // namespace mesh_traps_test
