// SPDX-License-Identifier: MIT
// Delaunay triangulations of points in all positions.
#include "base/watch.h"
#include "delaunay_checks.h"

#include <array>
#include <cmath>

namespace delaunay_test {

namespace {

// All circles of triangles against all points.
bool all_circles_empty(const Triangulation &t) {
    for (TriangleId id = 0; id < t.size(); ++id) {
        for (const GridPoint &p : t.vertices()) {
            if (!t.ghost(id) && power(corner(t, id, 0), corner(t, id, 1), corner(t, id, 2), p) > 0) {
                return false;
            }
        }
    }
    return true;
}

void expect_points_found(const Triangulation &t, const Points &points) {
    for (size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(t.vertices()[static_cast<size_t>(t.vertex_of(i))], points[i]);
    }
}

TEST(Delaunay, random_and_degenerate_points_have_empty_circles) {
    std::mt19937_64 random(seed);
    for (int kind = 0; kind < 4; ++kind) {
        for (size_t count = 0; count < 60; ++count) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " kind " + std::to_string(kind) + " points " +
                         std::to_string(count));
            const Points points = awkward_points(random, count, kind);
            const Triangulation t(points);
            expect_points_found(t, points);
            if (t.size() > 0) {
                EXPECT_EQ(fault_of(t), "");
                EXPECT_TRUE(all_circles_empty(t));
            } else {
                EXPECT_TRUE(doubled_hull_area(points) == 0);
            }
        }
    }
}

// As power() of delaunay_checks.h has it, with squares in a metric.
using Wider = boost::multiprecision::int256_t;
Wider power_in(const GridMetric &metric, const GridPoint &a, const GridPoint &b, const GridPoint &c,
               const GridPoint &d) {
    const auto square = [&](const GridPoint &p) {
        return Wider{metric.uu} * p.u * p.u + Wider{metric.vv} * p.v * p.v;
    };
    return square(a) * Wider{doubled_area(b, c, d)} - square(b) * Wider{doubled_area(a, c, d)} +
           square(c) * Wider{doubled_area(a, b, d)} - square(d) * Wider{doubled_area(a, b, c)};
}

constexpr std::array<GridMetric, 5> metrics{
    {{1, 1}, {GridMetric::most, 1}, {1, GridMetric::most}, {GridMetric::most, 12345}, {3, 2}}};

TEST(Delaunay, ellipses_of_a_metric_are_exact) {
    std::mt19937_64 random(seed);
    for (const GridMetric &metric : metrics) {
        for (int i = 0; i < 2000; ++i) {
            const int32_t size = i % 3 == 0 ? 4 : i % 3 == 1 ? 1000 : grid_end;
            const auto any = [&] {
                const auto coordinate = [&] { return static_cast<int32_t>(random() % (uint64_t(size) + 1)); };
                return GridPoint{coordinate(), coordinate()};
            };
            GridPoint a = any(), b = any(), c = any();
            const GridPoint p = i % 5 == 0 ? GridPoint{b.u, a.v} : any();
            if (doubled_area(a, b, c) < 0) {
                std::swap(b, c);
            }
            if (doubled_area(a, b, c) != 0) {
                ASSERT_EQ(in_circle(metric, a, b, c, p), power_in(metric, a, b, c, p) > 0) << i;
            }
        }
    }
}

TEST(Delaunay, in_a_metric_ellipses_are_empty) {
    std::mt19937_64 random(seed);
    for (const GridMetric &metric : metrics) {
        for (int kind = 0; kind < 4; ++kind) {
            const Points points = awkward_points(random, 40, kind);
            const Triangulation t(points, metric);
            expect_points_found(t, points);
            for (TriangleId id = 0; id < t.size(); ++id) {
                for (const GridPoint &p : t.vertices()) {
                    ASSERT_FALSE(!t.ghost(id) && power_in(metric, corner(t, id, 0), corner(t, id, 1),
                                                          corner(t, id, 2), p) > 0)
                        << kind;
                }
            }
        }
    }
}

