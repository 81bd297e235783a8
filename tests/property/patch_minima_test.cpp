// All minima of the distance on surfaces: against the critical points, and those at edges and corners.
#include "property/critical_points.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace patch_minima_test {

using namespace support;

namespace {

// A net over the unit square with hills, of 1 to 3 spans along each axis; without creases, or with one at
// each knot.
SplineData hills(Random &random, bool weighted, bool creases = false) {
    SplineData data{{random.whole(1, 4), random.whole(1, 4)}, {}, {}, 3, {}, {}, 0};
    for (const int32_t p : data.degrees) {
        const int spans = p == 1 && !creases ? 1 : random.whole(1, 3);
        std::vector<double> knots(static_cast<size_t>(p) + 1, 0.0);
        for (int i = 1; i < spans; ++i) {
            knots.insert(knots.end(), creases ? static_cast<size_t>(p) : 1U, i);
        }
        knots.insert(knots.end(), static_cast<size_t>(p) + 1, spans);
        data.counts.push_back(static_cast<int64_t>(knots.size()) - p - 1);
        data.knots.push_back(knots);
    }
    for (int64_t i = 0; i < data.counts[0]; ++i) {
        for (int64_t j = 0; j < data.counts[1]; ++j) {
            data.points.insert(data.points.end(),
                               {static_cast<double>(i) / static_cast<double>(data.counts[0] - 1),
                                static_cast<double>(j) / static_cast<double>(data.counts[1] - 1),
                                random.between(-1, 1)});
            if (weighted) {
                data.weights.push_back(random.between(0.5, 2));
            }
        }
    }
    return data;
}

// A point of the list, or none.
bool holds(const Critical &found, const double *at) {
    for (size_t i = 0; i < found.distances.size(); ++i) {
        if (std::hypot(found.params[2 * i] - at[0], found.params[2 * i + 1] - at[1]) < 1e-5) {
            return true;
        }
    }
    return false;
}

struct Counts {
    int asked = 0, certified = 0, several = 0, false_minima = 0, missed = 0;
};

// Against nurbs_critical_points(), which finds all minima but those on creases.
void compare(const nurbs *g, const std::vector<double> &x, double tolerance, Counts &counts) {
    double params[128], distances[64];
    int32_t kinds[64], status = 0;
    int64_t count = 0;
    require_ok(
        nurbs_critical_points(g, x.data(), nullptr, 0, 0, 0, nullptr, nullptr, nullptr, &count, &status));
    if (status != NURBS_CLOSEST_CERTIFIED || count > 64) {
        return;
    }
    require_ok(
        nurbs_critical_points(g, x.data(), nullptr, 0, 0, count, params, distances, kinds, &count, nullptr));
    const Critical found = all_nearest(g, x, tolerance);
    const double least = *std::min_element(distances, distances + count);
    size_t expected = 0;
    bool missed = false;
    for (int64_t i = 0; i < count; ++i) {
        if (kinds[i] == NURBS_CRITICAL_MINIMUM && distances[i] <= least + tolerance) {
            ++expected;
            missed = missed || !holds(found, params + 2 * i);
        }
    }
    ++counts.asked;
    counts.several += expected > 1 ? 1 : 0;
    const bool is_certified = (found.status & NURBS_CLOSEST_CERTIFIED) != 0;
    counts.certified += is_certified ? 1 : 0;
    counts.missed += missed && is_certified ? 1 : 0;
    counts.false_minima += found.distances.size() > expected ? 1 : 0;
}

TEST(PatchMinima, those_that_are_isolated_are_certified) {
    Counts counts;
    for (uint64_t seed = 2500000; seed < 2500200; ++seed) {
        Random random(seed);
        const SplineData data = hills(random, random.chance(40));
        const Handle g = create(data);
        const std::vector<double> x{random.between(-1, 2), random.between(-1, 2), random.between(-3, 3)};
        for (const double tolerance : {0.0, 1e-6, 1e-2, 0.3, 3.0}) {
            compare(g.get(), x, tolerance, counts);
        }
    }
    std::printf("%d of %d certified, %d with several, %d with false ones, %d missed\n", counts.certified,
                counts.asked, counts.several, counts.false_minima, counts.missed);
    EXPECT_GT(counts.several, 100);
    EXPECT_EQ(counts.missed, 0);
    EXPECT_EQ(counts.false_minima, 0);
    EXPECT_GE(counts.certified, counts.asked * 99 / 100);
}

// Certified lists of a surface of degrees p and q, its control points as u, v, z in rows.
Critical bezier_minima(int32_t p, int32_t q, int dim, std::vector<double> points,
                       const std::vector<double> &x, double tolerance) {
    SplineData data{{p, q}, {p + 1, q + 1}, {}, dim, std::move(points), {}, 0};
    for (const int32_t degree : data.degrees) {
        std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
        knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1);
        data.knots.push_back(knots);
    }
    return all_nearest(create(data).get(), x, tolerance);
}

bool is_certified(const Critical &found) {
    return (found.status & NURBS_CLOSEST_CERTIFIED) != 0;
}

