// Rays and faces: what is certified is what all hits of the surface and the sides of their places say.
#include "property/faces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace face_rays_test {

using namespace support;
using namespace support::faces;

namespace {

using Point = std::array<double, 3>;

struct Answer {
    double uv[2] = {0, 0}, t = 0;
    int32_t status = 0;
    [[nodiscard]] bool hit() const { return (status & NURBS_RAY_HIT) != 0; }
    [[nodiscard]] bool certified() const { return (status & NURBS_RAY_CERTIFIED) != 0; }
};

Answer cast(const nurbs_face *face, const Point &from, const Point &along) {
    Answer answer;
    require_ok(nurbs_face_rays(face, 1, from.data(), 0, 0, along.data(), 0, 0, answer.uv, &answer.t,
                               &answer.status));
    return answer;
}

// All hits of the surface, and on which side of the loops they are.
struct SurfaceHits {
    Vec uv, t;
    std::vector<int32_t> sides;
    int32_t complete = 0;
};

SurfaceHits hits_of(const nurbs *surface, const nurbs_face *face, const Point &from, const Point &along) {
    SurfaceHits found;
    int64_t count = 0;
    require_ok(nurbs_surface_ray_hits(surface, from.data(), along.data(), nullptr, 0, nullptr, nullptr,
                                      nullptr, &count, &found.complete));
    found.uv.resize(static_cast<size_t>(2 * count));
    found.t.resize(static_cast<size_t>(count));
    require_ok(nurbs_surface_ray_hits(surface, from.data(), along.data(), nullptr, count, found.uv.data(),
                                      found.t.data(), nullptr, &count, &found.complete));
    found.sides = sides(face, found.uv);
    return found;
}

// The first t of a hit on a side of the loops.
double first_of(const SurfaceHits &hits, int32_t side) {
    for (size_t i = 0; i < hits.t.size(); ++i) {
        if (hits.sides[i] == side) {
            return hits.t[i];
        }
    }
    return HUGE_VAL;
}

Point random_point(Random &random, double size) {
    return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

// Of the box of the control points.
double size_of(const nurbs *surface) {
    double lower[3], upper[3];
    require_ok(nurbs_box(surface, nullptr, 0.1, lower, upper, nullptr));
    double most = 0;
    for (int k = 0; k < 3; ++k) {
        most = std::max({most, std::abs(lower[k]), std::abs(upper[k])});
    }
    return most;
}

} // namespace

TEST(FaceRays, agree_with_all_hits_of_the_surface) {
    int64_t certified = 0, hit = 0, beside = 0, count = 0;
    for_each_case(2900000, 400, [&](Random &random, uint64_t seed) {
        for (const Ground &ground : grounds(random)) {
            const Handle loop = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{loop.get()}});
            const double size = size_of(ground.surface.get());
            for (int i = 0; i < 10; ++i) {
                const Point from = random_point(random, 3 * size), to = random_point(random, size);
                const Point along{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
                const Answer answer = cast(face.get(), from, along);
                const SurfaceHits hits = hits_of(ground.surface.get(), face.get(), from, along);
                ++count;
                if (!answer.certified() || hits.complete != 1) {
                    continue;
                }
                ++certified;
                const double inside = first_of(hits, 1);
                ASSERT_EQ(answer.hit(), inside < HUGE_VAL) << seed;
                beside += first_of(hits, -1) < inside ? 1 : 0;
                if (answer.hit()) {
                    ++hit;
                    ASSERT_NEAR(answer.t, inside, 1e-10) << seed;
                    ASSERT_EQ(sides(face.get(), {answer.uv[0], answer.uv[1]})[0], 1) << seed;
                } else {
                    ASSERT_TRUE(std::isnan(answer.t) && std::isnan(answer.uv[0])) << seed;
                }
            }
        }
    });
    EXPECT_GE(certified, of_whole_run(count - count / 50));
    EXPECT_GE(hit, of_whole_run(count / 10));
    EXPECT_GE(beside, of_whole_run(count / 10)); // the surface is met before the face, or beside it
}

// Rays at places that are known to be inside are never certified to miss, nor to hit something behind them.
TEST(FaceRays, do_not_miss_places_inside) {
    int64_t cast_at = 0, certified = 0;
    for_each_case(2910000, 300, [&](Random &random, uint64_t seed) {
        for (const Ground &ground : grounds(random)) {
            const Handle loop = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{loop.get()}});
            for (int i = 0; i < 20; ++i) {
                const Place at = ground.at(random.unit(), random.unit());
                if (sides(face.get(), {at[0], at[1]})[0] != 1) {
                    continue;
                }
                const Vec x = eval(ground.surface.get(), {at[0], at[1]});
                const Point from = random_point(random, 3 * size_of(ground.surface.get()));
                const Answer answer =
                    cast(face.get(), from, {x[0] - from[0], x[1] - from[1], x[2] - from[2]});
                ++cast_at;
                certified += answer.certified() ? 1 : 0;
                ASSERT_TRUE(!answer.certified() || (answer.hit() && answer.t <= 1 + 1e-10)) << seed;
            }
        }
    });
    EXPECT_GE(certified, of_whole_run(cast_at - cast_at / 50));
    EXPECT_GE(cast_at, of_whole_run(2000));
}