TEST(Delaunay, points_on_a_line_have_no_triangles) {
    for (const int32_t slope : {0, 1, 2}) {
        Points points;
        for (int32_t i = 0; i < 1000; ++i) {
            points.push_back({i * 3, i * slope});
        }
        EXPECT_EQ(Triangulation(points).size(), 0);
        points.push_back({0, 1});
        const Triangulation t(points);
        EXPECT_EQ(fault_of(t), "");
        EXPECT_GT(t.size(), 0);
    }
}

TEST(Delaunay, equal_points_are_one_vertex) {
    const GridPoint a = {5, 5}, b = {grid_end, 0}, c = {7, grid_end};
    EXPECT_EQ(Triangulation(Points{a, a, a}).vertices().size(), 1U);
    const Triangulation t(Points{a, b, a, c, b, c, c});
    EXPECT_EQ(t.vertices().size(), 3U);
    EXPECT_EQ(t.vertex_of(0), t.vertex_of(2));
    EXPECT_EQ(t.vertex_of(3), t.vertex_of(6));
    EXPECT_EQ(t.size(), 4); // three ghosts
}

// Exactly on a circle: the integers with u^2 + v^2 = (5 * 13 * 17 * 29)^2, enlarged to the whole grid.
TEST(Delaunay, points_on_one_circle_are_triangulated) {
    const int64_t radius = 5 * 13 * 17 * 29, scale = (grid_end / 2) / radius;
    Points points;
    for (int64_t u = -radius; u <= radius; ++u) {
        const auto v =
            static_cast<int64_t>(std::llround(std::sqrt(static_cast<double>(radius * radius - u * u))));
        if (u * u + v * v == radius * radius) {
            for (const int64_t sign : {-1, 1}) {
                points.push_back({static_cast<int32_t>((u + radius) * scale),
                                  static_cast<int32_t>((sign * v + radius) * scale)});
            }
        }
    }
    ASSERT_GT(points.size(), 300U);
    const Triangulation t(points);
    EXPECT_EQ(fault_of(t), "");
    EXPECT_TRUE(all_circles_empty(t));
    for (TriangleId id = 0; id < t.size(); ++id) {
        EXPECT_FALSE(t.inside(id));
    }
}

// Sets of which points in the order of a curve, or of their coordinates, take quadratic time.
std::vector<std::pair<const char *, Points>> large_sets(int32_t n) {
    std::mt19937_64 random(seed);
    std::vector<std::pair<const char *, Points>> sets = {
        {"random", random_points(random, static_cast<size_t>(n), grid_end)}};
    const int32_t step = grid_end / n, side = static_cast<int32_t>(std::sqrt(n));
    Points lattice, circle, parabola, lines, corner;
    for (int32_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n, x = static_cast<double>(i) / n;
        lattice.push_back({i / side * 1000, i % side * 1000});
        circle.push_back({static_cast<int32_t>(5e8 + 5e8 * std::cos(angle)),
                          static_cast<int32_t>(5e8 + 5e8 * std::sin(angle))});
        parabola.push_back({i * step, static_cast<int32_t>(x * x * grid_end)});
        lines.push_back({i * step, i % 2 * grid_end});
        corner.push_back(i % 2 == 0 ? GridPoint{i * step, 0} : GridPoint{0, i * step});
    }
    circle.push_back({grid_end / 2, grid_end / 2});
    sets.insert(sets.end(), {{"lattice", lattice},
                             {"circle", circle},
                             {"parabola", parabola},
                             {"lines", lines},
                             {"corner", corner}});
    return sets;
}

// By work instead of time.
TEST(Delaunay, no_set_takes_more_than_linear_work) {
    for (const auto &[name, points] : large_sets(100000)) {
        SCOPED_TRACE(name);
        const nrb::Watch watch({.work = 1000 * static_cast<int64_t>(points.size())});
        const Triangulation t(points);
        EXPECT_EQ(fault_of(t), "");
    }
}

TEST(Delaunay, can_be_cancelled) {
    std::mt19937_64 random(seed);
    const Points points = random_points(random, 100000, grid_end);
    const auto cancel = [](double, void *) { return int32_t{1}; };
    const nrb::Watch watch({.progress = cancel});
    EXPECT_THROW(Triangulation{points}, nrb::CallEnded);
}

} // namespace

} // namespace delaunay_test
