// Meshes: dense samples of shapes are no farther from the triangles than the bound, and those of triangles no farther from the shape;
// vertices are points of surfaces bit for bit, triangles have each side in common with one other and turn with the normals; laws
// of area, of scales and of knots; real files.
#include "property/meshes.h"
#include "property/solids.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace mesh_test {

using namespace support;
using namespace support::meshes;
using faces::pi;
using meshes::Point;

namespace {

// Both ways.
void expect_proven(const nurbs *g, const Mesh &mesh, Random &random, int samples) {
    double u[2], v[2];
    require_ok(nurbs_domain(g, 0, u));
    require_ok(nurbs_domain(g, 1, v));
    double most = 0;
    for (int i = 0; i < samples; ++i) {
        most = std::max(
            most, distance(mesh, point_of(g, {random.between(u[0], u[1]), random.between(v[0], v[1])})));
    }
    EXPECT_LE(most, mesh.from_shape * (1 + 1e-12));
    Vec places;
    for (int i = 0; i < samples; ++i) {
        const auto at = static_cast<size_t>(random.whole(0, static_cast<int>(mesh.welded.size()) - 1));
        const double s = random.unit(), t = random.unit() * (1 - s);
        const Point x = triangle(mesh, at).at(s, t);
        places.insert(places.end(), x.begin(), x.end());
    }
    Vec params(static_cast<size_t>(2 * samples)), distances(static_cast<size_t>(samples));
    require_ok(nurbs_closest_points(g, samples, places.data(), 0, 0, nullptr, mesh.from_mesh / 1024, 0,
                                    params.data(), 0, 0, nullptr, 0, 0, distances.data(), 0, nullptr, 0));
    EXPECT_LE(*std::ranges::max_element(distances), mesh.from_mesh * (1 + 1.0 / 512));
}

// With knots of any multiplicity that leaves it in one piece, in the three forms.
SplineData wavy(Random &random, int form) {
    SplineData data{{random.whole(1, 4), random.whole(2, 4)}, {}, {{}, {}}, 3, {}, {}, 0};
    for (size_t k = 0; k < 2; ++k) {
        const int degree = data.degrees[k], count = degree + 3 + random.whole(0, 3);
        data.counts.push_back(count);
        for (int i = 0; i < count + degree + 1; ++i) {
            data.knots[k].push_back(form == 0 ? std::clamp(i - degree, 0, count - degree) : i);
        }
    }
    for (int i = 0; i < data.counts[0]; ++i) {
        for (int j = 0; j < data.counts[1]; ++j) {
            data.points.insert(data.points.end(),
                               {static_cast<double>(i) + random.between(-0.2, 0.2),
                                static_cast<double>(j) + random.between(-0.2, 0.2), random.between(-1, 1)});
        }
    }
    if (form == 2) {
        for (int64_t i = 0; i < data.point_count(); ++i) {
            data.weights.push_back(random.between(0.5, 2));
        }
    }
    return data;
}

TEST(Mesh, no_sample_is_farther_than_the_bounds) {
    for_each_case(1, 12, [](Random &random, uint64_t seed) {
        const Handle g = create(wavy(random, random.whole(0, 2)));
        const double chord = random.magnitude(3e-3, 0.3);
        const Mesh mesh = mesh_of(g.get(), chord);
        SCOPED_TRACE(seed);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
        expect_proven(g.get(), mesh, random, 100);
    });
}

TEST(Mesh, of_shapes_that_close_no_sample_is_farther_than_the_bounds) {
    Random random(7);
    for (const double chord : {0.3, 0.03}) {
        for (const Handle &g : {sphere(1.5), torus(3, 1)}) {
            const Mesh mesh = mesh_of(g.get(), chord);
            EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
            expect_proven(g.get(), mesh, random, 300);
        }
    }
}

TEST(Mesh, vertices_are_points_of_the_surface_bit_for_bit) {
    for_each_case(21, 20, [](Random &random, uint64_t seed) {
        const Handle g = create(wavy(random, random.whole(0, 2)));
        const Mesh mesh = mesh_of(g.get(), 0.05);
        for (size_t i = 0; i < mesh.at.size(); ++i) {
            const Point x = point_of(g.get(), mesh.params[i]),
                        &y = mesh.points[static_cast<size_t>(mesh.at[i])];
            EXPECT_EQ(x, y) << seed;
        }
    });
}

TEST(Mesh, triangles_turn_with_the_normals) {
    for_each_case(41, 20, [](Random &random, uint64_t seed) {
        const Handle g = seed % 2 == 0 ? sphere(random.between(1, 2)) : torus(3, random.between(0.5, 1));
        const Mesh mesh = mesh_of(g.get(), 0.01);
        for (size_t i = 0; i < mesh.triangles.size(); ++i) {
            const Point across = triangle(mesh, i).across();
            for (const int64_t vertex : mesh.triangles[i]) {
                const Point &normal = mesh.normals[static_cast<size_t>(vertex)];
                EXPECT_GT(dot(across, normal), 0.5 * std::sqrt(dot(across, across))) << seed;
                EXPECT_NEAR(dot(normal, normal), 1, 1e-14);
            }
        }
    });
}

TEST(Mesh, inner_sides_have_two_triangles) {
    for_each_case(61, 20, [](Random &random, uint64_t seed) {
        const SplineData data = wavy(random, random.whole(0, 2));
        const Mesh mesh = mesh_of(create(data).get(), random.magnitude(3e-3, 0.3));
        const Sides sides = sides_of(mesh);
        EXPECT_EQ(euler(mesh, sides), 1) << where(seed, data); // a disk
        for (const auto &[side, count] : sides) {
            if (sides.count({side[1], side[0]}) > 0) {
                continue;
            }
            const auto on_border = [&](int64_t point) {
                const auto at = static_cast<size_t>(std::ranges::find(mesh.at, point) - mesh.at.begin());
                const auto &uv = mesh.params[at];
                return uv[0] == data.lower(0) || uv[0] == data.upper(0) || uv[1] == data.lower(1) ||
                       uv[1] == data.upper(1);
            };
            EXPECT_TRUE(on_border(side[0]) && on_border(side[1])) << where(seed, data);
        }
    });
}

TEST(Mesh, closed_shapes_have_no_free_side) {
    for (const double chord : {0.5, 0.1, 1e-2, 1e-3}) {
        const Mesh ball = mesh_of(sphere(1).get(), chord), ring = mesh_of(torus(2, 0.75).get(), chord);
        EXPECT_EQ(free_sides(sides_of(ball)), 0);
        EXPECT_EQ(euler(ball, sides_of(ball)), 2);
        EXPECT_EQ(free_sides(sides_of(ring)), 0);
        EXPECT_EQ(euler(ring, sides_of(ring)), 0);
    }
}

// A star cut out of a ground that is open or closed around.
TEST(Mesh, areas_of_faces_come_nearer_with_the_chord) {
    for_each_case(81, 10, [](Random &random, uint64_t seed) {
        const std::vector<faces::Ground> grounds = faces::grounds(random);
        const faces::Ground &ground = grounds[static_cast<size_t>(random.whole(1, 4))];
        const Handle star = create(faces::any_star(random, ground));
        const faces::Face face = faces::face_of(ground.surface.get(), {{star.get()}});
        const double known = faces::area_of(face.get(), 1e-8);
        for (const double chord : {0.02, 0.002}) {
            const Mesh mesh = mesh_of(face.get(), chord);
            const double told = std::max(mesh.from_shape, mesh.from_mesh);
            EXPECT_EQ(mesh.reached == 1, told <= chord) << seed;
            EXPECT_LE(told, 1.5 * chord) << seed;
            EXPECT_NEAR(area_of(mesh), known, 20 * chord) << seed;
            EXPECT_EQ(euler(mesh, sides_of(mesh)), 1) << seed;
        }
    });
}

// Clamping moves no point; it is exact but for rounding.
TEST(Mesh, knots_of_any_form_give_the_same_triangles) {
    for_each_case(101, 10, [](Random &random, uint64_t seed) {
        const Handle open = create(wavy(random, 1));
        constexpr uint32_t both = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END;
        const Handle clamped = made([&](nurbs **out) {
            nurbs *first = nullptr;
            require_ok(nurbs_clamp_ends(open.get(), 0, both, &first));
            return nurbs_clamp_ends(Handle(first).get(), 1, both, out);
        });
        const Mesh a = mesh_of(open.get(), 0.05), b = mesh_of(clamped.get(), 0.05);
        EXPECT_EQ(a.triangles, b.triangles) << seed;
        EXPECT_NEAR(area_of(a), area_of(b), 1e-12 * area_of(a)) << seed;
    });
}

TEST(Mesh, powers_of_two_change_nothing_but_sizes) {
    for_each_case(121, 10, [](Random &random, uint64_t seed) {
        SplineData data = wavy(random, random.whole(0, 2));
        const Mesh mesh = mesh_of(create(data).get(), 0.05);
        const int by = random.whole(-300, 300);
        for (double &x : data.points) {
            x = std::ldexp(x, by);
        }
        const Mesh other = mesh_of(create(data).get(), std::ldexp(0.05, by));
        EXPECT_EQ(mesh.triangles, other.triangles) << seed;
        EXPECT_EQ(mesh.params, other.params) << seed;
        EXPECT_EQ(other.from_shape, std::ldexp(mesh.from_shape, by)) << seed;
        EXPECT_EQ(other.from_mesh, std::ldexp(mesh.from_mesh, by)) << seed;
    });
}

// A roof: sides on both sides of the ridge have vertices of their own there, at the same points.
TEST(Mesh, creases_have_the_normals_of_both_sides) {
    const Vec knots{0, 0, 1, 2, 2};
    const Handle roof = create({{1, 1},
                                {3, 2},
                                {knots, {0, 0, 1, 1}},
                                3,
                                {0, 0, 0, 0, 5, 0, 1, 0, 1, 1, 5, 1, 2, 0, 0, 2, 5, 0},
                                {},
                                0});
    const Mesh mesh = mesh_of(roof.get(), 0.01);
    EXPECT_EQ(std::ssize(mesh.points), 6);
    EXPECT_EQ(std::ssize(mesh.at), 8);
    EXPECT_EQ(std::ssize(mesh.triangles), 4);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Point across = triangle(mesh, i).across();
        for (const int64_t vertex : mesh.triangles[i]) {
            EXPECT_NEAR(dot(across, mesh.normals[static_cast<size_t>(vertex)]),
                        std::sqrt(dot(across, across)), 1e-12);
        }
    }
}

