// Where two curves meet: as often as in exact arithmetic, the same under maps, and overlaps of parts.
#include "curve_meets.h"
#include "exact_roots.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace curve_intersections_test {

using namespace support;
using namespace curve_meets;

namespace {

// Numbers of few bits, so that maps of whole numbers are exact.
double short_number(Random &random, double low, double high) {
    return std::ldexp(std::floor(std::ldexp(random.between(low, high), 16)), -16);
}

// The graph y = g(x) over [0, m] of degree m, and a curve above [0, m], which meets the graph where y - g(x) = 0.
struct GraphCase {
    SplineData curve, graph;
};
GraphCase graph_case(Random &random) {
    const int m = random.whole(1, 6), n = random.whole(1, 6);
    Vec graph, curve, weights;
    for (int i = 0; i <= m; ++i) {
        graph.insert(graph.end(), {static_cast<double>(i), short_number(random, -2, 2)});
    }
    const bool rational = random.chance(40);
    for (int i = 0; i <= n; ++i) {
        curve.insert(curve.end(), {short_number(random, 0.01, m - 0.01), short_number(random, -2, 2)});
        if (rational) {
            weights.push_back(short_number(random, 0.3, 3));
        }
    }
    return {bezier(2, curve, weights), bezier(2, graph)};
}

// Scaled Bernstein coefficients of (y - g(x)) w^m along the curve: g in the Bernstein basis of x / m.
Polynomial height(const GraphCase &given) {
    const std::vector<Polynomial> curve = piece(given.curve, 0, 1); // w x, w y, w with a common factor
    const int m = given.graph.degrees[0];
    Polynomial rest = curve[2]; // m w - w x
    for (Integer &x : rest) {
        x *= m;
    }
    add(rest, curve[0], -1);
    const auto power = [](const Polynomial &of, int times) {
        Polynomial result{1};
        for (int i = 0; i < times; ++i) {
            result = product(result, of);
        }
        return result;
    };
    Integer scale = 1;
    for (int i = 0; i < m; ++i) {
        scale *= m;
    }
    Polynomial sum = product(curve[1], power(curve[2], m - 1));
    for (Integer &x : sum) {
        x *= scale << 60;
    }
    for (int i = 0; i <= m; ++i) {
        const reference::Rational y =
            reference::exact(std::ldexp(given.graph.points[2 * static_cast<size_t>(i) + 1], 60));
        add(sum, product(power(curve[0], i), power(rest, m - i)), -numerator(y) * Integer(binomial(m, i)));
    }
    return sum;
}

SplineData mapped(SplineData data, const std::array<double, 6> &map) {
    for (size_t i = 0; i < data.points.size(); i += 2) {
        const double x = data.points[i], y = data.points[i + 1];
        data.points[i] = map[0] * x + map[1] * y + map[2];
        data.points[i + 1] = map[3] * x + map[4] * y + map[5];
    }
    return data;
}

} // namespace

