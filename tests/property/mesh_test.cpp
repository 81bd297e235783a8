// Meshes: dense samples of shapes are no farther from the triangles than the bound, and those of triangles no farther from the shape;
// vertices are points of surfaces bit for bit, triangles have each side in common with one other and turn with the normals; laws
// of area, of scales and of knots; real files.
#include "property/faces.h"
#include "property/solids.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace mesh_test {

using namespace support;
using faces::pi;

namespace {

using Vec = std::vector<double>;
using Point = std::array<double, 3>;
using Corners = std::array<int64_t, 3>;

struct DestroyMesh {
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};

struct Mesh {
    std::vector<Point> points, normals;
    std::vector<std::array<double, 2>> params;
    std::vector<int64_t> at; // points of the vertices
    std::vector<Corners> triangles, welded;
    std::vector<int64_t> first_triangles, triangle_counts; // of the faces
    std::vector<int64_t> edge_firsts, edge_sizes, edge_points;
    double from_shape = -1, from_mesh = -1;
    int32_t reached = -1;
};

template <class T>
auto *flat(std::vector<T> &records) {
    return records.empty() ? nullptr : records[0].data();
}

Mesh arrays_of(const nurbs_mesh *mesh) {
    int64_t points = 0, vertices = 0, triangles = 0, faces = 0, edges = 0, edge_points = 0;
    require_ok(nurbs_mesh_counts(mesh, &points, &vertices, &triangles, &faces, &edges, &edge_points));
    const auto resize = [](auto &array, int64_t n) { array.resize(static_cast<size_t>(n)); };
    Mesh all;
    resize(all.points, points);
    resize(all.normals, vertices);
    resize(all.params, vertices);
    resize(all.at, vertices);
    resize(all.triangles, triangles);
    resize(all.welded, triangles);
    resize(all.first_triangles, faces);
    resize(all.triangle_counts, faces);
    resize(all.edge_firsts, edges);
    resize(all.edge_sizes, edges);
    resize(all.edge_points, edge_points);
    require_ok(nurbs_mesh_bound(mesh, &all.from_shape, &all.from_mesh, &all.reached));
    require_ok(nurbs_mesh_points(mesh, points, flat(all.points), nullptr));
    require_ok(
        nurbs_mesh_vertices(mesh, vertices, all.at.data(), flat(all.params), flat(all.normals), nullptr));
    require_ok(nurbs_mesh_triangles(mesh, 0, triangles, flat(all.triangles), nullptr));
    require_ok(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, triangles, flat(all.welded), nullptr));
    require_ok(nurbs_mesh_faces(mesh, faces, nullptr, nullptr, all.first_triangles.data(),
                                all.triangle_counts.data(), nullptr, nullptr, nullptr, nullptr));
    require_ok(nurbs_mesh_edges(mesh, edges, nullptr, all.edge_firsts.data(), all.edge_sizes.data(), nullptr,
                                nullptr, nullptr));
    require_ok(nurbs_mesh_edge_points(mesh, edge_points, all.edge_points.data(), nullptr));
    return all;
}

