// Where curves meet surfaces: as often as in exact arithmetic, as rays and planes do, and the same under maps.
#include "exact_roots.h"
#include "support/cases.h"
#include "surface_meets.h"

#include <gtest/gtest.h>

namespace curve_surface_test {

using namespace support;
using namespace surface_meets;

namespace {

double short_number(Random &random, double low, double high) {
    return std::ldexp(std::floor(std::ldexp(random.between(low, high), 16)), -16);
}

// The graph z = g(x, y) over [0, m] x [0, n] of these degrees, and a curve above that.
struct GraphCase {
    SplineData curve, graph;
};
GraphCase graph_case(Random &random) {
    const int m = random.whole(1, 3), n = random.whole(1, 3), degree = random.whole(1, 4);
    Vec graph, curve, weights;
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            graph.insert(graph.end(),
                         {static_cast<double>(i), static_cast<double>(j), short_number(random, -2, 2)});
        }
    }
    const bool rational = random.chance(40);
    for (int i = 0; i <= degree; ++i) {
        curve.insert(curve.end(), {short_number(random, 0.01, m - 0.01), short_number(random, 0.01, n - 0.01),
                                   short_number(random, -2, 2)});
        if (rational) {
            weights.push_back(short_number(random, 0.3, 3));
        }
    }
    return {bezier(3, curve, weights), patch(m, n, graph)};
}

Polynomial times(const Integer &factor, Polynomial a) {
    for (Integer &x : a) {
        x *= factor;
    }
    return a;
}
// a^times.
Polynomial power(const Polynomial &a, int times) {
    Polynomial result{1};
    for (int i = 0; i < times; ++i) {
        result = product(result, a);
    }
    return result;
}
// The scaled Bernstein functions of x / m, times (m w)^m, of a coordinate w x and the weight w.
std::vector<Polynomial> functions(const Polynomial &wx, const Polynomial &w, int m) {
    Polynomial rest = times(m, w);
    add(rest, wx, -1);
    std::vector<Polynomial> result;
    for (int i = 0; i <= m; ++i) {
        result.push_back(times(Integer(binomial(m, i)), product(power(wx, i), power(rest, m - i))));
    }
    return result;
}
Integer whole_power(int base, int times) {
    Integer result = 1;
    for (int i = 0; i < times; ++i) {
        result *= base;
    }
    return result;
}

// Scaled Bernstein coefficients of (z - g(x, y)) w^(m + n) m^m n^n along the curve, times a power of two.
Polynomial height(const GraphCase &given) {
    const std::vector<Polynomial> curve = piece(given.curve, 0, 1); // w x, w y, w z, w with a common factor
    const int m = given.graph.degrees[0], n = given.graph.degrees[1];
    const Polynomial &w = curve[3];
    const Integer scale = whole_power(m, m) * whole_power(n, n);
    Polynomial sum = times(scale << 60, product(curve[2], power(w, m + n - 1)));
    const std::vector<Polynomial> by_x = functions(curve[0], w, m), by_y = functions(curve[1], w, n);
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            const auto at = static_cast<size_t>(i * (n + 1) + j);
            const Rational z = reference::exact(std::ldexp(given.graph.points[3 * at + 2], 60));
            add(sum, product(by_x[static_cast<size_t>(i)], by_y[static_cast<size_t>(j)]), -numerator(z));
        }
    }
    return sum;
}

using Matrix = std::array<std::array<double, 4>, 3>;
SplineData mapped(SplineData data, const Matrix &map) {
    for (size_t i = 0; i < data.points.size(); i += 3) {
        const Vec x(data.points.begin() + static_cast<int64_t>(i),
                    data.points.begin() + static_cast<int64_t>(i) + 3);
        for (size_t c = 0; c < 3; ++c) {
            data.points[i + c] = map[c][0] * x[0] + map[c][1] * x[1] + map[c][2] * x[2] + map[c][3];
        }
    }
    return data;
}
// Of whole numbers, whose determinant is not 0.
Matrix random_map(Random &random) {
    Matrix map{};
    double determinant = 0;
    while (determinant == 0) {
        for (auto &row : map) {
            for (double &x : row) {
                x = random.whole(-5, 5);
            }
        }
        determinant = map[0][0] * (map[1][1] * map[2][2] - map[1][2] * map[2][1]) -
                      map[0][1] * (map[1][0] * map[2][2] - map[1][2] * map[2][0]) +
                      map[0][2] * (map[1][0] * map[2][1] - map[1][1] * map[2][0]);
    }
    return map;
}

Recipe in_space(Random &random, int axes, int most_degree) {
    Recipe recipe = random_recipe(random, axes, most_degree);
    recipe.dim = 3;
    for (AxisRecipe &axis : recipe.axes) {
        axis.degree = std::max(axis.degree, 1);
    }
    return recipe;
}