// Whole numbers map both curves, so that neither is a graph any more; all numbers stay exact.
TEST(CurveIntersections, are_as_many_as_in_exact_arithmetic) {
    int64_t complete = 0, all = 0, found = 0;
    for_each_case(2700000, 300, [&](Random &random, uint64_t seed) {
        const GraphCase given = graph_case(random);
        const std::array<double, 6> map{
            static_cast<double>(random.whole(1, 5)),  static_cast<double>(random.whole(-5, 5)),
            static_cast<double>(random.whole(-9, 9)), static_cast<double>(random.whole(6, 9)),
            static_cast<double>(random.whole(-5, 0)), static_cast<double>(random.whole(-9, 9))};
        const SplineData first = mapped(given.curve, map), second = mapped(given.graph, map);
        const Handle a = create(first), b = create(second);
        if (map[0] * map[4] == map[1] * map[3]) {
            return;
        }
        ++all;
        const Hits hits = meets(a.get(), b.get(), 0);
        for (size_t i = 0; i < hits.a.size(); ++i) {
            ASSERT_LE(gap_of(a.get(), hits.a[i], b.get(), hits.b[i]), 1e-12)
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
        found += wanted.inside;
    });
    std::cout << "complete " << complete << " of " << all << ", " << found << " meets\n";
    EXPECT_GE(complete, of_whole_run(all - all / 50));
    EXPECT_GE(found, of_whole_run(100));
}

// The arguments change places, one curve is turned around, both get more knots and a higher degree: the same hits.
TEST(CurveIntersections, do_not_depend_on_how_curves_are_given) {
    for_each_case(2710000, 150, [&](Random &random, uint64_t seed) {
        const GraphCase given = graph_case(random);
        const Handle a = create(given.curve), b = create(given.graph);
        const double tolerance = 1e-9;
        const Hits hits = meets(a.get(), b.get(), tolerance), other = meets(b.get(), a.get(), tolerance);
        ASSERT_EQ(hits.a.size(), other.a.size()) << where(seed, given.curve);
        nurbs *out = nullptr;
        require_ok(nurbs_reverse(a.get(), 0, 0, &out));
        const Handle turned(out);
        ASSERT_EQ(meets(turned.get(), b.get(), tolerance).a.size(), hits.a.size())
            << where(seed, given.curve);
        require_ok(nurbs_elevate(a.get(), 0, 1, &out));
        const Handle high(out);
        ASSERT_EQ(meets(high.get(), b.get(), tolerance).a.size(), hits.a.size()) << where(seed, given.curve);
        require_ok(nurbs_insert_knot(b.get(), 0, random.between(0.1, 0.9), 1, &out));
        const Handle fine(out);
        if (!hits.a.empty()) { // also where they meet
            require_ok(nurbs_insert_knot(
                a.get(), 0, hits.a.front() > 0 && hits.a.front() < 1 ? hits.a.front() : 0.5, 1, &out));
            const Handle cut(out);
            ASSERT_EQ(meets(cut.get(), fine.get(), tolerance).a.size(), hits.a.size())
                << where(seed, given.curve);
        }
    });
}

// Two graphs over the same knots meet where the scalar curve between them has roots, at angles down to 1e-8.
TEST(CurveIntersections, at_small_angles_are_as_many_as_roots) {
    int64_t found = 0;
    for_each_case(2760000, 100, [&](Random &random, uint64_t seed) {
        const int degree = random.whole(1, 5), count = degree + random.whole(1, 8);
        const double small = std::pow(10.0, -random.whole(1, 8));
        SplineData between{{degree}, {count}, {{}}, 1, {}, {}, 0}, low = between, high = between;
        Vec &knots = between.knots[0];
        for (int i = 0; i < count + degree + 1; ++i) {
            knots.push_back(std::min(std::max(i - degree, 0), count - degree));
        }
        low.knots = high.knots = between.knots;
        low.dim = high.dim = 2;
        for (int i = 0; i < count; ++i) {
            double x = 0;
            for (int j = 1; j <= degree; ++j) {
                x += knots[static_cast<size_t>(i + j)] / degree;
            }
            const double y = random.between(-1, 1), apart = random.between(-1, 1);
            between.points.push_back(apart);
            low.points.insert(low.points.end(), {x, y});
            high.points.insert(high.points.end(), {x, y + small * apart});
        }
        const Handle a = create(low), b = create(high), f = create(between);
        int64_t roots = 0;
        int32_t complete = 0;
        require_ok(nurbs_roots(f.get(), 0, 0, 0, nullptr, nullptr, nullptr, &roots, &complete));
        const Hits hits = meets(a, b, 0);
        if (complete != 1 || hits.complete != 1) {
            return;
        }
        found += roots;
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING), roots) << small << where(seed, low) << where(seed, high);
        ASSERT_EQ(static_cast<int64_t>(hits.size()), roots) << small << where(seed, low) << where(seed, high);
    });
    EXPECT_GE(found, of_whole_run(100));
}

// Parts of one curve overlap where both are, whichever way they run.
TEST(CurveIntersections, parts_of_one_curve_overlap) {
    for_each_case(2720000, 100, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 4);
        recipe.dim = random.whole(2, 3);
        recipe.axes[0].degree = std::max(recipe.axes[0].degree, 1);
        recipe.axes[0] = {recipe.axes[0].degree, KnotForm::clamped, Spacing::integers, Placement::origin, 3};
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        double size = 0;
        for (const double x : data.points) {
            size = std::max(size, std::abs(x));
        }
        const double lower = data.lower(0), upper = data.upper(0),
                     from = lower + (upper - lower) * random.between(0.2, 0.6);
        nurbs *left = nullptr, *right = nullptr, *out = nullptr;
        require_ok(nurbs_split(g.get(), 0, from, &left, &right));
        const Handle first(left), second(right);
        const bool turned = random.chance(50);
        if (turned) {
            require_ok(nurbs_reverse(right, 0, 0, &out));
        } else {
            require_ok(nurbs_clone(right, &out));
        }
        const Handle part(out);
        const Hits hits = meets(g.get(), part.get(), 1e-9 * size);
        ASSERT_EQ(hits.complete, 1) << where(seed, data);
        ASSERT_GE(hits.count(NURBS_HIT_OVERLAP), 1) << turned << where(seed, data);
        double start = upper, end = lower; // one overlap between jumps each
        for (size_t i = 0; i < hits.a.size(); ++i) {
            if (hits.kinds[i] == NURBS_HIT_OVERLAP) {
                start = std::min(start, hits.ranges_a[2 * i]);
                end = std::max(end, hits.ranges_a[2 * i + 1]);
                ASSERT_EQ(hits.ranges_b[2 * i] > hits.ranges_b[2 * i + 1], turned) << where(seed, data);
            }
        }
        ASSERT_NEAR(start, from, 1e-5 * (upper - lower)) << where(seed, data);
        ASSERT_EQ(end, upper) << where(seed, data);
    });
}

