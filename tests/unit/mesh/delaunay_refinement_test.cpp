// SPDX-License-Identifier: MIT
// Vertices that come later, and flips by hand.
#include "base/watch.h"
#include "delaunay_checks.h"

#include <set>

namespace delaunay_test {

namespace {

// Non-ghost triangles with their corners, by their numbers.
std::map<TriangleId, std::array<VertexId, 3>> triangles_of(const Triangulation &t) {
    std::map<TriangleId, std::array<VertexId, 3>> all;
    for (TriangleId id = 0; id < t.size(); ++id) {
        if (!t.ghost(id)) {
            all[id] = t.corners(id);
            std::sort(all[id].begin(), all[id].end());
        }
    }
    return all;
}

// Those of the second that are not in the first, as they are.
std::set<TriangleId> differences(const std::map<TriangleId, std::array<VertexId, 3>> &before,
                                 const std::map<TriangleId, std::array<VertexId, 3>> &after) {
    std::set<TriangleId> changed;
    for (const auto &[id, corners] : after) {
        const auto old = before.find(id);
        if (old == before.end() || old->second != corners) {
            changed.insert(id);
        }
    }
    return changed;
}

// The whole grid with a hole.
struct Region {
    Points points = {{0, 0},
                     {grid_end, 0},
                     {grid_end, grid_end},
                     {0, grid_end},
                     {300000000, 300000000},
                     {700000000, 300000008},
                     {699999998, 800000000},
                     {300000000, 700000000}};
    std::vector<Segment> segments;
    Triangulation triangles;

    Region() : triangles(points) {
        for (size_t i = 0; i < 8; ++i) {
            const size_t next = i / 4 * 4 + (i + 1) % 4;
            segments.push_back(
                {triangles.vertex_of(i), triangles.vertex_of(next), static_cast<int32_t>(i), true});
        }
        EXPECT_TRUE(triangles.constrain(segments).empty());
        EXPECT_TRUE(triangles.mark_inside());
    }
};

TEST(DelaunayRefinement, each_insertion_tells_what_it_changes) {
    std::mt19937_64 random(seed);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " round " + std::to_string(round));
        const int kind = round % 4;
        const Points points = awkward_points(random, 30, kind);
        Triangulation t(points);
        std::vector<Segment> segments;
        for (int32_t i = 0; i < 15; ++i) {
            segments.push_back(
                {t.vertex_of(random() % points.size()), t.vertex_of(random() % points.size()), i, false});
        }
        std::set<size_t> out;
        for (const Triangulation::Crossing &crossing : t.constrain(segments)) {
            out.insert(crossing.segment);
        }
        std::vector<TriangleId> changed;
        for (const GridPoint &p : awkward_points(random, 150, kind)) {
            const auto before = triangles_of(t);
            const bool is_vertex =
                std::find(t.vertices().begin(), t.vertices().end(), p) != t.vertices().end();
            const auto near = static_cast<TriangleId>(random() % static_cast<uint64_t>(t.size()));
            const auto v = t.insert(p, near, true, changed);
            EXPECT_EQ(v.has_value(), !is_vertex);
            EXPECT_EQ(fault_of(t), "");
            EXPECT_EQ(std::set<TriangleId>(changed.begin(), changed.end()),
                      differences(before, triangles_of(t)));
            EXPECT_EQ(std::set<TriangleId>(changed.begin(), changed.end()).size(), changed.size());
        }
        expect_segments(t, segments, out);
    }
}

TEST(DelaunayRefinement, insertions_keep_what_stays_and_what_is_inside) {
    std::mt19937_64 random(seed);
    Region region;
    Triangulation &t = region.triangles;
    std::vector<TriangleId> changed;
    TriangleId near = 0;
    for (const GridPoint &p : random_points(random, 100000, grid_end)) {
        const auto v = t.insert(p, near, false, changed);
        near = v ? changed.front() : near;
    }
    EXPECT_GT(t.vertices().size(), 100000U);
    EXPECT_EQ(fault_of(t), "");
    EXPECT_EQ(staying_edges(t).size(), 8U);
    expect_parity(t, region.segments);
}

// The frame and the hole get all vertices on them: borders stay borders, with their labels.
TEST(DelaunayRefinement, edges_that_stay_are_split_where_that_is_allowed) {
    Region region;
    Triangulation &t = region.triangles;
    std::vector<TriangleId> changed;
    size_t edges = 8;
    for (const Segment &segment : region.segments) {
        const GridPoint a = t.vertices()[static_cast<size_t>(segment.from)];
        const GridPoint b = t.vertices()[static_cast<size_t>(segment.to)];
        const GridPoint middle = {a.u + (b.u - a.u) / 2, a.v + (b.v - a.v) / 2};
        ASSERT_TRUE(on_segment(a, b, middle));
        EXPECT_FALSE(t.insert(middle, 0, false, changed).has_value());
        EXPECT_TRUE(changed.empty());
        EXPECT_EQ(staying_edges(t).size(), edges);
        const auto v = t.insert(middle, 0, true, changed);
        ASSERT_TRUE(v.has_value());
        const auto staying = staying_edges(t);
        EXPECT_EQ(staying.size(), ++edges);
        EXPECT_EQ(staying.at(std::minmax(segment.from, *v)), segment.label);
        EXPECT_EQ(staying.at(std::minmax(segment.to, *v)), segment.label);
        EXPECT_EQ(fault_of(t), "");
        expect_parity(t, region.segments);
    }
}