void move(SplineData &data, const Vec &by) {
    for (size_t i = 0; i < data.points.size(); ++i) {
        data.points[i] += by[i % 3];
    }
}

} // namespace

// Whole numbers map both, so that the surface is no graph any more; all numbers stay exact.
TEST(CurveSurface, meets_are_as_many_as_in_exact_arithmetic) {
    int64_t complete = 0, all = 0, found = 0;
    for_each_case(3000000, 400, [&](Random &random, uint64_t seed) {
        const GraphCase given = graph_case(random);
        const Matrix map = random_map(random);
        const SplineData first = mapped(given.curve, map), second = mapped(given.graph, map);
        const Handle curve = create(first), surface = create(second);
        ++all;
        const Hits hits = meets(curve, surface, 0);
        for (size_t i = 0; i < hits.size(); ++i) {
            ASSERT_LE(gap_of(curve.get(), hits.t[i], surface.get(), &hits.uv[2 * i]), 1e-11)
                << where(seed, first) << where(seed, second);
        }
        if (hits.complete != 1) {
            return;
        }
        ++complete;
        const ExactRoots wanted = exact_roots(height(given));
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING),
                  wanted.inside + (wanted.at_start ? 1 : 0) + (wanted.at_end ? 1 : 0))
            << where(seed, first) << where(seed, second);
        ASSERT_EQ(static_cast<size_t>(hits.count(NURBS_HIT_CROSSING)), hits.size());
        found += wanted.inside;
    });
    std::cout << "complete " << complete << " of " << all << ", " << found << " meets\n";
    EXPECT_GE(complete, of_whole_run(all - all / 50));
    EXPECT_GE(found, of_whole_run(100));
}

// Random splines in all forms of knots, with weights from 1e-6 to 1e6, moved to meet in a known place.
TEST(CurveSurface, known_meets_are_found) {
    int64_t complete = 0, all = 0;
    for_each_case(3010000, 300, [&](Random &random, uint64_t seed) {
        SplineData curve = random_spline(random, in_space(random, 1, 4));
        const SplineData surface = random_spline(random, in_space(random, 2, 3));
        const Handle s = create(surface), before = create(curve);
        const double uv[] = {random.between(surface.lower(0), surface.upper(0)),
                             random.between(surface.lower(1), surface.upper(1))},
                     t = random.between(curve.lower(0), curve.upper(0));
        const Vec from = point_of(before.get(), t), to = point_at(s.get(), uv);
        const double size = std::max(size_of(curve), size_of(surface)), tolerance = 1e-7 * size;
        move(curve, {to[0] - from[0], to[1] - from[1], to[2] - from[2]});
        const Handle c = create(curve);
        const Hits hits = meets(c.get(), s.get(), tolerance, 50000000);
        ++all;
        complete += hits.complete;
        bool holds = false;
        for (size_t i = 0; i < hits.size(); ++i) {
            const double lower = hits.ranges_curve[2 * i], upper = hits.ranges_curve[2 * i + 1];
            const double period = curve.upper(0) - curve.lower(0);
            holds = holds || (t >= lower && t <= upper) || (t + period >= lower && t + period <= upper) ||
                    distance(point_of(c.get(), hits.t[i]), to) <= 1e-3 * size + noise_of(curve);
            if (hits.kinds[i] != NURBS_HIT_UNDECIDED && has_even_weights(curve) &&
                has_even_weights(surface)) {
                ASSERT_LE(gap_of(c.get(), hits.t[i], s.get(), &hits.uv[2 * i]),
                          1.1 * tolerance + noise_of(curve) + noise_of(surface))
                    << where(seed, curve) << where(seed, surface);
            }
        }
        ASSERT_TRUE(holds) << t << where(seed, curve) << where(seed, surface);
    });
    std::cout << "complete " << complete << " of " << all << '\n';
    EXPECT_GE(complete, of_whole_run(all - all / 10));
}