// Tangents that vanish: minima there are found, or nothing is certified.
TEST(PatchMinima, on_a_ridge_of_cusps) {
    const double y[] = {2, -2.0 / 3, -2.0 / 3, 2, 2, 0, -1.3}, z[] = {-1, 1, -1, 1, 2, 2, 0.4};
    SplineData data{{1, 3}, {2, 7}, {{0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}}, 3, {}, {}, 0};
    for (const double u : {0.0, 1.0}) {
        for (size_t j = 0; j < 7; ++j) {
            data.points.insert(data.points.end(), {u, y[j], z[j]});
        }
    }
    const double ridge[] = {0.5, 0.5};
    const Critical found = all_nearest(create(data).get(), {0.5, -1, 0}, 1);
    EXPECT_TRUE(holds(found, ridge) || !is_certified(found));
}

TEST(PatchMinima, at_a_corner_without_a_tangent) {
    const double corner[] = {0, 1};
    const Critical found = bezier_minima(
        1, 3, 3, {0, 1, 0, 0, 3, 0, 0, -1.2, 0, 0, -1.2, 0, 1, 1, 0, 1, 3, 0, 1, -1.2, 0, 1, -1.2, 0},
        {-1, 0, 0}, 1);
    EXPECT_TRUE(holds(found, corner) || !is_certified(found));
}

// Edges from which the distance falls at second order are no minima.
TEST(PatchMinima, edges_that_second_derivatives_deny) {
    const double saddle[] = {0, 0.5}, slanted[] = {0, 0.71307};
    const Critical doubled = bezier_minima(2, 1, 2, {-1, 0, 1, 0, -1, 0, 1, 0, -1, 0.5, 1, 0.5}, {0, 1}, 1);
    EXPECT_TRUE(!holds(doubled, saddle) || !is_certified(doubled));
    const Critical parallel = bezier_minima(
        2, 2, 2, {-1.5, -0.5, 0.5, -0.5, -0.5, 1, 0, -0.5, 1, -0.5, 0.5, -0.5, -1, -0.5, 0, 0, 0, 1},
        {-0.07386155612787562, 0.23327272582169248}, 10);
    EXPECT_TRUE(!holds(parallel, slanted) || !is_certified(parallel));
}

// A pole with a narrow way down is no minimum.
TEST(PatchMinima, poles_between_samples) {
    std::vector<double> points(3 * 26, 0.0);
    for (int i = 0; i <= 25; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / 25;
        points.insert(points.end(), {std::cos(angle), std::sin(angle), i == 14 ? -6.0 : 1.0});
    }
    EXPECT_FALSE(is_certified(bezier_minima(1, 25, 3, points, {0, 0, -1}, 5)));
}

double distance_at(const nurbs *g, double u, double v, const std::vector<double> &x) {
    const std::vector<double> p = eval(g, {u, v});
    return std::hypot(p[0] - x[0], p[1] - x[1], p[2] - x[2]);
}

// The lowest of a grid around a place, by steps that shrink.
double descend(const nurbs *g, const SplineData &data, const std::vector<double> &x, double *at,
               double step) {
    double best = distance_at(g, at[0], at[1], x);
    while (step > 1e-9) {
        double next[] = {at[0], at[1]};
        for (int i = 0; i < 16; ++i) {
            const double angle = i * 0.39269908169872414;
            const double u = std::clamp(at[0] + step * std::cos(angle), data.lower(0), data.upper(0)),
                         v = std::clamp(at[1] + step * std::sin(angle), data.lower(1), data.upper(1));
            const double d = distance_at(g, u, v, x);
            if (d < best) {
                best = d;
                next[0] = u;
                next[1] = v;
            }
        }
        const bool moved = next[0] != at[0] || next[1] != at[1];
        at[0] = next[0];
        at[1] = next[1];
        step *= moved ? 1 : 0.5;
    }
    return best;
}

// Critical on creases too: wherever a descent without derivatives ends that counts, and no others.
TEST(PatchMinima, those_on_creases_are_where_descents_end) {
    int certified = 0, asked = 0, ended = 0;
    for (uint64_t seed = 2510000; seed < 2510040; ++seed) {
        Random random(seed);
        const SplineData data = hills(random, random.chance(40), true);
        const Handle g = create(data);
        const std::vector<double> x{random.between(-1, 2), random.between(-1, 2), random.between(-3, 3)};
        const double tolerance = random.magnitude(1e-2, 3);
        const Critical found = all_nearest(g.get(), x, tolerance);
        ++asked;
        if ((found.status & NURBS_CLOSEST_CERTIFIED) == 0) {
            continue;
        }
        ++certified;
        const double least = *std::min_element(found.distances.begin(), found.distances.end());
        for (size_t i = 0; i < found.distances.size(); ++i) {
            double at[] = {found.params[2 * i], found.params[2 * i + 1]};
            EXPECT_GE(descend(g.get(), data, x, at, 1e-4), found.distances[i] - 1e-12) << "seed " << seed;
        }
        for (int i = 0; i < 12; ++i) {
            double at[] = {random.between(data.lower(0), data.upper(0)),
                           random.between(data.lower(1), data.upper(1))};
            const double d = descend(g.get(), data, x, at, 0.02);
            const auto same = [&](double other) { return std::fabs(other - d) < 1e-5; };
            if (d < least + tolerance - 1e-5) {
                ++ended;
                EXPECT_TRUE(std::any_of(found.distances.begin(), found.distances.end(), same))
                    << "seed " << seed << ", " << at[0] << " " << at[1] << ", distance " << d;
            }
        }
    }
    std::printf("%d of %d certified, %d descents\n", certified, asked, ended);
    EXPECT_GE(ended, 100);
    EXPECT_EQ(certified, asked);
}

} // namespace

} // namespace patch_minima_test
