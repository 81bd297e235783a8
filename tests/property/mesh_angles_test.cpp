// Meshes without small angles: of all triangles whose circle does not come to the border or to a pole, with all else that holds of
// meshes.
#include "property/mesh_samples.h"
#include "support/cases.h"
#include "support/step_solids.h"

#include <gtest/gtest.h>
#include <numbers>

namespace mesh_angles_test {

using namespace support;
using namespace support::meshes;
using meshes::Point;
using std::numbers::pi;

namespace {

template <class Shape, class Make>
Mesh refined(const Shape *shape, double chord, double least, Make make) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    options.minimum_angle = least;
    nurbs_mesh *made = nullptr;
    require_ok(make(shape, &options, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    return arrays_of(made);
}
Mesh refined(const nurbs *g, double chord, double least) {
    return refined(g, chord, least, nurbs_mesh_surface);
}
Mesh refined(const nurbs_face *face, double chord, double least) {
    return refined(face, chord, least, nurbs_mesh_face);
}

// Points of a net of 5 x 5 over a rectangle of such a width, with heights that alternate.
Vec waves(double width, double height) {
    Vec points;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            points.insert(points.end(), {width * i / 4, j / 4.0, (i + j) % 2 == 0 ? height : -height});
        }
    }
    return points;
}

double least_angle(const Triangle &t) {
    const Point corners[] = {t.a, t.b, t.c};
    double least = pi;
    for (size_t k = 0; k < 3; ++k) {
        const Point a = minus(corners[(k + 1) % 3], corners[k]), b = minus(corners[(k + 2) % 3], corners[k]),
                    across = cross(a, b);
        least = std::min(least, std::atan2(std::sqrt(dot(across, across)), dot(a, b)));
    }
    return least;
}

// Segments in space.
using Segments = std::vector<std::array<Point, 2>>;

// Sides without a triangle on their other side, segments of edges, and sides at points of so many vertices that these are poles.
Segments barriers_of(const Mesh &mesh) {
    const Sides sides = sides_of(mesh);
    std::map<int64_t, int> vertices;
    for (const int64_t point : mesh.at) {
        ++vertices[point];
    }
    Segments result;
    const auto add = [&](int64_t a, int64_t b) {
        result.push_back({mesh.points[static_cast<size_t>(a)], mesh.points[static_cast<size_t>(b)]});
    };
    for (const auto &[side, count] : sides) {
        const bool free = sides.count({side[1], side[0]}) == 0,
                   pole = vertices[side[0]] > 4 || vertices[side[1]] > 4;
        if (free || pole) {
            add(side[0], side[1]);
        }
    }
    for (size_t i = 0; i < mesh.edge_firsts.size(); ++i) {
        const int64_t *at = &mesh.edge_points[static_cast<size_t>(mesh.edge_firsts[i])];
        for (int64_t k = 1; k < mesh.edge_sizes[i]; ++k) {
            add(at[k - 1], at[k]);
        }
    }
    return result;
}

double from_segment(const Point &x, const std::array<Point, 2> &segment) {
    const Point d = minus(segment[1], segment[0]), off = minus(x, segment[0]);
    const double share = dot(d, d) > 0 ? std::clamp(dot(off, d) / dot(d, d), 0.0, 1.0) : 0;
    const Point rest{off[0] - share * d[0], off[1] - share * d[1], off[2] - share * d[2]};
    return std::sqrt(dot(rest, rest));
}

// Whether the circle of a triangle comes to a barrier. Surfaces are not flat, so that it counts as a little larger.
bool reaches(const Triangle &t, const Segments &barriers) {
    const Point a = minus(t.b, t.a), b = minus(t.c, t.a), n = cross(a, b), u = cross(n, a), v = cross(b, n);
    Point centre{};
    for (size_t k = 0; k < 3; ++k) {
        centre[k] = t.a[k] + (dot(b, b) * u[k] + dot(a, a) * v[k]) / (2 * dot(n, n));
    }
    const Point off = minus(centre, t.a);
    const double radius = 1.25 * std::sqrt(dot(off, off));
    return std::ranges::any_of(barriers,
                               [&](const auto &segment) { return from_segment(centre, segment) <= radius; });
}

// Returns how many triangles are said to have no small angle.
int64_t expect_no_small_angles(const Mesh &mesh, double least) {
    const Segments barriers = barriers_of(mesh);
    int64_t small = 0, count = 0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle own = triangle(mesh, i);
        const bool fails = !(least_angle(own) >= least * (1 - 1e-12));
        count += fails ? 0 : 1;
        small += fails && !reaches(own, barriers) ? 1 : 0;
    }
    EXPECT_EQ(small, 0);
    return count;
}

} // namespace

