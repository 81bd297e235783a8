// What meshes can be asked for besides a distance: normals at the corners of triangles that are near each other, wherever triangles
// lie; and which of them make quads.
#include "property/meshes.h"
#include "support/cases.h"
#include "support/frames.h"

#include <gtest/gtest.h>

namespace mesh_options_test {

using namespace support;
using namespace support::meshes;
using faces::pi;
using meshes::Point;

namespace {

double angle_between(const Point &a, const Point &b) {
    const Point d = minus(a, b);
    return 2 * std::asin(std::min(std::sqrt(dot(d, d)) / 2, 1.0));
}

// Of two corners of a triangle that have normals.
double largest_angle(const Mesh &mesh) {
    double most = 0;
    for (const Corners &corners : mesh.triangles) {
        for (size_t k = 0; k < 3; ++k) {
            const double angle = angle_between(mesh.normals[static_cast<size_t>(corners[k])],
                                               mesh.normals[static_cast<size_t>(corners[(k + 1) % 3])]);
            most = angle > most ? angle : most; // none where there is no normal
        }
    }
    return most;
}

Point normal_at(const nurbs *g, const std::array<double, 2> &at) {
    const Vec normal = surface_frames(g, {at[0], at[1]}).normals;
    return {normal[0], normal[1], normal[2]};
}

// Normals over a triangle, not only at its corners, turn by little more.
void expect_no_waves(const nurbs *g, const Mesh &mesh, double angle, Random &random, int samples) {
    for (int i = 0; i < samples; ++i) {
        const auto at = static_cast<size_t>(random.whole(0, static_cast<int>(mesh.triangles.size()) - 1));
        const double s = random.unit(), t = random.unit() * (1 - s);
        std::array<double, 2> place{};
        for (size_t k = 0; k < 2; ++k) {
            const auto param = [&](size_t corner) {
                return mesh.params[static_cast<size_t>(mesh.triangles[at][corner])][k];
            };
            place[k] = param(0) + s * (param(1) - param(0)) + t * (param(2) - param(0));
        }
        const Point normal = normal_at(g, place);
        for (const int64_t corner : mesh.triangles[at]) {
            const double found = angle_between(normal, mesh.normals[static_cast<size_t>(corner)]);
            EXPECT_FALSE(found > 1.1 * angle) << found << " at " << place[0] << ", " << place[1];
        }
    }
}

// From any of its corners on.
bool is_triangle(const Corners &a, const Corners &b) {
    bool same = false;
    for (size_t k = 0; k < 3; ++k) {
        same = same || (a[0] == b[k] && a[1] == b[(k + 1) % 3] && a[2] == b[(k + 2) % 3]);
    }
    return same;
}

// Returns how many triangles are left.
int64_t expect_quads(const Mesh &mesh) {
    int64_t next = 0, left = std::ssize(mesh.triangles);
    EXPECT_EQ(mesh.quads.size(), mesh.quad_triangles.size());
    for (size_t i = 0; i < mesh.quads.size(); ++i) {
        const Quad &q = mesh.quads[i];
        const auto first = static_cast<size_t>(mesh.quad_triangles[i]);
        EXPECT_GE(mesh.quad_triangles[i], next); // none is in two
        EXPECT_LT(first + 1, mesh.triangles.size());
        EXPECT_TRUE(is_triangle(mesh.triangles[first], {q[0], q[1], q[2]}) &&
                    is_triangle(mesh.triangles[first + 1], {q[0], q[2], q[3]}));
        next = mesh.quad_triangles[i] + 2;
        left -= 2;
        for (size_t k = 0; k < 2; ++k) { // a rectangle of the domain
            const auto param = [&](size_t corner) { return mesh.params[static_cast<size_t>(q[corner])][k]; };
            const bool along = param(0) == param(1);
            EXPECT_TRUE(along ? param(2) == param(3) : param(0) == param(3) && param(1) == param(2));
        }
    }
    return left;
}

// Open, around one axis or both, with control points a little off a plane, a tube or a ring; where the degree is 0, or a knot occurs
// often, it jumps.
SplineData any_surface(Random &random) {
    Recipe recipe;
    recipe.weights = random.chance(30) ? Weights::ones : Weights::none;
    for (int k = 0; k < 2; ++k) {
        AxisRecipe axis{random.whole(0, 3), KnotForm::clamped, Spacing::integers, Placement::origin,
                        random.whole(2, 4)};
        axis.form = random.chance(33)                      ? KnotForm::clamped
                    : axis.degree > 0 && random.chance(50) ? KnotForm::periodic
                                                           : KnotForm::unclamped;
        recipe.axes.push_back(axis);
    }
    SplineData data = random_spline(random, recipe);
    std::array<int64_t, 2> distinct{};
    std::array<bool, 2> around{};
    for (size_t k = 0; k < 2; ++k) {
        around[k] = (data.flags & NURBS_ON_AXIS(k, NURBS_PERIODIC)) != 0;
        distinct[k] = data.counts[k] - (around[k] ? data.degrees[k] : 0);
    }
    Vec noise(static_cast<size_t>(distinct[0] * distinct[1]));
    std::ranges::generate(noise, [&] { return random.between(-0.2, 0.2); });
    data.points.clear();
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        for (int64_t j = 0; j < data.counts[1]; ++j) {
            const int64_t u = i % distinct[0], v = j % distinct[1];
            const double off = noise[static_cast<size_t>(u * distinct[1] + v)];
            const double a = 2 * pi * static_cast<double>(u) / static_cast<double>(distinct[0]),
                         b = 2 * pi * static_cast<double>(v) / static_cast<double>(distinct[1]);
            const Point place = around[0] && around[1] ? Point{(4 + (1 + off) * std::cos(b)) * std::cos(a),
                                                               (4 + (1 + off) * std::cos(b)) * std::sin(a),
                                                               (1 + off) * std::sin(b)}
                                : around[0] ? Point{(2 + off) * std::cos(a), (2 + off) * std::sin(a), b}
                                : around[1] ? Point{(2 + off) * std::cos(b), (2 + off) * std::sin(b), a}
                                            : Point{a, b, off};
            data.points.insert(data.points.end(), place.begin(), place.end());
        }
    }
    return data;
}

double enough(double angle) {
    return angle * (1 + 1e-12);
}

} // namespace

