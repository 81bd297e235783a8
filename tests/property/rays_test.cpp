// Rays and surfaces: no certified answer misses a place that is known to be there.
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace rays_test {

using namespace support;

namespace {

using Vec = std::vector<double>;
using Point = std::array<double, 3>;

struct Answer {
    double uv[2], t;
    int32_t status;
    [[nodiscard]] bool hit() const { return (status & NURBS_RAY_HIT) != 0; }
    [[nodiscard]] bool certified() const { return (status & NURBS_RAY_CERTIFIED) != 0; }
};

Answer cast(const nurbs *g, const Point &from, const Point &along) {
    Answer answer{};
    require_ok(nurbs_surface_rays(g, 1, from.data(), 0, 0, along.data(), 0, 0, answer.uv, &answer.t,
                                  &answer.status));
    return answer;
}

struct Hits {
    Vec uv, t;
    std::vector<int32_t> kinds;
    int32_t complete = -1;
};
Hits all(const nurbs *g, const Point &from, const Point &along, const double *range = nullptr) {
    Hits h;
    int64_t count = 0;
    require_ok(nurbs_surface_ray_hits(g, from.data(), along.data(), range, 0, nullptr, nullptr, nullptr,
                                      &count, &h.complete));
    h.uv.resize(static_cast<size_t>(2 * count));
    h.t.resize(static_cast<size_t>(count));
    h.kinds.resize(static_cast<size_t>(count));
    require_ok(nurbs_surface_ray_hits(g, from.data(), along.data(), range, count, h.uv.data(), h.t.data(),
                                      h.kinds.data(), &count, &h.complete));
    EXPECT_TRUE(std::is_sorted(h.t.begin(), h.t.end()));
    return h;
}

Point point_of(const nurbs *g, double u, double v) {
    const double uv[] = {u, v};
    Point x{};
    require_ok(nurbs_eval(g, 1, uv, 0, 0, x.data(), 0, 0, 0));
    return x;
}
double distance(const Point &x, const Point &y);
// How far the surface is from a point; where it jumps, from either side.
double gap_of(const nurbs *g, const double *uv, const Point &x) {
    double least = HUGE_VAL;
    for (uint32_t sides = 0; sides < 4; ++sides) {
        const uint32_t flags =
            (sides & 1U) * NURBS_ON_AXIS(0, NURBS_LEFT) + (sides >> 1) * NURBS_ON_AXIS(1, NURBS_LEFT);
        Point at{};
        require_ok(nurbs_eval(g, 1, uv, 0, 0, at.data(), 0, 0, flags));
        least = std::min(least, distance(at, x));
    }
    return least;
}
double distance(const Point &x, const Point &y) {
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}
Point on_ray(const Point &from, const Point &along, double t) {
    return {from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2]};
}
double size_of(const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::abs(x));
    }
    return size;
}

// What rounding a parameter moves a point by: weights of a ratio of 8 make it 8 times as fast at most.
double noise_of(const SplineData &data) {
    double share = 1e-11;
    for (size_t k = 0; k < 2; ++k) {
        double shortest = HUGE_VAL, largest = 0;
        const Vec &knots = data.knots[k];
        for (size_t i = 0; i + 1 < knots.size(); ++i) {
            shortest = knots[i + 1] > knots[i] ? std::min(shortest, knots[i + 1] - knots[i]) : shortest;
            largest = std::max(largest, std::abs(knots[i + 1]));
        }
        share += 32 * data.degrees[k] * std::numeric_limits<double>::epsilon() * largest / shortest;
    }
    return share * size_of(data);
}

// Where weights all but vanish, parameters have no digits for the place.
bool has_even_weights(const SplineData &data) {
    return data.weights.empty() ||
           std::ranges::all_of(data.weights, [](double w) { return w > 0.1 && w < 10; });
}