// Corners of whole numbers: signs of areas tell exactly which sides cross.
TEST(SelfIntersections, of_polygons_are_as_many_as_in_exact_arithmetic) {
    for_each_case(2730000, 200, [](Random &random, uint64_t seed) {
        const int corners = random.whole(4, 12);
        Vec points;
        for (int i = 0; i < 2 * corners; ++i) {
            points.push_back(random.whole(-500, 500));
        }
        const auto area = [&](int i, int j, int k) {
            const double *p = points.data() + 2 * i, *q = points.data() + 2 * j, *r = points.data() + 2 * k;
            const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
            return twice > 0 ? 1 : twice < 0 ? -1 : 0;
        };
        int64_t wanted = 0;
        for (int i = 0; i + 1 < corners; ++i) {
            for (int j = i + 2; j + 1 < corners; ++j) {
                const int first = area(i, i + 1, j) * area(i, i + 1, j + 1),
                          second = area(j, j + 1, i) * area(j, j + 1, i + 1);
                if (first == 0 || second == 0 || area(i, i + 1, i + 2) == 0) {
                    return; // a corner on a side
                }
                wanted += first < 0 && second < 0 ? 1 : 0;
            }
        }
        const SplineData data = polygon(points);
        const Handle g = create(data);
        const Hits hits = own_meets(g.get(), 0);
        ASSERT_EQ(hits.complete, 1) << where(seed, data);
        ASSERT_EQ(hits.count(NURBS_HIT_CROSSING), wanted) << where(seed, data);
        ASSERT_EQ(static_cast<int64_t>(hits.size()), wanted) << where(seed, data);
    });
}

// A curve meets itself where its parts do, and where one part meets the other.
TEST(SelfIntersections, are_those_of_two_parts_and_between_them) {
    int64_t found = 0;
    for_each_case(2740000, 100, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 5);
        recipe.dim = 2;
        recipe.axes[0] = {random.whole(2, 5), random.chance(50) ? KnotForm::clamped : KnotForm::periodic,
                          Spacing::integers, Placement::origin, random.whole(4, 12)};
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        const double lower = data.lower(0), upper = data.upper(0), at = lower + (upper - lower) * 0.4375;
        const Hits all = own_meets(g.get(), 0);
        nurbs *left = nullptr, *right = nullptr;
        require_ok(nurbs_split(g.get(), 0, at, &left, &right));
        const Handle first(left), second(right);
        const Hits parts[] = {own_meets(left, 0), own_meets(right, 0), meets(left, right, 0)};
        if (all.complete != 1 || parts[0].complete != 1 || parts[1].complete != 1 || parts[2].complete != 1) {
            return;
        }
        int64_t sum = parts[0].count(NURBS_HIT_CROSSING) + parts[1].count(NURBS_HIT_CROSSING);
        for (size_t i = 0; i < parts[2].size(); ++i) { // but for their ends, which are joined
            const bool joint = parts[2].ranges_a[2 * i + 1] >= at || parts[2].ranges_a[2 * i] <= lower;
            sum += !joint && parts[2].kinds[i] == NURBS_HIT_CROSSING ? 1 : 0;
        }
        ASSERT_EQ(all.count(NURBS_HIT_CROSSING), sum) << where(seed, data);
        found += sum;
        for (size_t i = 0; i < all.size(); ++i) {
            ASSERT_LT(all.a[i], all.b[i]);
            double size = 0;
            for (const double x : data.points) {
                size = std::max(size, std::abs(x));
            }
            ASSERT_LE(gap_of(g.get(), all.a[i], g.get(), all.b[i]), 1e-12 * size) << where(seed, data);
        }
    });
    EXPECT_GE(found, of_whole_run(100));
}

} // namespace curve_intersections_test
