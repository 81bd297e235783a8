// Nearest points of faces: no place inside is nearer than what is certified, and the nearest point is on the face.
#include "property/faces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace face_closest_test {

using namespace support;
using namespace support::faces;

namespace {

struct Answer {
    double uv[2] = {0, 0}, x[3] = {0, 0, 0}, distance = 0;
    int32_t status = 0;
    [[nodiscard]] bool certified() const { return (status & NURBS_CLOSEST_CERTIFIED) != 0; }
    [[nodiscard]] bool boundary() const { return (status & NURBS_CLOSEST_BOUNDARY) != 0; }
};

Answer nearest(const nurbs_face *face, const Vec &point, double tolerance) {
    Answer answer;
    require_ok(nurbs_face_closest_points(face, 1, point.data(), 0, 0, tolerance, answer.uv, answer.x,
                                         &answer.distance, &answer.status));
    return answer;
}

double distance(const Vec &a, const double *b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Places of a grid inside of the loops.
std::vector<Vec> points_inside(const Ground &ground, const nurbs_face *face) {
    constexpr int per_axis = 40;
    Vec places;
    for (int i = 0; i <= per_axis; ++i) {
        for (int j = 0; j <= per_axis; ++j) {
            const Place at = ground.at(i / (per_axis + 0.0), j / (per_axis + 0.0));
            places.insert(places.end(), at.begin(), at.end());
        }
    }
    const std::vector<int32_t> found = sides(face, places);
    std::vector<Vec> points;
    for (size_t i = 0; i < found.size(); ++i) {
        if (found[i] >= 0) {
            points.push_back(eval(ground.surface.get(), {places[2 * i], places[2 * i + 1]}));
        }
    }
    return points;
}

} // namespace

TEST(FaceClosest, no_place_inside_is_nearer) {
    int64_t certified = 0, boundary = 0, count = 0;
    for_each_case(3000000, 25, [&](Random &random, uint64_t seed) {
        for (const Ground &ground : grounds(random)) {
            const Handle loop = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{loop.get()}});
            const std::vector<Vec> inside = points_inside(ground, face.get());
            const Box box = box_of(face.get(), HUGE_VAL);
            double size = 0;
            for (size_t k = 0; k < 3; ++k) {
                size = std::max(size, box.upper[k] - box.lower[k]);
            }
            for (int i = 0; i < 8; ++i) {
                Vec point;
                for (size_t k = 0; k < 3; ++k) {
                    point.push_back(random.between(box.lower[k] - size / 2, box.upper[k] + size / 2));
                }
                const double tolerance = 1e-6 * size;
                const Answer answer = nearest(face.get(), point, tolerance);
                ++count;
                ASSERT_NEAR(answer.distance, distance(point, answer.x), 1e-12 * size) << seed;
                ASSERT_GE(sides(face.get(), {answer.uv[0], answer.uv[1]}, 1e-6 * size)[0], 0) << seed;
                if (!answer.certified()) {
                    continue;
                }
                ++certified;
                boundary += answer.boundary() ? 1 : 0;
                for (const Vec &other : inside) {
                    ASSERT_LE(answer.distance, distance(other, point.data()) + 2 * tolerance) << seed;
                }
            }
        }
    });
    std::cout << "certified " << certified << " of " << count << ", at the boundary " << boundary << '\n';
    EXPECT_GE(certified, of_whole_run(count * 3 / 4));
    EXPECT_GE(boundary, of_whole_run(count / 5));
}

// A square without a disc: the nearest points of places over the disc are on its rim, where the closed form says.
TEST(FaceClosest, of_places_over_a_hole_are_on_its_rim) {
    const Ground ground = plane(4, 1);
    const Handle outline = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const double centre[] = {0.5, 0.5};
    const Handle hole = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.25, NURBS_ARC_QUARTERS, out);
    });
    const Face face = face_of(ground.surface.get(), {{outline.get()}, {hole.get()}});
    for_each_case(3010000, 200, [&](Random &random, uint64_t seed) {
        const double x = random.between(-1, 5), y = random.between(-1, 5), z = random.between(-1, 1);
        const double from_axis = std::hypot(x - 2, y - 2), beyond_x = std::max({-x, x - 4, 0.0}),
                     beyond_y = std::max({-y, y - 4, 0.0});
        const double expected =
            std::hypot(from_axis < 1 ? 1 - from_axis : 0, beyond_x, std::hypot(beyond_y, z));
        const Answer answer = nearest(face.get(), {x, y, z}, 1e-9);
        ASSERT_TRUE(answer.certified()) << seed;
        ASSERT_NEAR(answer.distance, expected, 2e-9) << seed;
        ASSERT_EQ(answer.boundary(), from_axis < 1 || beyond_x > 0 || beyond_y > 0) << seed;
    });
}

