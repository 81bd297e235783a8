// Offsets of offsets of splines: by their definition, the normal of each surface along its own S_u x S_v.
#include "base/error.h"
#include "eval/evaluate.h"
#include "model/shapes/surface_spline.h"

#include <cmath>
#include <gtest/gtest.h>

namespace made_surface_test {

namespace {

using namespace nrb;
using namespace nrb::model;

constexpr Rectangle all{{0, 1}, {0, 1}};

SurfaceShape shape_of(SurfaceKind kind) {
    SurfaceShape shape{kind, {}, {0, 0}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    shape.place.dim = 3;
    return shape;
}

SurfaceShapePtr shared(SurfaceShape surface) {
    return std::make_shared<const SurfaceShape>(std::move(surface));
}

// (x, y, (a x^2 + b y^2) / 2) over [-1/4, 1/4]^2, with the curvatures a and b in the middle.
SurfaceShapePtr sheet(double a, double b) {
    const KnotVectorPtr square = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const auto blossom = [](int i) { return i == 1 ? -1.0 / 16 : 1.0 / 16; };
    std::vector<double> points;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            points.insert(points.end(),
                          {(i - 1) / 4.0, (j - 1) / 4.0, (a * blossom(i) + b * blossom(j)) / 2});
        }
    }
    SurfaceShape shape = shape_of(SurfaceKind::spline);
    shape.spline = make_result({square, square}, 3, Form::polynomial, std::move(points));
    return shared(std::move(shape));
}

SurfaceShapePtr moved(const SurfaceShapePtr &basis, double distance) {
    SurfaceShape offset = shape_of(SurfaceKind::offset);
    offset.basis = basis;
    offset.distance = distance;
    return shared(std::move(offset));
}

SurfaceShapePtr mirrored(const SurfaceShapePtr &basis) {
    SurfaceShape part = shape_of(SurfaceKind::trimmed);
    part.basis = basis;
    part.range = all;
    part.u_forward = false;
    return shared(std::move(part));
}

Vector3 point_of(const Spline &spline, double u, double v) {
    const double at[2] = {u, v};
    double x[3];
    eval::evaluate_points(spline, {}, 0, {at, 1, 2, 2, 1}, {x, 1, 3, 3, 1});
    return {x[0], x[1], x[2]};
}

// S + distance N.
Vector3 offset_point(const SurfaceShapePtr &sheet, double u, double v, double distance) {
    const double at[2] = {u, v};
    double x[9];
    eval::evaluate_points(*sheet->spline, {}, 1, {at, 1, 2, 2, 1}, {x, 1, 9, 9, 1});
    return Vector3{x[0], x[1], x[2]} +
           distance * unit(cross(Vector3{x[3], x[4], x[5]}, Vector3{x[6], x[7], x[8]}));
}

MadeSurface made(const SurfaceShapePtr &surface) {
    const Rectangle range = natural_range(*surface);
    return made_surface(*surface, range, {1e-7, 4096});
}

void expect_distance(const SurfaceShapePtr &surface, const SurfaceShapePtr &sheet, double distance) {
    const MadeSurface found = made(surface);
    EXPECT_LE(found.distance, 1e-7);
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const double u = i / 8.0, v = j / 8.0;
            const Vector3 x = point_of(*found.spline, surface->kind == SurfaceKind::trimmed ? -u : u, v);
            EXPECT_LE(length(x - offset_point(sheet, u, v, distance)), found.distance + 1e-14);
        }
    }
}

// Centres of curvature at the heights 1 / a and 1 / b: beyond none, one or both of them.
TEST(MadeSurface, offsets_of_offsets_of_splines) {
    const SurfaceShapePtr channel = sheet(2, 0.25), dome = sheet(2, 2.5), flat = sheet(0.25, -0.25);
    expect_distance(moved(moved(channel, 0.125), 0.25), channel, 0.375);
    expect_distance(moved(moved(channel, -0.5), 0.25), channel, -0.25);
    expect_distance(moved(moved(channel, 1.5), 0.25), channel, 1.25); // beyond one: turned around
    expect_distance(moved(moved(channel, 1.5), -0.25), channel, 1.75);
    expect_distance(moved(moved(dome, 1.5), 0.25), dome, 1.75); // beyond both
    expect_distance(moved(moved(flat, 1), 0.25), flat, 1.25);
    expect_distance(moved(moved(moved(channel, 1.5), 0.25), 0.25), channel, 1.0);
    expect_distance(moved(moved(moved(channel, 1.5), 1.375), 0.25), channel, 0.375);
}

// A part that runs the other way has its normal on the other side.
TEST(MadeSurface, offsets_of_parts_of_offsets) {
    const SurfaceShapePtr channel = sheet(2, 0.25);
    const auto mirrored_offset = [&](double first, double second) {
        return moved(mirrored(moved(channel, first)), second);
    };
    const auto part = [](const SurfaceShapePtr &basis) {
        SurfaceShape whole = shape_of(SurfaceKind::trimmed);
        whole.basis = basis;
        whole.range = {{-1, 0}, {0, 1}};
        return shared(std::move(whole));
    };
    expect_distance(part(mirrored_offset(0.125, 0.25)), channel, -0.125);
    expect_distance(part(mirrored_offset(1.5, 0.25)), channel, 1.75);
    expect_distance(mirrored(moved(moved(channel, 1.5), 0.25)), channel, 1.25);
}

TEST(MadeSurface, offsets_and_back_are_the_surface) {
    const SurfaceShapePtr channel = sheet(2, 0.25);
    const MadeSurface there = made(moved(moved(channel, 0.125), -0.125)),
                      turned = made(moved(moved(channel, 1.5), 1.5)), none = made(moved(channel, 0)),
                      tiny = made(moved(channel, 1e-300));
    EXPECT_EQ(there.distance, 0);
    EXPECT_EQ(turned.distance, 0);
    EXPECT_EQ(none.distance, 0);
    EXPECT_EQ(tiny.distance, 1e-300);
    for (const MadeSurface *same : {&there, &turned, &none, &tiny}) {
        EXPECT_TRUE(std::ranges::equal(same->spline->points(), channel->spline->points()));
    }
}

// Somewhere a radius of curvature is the distance.
TEST(MadeSurface, offsets_of_offsets_with_a_ridge_are_refused) {
    for (const double first : {0.5, 0.55, 0.65}) {
        try {
            (void)made(moved(moved(sheet(2, 0.25), first), 0.25));
            FAIL() << first;
        } catch (const Error &error) {
            EXPECT_EQ(error.status(), Status::unsupported);
            EXPECT_NE(std::string(error.what()).find("the normal of the surface at the distance"),
                      std::string::npos)
                << error.what();
        }
    }
}

} // namespace

} // namespace made_surface_test
