// Faces trimmed by surfaces: both sides make up the face, areas are those of closed forms, places are on the side that they should be on.
#include "property/regions.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace face_trim_test {

using namespace support;
using namespace support::regions;
using models::Face;

namespace {

constexpr double pi = std::numbers::pi;
using Point3 = std::array<double, 3>;

Handle sphere(const Point3 &center, double radius, const Point3 &axis = {0, 0, 1}) {
    return made([&](nurbs **out) {
        return nurbs_surface_sphere(center.data(), axis.data(), nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

Point3 unit(Random &random) {
    Point3 x{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double size = std::hypot(x[0], x[1], x[2]);
    return size < 0.1 ? Point3{0, 0.6, 0.8} : Point3{x[0] / size, x[1] / size, x[2] / size};
}

// A square of the plane n . x = off, its normal n or against it.
Handle square(const Point3 &n, double off, double half, bool turned = false) {
    Point3 a = std::abs(n[0]) < 0.6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
    const double along = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
    for (size_t k = 0; k < 3; ++k) {
        a[k] -= along * n[k];
    }
    const double size = std::hypot(a[0], a[1], a[2]);
    Point3 b;
    for (size_t k = 0; k < 3; ++k) {
        a[k] /= size;
    }
    b = {n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0]};
    if (turned) {
        std::swap(a, b);
    }
    SplineData data{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}};
    for (const double u : {-half, half}) {
        for (const double v : {-half, half}) {
            for (size_t k = 0; k < 3; ++k) {
                data.points.push_back(off * n[k] + u * a[k] + v * b[k]);
            }
        }
    }
    return create(data);
}

Face whole(const nurbs *surface) {
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface, 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &face));
    return Face(face);
}

nurbs_status try_trim(const nurbs_face *face, const nurbs *surface, int32_t side, Model &out,
                      double tolerance = 1e-8) {
    nurbs_model *model = nullptr;
    const nurbs_status status = nurbs_face_trim(face, surface, side, tolerance, &model);
    out.reset(model);
    return status;
}

Model trim(const nurbs_face *face, const nurbs *surface, int32_t side, double tolerance = 1e-8) {
    Model model;
    require_ok(try_trim(face, surface, side, model, tolerance));
    return model;
}

double area(const Model &model) {
    double sum = 0;
    for (const Face &face : faces_of(model.get())) {
        double own = 0;
        require_ok(nurbs_face_area(face.get(), 1e-8, &own, nullptr));
        sum += own;
    }
    return sum;
}

Vec random_places(Random &random, const nurbs *surface, int count) {
    Vec places;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 2; ++k) {
            double ends[2];
            require_ok(nurbs_domain(surface, k, ends));
            places.push_back(random.between(ends[0], ends[1]));
        }
    }
    return places;
}

// Of places at which `height` is not small, those with a positive one are in front.
template <class Height>
void expect_sides(const nurbs *surface, const Model &front, const Model &back, Random &random,
                  Height &&height) {
    const Vec places = random_places(random, surface, 200), points = eval(surface, places);
    const std::vector<int32_t> in_front = sides_of(front, places), behind = sides_of(back, places);
    for (size_t i = 0; i < in_front.size(); ++i) {
        const double own = height(Point3{points[3 * i], points[3 * i + 1], points[3 * i + 2]});
        if (std::abs(own) > 1e-5) {
            EXPECT_EQ(in_front[i], own > 0 ? 1 : -1)
                << places[2 * i] << " " << places[2 * i + 1] << " " << own;
            EXPECT_EQ(behind[i], own > 0 ? -1 : 1) << places[2 * i] << " " << places[2 * i + 1] << " " << own;
        }
    }
}

} // namespace

// Above a plane at height h a sphere has the area 2 pi r (r - h), whichever way its poles are.
TEST(FaceTrim, CapsOfASphere) {
    for_each_case(9100, 40, [](Random &random, uint64_t) {
        const double radius = random.between(0.5, 2), h = random.between(-1.1, 1.1) * radius;
        const Point3 n = unit(random);
        const bool turned = random.chance(50);
        const Handle surface = sphere({0, 0, 0}, radius, unit(random)), plane = square(n, h, 5, turned);
        const Face face = whole(surface.get());
        const Model front = trim(face.get(), plane.get(), NURBS_TRIM_FRONT),
                    back = trim(face.get(), plane.get(), NURBS_TRIM_BACK);
        const double above = 2 * pi * radius * std::clamp(radius - h, 0.0, 2 * radius),
                     all = 4 * pi * radius * radius;
        EXPECT_NEAR(area(turned ? back : front), above, 1e-6 * all);
        EXPECT_NEAR(area(front) + area(back), all, 1e-6 * all);
        expect_sides(surface.get(), front, back, random, [&](const Point3 &x) {
            return (turned ? -1 : 1) * (n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - h);
        });
    });
}