// Whole surfaces of all forms of knots and weights as faces and as models: places that are known to be there are not missed,
// and what is certified of a face is so of its surface.
TEST(FaceRays, of_whole_surfaces_are_those_of_the_surface) {
    int64_t certified = 0, hit = 0, count = 0;
    for_each_case(2950000, 300, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 4);
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        nurbs_face *made = nullptr;
        if (nurbs_face_create(g.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &made) !=
            NURBS_OK) {
            return;
        }
        const Face face(made);
        nurbs_model *of_one = nullptr;
        require_ok(nurbs_model_create(1, &made, 1, &of_one));
        const std::unique_ptr<nurbs_model, decltype(&nurbs_model_destroy)> model(of_one, nurbs_model_destroy);
        const double size = size_of(g.get());
        for (int i = 0; i < 10; ++i) {
            const Vec x = eval(g.get(), {random.between(data.lower(0), data.upper(0)),
                                         random.between(data.lower(1), data.upper(1))});
            const Point from = random_point(random, 3 * size),
                        along{x[0] - from[0], x[1] - from[1], x[2] - from[2]};
            Answer of_surface, of_model;
            require_ok(nurbs_surface_rays(g.get(), 1, from.data(), 0, 0, along.data(), 0, 0, of_surface.uv,
                                          &of_surface.t, &of_surface.status));
            require_ok(nurbs_model_rays(of_one, 1, from.data(), along.data(), of_model.uv, &of_model.t,
                                        &of_model.status, nullptr));
            ++count;
            for (const Answer &answer : {cast(made, from, along), of_model}) {
                if (!answer.certified()) {
                    continue;
                }
                ++certified;
                ASSERT_TRUE(answer.hit() && answer.t <= 1 + 1e-10) << where(seed, data);
                ASSERT_TRUE(!of_surface.certified() || answer.t == of_surface.t) << where(seed, data);
                hit += answer.hit() ? 1 : 0;
            }
        }
    });
    std::cout << "certified " << certified << " of " << 2 * count << '\n';
    EXPECT_GE(certified, of_whole_run(count));
}

// At places of the loop itself, and beside it by less and less: inside or not, nothing that is false is certified.
TEST(FaceRays, at_the_loop_are_touches) {
    const Ground ground = plane();
    const Handle loop = polygon({{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}});
    const Face face = face_of(ground.surface.get(), {{loop.get()}});
    for (double away = 0.0625; away > 1e-20; away /= 2) {
        for (const double side : {-1.0, 0.0, 1.0}) {
            const double u = 0.25 + side * away;
            const Answer answer = cast(face.get(), {u, 0.5, 1}, {0, 0, -1});
            if (answer.certified()) {
                ASSERT_EQ(answer.hit(), u > 0.25) << away << ' ' << side;
                ASSERT_NE(u, 0.25);
            } else {
                ASSERT_EQ(answer.status, NURBS_RAY_TOUCH) << away << ' ' << side;
                ASSERT_LE(std::abs(u - 0.25), 1e-12);
            }
        }
    }
    EXPECT_EQ(cast(face.get(), {0.25, 0.25, 1}, {0, 0, -1}).status, NURBS_RAY_TOUCH);
}

// On closed axes loops run over seams, and around.
TEST(FaceRays, find_faces_across_the_seam) {
    const Ground ground = cylinder(1, 2);
    const double turn = ground.period[0];
    const Handle patch = polygon({{ground.lower[0] + 0.9 * turn, ground.lower[1] + 0.25 * ground.period[1]},
                                  {ground.lower[0] + 1.1 * turn, ground.lower[1] + 0.25 * ground.period[1]},
                                  {ground.lower[0] + 1.1 * turn, ground.lower[1] + 0.75 * ground.period[1]},
                                  {ground.lower[0] + 0.9 * turn, ground.lower[1] + 0.75 * ground.period[1]}});
    const Face face = face_of(ground.surface.get(), {{patch.get()}});
    for (const double y : {-0.3, -1e-3, -1e-12, 1e-12, 1e-3, 0.3}) {
        const Answer towards = cast(face.get(), {3, y, 1}, {-1, 0, 0}),
                     away = cast(face.get(), {-3, y, 1}, {1, 0, 0});
        EXPECT_EQ(towards.status, NURBS_RAY_HIT | NURBS_RAY_CERTIFIED) << y;
        EXPECT_NEAR(towards.t, 3 - std::sqrt(1 - y * y), 1e-12);
        EXPECT_EQ(away.status, NURBS_RAY_HIT | NURBS_RAY_CERTIFIED | NURBS_RAY_BACK) << y;
        EXPECT_NEAR(away.t, 3 + std::sqrt(1 - y * y), 1e-12);
        EXPECT_EQ(cast(face.get(), {3, y, 1.6}, {-1, 0, 0}).status, NURBS_RAY_CERTIFIED) << y;
    }
}

} // namespace face_rays_test
