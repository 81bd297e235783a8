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

// Around a cylinder or a cone: the line across the straight ones at a share of the height, with so much of a wave, and n holes in
// its middle.
struct Around {
    std::vector<Handle> curves;
    faces::Face face;
};
Handle wave(const faces::Ground &ground, double from, double to, double middle, double height) {
    constexpr int n = 48;
    Vec params, places;
    for (int i = 0; i <= n; ++i) {
        const double share = static_cast<double>(i) / n, u = from + share * (to - from);
        const faces::Place at = ground.at(u, middle + height * std::cos(2 * pi * u));
        params.push_back(share);
        places.insert(places.end(), at.begin(), at.end());
    }
    const int32_t degree = 3;
    const int64_t count = n + 1;
    return made([&](nurbs **out) {
        return nurbs_interpolate(1, &degree, &count, params.data(), 2, places.data(), 0, 0, nullptr, 0,
                                 nullptr, out);
    });
}
Around around(const faces::Ground &ground, double slant, int holes) {
    Around result;
    result.curves.push_back(wave(ground, 0, 1, 0, 0));
    result.curves.push_back(wave(ground, 1, 0, (slant > 0 ? 0.95 : 1) - slant, slant));
    for (int i = 0; i < holes; ++i) {
        const faces::Place centre = ground.at((i + 0.37) / holes, 0.5);
        const double radii[] = {0.025 * ground.period[0], 0.06 * ground.period[1]};
        result.curves.push_back(made([&](nurbs **out) {
            return nurbs_curve_ellipse(2, centre.data(), nullptr, nullptr, radii[0], radii[1], 0, -2 * pi,
                                       NURBS_ARC_QUARTERS, out);
        }));
    }
    faces::Curves loops;
    for (const Handle &curve : result.curves) {
        loops.push_back({curve.get()});
    }
    result.face = faces::face_of(ground.surface.get(), loops);
    return result;
}

// Triangles of a mesh that has no more vertices than it has to: those of its edges. One loop or two, and holes, of a cylinder.
double fewest(const Mesh &mesh, int holes) {
    const std::set<int64_t> border(mesh.edge_points.begin(), mesh.edge_points.end());
    return static_cast<double>(border.size()) + 2.0 * holes;
}

} // namespace

// Of a strip along the straight lines, whatever ends it: none of its triangles is across the bend.
TEST(MeshThin, cylinders_with_holes_and_slanted_ends_take_few_triangles) {
    const faces::Ground ground = faces::cylinder(1, 3);
    Random random(12);
    for (const double chord : {1e-3, 1e-4}) {
        for (const double slant : {0.0, 0.2}) {
            for (const int holes : {0, 1, 4}) {
                SCOPED_TRACE(testing::Message() << chord << ", " << slant << ", " << holes);
                const Around own = around(ground, slant, holes);
                const Mesh mesh = mesh_of(own.face.get(), chord);
                EXPECT_EQ(mesh.reached, 1);
                EXPECT_LE(static_cast<double>(mesh.triangles.size()), 1.6 * fewest(mesh, holes));
                expect_whole(mesh);
                expect_shape_near(ground.surface.get(), own.face.get(), mesh, random, 200);
                expect_mesh_near(ground.surface.get(), mesh, random, 200);
            }
        }
    }
}

// What is beside straight lines in the plane of two triangles is over the other one.
TEST(MeshThin, cones_cut_off_take_as_few_triangles_as_cylinders) {
    const faces::Ground ground =
        faces::ground_of(made([](nurbs **out) {
                             return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0.3, 2, 0, 2 * pi,
                                                       NURBS_ARC_QUARTERS, out);
                         }),
                         true, false);
    Random random(13);
    for (const double chord : {1e-3, 1e-4}) {
        SCOPED_TRACE(chord);
        const Mesh whole = mesh_of(ground.surface.get(), chord);
        EXPECT_EQ(whole.reached, 1);
        EXPECT_LE(static_cast<double>(whole.triangles.size()), 1.9 * 2 * pi / std::acos(1 - chord));
        expect_shape_near(ground.surface.get(), nullptr, whole, random, 200);
        expect_mesh_near(ground.surface.get(), whole, random, 200);
        const Around own = around(ground, 0.2, 0);
        const Mesh mesh = mesh_of(own.face.get(), chord);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_LE(static_cast<double>(mesh.triangles.size()), 1.6 * fewest(mesh, 0));
        expect_whole(mesh);
        expect_shape_near(ground.surface.get(), own.face.get(), mesh, random, 200);
        expect_mesh_near(ground.surface.get(), mesh, random, 200);
    }
}

// A diagonal from end to end is no end itself.
TEST(MeshThin, extruded_curves_take_two_triangles_for_each_segment) {
    const Vec params{0, 0.2, 0.4, 0.6, 0.8, 1},
        points{0, 0, 0, 1, 2, 0, 2, -1, 0, 3, 1, 0, 4, 0, 0, 5, 1.5, 0};
    const int32_t degree = 3;
    const int64_t count = 6;
    const Handle curve = made([&](nurbs **out) {
        return nurbs_interpolate(1, &degree, &count, params.data(), 3, points.data(), 0, 0, nullptr, 0,
                                 nullptr, out);
    });
    const double way[] = {0.3, 0.2, 3};
    const Handle wall = made([&](nurbs **out) { return nurbs_extrude(curve.get(), way, out); });
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
        const Mesh mesh = mesh_of(wall.get(), chord);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_LE(static_cast<double>(mesh.triangles.size()), 9 / std::sqrt(chord)) << chord;
    }
}

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
