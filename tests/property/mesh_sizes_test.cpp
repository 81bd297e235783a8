// Large meshes and many samples: a hundredth of the size that they have where NURBS_TEST_SCALE is 100.
#include "property/mesh_samples.h"
#include "support/cases.h"

#include <cstdio>
#include <ctime>
#include <gtest/gtest.h>

namespace mesh_sizes_test {

using namespace support;
using namespace support::meshes;
using faces::pi;
using meshes::Point;

// Of surfaces; and as many of triangles.
TEST(MeshSizes, none_of_ten_million_samples_is_farther_than_the_bounds) {
    Random random(51);
    const auto samples = scaled(10000);
    for (const faces::Ground &ground : faces::grounds(random)) {
        for (const double chord : {0.05, 0.005}) {
            const Mesh mesh = mesh_of(ground.surface.get(), chord);
            expect_shape_near(ground.surface.get(), nullptr, mesh, random, samples);
            expect_mesh_near(ground.surface.get(), mesh, random, samples);
        }
    }
}

// All corners of the border are vertices, however small the sides are beside the chord.
TEST(MeshSizes, loops_of_100000_vertices) {
    Random random(7);
    const faces::Ground ground = faces::wavy(random);
    const auto n = static_cast<int>(scaled(1000));
    std::vector<faces::Place> corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * i / n, radius = 0.4 + (i % 2 == 0 ? 0.001 : 0);
        corners.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    const Handle loop = faces::polygon(corners);
    const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
    const std::clock_t start = std::clock();
    const Mesh mesh = mesh_of(face.get(), 3e-3);
    std::printf("%d corners: %.2f us each\n", n,
                1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / n);
    EXPECT_EQ(mesh.reached, 1);
    EXPECT_EQ(euler(mesh, sides_of(mesh)), 1);
    EXPECT_GE(std::ssize(mesh.edge_points), n);
    expect_whole(mesh);
    EXPECT_NEAR(area_of(mesh), faces::area_of(face.get(), 1e-6), 0.02);
}

// A chord error that is too small for a number of its own is none that can be reached: the work ends the mesh.
TEST(MeshSizes, chords_that_underflow) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.relative_chord = 1e-30;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 20'000'000;
    for (const double size : {1.0, 1e-290, 1e-300, 1e-306}) {
        Random random(3);
        SplineData data{{2, 2}, {3, 3}, {{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, 3, {}, {}, 0};
        for (int i = 0; i < 9; ++i) {
            data.points.insert(data.points.end(),
                               {size * (i / 3), size * (i % 3), size * random.between(0, 1)});
        }
        const Handle ground = create(data);
        const faces::Face face = faces::face_of(ground.get(), {}, 1e-9 * size);
        nurbs_mesh *made = nullptr;
        require_ok(nurbs_mesh_model_with(models::model_of({face.get()}).get(), &options, &call, &made));
        const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
        double from_shape = -1;
        int32_t reached = -1;
        require_ok(nurbs_mesh_bound(made, &from_shape, nullptr, &reached));
        EXPECT_EQ(reached, 0) << size;
        EXPECT_LE(from_shape, size) << size;
    }
}

namespace {

struct Cost {
    double triangles, each; // in us of the processor
};
Cost cost_of(const nurbs *g, double chord) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = INT64_MAX;
    nurbs_mesh *made = nullptr;
    const std::clock_t start = std::clock();
    require_ok(nurbs_mesh_surface_with(g, &options, &call, &made));
    const auto taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    int64_t triangles = 0;
    int32_t reached = 0;
    require_ok(nurbs_mesh_counts(made, nullptr, nullptr, &triangles, nullptr, nullptr, nullptr));
    require_ok(nurbs_mesh_bound(made, nullptr, nullptr, &reached));
    EXPECT_EQ(reached, 1);
    const auto count = static_cast<double>(triangles);
    std::printf("%.0f triangles: %.2f us each\n", count, 1e6 * taken / count);
    return {count, 1e6 * taken / count};
}

} // namespace

// Up to ten million: linear but for a factor that leaves room for caches.
TEST(MeshSizes, time_grows_with_the_triangles) {
    const Handle ring = torus(3, 1);
    const double finest = 6e-4 / scale();
    const Cost coarse = cost_of(ring.get(), 8 * finest), fine = cost_of(ring.get(), finest);
    EXPECT_GE(fine.triangles, 4 * coarse.triangles);
    EXPECT_LE(fine.each, 4 * coarse.each);
}

} // namespace mesh_sizes_test
