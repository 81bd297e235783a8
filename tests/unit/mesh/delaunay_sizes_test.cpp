// SPDX-License-Identifier: MIT
// Large triangulations, exactly: a hundredth of the size that they have where NURBS_TEST_SCALE is 100, a million points.
#include "base/watch.h"
#include "delaunay_checks.h"
#include "support/scale.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace delaunay_test {

namespace {

// Points that are exactly on circles about one centre: u^2 + v^2 = r^2 with many integer solutions.
Points rings(int64_t count) {
    constexpr int64_t unit = int64_t{5} * 13 * 17;
    Points points;
    for (int64_t ring = 1; std::ssize(points) < count; ++ring) {
        const int64_t radius = ring * unit;
        for (int64_t m = 1; m < 40; ++m) {
            for (int64_t n = 0; n < m; ++n) { // of triples with hypotenuse m^2 + n^2
                const int64_t c = m * m + n * n;
                if (radius % c != 0) {
                    continue;
                }
                const int64_t a = (m * m - n * n) * (radius / c), b = 2 * m * n * (radius / c);
                for (const auto &[u, v] :
                     {std::pair{a, b}, {b, a}, {-a, b}, {-b, a}, {a, -b}, {b, -a}, {-a, -b}, {-b, -a}}) {
                    points.push_back(
                        {static_cast<int32_t>(grid_end / 2 + u), static_cast<int32_t>(grid_end / 2 + v)});
                }
            }
        }
    }
    return points;
}

Points lattice(int64_t count) {
    const auto side = static_cast<int32_t>(std::sqrt(static_cast<double>(count)));
    Points points;
    for (int32_t i = 0; i < side * side; ++i) {
        points.push_back({i / side * 1000, i % side * 1000});
    }
    return points;
}

// With how long it took, for reading: machines and what else they do differ.
void expect_triangulated(const char *name, const Points &points) {
    SCOPED_TRACE(name);
    const nrb::Watch watch({.work = 1000 * std::ssize(points)});
    const auto start = std::chrono::steady_clock::now();
    const Triangulation t(points);
    const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
    std::printf("%s: %zu points, %.2f us each\n", name, points.size(),
                taken.count() / static_cast<double>(points.size()));
    EXPECT_EQ(fault_of(t), "");
}

// CDT#40: 84 s for a lattice. All squares of it are cocircular, and so are rings.
TEST(DelaunaySizes, a_million_points) {
    std::mt19937_64 random(seed);
    const int64_t n = support::scaled(10000);
    expect_triangulated("random", random_points(random, static_cast<size_t>(n), grid_end));
    expect_triangulated("lattice", lattice(n));
    expect_triangulated("rings", rings(n));
    // few places: most of them often
    expect_triangulated("dense",
                        random_points(random, static_cast<size_t>(n), static_cast<int32_t>(std::sqrt(n))));
}

// Lines of a lattice as constraints, each through the vertices of its line; every other one a border.
TEST(DelaunaySizes, constraints_through_a_million_vertices) {
    const int64_t n = support::scaled(10000);
    const auto side = static_cast<int32_t>(std::sqrt(static_cast<double>(n)));
    Triangulation t(lattice(n));
    std::vector<Segment> segments;
    for (int32_t i = 0; i < side; ++i) {
        const auto at = [&](int32_t u, int32_t v) { return t.vertex_of(static_cast<size_t>(u * side + v)); };
        segments.push_back({at(i, 0), at(i, side - 1), 2 * i, false});
        segments.push_back({at(0, i), at(side - 1, i), 2 * i + 1, false});
    }
    const nrb::Watch watch({.work = 1000 * n});
    EXPECT_TRUE(t.constrain(segments).empty());
    EXPECT_EQ(fault_of(t), "");
    EXPECT_EQ(std::ssize(staying_edges(t)), 2 * int64_t{side} * (side - 1));
}

// CDT#37: a triangle around all that is too small for points that are nearly on a line. There is none here: the hull is covered
// whatever its circles are.
TEST(DelaunaySizes, hulls_of_points_nearly_on_a_line_are_covered) {
    std::mt19937_64 random(seed);
    for (const int32_t height : {1, 2, 10, 1000}) {
        const auto n = static_cast<int32_t>(support::scaled(3000));
        Points points;
        for (int32_t i = 0; i < n; ++i) {
            points.push_back({static_cast<int32_t>(random() % (uint64_t{1} << 30)),
                              static_cast<int32_t>(random() % static_cast<uint64_t>(height + 1))});
        }
        points.insert(points.end(), {{0, 0}, {grid_end, height}, {grid_end / 2, height}});
        expect_triangulated("nearly on a line", points);
    }
}

} // namespace

} // namespace delaunay_test