SplineData surface_in_space(Random &random, int most_degree) {
    Recipe recipe = random_recipe(random, 2, most_degree);
    recipe.dim = 3;
    for (int k = 0; k < 2; ++k) {
        recipe.axes[static_cast<size_t>(k)].degree = std::max(recipe.axes[static_cast<size_t>(k)].degree, 1);
    }
    return random_spline(random, recipe);
}

} // namespace

// Rays to places on random surfaces, in all forms of knots: what is certified is not behind them.
TEST(Rays, do_not_miss_places_they_are_cast_at) {
    int64_t certified = 0, count = 0;
    for_each_case(2800000, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = surface_in_space(random, 4);
        const Handle g = create(data);
        const double size = size_of(data);
        for (int i = 0; i < 10; ++i) {
            const Point at = point_of(g.get(), random.between(data.lower(0), data.upper(0)),
                                      random.between(data.lower(1), data.upper(1)));
            const Point from{size * random.between(-3, 3), size * random.between(-3, 3),
                             size * random.between(-3, 3)};
            const Point along{at[0] - from[0], at[1] - from[1], at[2] - from[2]};
            const Answer answer = cast(g.get(), from, along);
            ++count;
            if (!answer.certified()) {
                continue;
            }
            ++certified;
            ASSERT_TRUE(answer.hit()) << where(seed, data);
            ASSERT_LE(answer.t, 1 + 1e-10) << where(seed, data);
            if (!has_even_weights(data)) {
                continue;
            }
            ASSERT_LE(gap_of(g.get(), answer.uv, on_ray(from, along, answer.t)), noise_of(data))
                << where(seed, data);
        }
    });
    std::cout << "certified " << certified << " of " << count << '\n';
    EXPECT_GE(certified,
              of_whole_run(count - count / 10)); // some surfaces are curves, which no ray hits for certain
}

// The first of all is the nearest; hits with a limit are those below it.
TEST(Rays, all_hits_and_the_nearest_agree) {
    int64_t found = 0;
    for_each_case(2810000, 200, [&](Random &random, uint64_t seed) {
        const SplineData data = surface_in_space(random, 3);
        const Handle g = create(data);
        const double size = size_of(data);
        const Point from{size * random.between(-2, 2), size * random.between(-2, 2),
                         size * random.between(-2, 2)};
        const Point at =
            point_of(g.get(), (data.lower(0) + data.upper(0)) / 2, (data.lower(1) + data.upper(1)) / 2);
        const Point along{at[0] - from[0], at[1] - from[1], at[2] - from[2]};
        const Hits hits = all(g.get(), from, along);
        const Answer nearest = cast(g.get(), from, along);
        if (hits.complete != 1 || !nearest.certified()) {
            return;
        }
        ASSERT_EQ(nearest.hit(), !hits.t.empty()) << where(seed, data);
        if (hits.t.empty()) {
            return;
        }
        ASSERT_NEAR(nearest.t, hits.t[0], 1e-10 * (1 + std::abs(nearest.t))) << where(seed, data);
        for (size_t i = 0; i < hits.t.size() && has_even_weights(data); ++i) {
            ++found;
            ASSERT_LE(gap_of(g.get(), hits.uv.data() + 2 * i, on_ray(from, along, hits.t[i])), noise_of(data))
                << where(seed, data);
        }
        const double some[] = {0, hits.t[hits.t.size() / 2] + 1e-6};
        ASSERT_EQ(all(g.get(), from, along, some).t.size(),
                  static_cast<size_t>(
                      std::count_if(hits.t.begin(), hits.t.end(), [&](double t) { return t <= some[1]; })))
            << where(seed, data);
    });
    EXPECT_GE(found, of_whole_run(200));
}

