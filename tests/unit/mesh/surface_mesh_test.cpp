// SPDX-License-Identifier: MIT
// Meshes of whole surfaces: both proven distances against samples and nearest points, how triangles hang together, kinks, jumps and
// closed axes.
#include "mesh/surface_mesh.h"

#include "base/error.h"
#include "closest/closest.h"
#include "eval/evaluate.h"
#include "mesh/proof/distance.h"
#include "support/generators.h"
#include "support/scale.h"
#include "unit/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace surface_mesh_test {

using namespace nrb;
using mesh::Mesh;
using mesh::MeshPtr;
using mesh::MeshRule;

namespace {

MeshRule within(double chord) {
    MeshRule rule;
    rule.chord = chord;
    return rule;
}

// Rational points over knots; the last `repeated` points of each row are the first ones.
SplinePtr wavy(support::Random &random, int degree, std::vector<double> knots, bool rational) {
    const int count = static_cast<int>(knots.size()) - degree - 1;
    std::vector<double> points, weights;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            points.insert(points.end(), {i + random.between(-0.2, 0.2), j + random.between(-0.2, 0.2),
                                         random.between(-0.5, 0.5)});
            weights.push_back(random.between(0.6, 1.6));
        }
    }
    const KnotVectorPtr axis = make_knot_vector(degree, std::move(knots));
    return make_spline({axis, axis}, 3, rational ? Form::rational : Form::polynomial, std::move(points),
                       rational ? std::move(weights) : std::vector<double>{});
}

std::vector<double> clamped(int degree, int spans) {
    std::vector<double> knots(static_cast<size_t>(degree), 0.0);
    for (int i = 0; i <= spans; ++i) {
        knots.push_back(i);
    }
    knots.insert(knots.end(), static_cast<size_t>(degree), spans);
    return knots;
}

std::array<Vector3, 3> points_of(const Mesh &mesh, size_t triangle) {
    std::array<Vector3, 3> result;
    for (size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<size_t>(mesh.triangles[triangle][k]);
        result[k] = mesh.points[static_cast<size_t>(mesh.vertices[vertex].point)];
    }
    return result;
}

// Sides by the points that they join, with how many triangles have them.
std::map<std::pair<int32_t, int32_t>, int> sides_of(const Mesh &mesh) {
    std::map<std::pair<int32_t, int32_t>, int> sides;
    for (const auto &triangle : mesh.triangles) {
        for (size_t k = 0; k < 3; ++k) {
            const int32_t a = mesh.vertices[static_cast<size_t>(triangle[k])].point,
                          b = mesh.vertices[static_cast<size_t>(triangle[(k + 1) % 3])].point;
            ++sides[std::minmax(a, b)];
        }
    }
    return sides;
}

int64_t free_sides(const Mesh &mesh) {
    int64_t count = 0;
    for (const auto &[side, triangles] : sides_of(mesh)) {
        EXPECT_LE(triangles, 2);
        count += triangles == 1 ? 1 : 0;
    }
    return count;
}

int64_t euler(const Mesh &mesh) {
    std::set<int32_t> points;
    for (const auto &triangle : mesh.triangles) {
        for (const int32_t vertex : triangle) {
            points.insert(mesh.vertices[static_cast<size_t>(vertex)].point);
        }
    }
    return std::ssize(points) - std::ssize(sides_of(mesh)) + std::ssize(mesh.triangles);
}

Vector3 at(const Spline &surface, double u, double v) {
    const std::array<double, 2> x{u, v};
    std::array<double, 3> point{};
    eval::evaluate_points(surface, {}, 0, {x.data(), 1, 2, 2, 1},
                          {point.data(), 1, surface.dim(), surface.dim(), 1});
    return {point[0], point[1], point[2]};
}

// Samples of each of the two are no farther from the other than is proven.
void expect_proven(const Spline &surface, const Mesh &mesh, support::Random &random, int64_t samples) {
    const mesh::MeshFace &face = mesh.faces.front();
    const Interval u = surface.axis(0).domain(), v = surface.axis(1).domain();
    for (int64_t i = 0; i < samples; ++i) {
        const Vector3 x = at(surface, random.between(u.lower, u.upper), random.between(v.lower, v.upper));
        double nearest = infinity;
        for (size_t t = 0; t < mesh.triangles.size(); ++t) {
            nearest = std::min(nearest, mesh::distance_from_triangle(x, points_of(mesh, t)));
        }
        EXPECT_LE(nearest, face.from_shape);
        const auto t = static_cast<size_t>(random.whole(0, static_cast<int>(mesh.triangles.size()) - 1));
        const auto corners = points_of(mesh, t);
        const double a = random.unit(), b = random.unit() * (1 - a);
        const Vector3 p = a * corners[0] + b * corners[1] + (1 - a - b) * corners[2];
        const std::array<double, 3> query{p.x, p.y, p.z};
        const closest::Foot foot = closest::locator_of(surface).nearest(
            {query.data(), nullptr, 1e-3 * face.from_mesh, closest::usual_budget(surface), false, true});
        EXPECT_LE(foot.distance, face.from_mesh * 1.002);
    }
}

} // namespace

