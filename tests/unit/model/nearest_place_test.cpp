// SPDX-License-Identifier: MIT
// Nearest points of elementary surfaces in closed form, beside the search among the pieces of their splines.
#include "closest/closest.h"
#include "closest/locator.h"
#include "model/shapes/nearest_place.h"
#include "model/shapes/surface_spline.h"
#include "numeric/norm.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace nearest_place_test {

namespace {

using namespace nrb;
using namespace nrb::model;

struct Case {
    const char *name;
    SurfaceShape surface;
    Rectangle range;
};

SurfaceShape shape(SurfaceKind kind, double a, double b = 0) {
    const double origin[3] = {1, 2, 3}, z[3] = {1, -2, 0.5}, x[3] = {0.25, 1, 1};
    SurfaceShape surface{kind,    build::make_placement(3, origin, z, x, "origin"),
                         {a, b},  {},
                         nullptr, {},
                         nullptr, 0,
                         true,    true,
                         nullptr};
    surface.range.v = {0, turn};
    return surface;
}

std::vector<Case> cases() {
    return {{"whole cylinder", shape(SurfaceKind::cylinder, 2), {{0, turn}, {-2, 2}}},
            {"part of a cylinder", shape(SurfaceKind::cylinder, 2), {{-7, -5.5}, {-2, 2}}},
            {"cone", shape(SurfaceKind::cone, 2, 0.5), {{-3, 3}, {-3, 2}}},
            {"cone beyond its apex", shape(SurfaceKind::cone, 2, 0.5), {{-3, 3}, {-9, -5}}},
            {"sphere", shape(SurfaceKind::sphere, 2), {{0, turn}, {-turn / 4, turn / 4}}},
            {"cap of a sphere", shape(SurfaceKind::sphere, 2), {{1, 4}, {0.5, turn / 4}}},
            {"torus", shape(SurfaceKind::torus, 3, 1), {{0, turn}, {0, turn}}},
            {"part of a torus", shape(SurfaceKind::torus, 3, 1), {{2, 5}, {-3, 1}}}};
}

// A point beside the surface, over a place of the spline. The normal leads to the place back.
std::array<double, 3> point_beside(const Spline &spline, const face::Point2 &at, double distance) {
    constexpr double h = 1e-6;
    const auto x = face::point_at(spline, at), u = face::point_at(spline, {at[0] + h, at[1]}),
               v = face::point_at(spline, {at[0], at[1] + h});
    const Vector3 a{u[0] - x[0], u[1] - x[1], u[2] - x[2]}, b{v[0] - x[0], v[1] - x[1], v[2] - x[2]};
    const Vector3 n = cross(a, b);
    const double size = std::sqrt(dot(n, n));
    return {x[0] + distance * n.x / size, x[1] + distance * n.y / size, x[2] + distance * n.z / size};
}

} // namespace

TEST(NearestPlace, no_place_of_the_spline_is_nearer) {
    std::mt19937 random(25);
    std::uniform_real_distribution<double> share(0.02, 0.98), beside(-0.4, 0.4);
    for (const Case &one : cases()) {
        SCOPED_TRACE(one.name);
        const SplinePtr spline = surface_spline(one.surface, one.range);
        const face::NearestPlace nearest = nearest_place(one.surface, spline);
        ASSERT_TRUE(nearest);
        const closest::Locator &locator = closest::locator_of(*spline);
        for (int i = 0; i < 300; ++i) {
            const Interval u = one.range.u, v = one.range.v;
            const face::Point2 at{u.lower + (u.upper - u.lower) * share(random),
                                  v.lower + (v.upper - v.lower) * share(random)};
            const auto point = point_beside(*spline, at, beside(random));
            const double found =
                distance(face::point_at(*spline, nearest(point.data())).data(), point.data(), 3);
            const closest::Foot best =
                locator.nearest({point.data(), nullptr, 1e-14, closest::usual_budget(*spline), false, true});
            // A few units of the size, 6; the place is that of a minimum, so that its own rounding does not count.
            EXPECT_NEAR(found, best.distance, 64 * 0x1p-52 * 6);
        }
    }
}

TEST(NearestPlace, is_an_end_of_the_domain_where_the_foot_is_outside) {
    const SurfaceShape cylinder = shape(SurfaceKind::cylinder, 2);
    const SplinePtr spline = surface_spline(cylinder, {{0, 1}, {0, 1}});
    const face::NearestPlace nearest = nearest_place(cylinder, spline);
    double point[3];
    cylinder.place.point(2 * std::cos(1.5), 2 * std::sin(1.5), 7, point);
    EXPECT_EQ(nearest(point), (face::Point2{1, 1}));
    cylinder.place.point(2 * std::cos(-1.5), 2 * std::sin(-1.5), -7, point);
    EXPECT_EQ(nearest(point), (face::Point2{0, 0}));
}

TEST(NearestPlace, is_not_known_of_other_surfaces) {
    const SurfaceShape lemon = shape(SurfaceKind::torus, 1, 2), plane = shape(SurfaceKind::plane, 0);
    EXPECT_FALSE(nearest_place(lemon, nullptr));
    EXPECT_FALSE(nearest_place(plane, nullptr));
}

} // namespace nearest_place_test