// Inside of another sphere is a cap, by what both radii and the distance of the centres say.
TEST(FaceTrim, SpheresBySpheres) {
    for_each_case(9200, 30, [](Random &random, uint64_t) {
        const double r = random.between(0.5, 1.5), d = random.between(0.2, 2.5);
        const Point3 to = unit(random), center{d * to[0], d * to[1], d * to[2]};
        const Handle surface = sphere({0, 0, 0}, 1, unit(random)), tool = sphere(center, r, unit(random));
        const Face face = whole(surface.get());
        const Model outside = trim(face.get(), tool.get(), NURBS_TRIM_FRONT),
                    inside = trim(face.get(), tool.get(), NURBS_TRIM_BACK);
        const double low = std::clamp((d * d + 1 - r * r) / (2 * d), -1.0, 1.0);
        EXPECT_NEAR(area(inside), 2 * pi * (1 - low), 1e-5);
        EXPECT_NEAR(area(inside) + area(outside), 4 * pi, 1e-5);
        expect_sides(surface.get(), outside, inside, random, [&](const Point3 &x) {
            return std::hypot(x[0] - center[0], x[1] - center[1], x[2] - center[2]) - r;
        });
    });
}

// Each part is on one side; both sides together are the torus.
TEST(FaceTrim, TorusByPlanes) {
    for_each_case(9300, 30, [](Random &random, uint64_t) {
        const Handle surface = made([](nurbs **out) {
            return nurbs_surface_torus(nullptr, nullptr, nullptr, 2, 0.75, 0, 2 * pi, 0, 2 * pi,
                                       NURBS_ARC_QUARTERS, out);
        });
        const Face face = whole(surface.get());
        const Point3 n = unit(random);
        const double off = random.between(-2.5, 2.5);
        const Handle plane = square(n, off, 6);
        const Model front = trim(face.get(), plane.get(), NURBS_TRIM_FRONT),
                    back = trim(face.get(), plane.get(), NURBS_TRIM_BACK);
        EXPECT_NEAR(area(front) + area(back), 4 * pi * pi * 2 * 0.75, 1e-4);
        expect_sides(surface.get(), front, back, random,
                     [&](const Point3 &x) { return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - off; });
    });
}

// Plates with holes, cut by what crosses them, and what is cut again: the parts of parts are the whole.
TEST(FaceTrim, PlatesWithHoles) {
    for_each_case(9400, 30, [](Random &random, uint64_t) {
        Curves curves;
        curves.push_back(rectangle(-2, -1, 2, 1));
        curves.push_back(circle(random.between(-1.2, -0.8), random.between(-0.3, 0.3), 0.5));
        curves.push_back(circle(random.between(0.8, 1.2), random.between(-0.3, 0.3), 0.5));
        const Model plate = region(curves, NURBS_FILL_EVEN_ODD);
        const Face face = models::face_of(plate.get(), 0);
        const double all = area(plate);
        const Point3 center{random.between(-2, 2), random.between(-1, 1), random.between(-0.5, 0.5)};
        const double radius = random.between(0.6, 1.4);
        const Handle ball = sphere(center, radius, unit(random));
        const Model outside = trim(face.get(), ball.get(), NURBS_TRIM_FRONT),
                    inside = trim(face.get(), ball.get(), NURBS_TRIM_BACK);
        EXPECT_NEAR(area(outside) + area(inside), all, 1e-6);
        Point3 n = unit(random);
        n[2] *= 0.25;
        const double size = std::hypot(n[0], n[1], n[2]);
        const Handle plane = square({n[0] / size, n[1] / size, n[2] / size}, random.between(-0.5, 0.5), 9);
        double sum = 0;
        for (const Model *model : {&outside, &inside}) {
            for (const Face &part : faces_of(model->get())) {
                sum += area(trim(part.get(), plane.get(), NURBS_TRIM_FRONT));
                sum += area(trim(part.get(), plane.get(), NURBS_TRIM_BACK));
            }
        }
        EXPECT_NEAR(sum, all, 1e-6);
    });
}