TEST(SurfaceMesh, distances_hold_for_samples) {
    support::Random random(42);
    for (int i = 0; i < 12; ++i) {
        const int degree = random.whole(2, 4);
        const SplinePtr surface =
            wavy(random, degree, clamped(degree, random.whole(1, 4)), random.chance(60));
        const double chord = random.magnitude(0.002, 0.1);
        const MeshPtr mesh = mesh_of(*surface, within(chord));
        EXPECT_TRUE(mesh->faces.front().reached);
        EXPECT_LE(mesh->faces.front().from_shape, chord);
        EXPECT_LE(mesh->faces.front().from_mesh, chord);
        EXPECT_EQ(euler(*mesh), 1);
        expect_proven(*surface, *mesh, random, support::scaled(60));
    }
}

TEST(SurfaceMesh, vertices_are_places_of_the_surface) {
    support::Random random(43);
    const SplinePtr surface = wavy(random, 3, clamped(3, 3), true);
    const MeshPtr mesh = mesh_of(*surface, within(0.02));
    for (const mesh::MeshVertex &vertex : mesh->vertices) {
        const Vector3 x = at(*surface, vertex.param[0], vertex.param[1]),
                      p = mesh->points[static_cast<size_t>(vertex.point)];
        EXPECT_EQ(x.x, p.x);
        EXPECT_EQ(x.y, p.y);
        EXPECT_EQ(x.z, p.z);
        EXPECT_NEAR(length(vertex.normal), 1, 1e-12);
    }
}

// Along a kink there are vertices for both sides, which share points; along a jump they share nothing.
TEST(SurfaceMesh, kinks_and_jumps) {
    support::Random random(44);
    for (const int multiplicity : {2, 3}) {
        std::vector<double> knots{0, 0, 0};
        knots.insert(knots.end(), static_cast<size_t>(multiplicity), 1.0);
        knots.insert(knots.end(), {2, 2, 2});
        const SplinePtr surface = wavy(random, 2, knots, false);
        const MeshPtr mesh = mesh_of(*surface, within(0.05));
        EXPECT_TRUE(mesh->faces.front().reached);
        EXPECT_EQ(euler(*mesh), multiplicity == 2 ? 1 : 4);
        int64_t on_kink = 0;
        std::set<int32_t> points;
        for (const mesh::MeshVertex &vertex : mesh->vertices) {
            if (vertex.param[0] == 1) {
                ++on_kink;
                points.insert(vertex.point);
            }
        }
        EXPECT_GT(on_kink, 2);
        EXPECT_EQ(std::ssize(points) < on_kink, multiplicity == 2);
        for (size_t t = 0; t < mesh->triangles.size(); ++t) { // none passes it
            bool before = false, behind = false;
            for (const int32_t vertex : mesh->triangles[t]) {
                const double u = mesh->vertices[static_cast<size_t>(vertex)].param[0];
                before = before || u < 1;
                behind = behind || u > 1;
            }
            EXPECT_FALSE(before && behind);
        }
    }
}

// A tube of a periodic axis has no border but its two ends, and as many triangles wherever its seam is.
TEST(SurfaceMesh, periodic_axes_close) {
    const int count = 8;
    std::vector<double> points;
    for (int i = 0; i < count + 3; ++i) {
        for (int j = 0; j < 2; ++j) {
            const double t = 2 * M_PI * (i % count) / count;
            points.insert(points.end(), {std::cos(t), std::sin(t), static_cast<double>(j)});
        }
    }
    std::vector<double> knots;
    for (int i = -3; i <= count + 3; ++i) {
        knots.push_back(i);
    }
    const SplinePtr tube =
        make_spline({make_knot_vector(3, knots, true), shapes::bezier_axis(1)}, 3, Form::polynomial, points);
    const MeshPtr mesh = mesh_of(*tube, within(0.01));
    EXPECT_TRUE(mesh->faces.front().reached);
    EXPECT_EQ(euler(*mesh), 0);
    int64_t at_ends = 0;
    for (const mesh::MeshVertex &vertex : mesh->vertices) {
        at_ends +=
            vertex.param[0] < static_cast<double>(count) && (vertex.param[1] == 0 || vertex.param[1] == 1)
                ? 1
                : 0;
    }
    EXPECT_EQ(free_sides(*mesh), at_ends);
}