TEST(MeshAngles, triangles_of_surfaces_have_no_small_angles) {
    Random random(3);
    for (const faces::Ground &ground : faces::grounds(random)) {
        for (const double least : {0.2, 0.45, pi / 6}) {
            const Mesh mesh = refined(ground.surface.get(), 0.02, least);
            EXPECT_EQ(mesh.reached, 1);
            EXPECT_GE(10 * expect_no_small_angles(mesh, least), 9 * std::ssize(mesh.triangles));
            expect_shape_near(ground.surface.get(), nullptr, mesh, random, 2000);
            expect_mesh_near(ground.surface.get(), mesh, random, 500);
            EXPECT_EQ(free_sides(sides_of(mesh)),
                      free_sides(sides_of(refined(ground.surface.get(), 0.02, 0)))); // none is divided
        }
    }
}

TEST(MeshAngles, triangles_of_faces_have_no_small_angles) {
    for_each_case(13, 12, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        for (const faces::Ground &ground : faces::grounds(random)) {
            const faces::Star kind{random.whole(1, 3), random.chance(50), false, 0.4};
            const Handle loop = create(faces::star(random, ground, ground.at(0.5, 0.5), kind));
            const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
            const double least = random.between(0.1, 0.5);
            const Mesh mesh = refined(face.get(), 0.02, least);
            EXPECT_EQ(mesh.reached, 1);
            expect_no_small_angles(mesh, least);
            expect_shape_near(ground.surface.get(), face.get(), mesh, random, 1000);
            expect_mesh_near(ground.surface.get(), mesh, random, 500);
            expect_whole(mesh);
        }
    });
}

// Over a grid of points, so that no side of a cell is far longer in space than others of as many parameters.
SplineData gentle(Random &random) {
    Recipe recipe;
    for (int k = 0; k < 2; ++k) {
        const KnotForm form = random.chance(50) ? KnotForm::clamped : KnotForm::unclamped;
        recipe.axes.push_back({random.whole(1, 4), form, Spacing::integers, Placement::origin, 4});
    }
    recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
    SplineData data = random_spline(random, recipe);
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const double x[] = {static_cast<double>(i / data.counts[1]), static_cast<double>(i % data.counts[1]),
                            0};
        for (size_t c = 0; c < 3; ++c) {
            data.points[static_cast<size_t>(3 * i) + c] = x[c] + random.between(-0.2, 0.2);
        }
    }
    for (double &weight : data.weights) {
        weight = random.between(0.7, 1.4);
    }
    return data;
}

TEST(MeshAngles, triangles_of_surfaces_of_any_form_have_no_small_angles) {
    for_each_case(19, 30, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Handle g = create(gentle(random));
        const double least = random.between(0.1, 0.36);
        const Mesh mesh = refined(g.get(), 0.02, least);
        EXPECT_EQ(mesh.reached, 1);
        expect_no_small_angles(mesh, least);
        expect_shape_near(g.get(), nullptr, mesh, random, 500);
    });
}