template <class Shape, class Function>
Mesh mesh_of(const Shape *shape, double chord, Function make) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    nurbs_mesh *made = nullptr;
    require_ok(make(shape, &options, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    return arrays_of(made);
}
Mesh mesh_of(const nurbs *g, double chord) {
    return mesh_of(g, chord, nurbs_mesh_surface);
}
Mesh mesh_of(const nurbs_face *face, double chord) {
    return mesh_of(face, chord, nurbs_mesh_face);
}
Mesh mesh_of(const nurbs_model *model, double chord) {
    return mesh_of(model, chord, nurbs_mesh_model);
}

double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point minus(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Triangle {
    Point a, b, c;

    [[nodiscard]] Point across() const { return cross(minus(b, a), minus(c, a)); }
    [[nodiscard]] double area() const { return std::sqrt(dot(across(), across())) / 2; }
    [[nodiscard]] Point at(double s, double t) const {
        Point x{};
        for (size_t k = 0; k < 3; ++k) {
            x[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
        }
        return x;
    }
    // Over it the height, elsewhere the distance of the nearest side.
    [[nodiscard]] double distance(const Point &x) const {
        const Point normal = across(), corners[] = {a, b, c};
        double least = INFINITY;
        bool over = dot(normal, normal) > 0;
        for (size_t k = 0; k < 3; ++k) {
            const Point &from = corners[k], side = minus(corners[(k + 1) % 3], from), off = minus(x, from);
            over = over && dot(cross(normal, side), off) >= 0;
            const double share = std::clamp(dot(off, side) / dot(side, side), 0.0, 1.0);
            const Point rest{off[0] - share * side[0], off[1] - share * side[1], off[2] - share * side[2]};
            least = std::min(least, std::sqrt(dot(rest, rest)));
        }
        return over ? std::min(least, std::fabs(dot(normal, minus(x, a))) / std::sqrt(dot(normal, normal)))
                    : least;
    }
};

Triangle triangle(const Mesh &mesh, size_t i) {
    const Corners &at = mesh.welded[i];
    return {mesh.points[static_cast<size_t>(at[0])], mesh.points[static_cast<size_t>(at[1])],
            mesh.points[static_cast<size_t>(at[2])]};
}

double area_of(const Mesh &mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh.welded.size(); ++i) {
        sum += triangle(mesh, i).area();
    }
    return sum;
}

double distance(const Mesh &mesh, const Point &x) {
    double least = INFINITY;
    for (size_t i = 0; i < mesh.welded.size(); ++i) {
        least = std::min(least, triangle(mesh, i).distance(x));
    }
    return least;
}

// How often triangles run along a side from one point to another.
using Sides = std::map<std::array<int64_t, 2>, int>;
void add_sides(const Corners &at, bool turned, Sides &sides) {
    for (size_t k = 0; k < 3; ++k) {
        const int64_t from = at[k], to = at[(k + 1) % 3];
        EXPECT_NE(from, to);
        ++sides[turned ? std::array{to, from} : std::array{from, to}];
    }
}
Sides sides_of(const Mesh &mesh) {
    Sides sides;
    for (const Corners &at : mesh.welded) {
        add_sides(at, false, sides);
    }
    return sides;
}

// Sides without a triangle on their other side; none has two on one.
int64_t free_sides(const Sides &sides) {
    int64_t free = 0;
    for (const auto &[side, count] : sides) {
        EXPECT_EQ(count, 1);
        free += sides.count({side[1], side[0]}) == 0 ? 1 : 0;
    }
    return free;
}

int64_t euler(const Mesh &mesh, const Sides &sides) {
    std::set<int64_t> used;
    for (const Corners &at : mesh.welded) {
        used.insert(at.begin(), at.end());
    }
    const auto edges = (std::ssize(sides) + free_sides(sides)) / 2;
    return std::ssize(used) - edges + std::ssize(mesh.welded);
}

Handle sphere(double radius) {
    return std::move(faces::sphere(radius).surface);
}
Handle torus(double major, double minor) {
    return std::move(faces::torus(major, minor).surface);
}

Point point_of(const nurbs *g, const std::array<double, 2> &at) {
    Point x{};
    require_ok(nurbs_eval(g, 1, at.data(), 0, 0, x.data(), 0, 0, 0));
    return x;
}

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

// Sides of the triangles of a model about its outer normals.
Sides sides_of(const nurbs_model *model, const Mesh &mesh) {
    Sides sides;
    for (size_t face = 0; face < mesh.first_triangles.size(); ++face) {
        int32_t against = 0;
        nurbs_face *own = nullptr;
        require_ok(
            nurbs_model_face(model, static_cast<int64_t>(face), nullptr, nullptr, &against, nullptr, &own));
        nurbs_face_destroy(own);
        const auto first = static_cast<size_t>(mesh.first_triangles[face]);
        for (size_t i = 0; std::cmp_less(i, mesh.triangle_counts[face]); ++i) {
            add_sides(mesh.welded[first + i], against != 0, sides);
        }
    }
    return sides;
}

// Its edges are those of triangles of both faces that share them.
void expect_common_edges(const Mesh &mesh, const Sides &sides) {
    for (size_t i = 0; i < mesh.edge_firsts.size(); ++i) {
        const int64_t *at = &mesh.edge_points[static_cast<size_t>(mesh.edge_firsts[i])];
        for (int64_t k = 1; k < mesh.edge_sizes[i]; ++k) {
            EXPECT_EQ(sides.count({at[k - 1], at[k]}) + sides.count({at[k], at[k - 1]}), 2U) << i;
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
