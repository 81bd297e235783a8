// SPDX-License-Identifier: MIT
// Segments that become edges of Delaunay triangulations, and what is inside of them.
#include "base/watch.h"
#include "delaunay_checks.h"

#include <cmath>
#include <numeric>
#include <set>
#include <span>

namespace delaunay_test {

namespace {

std::vector<Segment> loop_of(const Triangulation &t, size_t first, size_t end, int32_t label) {
    std::vector<Segment> segments;
    for (size_t i = first; i < end; ++i) {
        segments.push_back({t.vertex_of(i), t.vertex_of(i + 1 < end ? i + 1 : first), label, true});
    }
    return segments;
}

// The rule in exact arithmetic: a segment is left out if it crosses one that was not, and told with one that it crosses.
std::set<size_t> expect_crossings(const Triangulation &t, const std::vector<Segment> &segments,
                                  const std::vector<Triangulation::Crossing> &crossings) {
    std::set<size_t> out;
    std::vector<size_t> kept;
    size_t told = 0;
    const auto point = [&](VertexId v) { return t.vertices()[static_cast<size_t>(v)]; };
    for (size_t i = 0; i < segments.size(); ++i) {
        const GridPoint a = point(segments[i].from), b = point(segments[i].to);
        const auto crossed = [&](size_t j) {
            return cross(a, b, point(segments[j].from), point(segments[j].to));
        };
        // parts of a segment, too, between vertices on it
        const bool crosses = std::any_of(kept.begin(), kept.end(), [&](size_t j) {
            if (!crossed(j)) {
                return false;
            }
            const std::vector<VertexId> on = vertices_on(t, segments[j]), own = vertices_on(t, segments[i]);
            return std::none_of(on.begin(), on.end(), [&](VertexId v) {
                return std::find(own.begin(), own.end(), v) != own.end();
            });
        });
        if (!crosses) {
            kept.push_back(i);
            continue;
        }
        out.insert(i);
        if (told == crossings.size() || crossings[told].segment != i) {
            ADD_FAILURE() << "segment " << i << " crosses and is not told";
            return out;
        }
        EXPECT_TRUE(cross(a, b, point(crossings[told].from), point(crossings[told].to)));
        ++told;
    }
    EXPECT_EQ(told, crossings.size());
    return out;
}

TEST(DelaunaySegments, random_segments_stay_or_are_told_to_cross) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " round " + std::to_string(round));
        const Points points = awkward_points(random, 3 + random() % 60, round % 4);
        Triangulation t(points);
        std::vector<Segment> segments;
        for (int32_t i = 0; t.size() > 0 && i < 25; ++i) {
            segments.push_back(
                {t.vertex_of(random() % points.size()), t.vertex_of(random() % points.size()), i, false});
        }
        const std::vector<Triangulation::Crossing> crossings = t.constrain(segments);
        if (t.size() > 0) {
            EXPECT_EQ(fault_of(t), "");
            expect_segments(t, segments, expect_crossings(t, segments, crossings));
        }
    }
}

// Whatever they pass: after flips at random, too, where sides of what they open need not be Delaunay.
TEST(DelaunaySegments, segments_stay_where_nothing_is_delaunay) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 2000; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " round " + std::to_string(round));
        const Points points = awkward_points(random, 10 + random() % 60, round % 4);
        Triangulation t(points);
        std::vector<TriangleId> changed;
        for (int i = 0; i < 300; ++i) {
            t.flip(static_cast<TriangleId>(random() % static_cast<uint64_t>(t.size())),
                   static_cast<int>(random() % 3), changed);
        }
        std::vector<Segment> segments;
        for (int32_t i = 0; i < 25; ++i) {
            segments.push_back(
                {t.vertex_of(random() % points.size()), t.vertex_of(random() % points.size()), i, false});
        }
        const std::vector<Triangulation::Crossing> crossings = t.constrain(segments);
        EXPECT_EQ(fault_of(t, false), "");
        expect_segments(t, segments, expect_crossings(t, segments, crossings));
        for (TriangleId id = 0; id < t.size(); ++id) {
            for (int k = 0; k < 3; ++k) {
                const bool expected = is_diagonal(t, id, k) && !t.constrained(id, k);
                ASSERT_EQ(t.flip(id, k, changed), expected);
            }
        }
    }
}