TEST(MeshOptions, normals_at_corners_are_within_the_angle) {
    Random random(3);
    for (const faces::Ground &ground : faces::grounds(random)) {
        for (const double angle : {0.5, 0.15}) {
            const Mesh mesh = mesh_of(ground.surface.get(), INFINITY, angle);
            EXPECT_EQ(mesh.reached, 1);
            EXPECT_LE(largest_angle(mesh), enough(angle));
            expect_no_waves(ground.surface.get(), mesh, angle, random, 200);
        }
    }
}

TEST(MeshOptions, normals_of_faces_are_within_the_angle_up_to_their_borders) {
    for_each_case(5, 10, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        for (const faces::Ground &ground : faces::grounds(random)) {
            const faces::Star kind{random.whole(1, 3), random.chance(50), false, 0.4};
            const Handle loop = create(faces::star(random, ground, ground.at(0.5, 0.5), kind));
            const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
            const Mesh mesh = mesh_of(face.get(), INFINITY, 0.3);
            EXPECT_EQ(mesh.reached, 1);
            EXPECT_LE(largest_angle(mesh), enough(0.3));
            expect_quads(mesh);
        }
    });
}

// Between two lines that are skew: their edges are straight, and normals turn along them.
TEST(MeshOptions, straight_edges_are_divided_where_normals_turn) {
    const Handle twisted = create(
        {{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1, 0}, {}, 0});
    const Handle loop = faces::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const faces::Face face = faces::face_of(twisted.get(), {{loop.get()}});
    const Mesh mesh = mesh_of(face.get(), INFINITY, 0.1);
    EXPECT_EQ(mesh.reached, 1);
    EXPECT_LE(largest_angle(mesh), enough(0.1));
}

