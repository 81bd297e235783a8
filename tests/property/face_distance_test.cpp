// Distances of faces: closed forms, and no places inside of two faces are nearer, or farther from the other one, than is proven.
#include "property/faces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace face_distance_test {

using namespace support;
using namespace support::faces;

namespace {

struct Nearest {
    double at_least = -1, at_most = -1;
    Place a{}, b{};
    int32_t status = 0;
};
Nearest distance_of(const nurbs_face *a, const nurbs_face *b, double tolerance) {
    Nearest found;
    require_ok(nurbs_face_distance(a, b, tolerance, &found.at_least, &found.at_most, found.a.data(),
                                   found.b.data(), &found.status));
    return found;
}

struct Farthest {
    std::array<double, 2> at_least{}, at_most{};
    Place a{}, b{};
    int32_t status = 0;
};
Farthest hausdorff_of(const nurbs_face *a, const nurbs_face *b, double tolerance) {
    Farthest found;
    require_ok(nurbs_face_hausdorff_distance(a, b, tolerance, found.at_least.data(), found.at_most.data(),
                                             found.a.data(), found.b.data(), &found.status));
    return found;
}

double distance(const Vec &a, const Vec &b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Handle circle(const Place &centre, double radius) {
    return made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre.data(), nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

// A disc about a centre in the plane z = height, a ring if `hole` is positive.
struct Disc {
    Place centre;
    double radius, hole = 0, height = 0;
};
Face disc(const Disc &of) {
    const Vec knots{0, 0, 1, 1};
    const double x = of.centre[0] - 5, y = of.centre[1] - 5, z = of.height;
    const Handle surface = create(
        {{1, 1}, {2, 2}, {knots, knots}, 3, {x, y, z, x, y + 10, z, x + 10, y, z, x + 10, y + 10, z}, {}, 0});
    const Place middle{0.5, 0.5};
    const Handle outer = circle(middle, of.radius / 10);
    if (of.hole == 0) {
        return face_of(surface.get(), {{outer.get()}});
    }
    const Handle inner = circle(middle, of.hole / 10);
    return face_of(surface.get(), {{outer.get()}, {inner.get()}});
}

Handle moved(const nurbs *surface, Random &random, double size) {
    const double turn = random.between(-3, 3), c = std::cos(turn), s = std::sin(turn);
    const double matrix[] = {c, -s, 0, s, c, 0, 0, 0, 1},
                 by[] = {random.between(-size, size), random.between(-size, size),
                         random.between(-size, size)};
    nurbs *out = nullptr;
    require_ok(nurbs_transform(surface, 3, matrix, by, &out));
    return Handle(out);
}

Vec points_inside(const Ground &ground, const nurbs_face *face, int per_axis) {
    Vec places, inside;
    for (int i = 0; i <= per_axis; ++i) {
        for (int j = 0; j <= per_axis; ++j) {
            const Place at = ground.at(i / (per_axis + 0.0), j / (per_axis + 0.0));
            places.insert(places.end(), at.begin(), at.end());
        }
    }
    const std::vector<int32_t> found = sides(face, places);
    for (size_t i = 0; i < found.size(); ++i) {
        if (found[i] >= 0) {
            inside.insert(inside.end(), {places[2 * i], places[2 * i + 1]});
        }
    }
    return inside;
}

std::vector<Vec> points_at(const nurbs *surface, const Vec &places) {
    std::vector<Vec> points;
    for (size_t i = 0; i < places.size(); i += 2) {
        points.push_back(eval(surface, {places[i], places[i + 1]}));
    }
    return points;
}

double nearest_pair(const std::vector<Vec> &a, const std::vector<Vec> &b) {
    double least = HUGE_VAL;
    for (const Vec &x : a) {
        for (const Vec &y : b) {
            least = std::min(least, distance(x, y));
        }
    }
    return least;
}

// Mostly of degrees that can be composed with those of surfaces.
SplineData low_star(Random &random, const Ground &ground) {
    for (;;) {
        SplineData data = any_star(random, ground);
        if (data.degrees[0] <= 4 || random.chance(2)) {
            return data;
        }
    }
}

// Two faces of grounds of any kinds, the second one moved.
struct Pair {
    Ground ground_a, ground_b;
    Face a, b;
    double size;
};
Pair random_pair(Random &random) {
    std::vector<Ground> first = grounds(random), second = grounds(random);
    Ground ground_a = std::move(first[static_cast<size_t>(random.whole(1, 4))]),
           ground_b = std::move(second[static_cast<size_t>(random.whole(1, 4))]);
    ground_b.surface = moved(ground_b.surface.get(), random, 6);
    const Handle loop_a = create(low_star(random, ground_a)), loop_b = create(low_star(random, ground_b));
    Face a = face_of(ground_a.surface.get(), {{loop_a.get()}}),
         b = face_of(ground_b.surface.get(), {{loop_b.get()}});
    return {std::move(ground_a), std::move(ground_b), std::move(a), std::move(b), 10};
}

} // namespace

// Discs beside and over each other; over a hole it is the rim that is near.
TEST(FaceDistance, of_discs_is_that_of_circles) {
    for_each_case(3600000, 60, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Disc below{{0, 0}, random.between(2, 3), random.chance(50) ? random.between(1, 1.9) : 0},
            above{{random.between(-4, 4), random.between(-4, 4)},
                  random.between(0.2, 1),
                  0,
                  random.between(0.1, 2)};
        const double away = std::hypot(above.centre[0], above.centre[1]);
        const double in_plane =
            std::max({away - above.radius - below.radius, below.hole - away - above.radius, 0.0});
        const Face a = disc(below), b = disc(above);
        const Nearest found = distance_of(a.get(), b.get(), 1e-9);
        EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
        EXPECT_NEAR(found.at_most, std::hypot(in_plane, above.height), 2e-9);
        EXPECT_LE(found.at_least, found.at_most);
        const Nearest back = distance_of(b.get(), a.get(), 1e-9);
        EXPECT_NEAR(back.at_most, found.at_most, 2e-9);
    });
}

// Caps of one sphere, of another one about the same centre, and a cone over its apex, which is a pole.
TEST(FaceDistance, at_poles_and_between_concentric_caps) {
    const auto ball = [](double radius) {
        return made([&](nurbs **out) {
            return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
        });
    };
    const Ground inner = ground_of(ball(1), true, false), outer = ground_of(ball(3), true, false);
    const Face all_inner = face_of(inner.surface.get(), {}), all_outer = face_of(outer.surface.get(), {});
    const Nearest whole = distance_of(all_inner.get(), all_outer.get(), 1e-9);
    EXPECT_EQ(whole.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_NEAR(whole.at_most, 2, 1e-8);
    const Farthest far = hausdorff_of(all_inner.get(), all_outer.get(), 1e-6);
    EXPECT_EQ(far.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_NEAR(far.at_most[0], 2, 2e-6);
    EXPECT_NEAR(far.at_most[1], 2, 2e-6);
    const Handle cone = made([&](nurbs **out) {
        const double apex[] = {0, 0, 5}, down[] = {0, 0, -1};
        return nurbs_surface_cone(apex, down, nullptr, 0, 1, 1, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Face roof = face_of(cone.get(), {});
    const Nearest under = distance_of(roof.get(), all_outer.get(), 1e-9);
    EXPECT_EQ(under.status, NURBS_CLOSEST_CERTIFIED);
    const Handle high = made([&](nurbs **out) {
        const double apex[] = {0, 0, 4}, up[] = {0, 0, 1};
        return nurbs_surface_cone(apex, up, nullptr, 0, 1, 1, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Nearest over = distance_of(face_of(high.get(), {}).get(), all_outer.get(), 1e-9);
    EXPECT_EQ(over.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_NEAR(over.at_most, 1, 1e-8);
}

// Parts of two balls around the places where these are nearest to each other: the second ball is the first one turned inside out,
// moved along the normal.
TEST(FaceDistance, inside_of_both_is_that_of_the_surfaces) {
    for_each_case(3605000, 40, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Ground ground = sphere(1.5);
        const Place middle = ground.at(random.unit(), 0.5);
        const Vec x = eval(ground.surface.get(), {middle[0], middle[1]});
        const double gap = random.magnitude(1e-3, 3), by = 2 + gap / 1.5;
        const double matrix[] = {-1, 0, 0, 0, -1, 0, 0, 0, -1}, shift[] = {by * x[0], by * x[1], by * x[2]};
        nurbs *out = nullptr;
        require_ok(nurbs_transform(ground.surface.get(), 3, matrix, shift, &out));
        const Handle other(out);
        Star kind;
        kind.radius = 0.2;
        const Handle loop_a = create(star(random, ground, middle, kind)),
                     loop_b = create(star(random, ground, middle, kind));
        const Face a = face_of(ground.surface.get(), {{loop_a.get()}}),
                   b = face_of(other.get(), {{loop_b.get()}});
        const Nearest found = distance_of(a.get(), b.get(), 1e-9);
        EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
        EXPECT_NEAR(found.at_most, gap, 2e-9);
    });
}

TEST(FaceDistance, no_places_inside_are_nearer) {
    int64_t certified = 0, count = 0;
    for_each_case(3610000, 40, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Pair pair = random_pair(random);
        const double tolerance = 1e-6;
        const Nearest found = distance_of(pair.a.get(), pair.b.get(), tolerance);
        ++count;
        certified += found.status == NURBS_CLOSEST_CERTIFIED ? 1 : 0;
        ASSERT_LE(found.at_least, found.at_most);
        ASSERT_GE(sides(pair.a.get(), {found.a[0], found.a[1]}, 1e-6)[0], 0);
        ASSERT_GE(sides(pair.b.get(), {found.b[0], found.b[1]}, 1e-6)[0], 0);
        const Vec x = eval(pair.ground_a.surface.get(), {found.a[0], found.a[1]}),
                  y = eval(pair.ground_b.surface.get(), {found.b[0], found.b[1]});
        ASSERT_NEAR(distance(x, y), found.at_most, 1e-12 * pair.size);
        const auto a = points_at(pair.ground_a.surface.get(), points_inside(pair.ground_a, pair.a.get(), 40)),
                   b = points_at(pair.ground_b.surface.get(), points_inside(pair.ground_b, pair.b.get(), 40));
        ASSERT_LE(found.at_least, nearest_pair(a, b) + 1e-12 * pair.size);
    });
    std::cout << "certified " << certified << " of " << count << '\n';
    EXPECT_GE(certified, of_whole_run(count * 9 / 10));
}

// Discs about one axis: the rim, or the middle of a hole, is farthest.
TEST(FaceHausdorff, of_discs_is_that_of_circles) {
    for_each_case(3620000, 20, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Disc ring{{0, 0}, random.between(2, 3), random.between(0.5, 1.5)},
            plate{{0, 0}, random.between(1, 4), 0, random.between(0, 1)};
        const Face a = disc(ring), b = disc(plate);
        const double tolerance = 1e-2;
        const Farthest found = hausdorff_of(a.get(), b.get(), tolerance);
        const double there = std::hypot(std::max(0.0, ring.radius - plate.radius), plate.height),
                     back = std::hypot(std::max(ring.hole, plate.radius - ring.radius), plate.height);
        EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
        for (const auto &[i, exact] : {std::pair<size_t, double>(0, there), {1, back}}) {
            EXPECT_LE(found.at_least[i], exact + 1e-9);
            EXPECT_GE(found.at_most[i], exact - 1e-9);
            EXPECT_LE(found.at_most[i] - found.at_least[i], 1.01 * tolerance);
        }
        EXPECT_GE(sides(a.get(), {found.a[0], found.a[1]}, 1e-9)[0], 0);
        EXPECT_GE(sides(b.get(), {found.b[0], found.b[1]}, 1e-9)[0], 0);
    });
}

TEST(FaceHausdorff, no_place_inside_is_farther) {
    int64_t certified = 0, count = 0;
    for_each_case(3630000, 12, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Pair pair = random_pair(random);
        const Farthest found = hausdorff_of(pair.a.get(), pair.b.get(), 0.1);
        ++count;
        certified += found.status == NURBS_CLOSEST_CERTIFIED ? 1 : 0;
        double most = 0;
        for (const Vec &x :
             points_at(pair.ground_a.surface.get(), points_inside(pair.ground_a, pair.a.get(), 20))) {
            double away = 0;
            require_ok(nurbs_face_closest_points(pair.b.get(), 1, x.data(), 0, 0, 1e-6, nullptr, nullptr,
                                                 &away, nullptr));
            most = std::max(most, away);
        }
        ASSERT_LE(most, found.at_most[0] + 2e-6);
        ASSERT_LE(found.at_least[0], found.at_most[0]);
        const Vec x = eval(pair.ground_a.surface.get(), {found.a[0], found.a[1]});
        double away = 0;
        require_ok(nurbs_face_closest_points(pair.b.get(), 1, x.data(), 0, 0, 1e-6, nullptr, nullptr, &away,
                                             nullptr));
        ASSERT_GE(away, found.at_least[0] - 1e-5);
        ASSERT_GE(sides(pair.a.get(), {found.a[0], found.a[1]}, 1e-9)[0], 0);
    });
    std::cout << "certified " << certified << " of " << count << '\n';
    EXPECT_GE(certified, of_whole_run(count * 9 / 10));
}

// A small plate in a large plane over domains that do not hold (0, 0), and a square about a corner of that plane: at every limit of
// work bounds are true, and feet are on the plate.
TEST(FaceHausdorff, limits_of_work_leave_true_bounds) {
    for (const double from : {0.0, 5.0}) {
        const Vec knots{from, from, from + 1, from + 1};
        const Handle large =
            create({{1, 1}, {2, 2}, {knots, knots}, 3, {0, 0, 0, 0, 10, 0, 10, 0, 0, 10, 10, 0}, {}, 0});
        const Handle outline = polygon({{from + 0.6, from + 0.6},
                                        {from + 0.9, from + 0.6},
                                        {from + 0.9, from + 0.9},
                                        {from + 0.6, from + 0.9}});
        const Face plate = face_of(large.get(), {{outline.get()}}),
                   unit = face_of(plane(1).surface.get(), {});
        const double exact = std::sqrt(72), exact_back = std::sqrt(128);
        for (int64_t work = 1; work < 100000000; work *= 3) {
            nurbs_call_options call;
            require_ok(nurbs_call_options_init(&call, sizeof call));
            call.work = work;
            Farthest found;
            require_ok(nurbs_face_hausdorff_distance_with(
                unit.get(), plate.get(), 1e-3, found.at_least.data(), found.at_most.data(), found.a.data(),
                found.b.data(), &found.status, &call));
            EXPECT_LE(found.at_least[0], exact + 1e-9) << work;
            EXPECT_GE(found.at_most[0], exact - 1e-9) << work;
            EXPECT_LE(found.at_least[1], exact_back + 1e-9) << work;
            EXPECT_GE(found.at_most[1], exact_back - 1e-9) << work;
            double low = 0, high = 0;
            require_ok(nurbs_face_distance_with(unit.get(), plate.get(), 1e-3, &low, &high, nullptr, nullptr,
                                                nullptr, &call));
            EXPECT_LE(low, std::sqrt(50) + 1e-9) << work;
            EXPECT_GE(high, std::sqrt(50) - 1e-9) << work;
            double uv[2], foot[3], distance = 0;
            const double corner[3] = {0, 0, 0};
            require_ok(nurbs_face_closest_points_with(plate.get(), 1, corner, 0, 0, 0, uv, foot, &distance,
                                                      nullptr, &call));
            EXPECT_GE(sides(plate.get(), {uv[0], uv[1]}, 1e-9)[0], 0) << work;
            EXPECT_GE(distance, exact - 1e-9) << work;
        }
    }
}

// Where the surface jumps the limit from below counts; searches of other parts do not use up the work.
TEST(FaceDistance, of_whole_surfaces_is_that_of_their_splines) {
    const double turn = 2 * pi;
    const Handle ball = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
    const Handle ring = made([&](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, turn, 0, turn, NURBS_ARC_QUARTERS,
                                   out);
    });
    const Handle hat = made([&](nurbs **out) {
        return nurbs_surface_cone(nullptr, nullptr, nullptr, 1, 0, 2, 0, turn, NURBS_ARC_QUARTERS, out);
    });
    const Handle steps = create({{1, 1},
                                 {4, 2},
                                 {{0, 0, .5, .5, 1, 1}, {0, 0, 1, 1}},
                                 3,
                                 {0, 0, 0, 0, 1, 0, .5, 0, 1, .5, 1, 1, .5, 0, 0, .5, 1, 0, 1, 0, 0, 1, 1, 0},
                                 {},
                                 0});
    const Handle above = create({{1, 1},
                                 {2, 2},
                                 {{0, 0, 1, 1}, {0, 0, 1, 1}},
                                 3,
                                 {0, 0, 1.5, 0, 1, 1.5, 1, 0, 1.5, 1, 1, 1.5},
                                 {},
                                 0});
    const std::vector<std::pair<const nurbs *, const nurbs *>> pairs{
        {ball.get(), ring.get()}, {ball.get(), hat.get()}, {steps.get(), above.get()}};
    for (const auto &[a, b] : pairs) {
        double high = 0;
        require_ok(nurbs_distance(a, b, 1e-9, 0, nullptr, &high, nullptr, nullptr, nullptr));
        const Face first = face_of(a, {}), second = face_of(b, {});
        for (const Nearest &found :
             {distance_of(first.get(), second.get(), 1e-9), distance_of(second.get(), first.get(), 1e-9)}) {
            EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
            EXPECT_NEAR(found.at_most, high, 2e-9);
        }
    }
}

TEST(FaceHausdorff, of_a_face_and_itself_is_0) {
    Random random(1);
    const Ground ground = wavy(random);
    const Handle loop = create(any_star(random, ground));
    const Face a = face_of(ground.surface.get(), {{loop.get()}}),
               b = face_of(ground.surface.get(), {{loop.get()}});
    const Farthest same = hausdorff_of(a.get(), a.get(), 0);
    EXPECT_EQ(same.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_EQ(same.at_most, (std::array<double, 2>{0, 0}));
    const Farthest other = hausdorff_of(a.get(), b.get(), 1e-2);
    EXPECT_EQ(other.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_LE(other.at_most[0], 1e-2);
    EXPECT_LE(distance_of(a.get(), b.get(), 1e-9).at_most, 1e-9);
}

} // namespace face_distance_test
