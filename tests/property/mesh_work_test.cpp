// Meshes where the work is not enough for the distance that is asked for: about as near as it allows, on all faces.
#include "property/mesh_samples.h"
#include "property/real_files.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace mesh_work_test {

using namespace support;
using namespace support::meshes;

namespace {

// A bicubic over the unit square, up and down by a tenth.
Handle rough(Random &random) {
    constexpr int count = 6;
    const int32_t degrees[] = {3, 3};
    const int64_t counts[] = {count, count};
    Vec knots, points;
    for (int k = 0; k < 2; ++k) {
        for (const double knot : {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}) {
            knots.push_back(knot / 3);
        }
    }
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            points.insert(points.end(), {static_cast<double>(i) / (count - 1),
                                         static_cast<double>(j) / (count - 1), random.between(0, 0.1)});
        }
    }
    return made([&](nurbs **out) {
        return nurbs_create(2, degrees, counts, knots.data(), std::ssize(knots), 3, points.data(), 0, 0,
                            nullptr, 0, 0, out);
    });
}

faces::Face with_hole(const nurbs *ground) {
    const Handle border = faces::polygon({{0.05, 0.05}, {0.95, 0.1}, {0.9, 0.95}, {0.1, 0.9}}),
                 hole = faces::polygon({{0.3, 0.4}, {0.45, 0.7}, {0.7, 0.5}});
    return faces::face_of(ground, {{border.get()}, {hole.get()}});
}

struct Told {
    double bound;
    int64_t edge_points;
    bool reached;
};

template <class Shape, class Function>
Told mesh_with_work(const Shape *shape, double chord, int64_t work, Function make) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    nurbs_mesh *mesh = nullptr;
    require_ok(make(shape, &options, &call, &mesh));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(mesh);
    double from_shape = 0, from_mesh = 0;
    int32_t reached = -1;
    int64_t edge_points = 0;
    require_ok(nurbs_mesh_bound(mesh, &from_shape, &from_mesh, &reached));
    require_ok(nurbs_mesh_counts(mesh, nullptr, nullptr, nullptr, nullptr, nullptr, &edge_points));
    return {std::max(from_shape, from_mesh), edge_points, reached != 0};
}

// What is asked for in vain costs no more than some of what there would be without.
template <class Shape, class Function>
void expect_near_whatever_is_asked(const Shape *shape, int64_t work, Function make) {
    constexpr double most_lost = 100;
    double nearest = INFINITY;
    for (double chord = 1e-2; chord > 1e-15; chord /= 10) {
        const Told told = mesh_with_work(shape, chord, work, make);
        EXPECT_LE(told.bound, std::max(most_lost * nearest, 1.01 * chord)) << "chord " << chord;
        EXPECT_TRUE(!told.reached || told.bound <= chord) << "chord " << chord;
        nearest = std::min(nearest, told.bound);
    }
    EXPECT_LE(nearest, 1e-3);
}

} // namespace

TEST(MeshWork, faces_are_as_near_as_the_work_allows_whatever_is_asked) {
    for (int seed = 1; seed <= scaled(3); ++seed) {
        Random random(static_cast<uint64_t>(seed));
        const Handle ground = rough(random);
        const faces::Face face = with_hole(ground.get());
        expect_near_whatever_is_asked(face.get(), 50'000'000, nurbs_mesh_face_with);
    }
}

// Rational surfaces that close, with poles and without.
TEST(MeshWork, closed_faces_are_as_near_as_the_work_allows) {
    std::vector<faces::Ground> grounds;
    grounds.push_back(faces::sphere(1));
    grounds.push_back(faces::torus(2, 0.5));
    grounds.push_back(faces::cylinder(1, 2));
    for (const faces::Ground &ground : grounds) {
        const faces::Face whole = faces::face_of(ground.surface.get(), {});
        expect_near_whatever_is_asked(whole.get(), 200'000'000,
                                      nurbs_mesh_face_with); // some 50,000 triangles
    }
}

// The first ones take no more than leaves enough for the last.
TEST(MeshWork, all_faces_of_a_model_are_as_near_as_the_work_allows) {
    for (int seed = 1; seed <= scaled(1); ++seed) {
        Random random(static_cast<uint64_t>(seed));
        std::vector<faces::Face> own;
        std::vector<const nurbs_face *> faces;
        for (int i = 0; i < 6; ++i) {
            own.push_back(with_hole(rough(random).get()));
            faces.push_back(own.back().get());
        }
        expect_near_whatever_is_asked(models::model_of(faces).get(), 400'000'000, nurbs_mesh_model_with);
    }
}

// Its bound is told again, and as proven as all others.
TEST(MeshWork, what_is_made_for_larger_distances_is_as_near_as_it_says) {
    Random random(5);
    const Handle ground = rough(random);
    const faces::Face face = with_hole(ground.get());
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = 50'000'000;
    const auto make = [&](const nurbs_face *shape, const nurbs_mesh_options *options, nurbs_mesh **out) {
        return nurbs_mesh_face_with(shape, options, &call, out);
    };
    const Mesh mesh = mesh_of(face.get(), 1e-9, make);
    EXPECT_EQ(mesh.reached, 0);
    expect_whole(mesh);
    expect_shape_near(ground.get(), face.get(), mesh, random, 2000);
    expect_mesh_near(ground.get(), mesh, random, 2000);
}

// Edges that are off their faces, and borders that lie on each other, are no nearer in however many parts.
TEST(MeshWork, edges_are_not_divided_in_vain) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA names no folder with CAD files";
    }
    nurbs_model *hull = nullptr;
    require_ok(nurbs_read_model_file((std::string(folder) + "/goteborg_hull.iges").c_str(), nullptr, &hull));
    const models::Model own(hull);
    constexpr double size = 7;
    for (const double share : {3e-6, 1e-6}) {
        const Told told = mesh_with_work(hull, size * share, 3'000'000'000, nurbs_mesh_model_with);
        EXPECT_FALSE(told.reached);
        EXPECT_LE(told.edge_points, 5000);
    }
}

} // namespace mesh_work_test
