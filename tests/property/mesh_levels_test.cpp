// Meshes for several distances in one call: each is, bit for bit, what a call for its distance alone gives.
#include "property/meshes.h"
#include "property/models.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/step_solids.h"

#include <cstring>
#include <gtest/gtest.h>
#include <string>

namespace mesh_levels_test {

using namespace support;
using namespace support::meshes;

namespace {

using Own = std::unique_ptr<nurbs_mesh, DestroyMesh>;

nurbs_mesh_options options_of(double angle, double longest) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.angle = angle;
    options.longest = longest;
    return options;
}

template <class T>
bool same_bits(const std::vector<T> &a, const std::vector<T> &b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_equal(const Mesh &a, const Mesh &b) {
    EXPECT_TRUE(same_bits(a.points, b.points));
    EXPECT_TRUE(same_bits(a.normals, b.normals));
    EXPECT_TRUE(same_bits(a.params, b.params));
    EXPECT_TRUE(same_bits(a.at, b.at) && same_bits(a.triangles, b.triangles));
    EXPECT_TRUE(same_bits(a.quads, b.quads) && same_bits(a.first_triangles, b.first_triangles));
    EXPECT_TRUE(same_bits(a.edge_sizes, b.edge_sizes) && same_bits(a.edge_points, b.edge_points));
    EXPECT_EQ(a.from_shape, b.from_shape);
    EXPECT_EQ(a.from_mesh, b.from_mesh);
    EXPECT_EQ(a.reached, b.reached);
}

// Files are told names, colours and which side is outside.
std::string file_of(const nurbs_mesh *mesh) {
    int64_t size = 0;
    require_ok(nurbs_mesh_write(mesh, NURBS_FORMAT_GLB, nullptr, 0, nullptr, &size));
    std::string bytes(static_cast<size_t>(size), ' ');
    require_ok(nurbs_mesh_write(mesh, NURBS_FORMAT_GLB, nullptr, size, bytes.data(), nullptr));
    return bytes;
}

template <class Shape, class Levels, class Single>
void expect_as_single(const Shape *shape, const Vec &chords, nurbs_mesh_options options, Levels levels,
                      Single single) {
    std::vector<nurbs_mesh *> made(chords.size());
    require_ok(levels(shape, std::ssize(chords), chords.data(), &options, made.data()));
    for (size_t i = 0; i < chords.size(); ++i) {
        SCOPED_TRACE(chords[i]);
        const Own own(made[i]);
        options.chord = chords[i];
        options.relative_chord = 0;
        nurbs_mesh *alone = nullptr;
        require_ok(single(shape, &options, &alone));
        const Own other(alone);
        const Mesh mesh = arrays_of(own.get());
        expect_equal(mesh, arrays_of(other.get()));
        if (!mesh.triangles.empty()) {
            EXPECT_TRUE(file_of(own.get()) == file_of(other.get()));
        }
    }
}

void expect_as_single(const nurbs *g, const Vec &chords, const nurbs_mesh_options &options) {
    expect_as_single(g, chords, options, nurbs_mesh_surface_levels, nurbs_mesh_surface);
}
void expect_as_single(const nurbs_face *face, const Vec &chords, const nurbs_mesh_options &options) {
    expect_as_single(face, chords, options, nurbs_mesh_face_levels, nurbs_mesh_face);
}

} // namespace

TEST(MeshLevels, each_of_a_surface_is_that_of_its_own_call) {
    Random random(41);
    for (const faces::Ground &ground : faces::grounds(random)) {
        expect_as_single(ground.surface.get(), {0.05, 0.3, 0.02, 0.05}, options_of(0, 0));
        expect_as_single(ground.surface.get(), {INFINITY, 0.1}, options_of(0.5, 1));
    }
}

// Clamped or not, periodic, rational, with steps of degree 0, anywhere.
TEST(MeshLevels, each_of_surfaces_of_any_form_is_that_of_its_own_call) {
    for_each_case(43, 24, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        Recipe recipe = random_recipe(random, 2, 4);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = random.whole(2, 3);
        const SplineData data = random_spline(random, recipe);
        const auto [least, most] = std::ranges::minmax(data.points);
        const double size = most - least;
        expect_as_single(create(data).get(), {0.1 * size, 0.02 * size, 0.3 * size}, options_of(0, 0));
    });
}

TEST(MeshLevels, each_of_a_face_is_that_of_its_own_call) {
    for_each_case(47, 6, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        for (const faces::Ground &ground : faces::grounds(random)) {
            const faces::Star kind{random.whole(1, 3), random.chance(50), false, 0.4};
            const Handle loop = create(faces::star(random, ground, ground.at(0.5, 0.5), kind));
            const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
            expect_as_single(face.get(), {0.003, 0.1, 0.03, 0.01}, options_of(0, 0));
        }
    });
}

TEST(MeshLevels, each_of_a_solid_is_that_of_its_own_call) {
    for (const std::string &text : {step_test::step_cylinder(true), step_test::step_cone(),
                                    step_test::step_sphere(false), step_test::step_half_torus()}) {
        const models::Model model = models::read_model(text);
        expect_as_single(model.get(), {0.1, 0.01, 0.03}, options_of(0, 0), nurbs_mesh_model_levels,
                         nurbs_mesh_model);
    }
}

// One that ends at the limit of work takes nothing from the others.
TEST(MeshLevels, a_limit_is_one_of_all_together) {
    const Handle g = torus(3, 1);
    const nurbs_mesh_options options = options_of(0, 0);
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 20000000;
    std::vector<nurbs_mesh *> made(2);
    const Vec chords{1e-7, 0.1};
    require_ok(nurbs_mesh_surface_levels_with(g.get(), 2, chords.data(), &options, &call, made.data()));
    const Own fine(made[0]), coarse(made[1]);
    EXPECT_EQ(arrays_of(fine.get()).reached, 0);
    EXPECT_EQ(arrays_of(coarse.get()).reached, 1);
}

} // namespace mesh_levels_test