// A sheet that a surface runs over twice, there and back: the nearest point of a face of the way back is where it is on a face of the
// sheet alone, though the way there, which is outside, is as near.
TEST(FaceClosest, of_sheets_on_each_other_that_of_the_face_counts) {
    int64_t inside = 0;
    for_each_case(3020000, 60, [&](Random &random, uint64_t seed) {
        const int32_t p = random.whole(1, 3);
        SplineData once{{p, 2}, {p + 1, 3}, {Vec(2 * static_cast<size_t>(p) + 2), {0, 0, 0, 1, 1, 1}}, 3, {},
                        {},     0};
        std::fill(once.knots[0].begin() + p + 1, once.knots[0].end(), 1.0);
        const bool rational = random.chance(50);
        for (int i = 0; i <= p; ++i) {
            for (int j = 0; j <= 2; ++j) {
                once.points.insert(once.points.end(), {i + random.between(-0.2, 0.2),
                                                       j + random.between(-0.2, 0.2), random.between(0, 1)});
                if (rational) {
                    once.weights.push_back(random.between(0.5, 2));
                }
            }
        }
        SplineData twice = once;
        twice.counts[0] = 2 * p + 1;
        twice.knots[0].insert(twice.knots[0].end() - 1, static_cast<size_t>(p), 2.0);
        twice.knots[0].back() = 2;
        for (int i = p - 1; i >= 0; --i) {
            const auto layer = [i](std::vector<double> &to, const std::vector<double> &from, int width) {
                to.insert(to.end(), from.begin() + i * width, from.begin() + (i + 1) * width);
            };
            layer(twice.points, once.points, 9);
            if (rational) {
                layer(twice.weights, once.weights, 3);
            }
        }
        const Handle sheet = create(once), back = create(twice);
        const double u = random.between(0.1, 0.5), v = random.between(0.1, 0.5), w = random.between(0.2, 0.4);
        const Handle loop = polygon({{u, v}, {u + w, v}, {u + w, v + w}, {u, v + w}});
        const Handle mirrored = polygon({{2 - u, v}, {2 - u - w, v}, {2 - u - w, v + w}, {2 - u, v + w}});
        const Face face = face_of(sheet.get(), {{loop.get()}}),
                   other = face_of(back.get(), {{mirrored.get()}});
        for (int i = 0; i < 4; ++i) {
            const Vec above =
                eval(sheet.get(), {u + random.between(0.1, 0.9) * w, v + random.between(0.1, 0.9) * w});
            const Vec point{above[0], above[1], above[2] + random.between(-0.1, 0.1)};
            const Answer expected = nearest(face.get(), point, 1e-9),
                         answer = nearest(other.get(), point, 1e-9);
            ASSERT_NEAR(answer.distance, expected.distance, 2e-9) << seed;
            ASSERT_TRUE(answer.certified() || !expected.certified()) << seed;
            inside += answer.boundary() ? 0 : 1;
        }
    });
    EXPECT_GE(inside, of_whole_run(120));
}

namespace {

// Control points anywhere in a cube: sheets run through each other, and the distance from a point has many minima.
Ground crumpled(Random &random) {
    const int32_t p = random.whole(2, 3), n = random.whole(6, 9);
    SplineData data{{p, p}, {n, n}, {}, 3, {}, {}, 0};
    for (int k = 0; k < 2; ++k) {
        Vec knots;
        for (int i = 0; i <= n + p; ++i) {
            knots.push_back(std::clamp(i - p, 0, n - p));
        }
        data.knots.push_back(knots);
    }
    for (int i = 0; i < 3 * n * n; ++i) {
        data.points.push_back(random.between(0, 1));
    }
    return ground_of(create(data), false, false);
}

} // namespace

// Of points beside a part that is cut out, near other sheets: certified or not.
TEST(FaceClosest, of_crumpled_surfaces_no_place_inside_is_nearer_by_much) {
    int64_t certified = 0, count = 0;
    for_each_case(3030000, 10, [&](Random &random, uint64_t seed) {
        const Ground ground = crumpled(random);
        const Handle outline = polygon({ground.at(0, 0), ground.at(1, 0), ground.at(1, 1), ground.at(0, 1)}),
                     hole = create(star(random, ground, ground.at(0.5, 0.5), Star{}));
        const Face face = face_of(ground.surface.get(), {{outline.get()}, {hole.get()}});
        const std::vector<Vec> inside = points_inside(ground, face.get());
        for (int i = 0; i < 10; ++i) {
            const Place at = ground.at(random.between(0.4, 0.6), random.between(0.4, 0.6));
            Vec point = eval(ground.surface.get(), {at[0], at[1]});
            for (double &x : point) {
                x += random.between(-1e-3, 1e-3);
            }
            const Answer answer = nearest(face.get(), point, 1e-7);
            ++count;
            certified += answer.certified() ? 1 : 0;
            for (const Vec &other : inside) {
                ASSERT_LE(answer.distance, distance(other, point.data()) + 2e-7) << seed;
            }
        }
    });
    std::cout << "certified " << certified << " of " << count << '\n';
    EXPECT_GE(certified, of_whole_run(count * 9 / 10));
}

// Points of the axis of a cylinder are as far from all of it: where its minima are is not to be told.
TEST(FaceClosest, of_points_on_the_axis_of_a_cylinder) {
    const Ground ground = cylinder(2, 3);
    for_each_case(3040000, 10, [&](Random &random, uint64_t seed) {
        const Handle loop = create(star(random, ground, ground.at(0.4, 0.5), Star{}));
        const Face face = face_of(ground.surface.get(), {{loop.get()}});
        for (const double off : {0.0, 1e-13, 1e-9}) {
            const Answer answer = nearest(face.get(), {off, -off, random.between(1.2, 1.8)}, 1e-6);
            ASSERT_NEAR(answer.distance, 2, 1e-6) << seed;
        }
    });
}

} // namespace face_closest_test