// A cylinder of so many sides, a sphere of about as many triangles as an even grid has.
TEST(MeshOptions, angles_take_no_more_triangles_than_they_need) {
    const faces::Ground round = faces::cylinder(2, 3);
    for (const double angle : {0.5, 0.1, 0.02}) {
        const double needed = 8 * std::ceil(pi / 2 / angle), even = 16 * pi / (angle * angle);
        const Mesh tube = mesh_of(round.surface.get(), INFINITY, angle);
        EXPECT_EQ(tube.reached, 1);
        EXPECT_LE(static_cast<double>(tube.triangles.size()), 1.6 * needed) << angle;
        const Mesh ball = mesh_of(sphere(1).get(), INFINITY, angle);
        EXPECT_EQ(ball.reached, 1);
        EXPECT_LE(static_cast<double>(ball.triangles.size()), (1.4 + 5 * angle) * even) << angle;
    }
}

// The unit of length changes nothing.
TEST(MeshOptions, angles_know_no_unit) {
    for (const double radius : {0x1p-40, 0x1p40}) {
        EXPECT_EQ(mesh_of(torus(3 * radius, radius).get(), INFINITY, 0.3).triangles,
                  mesh_of(torus(3, 1).get(), INFINITY, 0.3).triangles);
    }
}

// The tip of a cone has no normal, a crease two, and a line at which the surface turns back has one that jumps inside.
TEST(MeshOptions, singular_places_do_not_take_all_of_the_work) {
    const Vec once{0, 0, 1, 1}, twice{0, 0, 0, 1, 1, 1};
    const Handle cone = create(
        {{2, 1}, {3, 2}, {twice, once}, 3, {0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1}, {}, 0});
    const Mesh tip = mesh_of(cone.get(), INFINITY, 0.1);
    EXPECT_EQ(tip.reached, 1);
    EXPECT_LE(largest_angle(tip), enough(0.1));
    const Handle roof = create({{1, 1},
                                {3, 2},
                                {{0, 0, 1, 2, 2}, once},
                                3,
                                {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0},
                                {},
                                0});
    EXPECT_EQ(mesh_of(roof.get(), INFINITY, 0.1).triangles.size(), 4U);
    EXPECT_EQ(mesh_of(roof.get(), INFINITY, 0.1).reached, 1);
    const Handle cusp = create({{3, 1},
                                {4, 2},
                                {{0, 0, 0, 0, 1, 1, 1, 1}, once},
                                3,
                                {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0},
                                {},
                                0});
    const Mesh turned = mesh_of(cusp.get(), INFINITY, 0.1);
    EXPECT_EQ(turned.reached, 0);
    EXPECT_LE(turned.triangles.size(), 20000U);
}

TEST(MeshOptions, quads_and_the_other_triangles_are_all_of_them) {
    Random random(11);
    for (const faces::Ground &ground : faces::grounds(random)) {
        const Mesh mesh = mesh_of(ground.surface.get(), 0.01);
        EXPECT_LT(expect_quads(mesh), std::max<int64_t>(3 * std::ssize(mesh.triangles) / 4, 1));
    }
    const faces::Ground flat = faces::plane();
    EXPECT_EQ(expect_quads(mesh_of(flat.surface.get(), 0.01)), 0);
}

// Unclamped, periodic, of degree 0.
TEST(MeshOptions, angles_and_quads_of_any_form_and_degree) {
    int64_t reached = 0, all = 0;
    for_each_case(21, 40, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Handle g = create(any_surface(random));
        const Mesh mesh = mesh_of(g.get(), INFINITY, 0.25);
        ++all;
        if (mesh.reached == 1) {
            ++reached;
            EXPECT_LE(largest_angle(mesh), enough(0.25));
        }
        expect_quads(mesh);
    });
    EXPECT_GT(reached, of_whole_run(3 * all / 4));
}

} // namespace mesh_options_test
