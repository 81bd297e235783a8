// Solids whose faces are cut out of surfaces by each other, through poles, seams and crossings too: sewn they are closed, with the
// volumes of closed forms, and so are their meshes.
#include "property/meshes.h"
#include "property/models.h"
#include "support/cases.h"

#include <gtest/gtest.h>
#include <numbers>

namespace trimmed_solids_test {

using namespace support;
using models::Face;
using models::Model;

namespace {

constexpr double pi = std::numbers::pi;
using Point3 = std::array<double, 3>;

Handle ball(double radius) {
    return made([&](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

Handle pipe(const Point3 &axis, double radius) {
    const Point3 base{-3 * axis[0], -3 * axis[1], -3 * axis[2]};
    return made([&](nurbs **out) {
        return nurbs_surface_cylinder(base.data(), axis.data(), nullptr, radius, 6, 0, 2 * pi,
                                      NURBS_ARC_QUARTERS, out);
    });
}

// Through the origin, with the axis-th coordinate as its normal.
Handle wall(size_t axis) {
    Point3 u{0, 0, 0}, v{0, 0, 0}, corner{-2, -2, -2};
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 4;
    corner[axis] = 0;
    return made([&](nurbs **out) { return nurbs_surface_plane(3, corner.data(), u.data(), v.data(), out); });
}

struct Cut {
    const Handle *by;
    int32_t side;
};

// What of a surface is on all sides, added to the faces of a solid.
void add_kept(const Handle &surface, const std::vector<Cut> &cuts, std::vector<Face> &solid) {
    nurbs_face *whole = nullptr;
    require_ok(
        nurbs_face_create(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &whole));
    std::vector<Face> kept;
    kept.emplace_back(whole);
    for (const Cut &cut : cuts) {
        std::vector<Face> rest;
        for (const Face &face : kept) {
            nurbs_model *parts = nullptr;
            require_ok(nurbs_face_trim(face.get(), cut.by->get(), cut.side, 1e-7, &parts));
            const Model model(parts);
            for (int64_t i = 0; i < models::counts_of(parts).faces; ++i) {
                rest.push_back(models::face_of(parts, i));
            }
        }
        kept = std::move(rest);
    }
    std::ranges::move(kept, std::back_inserter(solid));
}

void expect_closed(const std::vector<Face> &faces, double volume, double area) {
    std::vector<const nurbs_face *> given;
    for (const Face &face : faces) {
        given.push_back(face.get());
    }
    nurbs_model *sewn = nullptr;
    require_ok(nurbs_model_sew(std::ssize(given), given.data(), 1e-5, 0, &sewn));
    const Model model(sewn);
    double found = 0, openness = 1;
    require_ok(nurbs_model_volume(sewn, 1e-8, &found, nullptr, nullptr, &openness, nullptr));
    EXPECT_NEAR(found, volume, 1e-5 * volume);
    EXPECT_LE(openness, 1e-5);
    EXPECT_NEAR(models::area_of(sewn, 1e-8), area, 1e-5 * area);
    const meshes::Mesh mesh = meshes::mesh_of(sewn, 1e-2);
    EXPECT_EQ(meshes::free_sides(meshes::sides_of(sewn, mesh)), 0);
    EXPECT_NEAR(meshes::area_of(mesh), area, 0.1 * area);
}

} // namespace

TEST(TrimmedSolids, PartsOfABallBetweenWalls) {
    const Handle sphere = ball(1);
    std::array<Handle, 3> walls{wall(0), wall(1), wall(2)};
    for (const size_t count : {size_t{1}, size_t{2}, size_t{3}}) {
        for (size_t first = 0; first < 3; ++first) {
            std::vector<Face> solid;
            const auto cuts_without = [&](size_t left_out) {
                std::vector<Cut> cuts;
                for (size_t i = 0; i < count; ++i) {
                    if (i != left_out) {
                        cuts.push_back({&walls[(first + i) % 3], NURBS_TRIM_FRONT});
                    }
                }
                return cuts;
            };
            add_kept(sphere, cuts_without(count), solid);
            for (size_t i = 0; i < count; ++i) {
                std::vector<Cut> cuts = cuts_without(i);
                cuts.push_back({&sphere, NURBS_TRIM_BACK});
                add_kept(walls[(first + i) % 3], cuts, solid);
            }
            const double share = std::pow(0.5, static_cast<double>(count));
            expect_closed(solid, 4 * pi / 3 * share,
                          4 * pi * share + static_cast<double>(count) * 2 * pi * share);
        }
    }
}

// What is left of a ball that is bored through depends on the height of the hole alone.
TEST(TrimmedSolids, BoredBalls) {
    const Handle sphere = ball(1);
    for (const Point3 &axis : {Point3{0, 0, 1}, Point3{1, 0, 0}, Point3{0.6, 0, 0.8}, Point3{0, 0.8, 0.6}}) {
        const Handle bore = pipe(axis, 0.5);
        std::vector<Face> solid;
        add_kept(sphere, {{&bore, NURBS_TRIM_FRONT}}, solid);
        add_kept(bore, {{&sphere, NURBS_TRIM_BACK}}, solid);
        const double half = std::sqrt(0.75);
        expect_closed(solid, 4 * pi / 3 * half * half * half, 4 * pi * half + 2 * pi * half);
    }
}

// Of pipes of one radius (J. Steinmetz).
TEST(TrimmedSolids, WhatPipesHaveInCommon) {
    for (const double angle : {pi / 2, 1.1}) {
        const Handle upright = pipe({0, 0, 1}, 1), across = pipe({std::sin(angle), 0, std::cos(angle)}, 1);
        std::vector<Face> solid;
        add_kept(upright, {{&across, NURBS_TRIM_BACK}}, solid);
        add_kept(across, {{&upright, NURBS_TRIM_BACK}}, solid);
        expect_closed(solid, 16 / (3 * std::sin(angle)), 16 / std::sin(angle));
    }
}

} // namespace trimmed_solids_test