// All of it is kept for one side, nothing for the other one: along a curve of contact it stays on its side.
TEST(FaceTrim, WhatTouchesAlongACurveIsNotDivided) {
    const Handle torus = made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 2, 0.5, 0, 2 * pi, 0, 2 * pi,
                                   NURBS_ARC_QUARTERS, out);
    });
    const Handle around = made([](nurbs **out) {
        const double base[] = {0, 0, -1};
        return nurbs_surface_cylinder(base, nullptr, nullptr, 2.5, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Handle plate = square({0, 0, 1}, 0.5, 4), turned = square({0, 0, 1}, 0.5, 4, true);
    const auto expect_whole = [](const Handle &surface, const Handle &cutter, double size, int32_t side) {
        const Face face = whole(surface.get());
        EXPECT_NEAR(area(trim(face.get(), cutter.get(), side)), size, 1e-6 * size);
        EXPECT_TRUE(faces_of(trim(face.get(), cutter.get(), -side).get()).empty());
    };
    const double ring = 4 * pi * pi;
    expect_whole(torus, plate, ring, NURBS_TRIM_BACK);
    expect_whole(torus, turned, ring, NURBS_TRIM_FRONT);
    expect_whole(torus, around, ring, NURBS_TRIM_BACK);
    expect_whole(plate, torus, 64, NURBS_TRIM_FRONT);
    expect_whole(around, torus, 10 * pi, NURBS_TRIM_FRONT);
}

namespace {

constexpr double coarse = 1e-6; // a tolerance

// Both sides of a plane n . x = off; above: the area of the side to which n points.
void expect_halves(const nurbs *surface, const Point3 &n, double off, double above, double all,
                   Random &random) {
    const Face face = whole(surface);
    const Handle plane = square(n, off, 5);
    const Model front = trim(face.get(), plane.get(), NURBS_TRIM_FRONT, coarse),
                back = trim(face.get(), plane.get(), NURBS_TRIM_BACK, coarse);
    EXPECT_NEAR(area(front), above, 1e-5 * all);
    EXPECT_NEAR(area(front) + area(back), all, 1e-6 * all);
    expect_sides(surface, front, back, random,
                 [&](const Point3 &x) { return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - off; });
}

Handle tube(const Point3 &base, const Point3 &axis, double radius, double height) {
    return made([&](nurbs **out) {
        return nurbs_surface_cylinder(base.data(), axis.data(), nullptr, radius, height, 0, 2 * pi,
                                      NURBS_ARC_QUARTERS, out);
    });
}

} // namespace

// Along meridians, the seam and knots among them, and askew through a pole.
TEST(FaceTrim, ThroughPoles) {
    for_each_case(9500, 16, [](Random &random, uint64_t seed) {
        const Point3 axis = unit(random), other = unit(random);
        const Handle ball = sphere({0, 0, 0}, 1, axis);
        const double along = axis[0] * other[0] + axis[1] * other[1] + axis[2] * other[2];
        if (seed % 2 == 0 && std::abs(along) > 0.05) {
            expect_halves(ball.get(), other, along, 2 * pi * (1 - along), 4 * pi, random);
            return;
        }
        const Handle cone = made([&](nurbs **out) {
            return nurbs_surface_cone(nullptr, axis.data(), nullptr, 1, 0, 1.5, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                      out);
        });
        const Vec start =
            eval(seed % 4 == 1 ? ball.get() : cone.get(),
                 {0.25 * random.whole(0, 3) + (seed % 8 < 4 ? 0 : random.between(0, 0.25)), 0.4});
        Point3 n{axis[1] * start[2] - axis[2] * start[1], axis[2] * start[0] - axis[0] * start[2],
                 axis[0] * start[1] - axis[1] * start[0]};
        const double size = std::hypot(n[0], n[1], n[2]);
        n = {n[0] / size, n[1] / size, n[2] / size};
        const double of_cone = pi * std::sqrt(1 + 1.5 * 1.5);
        seed % 4 == 1 ? expect_halves(ball.get(), n, 0, 2 * pi, 4 * pi, random)
                      : expect_halves(cone.get(), n, 0, of_cone / 2, of_cone, random);
    });
}

// What cuts may have its poles in the face.
TEST(FaceTrim, ByWhatHasPolesInTheFace) {
    for_each_case(9520, 6, [](Random &random, uint64_t) {
        const Point3 n = unit(random);
        const Handle plate = square(n, 0, 2);
        const Vec corners = eval(plate.get(), {0, 0, 1, 0});
        const Handle ball =
            sphere({0, 0, 0}, 1, {corners[3] - corners[0], corners[4] - corners[1], corners[5] - corners[2]});
        const Face face = whole(plate.get());
        EXPECT_NEAR(area(trim(face.get(), ball.get(), NURBS_TRIM_BACK, coarse)), pi, 1e-5);
        EXPECT_NEAR(area(trim(face.get(), ball.get(), NURBS_TRIM_FRONT, coarse)), 16 - pi, 1e-5);
    });
}

// Pipes of equal radii, of each of which 8 / sin of the angle is in the other one; a ball and a pipe that touches it inside (V. Viviani).
TEST(FaceTrim, CurvesThatCrossEachOther) {
    for (const double angle : {pi / 2, 1.2}) {
        const Handle upright = tube({0, 0, -3}, {0, 0, 1}, 1, 6),
                     across = tube({-6 * std::sin(angle), 0, -6 * std::cos(angle)},
                                   {std::sin(angle), 0, std::cos(angle)}, 1, 12);
        const Face face = whole(upright.get());
        const double inside = 8 / std::sin(angle);
        EXPECT_NEAR(area(trim(face.get(), across.get(), NURBS_TRIM_BACK, coarse)), inside, 1e-4);
        EXPECT_NEAR(area(trim(face.get(), across.get(), NURBS_TRIM_FRONT, coarse)), 12 * pi - inside, 1e-4);
    }
    const Handle ball = sphere({0, 0, 0}, 1), pipe = tube({0.5, 0, -2}, {0, 0, 1}, 0.5, 4);
    const Face face = whole(ball.get());
    EXPECT_NEAR(area(trim(face.get(), pipe.get(), NURBS_TRIM_BACK, coarse)), 2 * pi - 4, 1e-4);
    EXPECT_NEAR(area(trim(face.get(), pipe.get(), NURBS_TRIM_FRONT, coarse)), 2 * pi + 4, 1e-4);
}

// What a file says of how far edges may be off a face is often more than its details are large; and a border may lie beside a seam by
// less than a curve over it leaves open.
TEST(FaceTrim, WhateverTheFaceTolerates) {
    for_each_case(9540, 30, [](Random &random, uint64_t seed) {
        const Handle pipe = tube({0, 0, 0}, {0, 0, 1}, 1, 2);
        const double from =
                         (seed % 3 == 0 ? 0 : random.between(-1, 1) * std::pow(10, random.between(-13, -10))),
                     to = 0.25 * random.whole(1, 3) + (seed % 2 == 0 ? from : 0);
        const Handle border = rectangle(from, 0.1, to, 0.9);
        const nurbs *const curve = border.get();
        const int64_t size = 1;
        nurbs_face *made_face = nullptr;
        require_ok(
            nurbs_face_create(pipe.get(), 1, &size, &curve, nullptr, nullptr, 0.3, 0, nullptr, &made_face));
        const Face face(made_face);
        const double all = 2 * pi * to * 1.6, tilt = random.between(-0.2, 0.2),
                     off = random.between(0.5, 1.5);
        const Point3 n{tilt * random.between(-1, 1), tilt * random.between(-1, 1), 1};
        const double length = std::hypot(n[0], n[1], n[2]);
        const Handle plane = square({n[0] / length, n[1] / length, n[2] / length}, off / length, 5);
        const Model front = trim(face.get(), plane.get(), NURBS_TRIM_FRONT, coarse),
                    back = trim(face.get(), plane.get(), NURBS_TRIM_BACK, coarse);
        // z = off - n . (cos a, sin a) up to the angle that quarters of the circle end at
        const double angle = 2 * pi * to,
                     below = off * angle - n[0] * std::sin(angle) - n[1] * (1 - std::cos(angle));
        EXPECT_NEAR(area(back), below - 0.2 * angle, 1e-5);
        EXPECT_NEAR(area(front) + area(back), all, 1e-5);
        EXPECT_EQ(faces_of(front.get()).size(), 1U);
        EXPECT_EQ(faces_of(back.get()).size(), 1U);
        EXPECT_NEAR(area(combine(NURBS_REGION_UNION, front, back)), all, 1e-5);
        EXPECT_NEAR(area(combine(NURBS_REGION_DIFFERENCE, front, back)), area(front), 1e-5);
    });
}

// What touches inside of a torus crosses itself; as finely as this it is not told apart there.
TEST(FaceTrim, WhatIsNotToldApartIsRefusedByName) {
    const Handle torus = made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 1, 0.5, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_SMOOTH,
                                   out);
    });
    const double slope = std::asin(0.5);
    const Handle plane = square({-std::sin(slope), 0, std::cos(slope)}, 0, 3);
    Model out;
    EXPECT_EQ(try_trim(whole(torus.get()).get(), plane.get(), NURBS_TRIM_FRONT, out, 1e-11),
              NURBS_ERROR_NOT_CONVERGED);
}

} // namespace face_trim_test