// Any closed chain of segments as long as none is left out; flooding finds the parity that rays find.
TEST(DelaunaySegments, parity_of_loops_is_that_of_rays) {
    std::mt19937_64 random(seed);
    int compared = 0;
    for (int round = 0; round < 4000; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " round " + std::to_string(round));
        const Points points = awkward_points(random, 12, round % 4);
        Triangulation t(points);
        std::vector<Segment> segments = loop_of(t, 0, 3 + random() % 3, 0);
        const std::vector<Segment> second = loop_of(t, 6, 9 + random() % 3, 1);
        segments.insert(segments.end(), second.begin(), second.end());
        if (t.size() == 0 || !t.constrain(segments).empty()) {
            continue;
        }
        EXPECT_TRUE(t.mark_inside());
        expect_parity(t, segments);
        // others that are no borders change nothing of that, whether it is asked again or not
        segments.push_back({t.vertex_of(random() % 12), t.vertex_of(random() % 12), 2, false});
        t.constrain(std::span(segments).last(1));
        expect_parity(t, segments);
        EXPECT_TRUE(t.mark_inside());
        expect_parity(t, segments);
        ++compared;
    }
    EXPECT_GT(compared, 300);
}

Points square(int32_t margin) {
    const int32_t far = grid_end - margin;
    return {{margin, margin}, {far, margin}, {far, far}, {margin, far}};
}

Wide doubled_inside(const Triangulation &t) {
    Wide area = 0;
    for (TriangleId id = 0; id < t.size(); ++id) {
        area += t.inside(id) ? doubled_area(corner(t, id, 0), corner(t, id, 1), corner(t, id, 2)) : 0;
    }
    return area;
}

TEST(DelaunaySegments, holes_in_holes_alternate) {
    std::mt19937_64 random(seed);
    Points points;
    const auto side = [](int32_t k) { return Wide{grid_end - 2 * k * 100000000}; };
    for (int32_t k = 0; k < 5; ++k) {
        const Points ring = square(k * 100000000);
        points.insert(points.end(), ring.begin(), ring.end());
    }
    const Points others = random_points(random, 3000, grid_end);
    points.insert(points.end(), others.begin(), others.end());
    Triangulation t(points);
    Wide expected = 0;
    for (int32_t k = 0; k < 5; ++k) {
        EXPECT_TRUE(t.constrain(loop_of(t, size_t{4} * static_cast<size_t>(k),
                                        size_t{4} * static_cast<size_t>(k) + 4, k))
                        .empty());
        expected += (k % 2 == 0 ? 2 : -2) * side(k) * side(k);
    }
    EXPECT_TRUE(t.mark_inside());
    EXPECT_EQ(fault_of(t), "");
    EXPECT_TRUE(doubled_inside(t) == expected);
}

TEST(DelaunaySegments, borders_on_each_other_cancel) {
    // two rectangles beside each other, with a side in common that has a vertex on it
    const Points points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {20, 0}, {20, 10}, {10, 5}};
    Triangulation t(points);
    const auto v = [&](size_t i) { return t.vertex_of(i); };
    EXPECT_TRUE(t.constrain(loop_of(t, 0, 4, 1)).empty());
    const std::vector<Segment> second = {
        {v(1), v(4), 2, true}, {v(4), v(5), 2, true}, {v(5), v(2), 2, true}, {v(2), v(1), 2, true}};
    EXPECT_TRUE(t.constrain(second).empty());
    EXPECT_TRUE(t.mark_inside());
    EXPECT_TRUE(doubled_inside(t) == 400);
    const auto edges = staying_edges(t);
    EXPECT_EQ(edges.at(std::minmax({v(1), v(6)})), 1);
    EXPECT_EQ(edges.at(std::minmax({v(6), v(2)})), 1);
    // the second one once more: nothing of it is left
    EXPECT_TRUE(t.constrain(second).empty());
    EXPECT_TRUE(t.mark_inside());
    EXPECT_TRUE(doubled_inside(t) == 200);
}

TEST(DelaunaySegments, an_open_border_is_told) {
    Triangulation t(square(0));
    EXPECT_TRUE(t.constrain(std::vector<Segment>{{t.vertex_of(0), t.vertex_of(1), 0, true}}).empty());
    EXPECT_FALSE(t.mark_inside());
}

TEST(DelaunaySegments, lines_of_a_lattice_are_divided) {
    Points points;
    for (int32_t i = 0; i < 41 * 41; ++i) {
        points.push_back({i / 41 * 1000, i % 41 * 1000});
    }
    Triangulation t(points);
    const auto at = [&](int32_t u, int32_t v) { return t.vertex_of(static_cast<size_t>(u * 41 + v)); };
    const std::vector<Segment> segments = {
        {at(20, 0), at(20, 40), 0, false}, {at(0, 20), at(40, 20), 1, false},
        {at(0, 0), at(40, 40), 2, false},  {at(40, 0), at(0, 40), 3, false},
        {at(0, 1), at(40, 21), 4, false},  {at(20, 5), at(20, 30), 5, false}};
    const auto crossings = t.constrain(segments);
    // the fifth meets all others in vertices, but the falling diagonal and the second between them
    EXPECT_EQ(fault_of(t), "");
    expect_segments(t, segments, expect_crossings(t, segments, crossings));
}