TEST(Mesh, of_a_cylinder_of_three_faces_is_closed) {
    const std::vector<solids::Face> sides = solids::closed_cylinder(2, 3);
    const models::Model model = models::model_of(solids::given(sides));
    const Mesh mesh = mesh_of(model.get(), 1e-2);
    const Sides found = sides_of(mesh);
    EXPECT_EQ(mesh.reached, 1);
    EXPECT_NEAR(area_of(mesh), 20 * pi, 0.3);
    int64_t alone = 0; // whichever way the faces look
    for (const auto &[side, count] : found) {
        const auto back = found.find({side[1], side[0]});
        alone += count + (back == found.end() ? 0 : back->second) == 2 ? 0 : 1;
    }
    EXPECT_EQ(alone, 0);
}

TEST(Mesh, of_real_solids_are_closed) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const auto &[name, area] :
         {std::pair{"countersunk_screw.step", 465.6342}, std::pair{"satellite_mainbody.stp", 211.8716}}) {
        SCOPED_TRACE(name);
        nurbs_model *read = nullptr;
        require_ok(nurbs_read_model_file((std::filesystem::path(folder) / name).c_str(), nullptr, &read));
        const models::Model model(read);
        const Mesh mesh = mesh_of(model.get(), 0.01);
        const Sides sides = sides_of(model.get(), mesh);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_EQ(free_sides(sides), 0);
        EXPECT_EQ(euler(mesh, sides) % 2, 0);
        EXPECT_NEAR(area_of(mesh), area, 0.02 * area);
        expect_common_edges(mesh, sides);
    }
}

} // namespace

} // namespace mesh_test
