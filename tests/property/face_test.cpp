// Faces: sides agree with dense polygons, areas with closed forms, boxes with samples; and what does not change them.
#include "property/faces.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace face_test {

using namespace support;
using namespace support::faces;

namespace {

constexpr int samples = 4000;

// Places of a curve at equal parameters.
Vec polygon_of(const nurbs *curve) {
    double ends[2];
    require_ok(nurbs_domain(curve, 0, ends));
    Vec params;
    for (int i = 0; i <= samples; ++i) {
        params.push_back(i == samples ? ends[1] : ends[0] + (ends[1] - ends[0]) * i / samples);
    }
    return eval(curve, params);
}

struct Winding {
    int number = 0;
    bool near = false; // so near that the polygon may be on the other side
};

// Of a polygon around a place, in parts of the period.
Winding winding(const Vec &polygon, const Place &x, const Place &period) {
    Winding result;
    for (size_t i = 0; i + 3 < polygon.size(); i += 2) {
        const double u0 = (polygon[i] - x[0]) / period[0], v0 = (polygon[i + 1] - x[1]) / period[1];
        const double u1 = (polygon[i + 2] - x[0]) / period[0], v1 = (polygon[i + 3] - x[1]) / period[1];
        const double cross = u0 * v1 - u1 * v0;
        result.number += v0 <= 0 && v1 > 0 && cross > 0 ? 1 : v0 > 0 && v1 <= 0 && cross < 0 ? -1 : 0;
        result.near = result.near || std::hypot(u0, v0) < 2e-3 + 2 * std::hypot(u1 - u0, v1 - v0);
    }
    return result;
}

// Over all copies that a loop of at most one period meets.
Winding winding_of_copies(const Ground &ground, const Vec &polygon, const Place &x) {
    Winding sum;
    for (int i = ground.closed[0] ? -2 : 0; i <= (ground.closed[0] ? 2 : 0); ++i) {
        for (int j = ground.closed[1] ? -2 : 0; j <= (ground.closed[1] ? 2 : 0); ++j) {
            const Place copy{x[0] + i * ground.period[0], x[1] + j * ground.period[1]};
            const Winding one = winding(polygon, copy, ground.period);
            sum.number += one.number;
            sum.near = sum.near || one.near;
        }
    }
    return sum;
}

SplineData moved(SplineData data, double u, double v) {
    for (size_t i = 0; i < data.points.size(); i += 2) {
        data.points[i] += u;
        data.points[i + 1] += v;
    }
    return data;
}
Handle reversed(const nurbs *curve) {
    return made([&](nurbs **out) { return nurbs_reverse(curve, 0, 0, out); });
}
Vec places_in(Random &random, const Ground &ground, int n) {
    Vec places;
    for (int i = 0; i < n; ++i) {
        const Place x = ground.at(random.unit(), random.unit());
        places.insert(places.end(), x.begin(), x.end());
    }
    return places;
}
double whole_area(const Ground &ground) {
    double area = 0;
    require_ok(nurbs_surface_area(ground.surface.get(), nullptr, 1e-10, &area, nullptr));
    return area;
}

TEST(Face, sides_agree_with_dense_polygons) {
    Random random(1);
    int compared = 0;
    for (int round = 0; round < 8; ++round) {
        for (const Ground &ground : grounds(random)) {
            const Handle curve = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{curve.get()}}, 1e-9, NURBS_AS_ORIENTED);
            const Vec places = places_in(random, ground, 60), polygon = polygon_of(curve.get());
            const std::vector<int32_t> found = sides(face.get(), places);
            for (size_t i = 0; i < found.size(); ++i) {
                const Place x{places[2 * i], places[2 * i + 1]};
                const Winding expected = winding_of_copies(ground, polygon, x);
                if (!expected.near) {
                    EXPECT_EQ(found[i], expected.number > 0 ? 1 : -1) << x[0] << ' ' << x[1];
                    ++compared;
                }
                EXPECT_EQ(sides(face.get(), {x[0], x[1]})[0], found[i]);
            }
        }
    }
    EXPECT_GT(compared, 1500);
}