// Periodic, with steps of degree 0, with poles, folded and crumpled: whatever comes of the angles, all else holds.
TEST(MeshAngles, surfaces_of_any_kind_stay_whole_and_near) {
    for_each_case(17, 12, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        Recipe recipe = random_recipe(random, 2, 4);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        const auto [lower, upper] = std::ranges::minmax(data.points);
        const Handle g = create(data);
        const auto make = [](const nurbs *shape, const nurbs_mesh_options *options, nurbs_mesh **out) {
            nurbs_call_options call;
            require_ok(nurbs_call_options_init(&call, sizeof call));
            call.work = 30000000;
            return nurbs_mesh_surface_with(shape, options, &call, out);
        };
        const double chord = 0.1 * (upper - lower);
        // Without anything to do, but with cells at the same places.
        const Mesh plain = refined(g.get(), chord, 1e-9, make), mesh = refined(g.get(), chord, 0.3, make);
        EXPECT_EQ(free_sides(sides_of(mesh)), free_sides(sides_of(plain)));
        EXPECT_EQ(euler(mesh, sides_of(mesh)), euler(plain, sides_of(plain)));
        if (mesh.reached == 1) {
            EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
        }
        if (data.degrees[0] > 0 && data.degrees[1] > 0) { // else it is curves and points
            expect_shape_near(g.get(), nullptr, mesh, random, 200);
        }
    });
}

TEST(MeshAngles, solids_stay_closed) {
    for (const std::string &text : {step_test::step_cylinder(true), step_test::step_cone(),
                                    step_test::step_sphere(false), step_test::step_half_torus()}) {
        const models::Model model = models::read_model(text);
        const Mesh mesh = refined(model.get(), 0.03, 0.4, nurbs_mesh_model);
        EXPECT_EQ(mesh.reached, 1);
        expect_no_small_angles(mesh, 0.4);
        const Sides sides = sides_of(model.get(), mesh);
        EXPECT_EQ(free_sides(sides), 0);
        expect_common_edges(mesh, sides);
        expect_whole(mesh, sides);
    }
}

// Powers of two in the unit of length change nothing.
TEST(MeshAngles, angles_know_no_unit) {
    const Mesh mesh = refined(torus(3, 1).get(), 0.1, 0.4);
    for (const double unit : {0x1p-300, 0x1p-40, 0x1p40, 0x1p300}) {
        EXPECT_EQ(refined(torus(3 * unit, unit).get(), 0.1 * unit, 0.4).triangles, mesh.triangles);
    }
}

// Where a surface is ten thousand times as long as it is wide, all of the work goes into angles; it ends, and says so.
TEST(MeshAngles, a_limit_of_work_ends_it) {
    nurbs_mesh_options options;
    nurbs_call_options call;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    require_ok(nurbs_call_options_init(&call, sizeof call));
    options.minimum_angle = 0.5;
    call.work = 20000000;
    const faces::Ground thin = faces::cylinder(1e-4, 1);
    nurbs_mesh *made = nullptr;
    require_ok(nurbs_mesh_surface_with(thin.surface.get(), &options, &call, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    const Mesh mesh = arrays_of(made);
    EXPECT_EQ(mesh.reached, 0);
    EXPECT_LE(mesh.from_shape, 1e-3);
    EXPECT_EQ(euler(mesh, sides_of(mesh)), 0);
}

// A strip fifty times as long as it is wide with waves of its width: with whatever work, distances are what they are without angles.
TEST(MeshAngles, distances_come_first) {
    const Handle ground = create(
        {{2, 2}, {5, 5}, {{0, 0, 0, 1, 2, 3, 3, 3}, {0, 0, 0, 1, 2, 3, 3, 3}}, 3, waves(0.02, 0.02), {}, 0});
    const Handle border = faces::polygon({{0.5, 0.3}, {2.4, 0.7}, {2.8, 1.9}, {1.6, 2.7}, {0.3, 2.1}});
    const faces::Face face = faces::face_of(ground.get(), {{border.get()}});
    for (const int64_t work : {100000000, 300000000}) {
        const Mesh mesh =
            refined(face.get(), 1e-4, 0.31,
                    [&](const nurbs_face *own, const nurbs_mesh_options *options, nurbs_mesh **out) {
                        nurbs_call_options call;
                        require_ok(nurbs_call_options_init(&call, sizeof call));
                        call.work = work;
                        return nurbs_mesh_face_with(own, options, &call, out);
                    });
        EXPECT_EQ(mesh.reached, 0);
        EXPECT_LE(mesh.from_shape, 1e-4) << work;
    }
}

} // namespace mesh_angles_test