// A line meets a surface where a ray along it does.
TEST(CurveSurface, lines_meet_surfaces_as_rays_do) {
    int64_t compared = 0, found = 0;
    for_each_case(3020000, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, in_space(random, 2, 4));
        const Handle s = create(data);
        const double size = size_of(data), lower[] = {data.lower(0), data.lower(1)},
                     upper[] = {data.upper(0), data.upper(1)};
        Vec ends[2];
        for (Vec &end : ends) {
            const double uv[] = {random.between(lower[0], upper[0]), random.between(lower[1], upper[1])};
            end = point_at(s.get(), uv);
            for (double &x : end) {
                x += size * random.between(-0.5, 0.5);
            }
        }
        const Vec along{ends[1][0] - ends[0][0], ends[1][1] - ends[0][1], ends[1][2] - ends[0][2]};
        const double range[] = {0, 1};
        int64_t rays = 0;
        int32_t complete = 0;
        require_ok(nurbs_surface_ray_hits(s.get(), ends[0].data(), along.data(), range, 0, nullptr, nullptr,
                                          nullptr, &rays, &complete));
        const Hits hits = meets(line(ends[0], ends[1]), s, 0);
        if (complete != 1 || hits.complete != 1) {
            return;
        }
        ++compared;
        found += rays;
        ASSERT_EQ(static_cast<int64_t>(hits.size()), rays) << where(seed, data);
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING), rays) << where(seed, data);
    });
    std::cout << compared << " lines, " << found << " meets\n";
    EXPECT_GE(compared, of_whole_run(150));
    EXPECT_GE(found, of_whole_run(50));
}

// A curve meets a parallelogram where it meets its plane, if it stays over it.
TEST(CurveSurface, planes_meet_curves_as_their_equations_do) {
    int64_t compared = 0, found = 0;
    for_each_case(3030000, 300, [&](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, in_space(random, 1, 6));
        const Handle c = create(data);
        const double size = size_of(data);
        // z = a x + b y + c over a square that the curve does not leave.
        const double a = random.between(-1, 1), b = random.between(-1, 1),
                     offset = size * random.between(-0.3, 0.3), far = 1.5 * size;
        const double origin[] = {-far, -far, offset - far * (a + b)}, u[] = {2 * far, 0, 2 * far * a},
                     v[] = {0, 2 * far, 2 * far * b}, plane[] = {a, b, -1, offset};
        const Handle s = made([&](nurbs **out) { return nurbs_surface_plane(3, origin, u, v, out); });
        int64_t roots = 0;
        int32_t complete = 0;
        std::vector<int32_t> kinds(1000);
        require_ok(
            nurbs_curve_level(c.get(), 1, plane, 0, 1000, nullptr, kinds.data(), nullptr, &roots, &complete));
        const Hits hits = meets(c, s, 0);
        if (complete != 1 || hits.complete != 1 || data.rational()) {
            return; // weights may be so uneven that the curve leaves the square
        }
        roots -= std::ranges::count(kinds, int32_t{NURBS_HIT_JUMP});
        ++compared;
        found += roots;
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING), roots) << where(seed, data);
    });
    std::cout << compared << " planes, " << found << " meets\n";
    EXPECT_GE(compared, of_whole_run(60));
    EXPECT_GE(found, of_whole_run(50));
}

// A curve made of one in the parameters lies on the surface, all along.
TEST(CurveSurface, curves_on_surfaces_are_one_overlap) {
    for_each_case(3040000, 60, [&](Random &random, uint64_t seed) {
        Recipe recipe = in_space(random, 2, 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis = {axis.degree, random.chance(50) ? KnotForm::clamped : KnotForm::unclamped,
                    Spacing::integers, Placement::origin, 3};
        }
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Handle s = create(data);
        for (size_t k = 0; k < 2; ++k) {
            for (const double t : data.knots[k]) {
                if (std::ranges::count(data.knots[k], t) > data.degrees[k] &&
                    t > data.lower(static_cast<int>(k)) && t < data.upper(static_cast<int>(k))) {
                    return; // a jump
                }
            }
        }
        Vec inner;
        const int32_t degree = random.whole(1, 3);
        for (int i = 0; i <= degree; ++i) {
            for (int k = 0; k < 2; ++k) {
                inner.push_back(random.between(data.lower(k), data.upper(k)));
            }
        }
        SplineData way{{degree}, {degree + 1}, {{}}, 2, inner, {}, 0};
        way.knots[0].assign(static_cast<size_t>(degree) + 1, 0.0);
        way.knots[0].insert(way.knots[0].end(), static_cast<size_t>(degree) + 1, 1.0);
        const Handle f = create(way),
                     c = made([&](nurbs **out) { return nurbs_compose(s.get(), f.get(), out); });
        const double tolerance = 1e-8 * size_of(data);
        const Hits hits = meets(c, s, tolerance);
        ASSERT_EQ(hits.complete, 1) << hex(inner) << where(seed, data);
        ASSERT_GE(hits.count(NURBS_HIT_OVERLAP), 1) << hex(inner) << where(seed, data);
        const auto at = static_cast<size_t>(std::ranges::find(hits.kinds, int32_t{NURBS_HIT_OVERLAP}) -
                                            hits.kinds.begin());
        ASSERT_EQ(hits.ranges_curve[2 * at], 0) << hex(inner) << where(seed, data);
        ASSERT_EQ(hits.ranges_curve[2 * at + 1], 1) << hex(inner) << where(seed, data);
        ASSERT_LE(gap_of(c.get(), hits.t[at], s.get(), &hits.uv[2 * at]), tolerance)
            << hex(inner) << where(seed, data);
    });
}

