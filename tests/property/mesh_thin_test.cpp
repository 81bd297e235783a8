// Surfaces that bend, or whose places run unevenly, along one axis only: triangles are divided along this one.
#include "property/mesh_samples.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace mesh_thin_test {

using namespace support;
using namespace support::meshes;
using faces::pi;

namespace {

// The unit square, of whose axes the one of degree 3 is uneven, and the other one even, of any degree.
Handle uneven_plate(int32_t degree, bool first) {
    const Vec places{0, 0.1, 0.3, 1};
    std::array<int32_t, 2> degrees{degree, 3};
    std::array<int64_t, 2> counts{degree + 1, 4};
    if (first) {
        std::swap(degrees[0], degrees[1]);
        std::swap(counts[0], counts[1]);
    }
    Vec knots, points;
    for (const int32_t own : degrees) {
        for (const double end : {0.0, 1.0}) {
            knots.insert(knots.end(), static_cast<size_t>(own + 1), end);
        }
    }
    for (int64_t i = 0; i < counts[0]; ++i) {
        for (int64_t j = 0; j < counts[1]; ++j) {
            const double even = static_cast<double>(first ? j : i) / degree,
                         uneven = places[static_cast<size_t>(first ? i : j)];
            points.insert(points.end(), {first ? uneven : even, first ? even : uneven, 0});
        }
    }
    return made([&](nurbs **out) {
        return nurbs_create(2, degrees.data(), counts.data(), knots.data(),
                            static_cast<int64_t>(knots.size()), 3, points.data(), 0, 0, nullptr, 0, 0, out);
    });
}

Handle cone() {
    return made([](nurbs **out) {
        return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 1, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
}

// One flank of a thread.
Handle flank(double turns) {
    const auto edge = [&](double radius, double from) {
        const double origin[] = {0, 0, from};
        return made([&](nurbs **out) {
            return nurbs_curve_helix(3, origin, nullptr, nullptr, radius, 0, 1, 0, turns, 1e-7, nullptr, out);
        });
    };
    const Handle outer = edge(5, 0), inner = edge(4.4, 0.3);
    return made([&](nurbs **out) { return nurbs_ruled(outer.get(), inner.get(), 0, out); });
}

int32_t reached(const nurbs_face *face, double chord, int64_t work) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    nurbs_mesh *made = nullptr;
    require_ok(nurbs_mesh_face_with(face, &options, &call, &made));
    const std::unique_ptr<nurbs_mesh, DestroyMesh> own(made);
    int32_t result = 0;
    require_ok(nurbs_mesh_bound(made, nullptr, nullptr, &result));
    return result;
}

} // namespace

TEST(MeshThin, uneven_places_are_divided_along_their_axis) {
    for (int32_t degree = 1; degree <= 7; ++degree) {
        for (const bool first : {false, true}) {
            const Mesh mesh = mesh_of(uneven_plate(degree, first).get(), 0.01);
            EXPECT_EQ(mesh.reached, 1) << degree << ", " << first;
            EXPECT_LE(mesh.triangles.size(), 64U) << degree << ", " << first;
            EXPECT_NEAR(area_of(mesh), 1, 1e-12);
        }
    }
}

// Straight lines lead to the tip: as many triangles around it as the chord takes, and not in proportion to 1 / chord.
TEST(MeshThin, cones_take_as_many_triangles_as_circles) {
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
        const Mesh mesh = mesh_of(cone().get(), chord);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_LE(static_cast<double>(mesh.triangles.size()), 120 / std::sqrt(chord)) << chord;
        EXPECT_NEAR(area_of(mesh), pi * std::sqrt(2), 8 * chord);
    }
}

// Each new place may leave the next triangle along the strip over the distance: not in as many rounds as there are triangles.
TEST(MeshThin, long_strips_take_few_rounds) {
    const double turns = 3;
    const Handle thread = flank(turns);
    const Handle border = faces::polygon(
        {{0.01 * turns, 0.02}, {0.99 * turns, 0.02}, {0.98 * turns, 0.98}, {0.02 * turns, 0.98}});
    const faces::Face face = faces::face_of(thread.get(), {{border.get()}}, 1e-6);
    EXPECT_EQ(reached(face.get(), 3e-4, 800'000'000), 1);
    Random random(5);
    const Mesh mesh = mesh_of(face.get(), 3e-4);
    expect_whole(mesh);
    expect_shape_near(thread.get(), face.get(), mesh, random, 200);
}

} // namespace mesh_thin_test