// The same loop, as it is and backwards.
TEST(Face, areas_of_both_sides_add_up) {
    Random random(2);
    for (int round = 0; round < 3; ++round) {
        for (const Ground &ground : grounds(random)) {
            const Handle curve = create(any_star(random, ground)), back = reversed(curve.get());
            const double whole = whole_area(ground);
            double sum = 0;
            for (const nurbs *loop : {curve.get(), back.get()}) {
                sum += area_of(face_of(ground.surface.get(), {{loop}}, 1e-9, NURBS_AS_ORIENTED).get());
            }
            EXPECT_NEAR(sum / whole, 1, 1e-8);
        }
    }
}

// By whole periods; in parts; another loop first; backwards, where loops are turned.
TEST(Face, is_the_same_however_its_loops_are_given) {
    Random random(3);
    for (int round = 0; round < 4; ++round) {
        for (const Ground &ground : grounds(random)) {
            const SplineData data = any_star(random, ground);
            const double u = ground.closed[0] ? random.whole(-5, 5) * ground.period[0] : 0;
            const double v = ground.closed[1] ? random.whole(-5, 5) * ground.period[1] : 0;
            const Handle curve = create(data), other = create(moved(data, u, v)),
                         back = reversed(curve.get());
            double ends[2];
            require_ok(nurbs_domain(curve.get(), 0, ends));
            Handle first, second;
            const double middle = ends[0] + 0.375 * (ends[1] - ends[0]);
            first = made([&](nurbs **out) {
                nurbs *rest = nullptr;
                const nurbs_status status = nurbs_split(curve.get(), 0, middle, out, &rest);
                second.reset(rest);
                return status;
            });
            const Face face = face_of(ground.surface.get(), {{curve.get()}});
            const Vec places = places_in(random, ground, 200);
            const std::vector<int32_t> expected = sides(face.get(), places);
            const double area = area_of(face.get());
            const std::vector<Curves> forms{{{other.get()}},
                                            {{back.get()}},
                                            {{first.get(), second.get()}},
                                            {{second.get(), first.get()}}};
            for (const Curves &loops : forms) {
                const Face same = face_of(ground.surface.get(), loops);
                EXPECT_EQ(sides(same.get(), places), expected);
                EXPECT_NEAR(area_of(same.get()) / area, 1, 1e-8);
            }
        }
    }
}

TEST(Face, order_of_loops_does_not_matter) {
    const Ground ground = plane(2);
    std::vector<Handle> squares;
    Curves loops;
    double expected = 0, sign = 4;
    for (const double half : {0.45, 0.4, 0.35, 0.3, 0.25}) {
        const double a = 0.5 - half, b = 0.5 + half;
        squares.push_back(polygon({{a, a}, {b, a}, {b, b}, {a, b}}));
        loops.push_back({squares.back().get()});
        expected += sign * 4 * half * half;
        sign = -sign;
    }
    Random random(4);
    for (int round = 0; round < 10; ++round) {
        const Face face = face_of(ground.surface.get(), loops);
        EXPECT_NEAR(area_of(face.get()), expected, 1e-12);
        EXPECT_EQ(sides(face.get(), {0.5, 0.06, 0.5, 0.12, 0.5, 0.17, 0.5, 0.22, 0.5, 0.5, 0.5, 0.04}),
                  (std::vector<int32_t>{1, -1, 1, -1, 1, -1}));
        std::swap(loops[static_cast<size_t>(random.whole(0, 4))],
                  loops[static_cast<size_t>(random.whole(0, 4))]);
    }
}