// There is something within a tolerance if, and only if, the smallest distance is no larger; where it is larger by 1/64 or
// less that may be left open.
TEST(CurveSurface, what_is_near_is_what_the_distance_says) {
    int64_t compared = 0, complete = 0;
    for_each_case(3090000, 80, [&](Random &random, uint64_t seed) {
        Recipe on_curve = in_space(random, 1, 3), on_surface = in_space(random, 2, 3);
        on_curve.weights = on_surface.weights = random.chance(50) ? Weights::none : Weights::moderate;
        SplineData curve = random_spline(random, on_curve);
        const SplineData surface = scaled(random_spline(random, on_surface), 1);
        curve = scaled(curve, 0.3 * size_of(surface) / size_of(curve));
        move(curve, {size_of(surface) * random.between(-1, 1), size_of(surface) * random.between(-1, 1),
                     size_of(surface) * random.between(0.5, 2)});
        const Handle c = create(curve), s = create(surface);
        double least = 0, most = 0;
        int32_t certified = 0;
        require_ok(nurbs_distance(c.get(), s.get(), 1e-6 * size_of(surface), 0, &least, &most, nullptr,
                                  nullptr, &certified));
        if ((certified & NURBS_CLOSEST_CERTIFIED) == 0 || least < 1e-3 * size_of(surface)) {
            return;
        }
        ++compared;
        const Hits none = meets(c.get(), s.get(), 0.97 * least), some = meets(c.get(), s.get(), 1.05 * most);
        complete += none.complete;
        ASSERT_EQ(none.size() == 0, none.complete == 1) << where(seed, curve) << where(seed, surface);
        ASSERT_GE(some.size(), 1U) << where(seed, curve) << where(seed, surface);
        ASSERT_EQ(some.count(NURBS_HIT_CROSSING), 0) << where(seed, curve) << where(seed, surface);
        ASSERT_EQ(some.count(NURBS_HIT_TANGENT), 0) << where(seed, curve) << where(seed, surface);
    });
    EXPECT_GE(compared, of_whole_run(50));
    EXPECT_GE(complete, of_whole_run(compared - compared / 10));
}

// Other axes, directions, knots, degrees and places: the same hits.
TEST(CurveSurface, meets_do_not_depend_on_how_shapes_are_given) {
    int64_t found = 0;
    for_each_case(3050000, 100, [&](Random &random, uint64_t seed) {
        const GraphCase given = graph_case(random);
        const Handle c = create(given.curve), s = create(given.graph);
        const double tolerance = 1e-9;
        const Hits hits = meets(c, s, tolerance);
        found += static_cast<int64_t>(hits.size());
        std::vector<int32_t> kinds = hits.kinds;
        const auto check = [&](const nurbs *curve, const nurbs *surface, bool turned, const char *what) {
            Hits other = meets(curve, surface, tolerance);
            if (turned) {
                std::ranges::reverse(other.kinds);
            }
            ASSERT_EQ(other.kinds, kinds) << what << where(seed, given.curve) << where(seed, given.graph);
            ASSERT_EQ(other.complete, hits.complete);
        };
        const int32_t exchanged[] = {1, 0};
        check(c.get(), made([&](nurbs **out) { return nurbs_transpose(s.get(), exchanged, out); }).get(),
              false, "transposed");
        check(c.get(), made([&](nurbs **out) { return nurbs_reverse(s.get(), 1, 0, out); }).get(), false,
              "surface reversed");
        check(made([&](nurbs **out) { return nurbs_reverse(c.get(), 0, 0, out); }).get(), s.get(), true,
              "curve reversed");
        check(elevate(c.get(), 0, 1).get(), elevate(s.get(), random.whole(0, 1), 1).get(), false, "elevated");
        const double at = hits.size() == 0 ? 0.5 : hits.t.front(),
                     u = hits.size() == 0 ? 0.25 : hits.uv.front();
        if (at > 0 && at < 1 && u > 0 && u < 1) { // knots where they meet, too
            check(insert(c.get(), 0, at, 1).get(), insert(s.get(), 0, u, 1).get(), false, "refined");
            check(insert(c.get(), 0, random.between(0.1, 0.9), 1).get(),
                  insert(s.get(), 1, random.between(0.1, 0.9), given.graph.degrees[1]).get(), false, "cut");
        }
        const Matrix map = random_map(random);
        check(create(mapped(given.curve, map)).get(), create(mapped(given.graph, map)).get(), false,
              "mapped");
    });
    EXPECT_GE(found, of_whole_run(50));
}

} // namespace curve_surface_test