TEST(DelaunayRefinement, a_vertex_beyond_the_hull_is_outside) {
    Triangulation t(Points{{10, 10}, {20, 10}, {10, 20}});
    std::vector<Segment> loop;
    for (size_t i = 0; i < 3; ++i) {
        loop.push_back({t.vertex_of(i), t.vertex_of((i + 1) % 3), 0, true});
    }
    EXPECT_TRUE(t.constrain(loop).empty());
    EXPECT_TRUE(t.mark_inside());
    std::vector<TriangleId> changed;
    // in line with an edge, and beyond two of them
    for (const GridPoint &p : Points{{30, 10}, {0, 0}, {grid_end, grid_end}}) {
        EXPECT_TRUE(t.insert(p, t.size() - 1, false, changed).has_value());
        EXPECT_EQ(fault_of(t), "");
        expect_parity(t, loop);
    }
}

TEST(DelaunayRefinement, nothing_is_inserted_where_there_are_no_triangles) {
    Triangulation t(Points{{1, 1}, {3, 3}});
    std::vector<TriangleId> changed;
    EXPECT_FALSE(t.insert({5, 0}, 0, true, changed).has_value());
    EXPECT_TRUE(t.constrain(std::vector<Segment>{{0, 1, 0, true}}).empty());
    EXPECT_TRUE(t.mark_inside());
}

// Flips at random leave a triangulation that is not Delaunay, in which walks that only look at edges may go round for ever.
TEST(DelaunayRefinement, places_are_found_whatever_was_flipped) {
    std::mt19937_64 random(seed);
    Triangulation t(random_points(random, 2000, 150));
    std::vector<TriangleId> changed;
    size_t flipped = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto id = static_cast<TriangleId>(random() % static_cast<uint64_t>(t.size()));
        const int k = static_cast<int>(random() % 3);
        const TriangleId other = t.neighbour(id, k);
        const bool convex = is_diagonal(t, id, k);
        changed.clear();
        ASSERT_EQ(t.flip(id, k, changed), convex);
        ASSERT_EQ(changed, convex ? (std::vector<TriangleId>{id, other}) : std::vector<TriangleId>{});
        flipped += convex ? 1 : 0;
    }
    EXPECT_GT(flipped, 10000U);
    EXPECT_EQ(fault_of(t, false), "");
    for (const GridPoint &p : random_points(random, 2000, 160)) {
        const bool is_vertex = std::find(t.vertices().begin(), t.vertices().end(), p) != t.vertices().end();
        const auto near = static_cast<TriangleId>(random() % static_cast<uint64_t>(t.size()));
        ASSERT_EQ(t.insert(p, near, true, changed).has_value(), !is_vertex);
    }
    EXPECT_EQ(fault_of(t, false), "");
}

// Three rows of vertices, so far apart that the way over edges is given up: straight lines lead from vertex to vertex, too.
TEST(DelaunayRefinement, places_far_from_a_triangle_are_found) {
    constexpr int32_t count = 6000;
    std::mt19937_64 random(seed);
    Points points;
    for (int32_t i = 0; i < 3 * count; ++i) {
        points.push_back({i / 3 * 8, i % 3 * 4});
    }
    Triangulation t(points);
    std::vector<TriangleId> changed;
    for (int i = 0; i < 3000; ++i) {
        const int32_t end = random() % 2 == 0 ? 0 : 8 * (count - 100);
        const GridPoint p = {end + static_cast<int32_t>(random() % 800) - 4,
                             static_cast<int32_t>(random() % 13) - 2};
        const GridPoint place = {std::max(p.u, 0), std::max(p.v, 0)};
        const bool is_vertex =
            std::find(t.vertices().begin(), t.vertices().end(), place) != t.vertices().end();
        const auto near = static_cast<TriangleId>(random() % static_cast<uint64_t>(t.size()));
        ASSERT_EQ(t.insert(place, near, true, changed).has_value(), !is_vertex);
    }
    EXPECT_EQ(fault_of(t), "");
}

TEST(DelaunayRefinement, edges_that_stay_are_not_flipped) {
    Triangulation t(Points{{0, 0}, {10, 0}, {11, 11}, {0, 10}});
    EXPECT_TRUE(t.constrain(std::vector<Segment>{{t.vertex_of(0), t.vertex_of(2), 4, false}}).empty());
    std::vector<TriangleId> changed;
    for (TriangleId id = 0; id < t.size(); ++id) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_FALSE(t.flip(id, k, changed));
        }
    }
    EXPECT_EQ(staying_edges(t).size(), 1U);
}

} // namespace

} // namespace delaunay_test
