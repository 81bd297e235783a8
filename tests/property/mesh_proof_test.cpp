// Bounds of distances where much depends on little: corners off a surface with weights, creases beside a border, tips.
#include "property/mesh_samples.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace mesh_proof_test {

using namespace support;
using namespace support::meshes;
using faces::pi;
using faces::polygon;

namespace {

Vec clamped(int32_t degree, int64_t count, double lower, double upper) {
    Vec knots(static_cast<size_t>(degree + 1), lower);
    for (int64_t i = 1; i < count - degree; ++i) {
        knots.push_back(lower +
                        (upper - lower) * static_cast<double>(i) / static_cast<double>(count - degree));
    }
    knots.insert(knots.end(), static_cast<size_t>(degree + 1), upper);
    return knots;
}

Handle curve(int32_t degree, int32_t dim, const Vec &points, const Vec &weights = {}) {
    const auto count = std::ssize(points) / dim;
    return create({{degree}, {count}, {clamped(degree, count, 0, 1)}, dim, points, weights, 0});
}

void expect_proven(const nurbs *ground, const nurbs_face *face, double chord) {
    const Mesh mesh = mesh_of(face, chord);
    Random random(3);
    expect_shape_near(ground, face, mesh, random, 20000);
    expect_mesh_near(ground, mesh, random, 2000);
}

} // namespace

// All edges are in a plane, and all of a rational surface below it: between the edges by more than at them.
TEST(MeshProof, edges_off_a_surface_with_weights) {
    constexpr double off = 0.01, weight = 0.85, width = 0.1;
    Vec points, weights;
    for (const double u : {0.0, 0.5, 1.0}) {
        const double own = u == 0.5 ? weight : 1;
        for (const double v : {0.0, width}) {
            points.insert(points.end(), {u, v, -off / own});
            weights.push_back(own);
        }
    }
    const Handle ground =
        create({{2, 1}, {3, 2}, {clamped(2, 3, 0, 1), clamped(1, 2, 0, 1)}, 3, points, weights, 0});
    const auto across = [&](double u, double from, double to) { return curve(1, 3, {u, from, 0, u, to, 0}); };
    const auto along = [&](double v, double from, double to) {
        return curve(2, 3, {from, v, 0, 0.5, v, 0, to, v, 0}, {1, weight, 1});
    };
    const std::array<Handle, 4> curves{curve(1, 2, {0, 0, 1, 0}), curve(1, 2, {1, 0, 1, 1}),
                                       curve(1, 2, {1, 1, 0, 1}), curve(1, 2, {0, 1, 0, 0})},
        edges{along(0, 0, 1), across(1, 0, width), along(width, 1, 0), across(0, width, 0)};
    std::array<const nurbs *, 4> own_curves{}, own_edges{};
    std::ranges::transform(curves, own_curves.begin(), &Handle::get);
    std::ranges::transform(edges, own_edges.begin(), &Handle::get);
    const int64_t size = 4;
    nurbs_face *made = nullptr;
    require_ok(nurbs_face_create(ground.get(), 1, &size, own_curves.data(), own_edges.data(), nullptr, 0.011,
                                 0, nullptr, &made));
    const faces::Face face(made);
    expect_proven(ground.get(), face.get(), 0.0101);
}

// A border that runs beyond a crease and back between two vertices on it: there the surface goes down.
TEST(MeshProof, borders_over_creases) {
    constexpr double bend = 0.05, beyond = 0.01;
    Vec points;
    for (const auto &[x, z] : {std::pair(-20.0, 0.0), std::pair(0.0, 0.0), std::pair(0.0, -1.0)}) {
        for (const double y : {-1.0, 0.0, 1.0}) {
            points.insert(points.end(), {x, y, (y == 0 ? -bend : bend) + z});
        }
    }
    const Handle ground =
        create({{1, 2}, {3, 3}, {{-20, -20, 0, 1, 1}, {-1, -1, -1, 1, 1, 1}}, 3, points, {}, 0});
    constexpr int count = 40;
    Vec bulge;
    for (int i = 0; i < count; ++i) {
        const double v = i == 0 ? -1 : i + 1 == count ? 1 : -1 + 2 * (i - 0.5) / (count - 2);
        bulge.insert(bulge.end(), {beyond * (1 - v * v), v});
    }
    const Handle low = curve(1, 2, {-20, -1, 0, -1}), border = curve(2, 2, bulge),
                 high = curve(1, 2, {0, 1, -20, 1}), left = curve(1, 2, {-20, 1, -20, -1});
    const faces::Face face =
        faces::face_of(ground.get(), {{low.get(), border.get(), high.get(), left.get()}});
    expect_proven(ground.get(), face.get(), 0.1);
}

// Where rulings come together, triangles that follow them may lie on each other.
TEST(MeshProof, tips_of_cones_are_whole) {
    const Handle cone = made([](nurbs **out) {
        return nurbs_surface_cone(nullptr, nullptr, nullptr, 0.84, 0, 1.1, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                  out);
    });
    double u[2], v[2];
    require_ok(nurbs_domain(cone.get(), 0, u));
    require_ok(nurbs_domain(cone.get(), 1, v));
    const std::array<Handle, 4> sides{
        curve(1, 2, {u[0], v[0], u[1], v[0]}), curve(1, 2, {u[1], v[0], u[1], v[1]}),
        curve(1, 2, {u[1], v[1], u[0], v[1]}), curve(1, 2, {u[0], v[1], u[0], v[0]})};
    const faces::Face face =
        faces::face_of(cone.get(), {{sides[0].get(), sides[1].get(), sides[2].get(), sides[3].get()}});
    for (const double chord : {4e-4, 3.4e-4, 3e-4}) {
        const Mesh mesh = mesh_of(face.get(), chord);
        const Sides sides_of_triangles = sides_of(mesh);
        EXPECT_EQ(mesh.reached, 1) << chord;
        EXPECT_EQ(euler(mesh, sides_of_triangles), 1);
        for (const auto &side : sides_of_triangles) {
            EXPECT_EQ(side.second, 1);
        }
    }
}

} // namespace mesh_proof_test