// Random star polygons: the shoelace formula, in the units of the plane.
TEST(Face, areas_and_boxes_of_polygons_are_exact) {
    Random random(5);
    for (const double size : {1.0, 1e-6, 1e6, 1e-140, 1e140}) {
        for (const double length : {1.0, 1e-9, 1e9}) {
            const Ground ground = plane(size, length);
            Star kind;
            kind.degree = 1;
            const SplineData data = star(random, ground, ground.at(0.5, 0.5), kind);
            double twice = 0, lowest = length;
            for (size_t i = 0; i + 3 < data.points.size(); i += 2) {
                twice += data.points[i] * data.points[i + 3] - data.points[i + 2] * data.points[i + 1];
                lowest = std::min(lowest, data.points[i + 1]);
            }
            const Handle curve = create(data);
            const Face face = face_of(ground.surface.get(), {{curve.get()}}, 1e-9 * size);
            EXPECT_NEAR(area_of(face.get(), 1e-13) / size / size, twice / 2 / length / length, 1e-13);
            const Box box = box_of(face.get(), 1e-9 * size);
            EXPECT_NEAR(box.lower[1] / size, lowest / length, 1e-9);
            EXPECT_LE(box.gap, 1.001e-9 * size);
        }
    }
}

// Archimedes: a zone of a sphere of radius r has the area 2 pi r times its height.
TEST(Face, zones_of_spheres_have_the_area_of_the_cylinder) {
    const Ground ground = sphere(2);
    const double z[] = {-0.75, 1.25};
    Handle circles[2];
    for (int i = 0; i < 2; ++i) {
        double lower = 0, upper = 1;
        for (int step = 0; step < 60; ++step) { // the latitude of a height, whatever the parameters
            const double middle = lower / 2 + upper / 2;
            (eval(ground.surface.get(), {0, middle})[2] < z[i] ? lower : upper) = middle;
        }
        const Place a = ground.at(0, lower), b = ground.at(1, lower);
        circles[i] = i == 0 ? segment(a, b) : segment(b, a);
    }
    const Face zone = face_of(ground.surface.get(), {{circles[0].get()}, {circles[1].get()}});
    EXPECT_NEAR(area_of(zone.get(), 1e-12), 2 * pi * 2 * 2, 1e-10);
    const Face cap = face_of(ground.surface.get(), {{circles[0].get()}});
    EXPECT_NEAR(area_of(cap.get(), 1e-12), 2 * pi * 2 * 2.75, 1e-10);
    const Box box = box_of(cap.get(), 1e-8);
    EXPECT_NEAR(box.lower[2], -0.75, 1e-7);
    EXPECT_NEAR(box.upper[2], 2, 1e-7);
}

TEST(Face, of_a_whole_surface_has_its_moments) {
    Random random(6);
    for (const Ground &ground : grounds(random)) {
        nurbs_face *handle = nullptr;
        require_ok(nurbs_face_create(ground.surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0,
                                     nullptr, &handle));
        const Face face(handle);
        double content[2], centroid[2][3], inertia[2][9];
        require_ok(nurbs_face_moments(face.get(), 1e-10, content, centroid[0], inertia[0], nullptr));
        require_ok(nurbs_moments(ground.surface.get(), 1e-10, content + 1, centroid[1], inertia[1], nullptr));
        const double size = std::sqrt(content[1]);
        EXPECT_NEAR(content[0] / content[1], 1, 1e-9);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(centroid[0][c], centroid[1][c], 1e-8 * size);
            EXPECT_NEAR(inertia[0][4 * c], inertia[1][4 * c], 1e-7 * content[1] * size * size);
        }
        EXPECT_EQ(sides(face.get(), {ground.at(0.3, 0.6)[0], ground.at(0.3, 0.6)[1]})[0], 1);
    }
}

// Lengths times a factor: areas times its square.
TEST(Face, areas_follow_similarities_and_affine_maps_of_planes) {
    Random random(7);
    for (const Ground &ground : grounds(random)) {
        const Handle curve = create(any_star(random, ground));
        const double area = area_of(face_of(ground.surface.get(), {{curve.get()}}).get());
        const double factor = random.magnitude(1e-4, 1e4), c = 0.6 * factor, s = 0.8 * factor;
        const double turn[] = {c, -s, 0, s, c, 0, 0, 0, factor}, shift[] = {1, 2, 3};
        const Handle image =
            made([&](nurbs **out) { return nurbs_transform(ground.surface.get(), 3, turn, shift, out); });
        const double other = area_of(face_of(image.get(), {{curve.get()}}, 1e-9 * factor).get());
        EXPECT_NEAR(other / (area * factor * factor), 1, 1e-8);
    }
}