// A sphere: both roots of its equation, or none; the normal says which side.
TEST(Rays, of_a_sphere_are_those_of_its_equation) {
    const double centre[] = {0.25, -0.5, 1}, radius = 1.5;
    nurbs *out = nullptr;
    require_ok(nurbs_surface_sphere(centre, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, &out));
    const Handle g(out);
    int64_t hits_of_all = 0;
    for_each_case(2820000, 500, [&](Random &random, uint64_t seed) {
        const Point from{random.between(-4, 4), random.between(-4, 4), random.between(-4, 4)},
            along{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        double a = 0, b = 0, c = -radius * radius;
        for (size_t k = 0; k < 3; ++k) {
            const double o = from[k] - centre[k];
            a += along[k] * along[k];
            b += o * along[k];
            c += o * o;
        }
        const double discriminant = b * b - a * c;
        if (std::abs(discriminant) < 1e-6 * a) {
            return;
        }
        const double line[] = {-HUGE_VAL, HUGE_VAL};
        const Hits hits = all(g.get(), from, along, line);
        ASSERT_EQ(hits.complete, 1) << seed;
        ASSERT_EQ(hits.t.size(), discriminant > 0 ? 2U : 0U) << seed;
        if (discriminant > 0) {
            hits_of_all += 2;
            ASSERT_NEAR(hits.t[0], (-b - std::sqrt(discriminant)) / a, 1e-9) << seed;
            ASSERT_NEAR(hits.t[1], (-b + std::sqrt(discriminant)) / a, 1e-9) << seed;
            ASSERT_NE(hits.kinds[0] & NURBS_RAY_BACK, hits.kinds[1] & NURBS_RAY_BACK) << seed;
        }
    });
    EXPECT_GE(hits_of_all, of_whole_run(100));
}

// Through corners and edges of pieces, where two or four of them meet: once.
TEST(Rays, through_edges_of_pieces_hit_once) {
    SplineData data{{2, 2}, {6, 6}, {{0, 0, 0, 1, 2, 3, 4, 4, 4}, {0, 0, 0, 1, 2, 3, 4, 4, 4}}, 3, {}, {}, 0};
    Random random(2830000);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            data.points.insert(data.points.end(), {i * 1.0, j * 1.0, random.between(-0.5, 0.5)});
        }
    }
    const Handle g = create(data);
    for (double u = 0; u <= 4; u += 0.5) {
        for (double v = 0; v <= 4; v += 0.5) {
            const Point at = point_of(g.get(), u, v), from{at[0], at[1], 8}, down{0, 0, -1};
            const Hits hits = all(g.get(), from, down);
            ASSERT_EQ(hits.t.size(), 1U) << u << ' ' << v;
            ASSERT_EQ(hits.complete, 1) << u << ' ' << v;
            ASSERT_NEAR(hits.t[0], 8 - at[2], 1e-12);
            ASSERT_NEAR(hits.uv[0], u, 1e-7);
            ASSERT_NEAR(hits.uv[1], v, 1e-7);
        }
    }
}

// Scales, far origins, long and short directions.
TEST(Rays, do_not_depend_on_units) {
    for (const double scale : {1e-150, 1e-6, 1.0, 1e6, 1e150}) {
        SplineData data{{1, 1},
                        {2, 2},
                        {{0, 0, 1, 1}, {0, 0, 1, 1}},
                        3,
                        {0, 0, 0, 0, scale, 0, scale, 0, 0, scale, scale, scale},
                        {},
                        0};
        const Handle g = create(data);
        const Point from{0.25 * scale, 0.5 * scale, 4 * scale};
        for (const double length : {1e-100, 1.0, 1e100}) {
            const Answer answer = cast(g.get(), from, {0, 0, -length});
            ASSERT_EQ(answer.status, NURBS_RAY_HIT | NURBS_RAY_CERTIFIED) << scale << ' ' << length;
            ASSERT_NEAR(answer.uv[0], 0.25, 1e-12);
            ASSERT_NEAR(answer.uv[1], 0.5, 1e-12);
            ASSERT_NEAR(answer.t * length / scale, 4 - 0.125, 1e-12);
        }
    }
}

