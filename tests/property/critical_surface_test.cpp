// Critical points of the distance from surfaces: they add up as Morse says, and what rounding leaves open is
// not decided.
#include "property/critical_points.h"
#include "property/query_noise.h"
#include "property/same_shape.h"

#include <cmath>
#include <cstdio>
#include <map>

namespace critical_surface_test {

using namespace support;

namespace {

double best(const nurbs *g, const std::vector<double> &x, decltype(nurbs_closest_points) function) {
    double distance = 0;
    require_ok(function(g, 1, x.data(), 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, &distance, 0,
                        nullptr, 0));
    return distance;
}

// Where the distance has a maximum along an edge of the domain and so on, in the sense of Morse: the points
// at which it grows into the domain, minima less saddles plus maxima, are the Euler characteristic 1 of a
// disc.
int morse_sum(const nurbs *g, const SplineData &data, const std::vector<double> &x, const Critical &found) {
    int sum = 0;
    for (size_t i = 0; i < found.kinds.size(); ++i) {
        const std::vector<double> at{found.params[2 * i], found.params[2 * i + 1]};
        const std::vector<double> jet = eval_derivs(g, 1, at);
        int sides = 0;
        bool grows = true;
        for (int k = 0; k < 2; ++k) {
            const auto axis = static_cast<size_t>(k);
            double slope = 0;
            for (size_t c = 0; c < 3; ++c) {
                slope += (jet[c] - x[c]) * jet[3 * (axis + 1) + c];
            }
            const bool first = at[axis] == data.lower(k), last = at[axis] == data.upper(k);
            sides += first || last ? 1 : 0;
            grows = grows && (!(first || last) || (first ? slope > 0 : slope < 0));
            EXPECT_TRUE(first || last || std::fabs(slope) < 1e-7 * (1 + found.distances[i]));
        }
        if (grows) {
            const bool plus = found.kinds[i] == NURBS_CRITICAL_MINIMUM ||
                              (sides == 0 && found.kinds[i] == NURBS_CRITICAL_MAXIMUM);
            sum += plus ? 1 : -1;
        }
    }
    return sum;
}

TEST(CriticalSurface, points_add_up_to_the_characteristic_of_a_disc) {
    int certified = 0, all = 0;
    for_each_case(2180000, 60, [&](Random &random, uint64_t seed) {
        const int spans = random.whole(1, 3), n = spans + 3;
        SplineData data{{3, 3}, {n, n}, {}, 3, {}, {}, 0};
        for (int k = 0; k < 2; ++k) {
            std::vector<double> knots(4, 0.0);
            for (int i = 1; i < spans; ++i) {
                knots.push_back(i);
            }
            knots.insert(knots.end(), 4, spans);
            data.knots.push_back(knots);
        }
        const bool weighted = random.chance(50);
        for (int i = 0; i < n * n; ++i) {
            data.points.insert(data.points.end(), {i / n + random.between(-0.3, 0.3),
                                                   i % n + random.between(-0.3, 0.3), random.between(-1, 1)});
            if (weighted) {
                data.weights.push_back(random.between(0.5, 2));
            }
        }
        const Handle g = create(data);
        const std::vector<double> x{random.between(-1, n), random.between(-1, n), random.between(-3, 3)};
        const Critical found = critical(g.get(), x);
        ++all;
        if (found.status != NURBS_CLOSEST_CERTIFIED) {
            return;
        }
        ++certified;
        ASSERT_EQ(morse_sum(g.get(), data, x, found), 1) << where(seed, data) << hex(x);
        const auto [least, most] = std::minmax_element(found.distances.begin(), found.distances.end());
        ASSERT_NEAR(*least, best(g.get(), x, nurbs_closest_points), noise(data, x))
            << where(seed, data) << hex(x);
        ASSERT_NEAR(*most, best(g.get(), x, nurbs_farthest_points), noise(data, x))
            << where(seed, data) << hex(x);
    });
    std::printf("%d of %d certified\n", certified, all);
    EXPECT_GE(certified, all * 9 / 10);
}

// z = a u^2 + b v^2 for u and v from -1 to 1.
Handle paraboloid(double a, double b) {
    const std::vector<double> knots{-1, -1, -1, 1, 1, 1}, ends{1, -1, 1};
    SplineData data{{2, 2}, {3, 3}, {knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            data.points.insert(
                data.points.end(),
                {i - 1.0, j - 1.0, a * ends[static_cast<size_t>(i)] + b * ends[static_cast<size_t>(j)]});
        }
    }
    return create(data);
}

// (0, 0, 1/2) is a centre of curvature of a = 1: the square of the distance, u^4 + (1 - b) v^2 + ..., has a
// derivative that vanishes threefold. Above it and below it the kinds are plain.
TEST(CriticalSurface, a_centre_of_curvature_leaves_the_kind_open) {
    for (const double b : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        const Handle g = paraboloid(1, b);
        const Critical found = critical(g.get(), {0, 0, 0.5});
        int64_t near = 0;
        for (size_t i = 0; i < found.kinds.size(); ++i) {
            if (std::hypot(found.params[2 * i], found.params[2 * i + 1]) < 0.01) {
                EXPECT_EQ(found.kinds[i], NURBS_CRITICAL_UNDECIDED) << b;
                EXPECT_NEAR(found.distances[i], 0.5, 1e-12) << b;
                ++near;
            }
        }
        EXPECT_GT(near, 0) << b;
        EXPECT_EQ(found.status & NURBS_CLOSEST_CERTIFIED, 0) << b;
    }
    const auto kind_at_apex = [](double z) {
        const Critical found = critical(paraboloid(1, 0.5).get(), {0, 0, z});
        for (size_t i = 0; i < found.kinds.size(); ++i) {
            if (std::hypot(found.params[2 * i], found.params[2 * i + 1]) < 1e-6) {
                return found.kinds[i];
            }
        }
        return 0;
    };
    EXPECT_EQ(kind_at_apex(0.49), NURBS_CRITICAL_MINIMUM);
    EXPECT_EQ(kind_at_apex(0.51), NURBS_CRITICAL_SADDLE);
    EXPECT_EQ(kind_at_apex(1.01), NURBS_CRITICAL_MAXIMUM);
}

// A volume whose face at u = 0 is an edge, which all w share. Its ends are like corners where the distance
// changes alike along all w, and else nothing is said of them.
TEST(CriticalSurface, the_edge_of_a_wedge) {
    const std::vector<double> knots{0, 0, 1, 1};
    SplineData data{{1, 1, 1}, {2, 2, 2}, {knots, knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 8; ++i) {
        const double u = i >> 2, v = i >> 1 & 1, w = i & 1;
        data.points.insert(data.points.end(), {u, v, u * (w - 0.5)});
    }
    const Handle g = create(data);
    const auto kinds = [&](const std::vector<double> &x) {
        const Critical found = critical(g.get(), x);
        std::map<double, int32_t> by_square;
        for (size_t i = 0; i < found.kinds.size(); ++i) {
            by_square[std::round(found.distances[i] * found.distances[i] * 1e6)] = found.kinds[i];
        }
        return by_square;
    };
    constexpr int32_t least = NURBS_CRITICAL_MINIMUM, saddle = NURBS_CRITICAL_SADDLE,
                      most = NURBS_CRITICAL_MAXIMUM, open = NURBS_CRITICAL_UNDECIDED;
    using Kinds = std::map<double, int32_t>; // by squares of distances in millionths
    EXPECT_EQ(kinds({-1, -1, 0.125}), (Kinds{{2015625, least},
                                             {5015625, saddle},
                                             {5000000, saddle},
                                             {8390625, most},
                                             {8000000, saddle},
                                             {8140625, most}}));
    EXPECT_EQ(kinds({-0.1, -1, 5}),
              (Kinds{{26010000, open}, {29010000, open}, {22460000, least}, {35460000, most}}));
}

} // namespace

} // namespace critical_surface_test