TEST(SurfaceMesh, flat_surfaces_take_two_triangles) {
    std::vector<double> points;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) {
            points.insert(points.end(), {i / 29.0, j / 29.0, 0.3 * i / 29.0 - 0.2 * j / 29.0});
        }
    }
    std::vector<double> knots{0, 0, 0};
    for (int i = 1; i < 28; ++i) {
        knots.push_back(i);
    }
    knots.insert(knots.end(), {28, 28, 28});
    // Greville abscissae: an affine map.
    const KnotVectorPtr axis = make_knot_vector(2, knots);
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) {
            const auto g = [&](int k) {
                return (knots[static_cast<size_t>(k) + 1] + knots[static_cast<size_t>(k) + 2]) / 2;
            };
            double *x = points.data() + 3 * (30 * i + j);
            x[0] = g(i);
            x[1] = g(j);
            x[2] = 0.3 * g(i) - 0.2 * g(j);
        }
    }
    const MeshPtr mesh = mesh_of(*make_spline({axis, axis}, 3, Form::polynomial, points), within(1e-6));
    EXPECT_EQ(mesh->triangles.size(), 2U);
    EXPECT_TRUE(mesh->faces.front().reached);
}

TEST(SurfaceMesh, sides_are_limited) {
    support::Random random(45);
    const SplinePtr surface = wavy(random, 3, clamped(3, 2), true);
    MeshRule rule = within(10);
    rule.longest = 0.25;
    const MeshPtr mesh = mesh_of(*surface, rule);
    EXPECT_TRUE(mesh->faces.front().reached);
    for (size_t t = 0; t < mesh->triangles.size(); ++t) {
        const auto x = points_of(*mesh, t);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_LE(length(x[k] - x[(k + 1) % 3]), 0.25);
        }
    }
}

// In the plane triangles turn as the surface does.
TEST(SurfaceMesh, of_the_plane) {
    const SplinePtr surface = make_spline({shapes::bezier_axis(2), shapes::bezier_axis(1)}, 2,
                                          Form::polynomial, {0, 0, 0, 1, 1, 0.5, 1, 1.5, 2, 0, 2, 1});
    const MeshPtr mesh = mesh_of(*surface, within(0.01));
    EXPECT_TRUE(mesh->faces.front().reached);
    for (size_t t = 0; t < mesh->triangles.size(); ++t) {
        const auto x = points_of(*mesh, t);
        EXPECT_GT(cross(x[1] - x[0], x[2] - x[0]).z, 0);
    }
    EXPECT_EQ(mesh->vertices.front().normal.z, 1);
}

// Where an axis has degree 0 there are strips without a width.
TEST(SurfaceMesh, of_degree_0) {
    const SplinePtr surface =
        make_spline({make_knot_vector(0, {0, 1, 2}), shapes::bezier_axis(2)}, 3, Form::polynomial,
                    {0, 0, 0, 1, 1, 0, 2, 0, 0, 5, 0, 1, 6, 1, 1, 7, 0, 1});
    const MeshPtr mesh = mesh_of(*surface, within(0.01));
    EXPECT_TRUE(mesh->faces.front().reached);
    EXPECT_GT(mesh->triangles.size(), 4U);
    support::Random random(46);
    expect_proven(*surface, *mesh, random, 20);
}

TEST(SurfaceMesh, scales_by_powers_of_two_exactly) {
    support::Random random(47);
    const SplinePtr surface = wavy(random, 3, clamped(3, 3), true);
    std::vector<double> points = shapes::vector_of(surface->points());
    for (double &x : points) {
        x = std::ldexp(x, 40);
    }
    const SplinePtr large = make_spline(surface->knot_vectors(), 3, Form::rational, points,
                                        shapes::vector_of(surface->weights()));
    const MeshPtr a = mesh_of(*surface, within(0.02)), b = mesh_of(*large, within(std::ldexp(0.02, 40)));
    EXPECT_EQ(a->triangles, b->triangles);
    EXPECT_EQ(std::ldexp(a->faces.front().from_shape, 40), b->faces.front().from_shape);
}

// Weights that pass through 0: nothing can be proven, and it ends all the same.
TEST(SurfaceMesh, poles_of_weights_are_told) {
    std::vector<double> records;
    for (int i = 0; i < 4; ++i) {
        const double w = i == 3 ? -1 : 1;
        records.insert(records.end(), {w * (i / 2), w * (i % 2), w, w});
    }
    const SplinePtr surface =
        make_spline({shapes::bezier_axis(1), shapes::bezier_axis(1)}, 3, Form::homogeneous, records);
    const MeshPtr mesh = mesh_of(*surface, within(0.1));
    EXPECT_FALSE(mesh->faces.front().reached);
    EXPECT_EQ(mesh->faces.front().from_shape, infinity);
}

TEST(SurfaceMesh, others_are_refused) {
    const SplinePtr curve = shapes::bezier(3, {0, 0, 0, 1, 0, 0}),
                    high = make_spline({shapes::bezier_axis(1), shapes::bezier_axis(1)}, 4, Form::polynomial,
                                       std::vector<double>(16, 1.0));
    for (const auto &[spline, status] :
         {std::pair{curve, Status::axes}, std::pair{high, Status::dimension}}) {
        try {
            (void)mesh_of(*spline, within(0.1));
            ADD_FAILURE();
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), status);
        }
    }
}

} // namespace surface_mesh_test