// A surface that is level over [0, 1] of u, beyond which the weight falls below 0 in a corner: what is there is open, however
// many hits there are elsewhere. Through a piece that is a single point it is the same.
TEST(Rays, hits_do_not_hide_pieces_of_uncertain_weights) {
    const double knots[] = {0, 0, 1, 2, 2, 0, 0, 1, 1},
                 points[] = {0, 0, 0, 1, 0, 1, 0, 1, 1,      0,      0, 1,
                             1, 1, 0, 1, 2, 0, 0, 1, -2e-18, -1e-18, 0, -1e-18};
    const int32_t degrees[] = {1, 1}, none[] = {0, 0};
    const int64_t counts[] = {3, 2}, two[] = {2, 1};
    const Handle sheet = made([&](nurbs **out) {
        return nurbs_create_homogeneous(2, degrees, counts, knots, 9, 3, points, 0, 0, 0, out);
    });
    const Hits hits = all(sheet.get(), {0.25, 0.5, 1}, {0, 0, -1});
    EXPECT_EQ(hits.complete, 0);
    EXPECT_EQ(std::count(hits.kinds.begin(), hits.kinds.end(), NURBS_RAY_HIT), 1);
    EXPECT_EQ(std::count(hits.kinds.begin(), hits.kinds.end(), NURBS_RAY_TOUCH), 1);
    const double places[] = {0, 0, 0, 1, 0, 0, 1e-20, -1e-20}, steps[] = {0, 1, 2, 0, 1};
    const Handle dots = made([&](nurbs **out) {
        return nurbs_create_homogeneous(2, none, two, steps, 5, 3, places, 0, 0, 0, out);
    });
    EXPECT_EQ(all(dots.get(), {5, 5, 1}, {0, 0, -1}).complete, 0);
    EXPECT_FALSE(cast(dots.get(), {5, 5, 1}, {0, 0, -1}).certified());
}

// Two sheets a few units of rounding apart are two hits, on a knot line and beside it.
TEST(Rays, through_sheets_that_all_but_touch) {
    for (const double gap : {1e-13, 1e-9, 1e-6}) {
        SplineData wedge{{1, 1}, {3, 3}, {{0, 0, 1, 2, 2}, {0, 0, 0.5, 1, 1}}, 3, {}, {}, 0};
        for (const double x : {0.0, 1.0, 0.0}) {
            for (const double y : {0.0, 0.5, 1.0}) {
                wedge.points.insert(wedge.points.end(), {x, y,
                                                         wedge.points.size() < 9 ? 0
                                                         : x == 1                ? gap / 2
                                                                                 : gap});
            }
        }
        const Handle g = create(wedge);
        for (const double y : {0.5, 0.3}) {
            const Hits hits = all(g.get(), {-1, y, 1.3e-3}, {1, 0, -1e-3});
            ASSERT_EQ(hits.t.size(), 2U) << gap << ' ' << y;
            EXPECT_NE(hits.kinds[0] & NURBS_RAY_BACK, hits.kinds[1] & NURBS_RAY_BACK);
        }
    }
}

// From so far away that the origin has few digits for the place: sides and numbers hold all the same.
TEST(Rays, from_far_away_meet_both_sides_of_a_sphere) {
    nurbs *out = nullptr;
    require_ok(nurbs_surface_sphere(nullptr, nullptr, nullptr, 2, NURBS_ARC_QUARTERS, &out));
    const Handle g(out);
    for (const double far : {1e3, 1e6, 1e9, 1e12}) {
        const Hits hits = all(g.get(), {0.3, 0.2, far}, {0, 0, -1});
        ASSERT_EQ(hits.t.size(), 2U) << far;
        EXPECT_EQ(hits.kinds[0], NURBS_RAY_HIT) << far;
        EXPECT_EQ(hits.kinds[1], NURBS_RAY_HIT | NURBS_RAY_BACK) << far;
    }
    const Hits tiny = all(g.get(), {0.3, 0.2, 5}, {0, 0, -5e-324}); // no t is a number
    EXPECT_EQ(tiny.complete, 0);
}

} // namespace rays_test