// Both sides of a segment along the whole grid: n points at the distances that are given.
void expect_corridor(const char *name, int32_t n, const std::vector<int32_t> &heights) {
    SCOPED_TRACE(name);
    const int32_t step = grid_end / (n + 1);
    Points points = {{0, grid_end / 2}, {(n + 1) * step, grid_end / 2}};
    for (int32_t i = 0; i < n; ++i) {
        const int32_t height = heights[static_cast<size_t>(i)];
        points.push_back({(i + 1) * step, grid_end / 2 + (i % 2 == 0 ? height : -height)});
    }
    Triangulation t(points);
    const nrb::Watch watch({.work = 2000 * int64_t{n}});
    EXPECT_TRUE(t.constrain(std::vector<Segment>{{t.vertex_of(0), t.vertex_of(1), 7, true}}).empty());
    EXPECT_EQ(fault_of(t), "");
    EXPECT_EQ(staying_edges(t).size(), 1U);
}

TEST(DelaunaySegments, long_segments_take_linear_work) {
    constexpr int32_t n = 100000;
    std::mt19937_64 random(seed);
    std::vector<int32_t> flat(n), random_near(n), arc(n), tall(n), bump(n), valley(n), rising(n), far(n);
    for (int32_t i = 0; i < n; ++i) {
        const auto k = static_cast<size_t>(i);
        const double x = 2.0 * i / n - 1;
        flat[k] = 1;
        random_near[k] = 1 + static_cast<int32_t>(random() % 10000);
        far[k] = 1 + static_cast<int32_t>(random() % (grid_end / 2));
        arc[k] = 1 + static_cast<int32_t>(1e6 * (1 - x * x));
        tall[k] = 1 + static_cast<int32_t>((grid_end / 2 - 2) * (1 - x * x));
        bump[k] = 1 + static_cast<int32_t>(1e8 * std::exp(-50 * x * x));
        valley[k] = 1 + static_cast<int32_t>(1e6 * x * x);
        rising[k] = 1 + i;
    }
    expect_corridor("flat", n, flat);
    expect_corridor("random near", n, random_near);
    expect_corridor("random far", n, far);
    expect_corridor("arc", n, arc);
    expect_corridor("tall arc", n, tall);
    expect_corridor("bump", n, bump);
    expect_corridor("valley", n, valley);
    expect_corridor("rising", n, rising);
}

// A star of n corners, whose sides go through random points.
TEST(DelaunaySegments, a_loop_of_100000_corners_bounds_its_area) {
    constexpr size_t n = 100000;
    std::mt19937_64 random(seed);
    Points points;
    for (size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / n, radius = i % 2 == 0 ? 5e8 : 3e8;
        points.push_back({static_cast<int32_t>(grid_end / 2 + radius * std::cos(angle)),
                          static_cast<int32_t>(grid_end / 2 + radius * std::sin(angle))});
    }
    const Points others = random_points(random, n, grid_end);
    points.insert(points.end(), others.begin(), others.end());
    Triangulation t(points);
    const nrb::Watch watch({.work = 5000 * int64_t{n}});
    EXPECT_TRUE(t.constrain(loop_of(t, 0, n, 3)).empty());
    EXPECT_TRUE(t.mark_inside());
    EXPECT_EQ(fault_of(t), "");
    Wide expected = 0;
    for (size_t i = 0; i < n; ++i) {
        expected += doubled_area({0, 0}, points[i], points[(i + 1) % n]);
    }
    EXPECT_TRUE(doubled_inside(t) == expected);
}

// Every spoke is found from its end on the rim: the hub has as many triangles as there are spokes.
TEST(DelaunaySegments, spokes_of_a_hub_take_linear_work) {
    constexpr size_t n = 50000;
    Points points;
    for (size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / n;
        points.push_back({static_cast<int32_t>(grid_end / 2 + 5e8 * std::cos(angle)),
                          static_cast<int32_t>(grid_end / 2 + 5e8 * std::sin(angle))});
    }
    points.push_back({grid_end / 2, grid_end / 2});
    Triangulation t(points);
    std::vector<Segment> spokes;
    for (size_t i = 0; i < n; ++i) {
        spokes.push_back({t.vertex_of(n), t.vertex_of(i), 0, false});
    }
    const nrb::Watch watch({.work = 1000 * int64_t{n}});
    EXPECT_TRUE(t.constrain(spokes).empty());
    EXPECT_EQ(staying_edges(t).size(), n);
}

} // namespace

} // namespace delaunay_test