// 1e4 places of each, of which those inside are in the box, and come near all of its sides.
TEST(Face, boxes_contain_the_inside_and_touch_it) {
    Random random(8);
    for (int round = 0; round < 2; ++round) {
        for (const Ground &ground : grounds(random)) {
            const Handle curve = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{curve.get()}});
            const Box box = box_of(face.get(), 1e-3);
            const Vec places = places_in(random, ground, 10000);
            const std::vector<int32_t> found = sides(face.get(), places);
            const Vec points = eval(ground.surface.get(), places);
            Vec all = eval(ground.surface.get(), polygon_of(curve.get()), NURBS_ON_ALL_AXES(2, NURBS_WRAP));
            for (size_t i = 0; i < points.size(); ++i) {
                if (found[i / 3] > 0) {
                    all.push_back(points[i]);
                }
            }
            Vec lower(3, 1e300), upper(3, -1e300);
            for (size_t i = 0; i < all.size(); ++i) {
                lower[i % 3] = std::min(lower[i % 3], all[i]);
                upper[i % 3] = std::max(upper[i % 3], all[i]);
            }
            for (size_t c = 0; c < 3; ++c) {
                const double size = std::max({1e-3, std::fabs(box.lower[c]), std::fabs(box.upper[c])});
                EXPECT_GE(lower[c], box.lower[c] - 1e-12 * size);
                EXPECT_LE(upper[c], box.upper[c] + 1e-12 * size);
                EXPECT_LE(lower[c] - box.lower[c], box.gap + 0.03 * size);
                EXPECT_LE(box.upper[c] - upper[c], box.gap + 0.03 * size);
            }
        }
    }
}

// Within a distance in space of a circle in a plane.
TEST(Face, tolerances_are_distances_in_space) {
    const Ground ground = plane(10);
    const double centre[] = {0.5, 0.5};
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.25, NURBS_ARC_THIRDS, out);
    });
    const Face face = face_of(ground.surface.get(), {{circle.get()}});
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const double angle = random.between(0, 2 * pi), r = 0.25 + random.between(-0.02, 0.02);
        const double off = 10 * (r - 0.25);
        const int32_t side =
            sides(face.get(), {0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)}, 0.1)[0];
        if (std::fabs(std::fabs(off) - 0.1) > 1e-6) {
            EXPECT_EQ(side, std::fabs(off) < 0.1 ? 0 : off < 0 ? 1 : -1) << angle << ' ' << off;
        }
    }
}

} // namespace

// A surface has kinks in its parameters where its pieces meet, and where it closes up.
TEST(Face, edges_follow_curves_past_kinks) {
    for_each_case(1, 40, [](Random &random, uint64_t seed) {
        const Ground ground = random.chance(50) ? cylinder(2, 3) : torus(3, 1);
        const Star kind{random.whole(5, 9), true, random.chance(50), 0.4};
        const Place centre = ground.at(random.between(-0.2, 0.2), ground.closed[1] ? random.unit() : 0.5);
        const Handle loop = create(star(random, ground, centre, kind));
        const Face face = face_of(ground.surface.get(), {{loop.get()}});
        const Handle edge =
            made([&](nurbs **out) { return nurbs_face_edge(face.get(), 0, 0, nullptr, out); });
        const Vec places = polygon_of(loop.get()), points = polygon_of(edge.get());
        for (size_t i = 0; i < places.size() / 2; i += 7) {
            Place x{places[2 * i], places[2 * i + 1]};
            for (size_t k = 0; k < 2; ++k) {
                const double turns = std::floor((x[k] - ground.lower[k]) / ground.period[k]);
                x[k] -= ground.closed[k] ? turns * ground.period[k] : 0;
            }
            const Vec want = eval(ground.surface.get(), {x[0], x[1]});
            for (size_t k = 0; k < 3; ++k) {
                ASSERT_NEAR(points[3 * i + k], want[k], 1e-9) << seed;
            }
        }
    });
}

} // namespace face_test
